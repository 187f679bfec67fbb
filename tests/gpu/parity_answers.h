// What parity.comp and parity_test.cpp work out from the same numbers with the same functions. It stands inside a
// function with `number(i)`, the i-th float operand, and `put(word)`. No include guard: it stands inside a function,
// once each.

vec3 a = vec3(number(0u), number(1u), number(2u));
vec3 b = vec3(number(3u), number(4u), number(5u));
vec3 c = vec3(number(6u), number(7u), number(8u));
vec3 d = vec3(number(9u), number(10u), number(11u));
float x = number(12u);
float y = number(13u);
float z = number(14u);
uint word = floatBitsToUint(number(15u));

// Integers.
WideSum sum = wide_add(fixed_point(x * 1000.0f), fixed_point(z));
put(sum.low);
put(sum.middle);
put(sum.high);
vec2 offset = sample_offset(word & 0xffffu, word >> 16, word & 31u, word, 16u);
put(floatBitsToUint(offset.x));
put(floatBitsToUint(offset.y));

// The triangle a, b, c seen from d.
Ray ray = Ray(d, (a + b + c) * x - d);
Hit hit = no_hit(LARGEST_FLOAT);
put(intersect_triangle(sheared_ray(ray), a, b, c, 5u, 6u, 0.0f, NONE, hit) ? 1u : 0u);
put(floatBitsToUint(hit.t));
vec3 weights = crossing_weights(ray, a, b, c);
put(floatBitsToUint(weights.y));
put(floatBitsToUint(weights.z));
vec3 unit = unit_vector(a * z);
put(floatBitsToUint(unit.x));
put(floatBitsToUint(unit.y));
put(floatBitsToUint(unit.z));
put(floatBitsToUint(dot_product(a, b)));

// Floats whose roundings are the driver's.
Fresnel fresnel = fresnel_dielectric(x, y);
put(floatBitsToUint(fresnel.reflected));
put(floatBitsToUint(fresnel.transmitted));
put(floatBitsToUint(fresnel.refracted_cosine));
put(floatBitsToUint(blinn_highlight(unit_vector(a), unit_vector(b), unit_vector(a + b * 0.1f), z)));
put(floatBitsToUint(schlick_weight(x)));
