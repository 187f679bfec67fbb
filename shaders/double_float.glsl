// Numbers of twice the precision as unevaluated sums of two floats, for the exact level. They need no float64 and have the
// same bits on every device. Error bounds: Joldes, Muller, Popescu 2017, "Tight and Rigorous Error Bounds for Basic Building
// Blocks of Double-Word Arithmetic", ACM TOMS 44(2); u = 2^-24. Valid while no product leaves [2^-100, 2^115].
#ifndef VERNIER_DOUBLE_FLOAT_GLSL
#define VERNIER_DOUBLE_FLOAT_GLSL

#include "rounding.glsl"

struct DoubleFloat {
  float hi;
  float lo;  // at most half an ulp of hi
};

// `x`, exactly.
DoubleFloat widened(IN(float) x) { return DoubleFloat(x, 0.0f); }

// The float nearest to `x`.
float narrowed(IN(DoubleFloat) x) { return x.hi + x.lo; }

// a + b, exactly, where |a| >= |b| (Dekker 1971).
DoubleFloat fast_two_sum(IN(float) a, IN(float) b) {
  precise float sum = a + b;
  precise float rest = b - (sum - a);
  return DoubleFloat(sum, rest);
}

// a + b, exactly (Knuth, The Art of Computer Programming 2, 4.2.2).
DoubleFloat two_sum(IN(float) a, IN(float) b) {
  precise float sum = a + b;
  precise float b_part = sum - a;
  precise float rest = (a - (sum - b_part)) + (b - b_part);
  return DoubleFloat(sum, rest);
}

// a - b, exactly.
DoubleFloat two_difference(IN(float) a, IN(float) b) { return two_sum(a, -b); }

// a b, exactly (Dekker 1971): fma() is not promised to round once. 4097 = 2^12 + 1 halves the mantissa.
DoubleFloat two_product(IN(float) a, IN(float) b) {
  precise float a_shifted = 4097.0f * a;
  precise float a_hi = a_shifted - (a_shifted - a);
  precise float a_lo = a - a_hi;
  precise float b_shifted = 4097.0f * b;
  precise float b_hi = b_shifted - (b_shifted - b);
  precise float b_lo = b - b_hi;
  precise float product = a * b;
  precise float rest = ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo;
  return DoubleFloat(product, rest);
}

// a + b to 3 u^2.
DoubleFloat wide_sum(IN(DoubleFloat) a, IN(DoubleFloat) b) {
  DoubleFloat s = two_sum(a.hi, b.hi);
  DoubleFloat t = two_sum(a.lo, b.lo);
  precise float c = s.lo + t.hi;
  DoubleFloat v = fast_two_sum(s.hi, c);
  precise float w = t.lo + v.lo;
  return fast_two_sum(v.hi, w);
}

DoubleFloat negated(IN(DoubleFloat) a) { return DoubleFloat(-a.hi, -a.lo); }

// a - b to 3 u^2.
DoubleFloat wide_difference(IN(DoubleFloat) a, IN(DoubleFloat) b) { return wide_sum(a, negated(b)); }

// a b to 5 u^2.
DoubleFloat wide_product(IN(DoubleFloat) a, IN(DoubleFloat) b) {
  DoubleFloat c = two_product(a.hi, b.hi);
  precise float rest = c.lo + (a.hi * b.lo + a.lo * b.hi);
  return fast_two_sum(c.hi, rest);
}

// a / b to 15 u^2 where the division is right to 2.5 ulps: two steps of long division.
DoubleFloat wide_quotient(IN(DoubleFloat) a, IN(DoubleFloat) b) {
  precise float first = a.hi / b.hi;
  DoubleFloat rest = wide_difference(a, wide_product(b, widened(first)));
  precise float second = rest.hi / b.hi;
  DoubleFloat last = wide_difference(rest, wide_product(b, widened(second)));
  precise float third = last.hi / b.hi;
  return wide_sum(fast_two_sum(first, second), widened(third));
}

// The square root of a > 0, to a few u^2: a step of Newton's method from the float's.
DoubleFloat wide_square_root(IN(DoubleFloat) a) {
  precise float root = sqrt(a.hi);
  DoubleFloat rest = wide_difference(a, two_product(root, root));
  precise float correction = rest.hi / (2.0f * root);
  return fast_two_sum(root, correction);
}

// a b - c d with the right sign, and 0 only where it is 0: the rounded products decide unless they are so close that their
// difference is exact, and then the rest is added.
float signed_difference_of_products(IN(float) a, IN(float) b, IN(float) c, IN(float) d) {
  DoubleFloat ab = two_product(a, b);
  DoubleFloat cd = two_product(c, d);
  precise float leading = ab.hi - cd.hi;
  DoubleFloat rest = two_difference(ab.lo, cd.lo);
  precise float difference = (leading + rest.hi) + rest.lo;
  return difference;
}

// A number with the sign of a b - c d, and 0 only where that is 0: rounding is monotone, so that products which differ rounded
// differ in the same direction, and of equal ones the errors decide.
float sign_of_difference(IN(float) a, IN(float) b, IN(float) c, IN(float) d) {
  DoubleFloat ab = two_product(a, b);
  DoubleFloat cd = two_product(c, d);
  precise float difference = ab.hi - cd.hi;
  precise float rest = ab.lo - cd.lo;
  return difference != 0.0f ? difference : rest;
}

// Three numbers of twice the precision.
struct WideVector {
  DoubleFloat x, y, z;
};

// v, exactly.
WideVector widened_vector(IN(vec3) v) { return WideVector(widened(v.x), widened(v.y), widened(v.z)); }

// a - b, exactly.
WideVector exact_difference(IN(vec3) a, IN(vec3) b) {
  return WideVector(two_difference(a.x, b.x), two_difference(a.y, b.y), two_difference(a.z, b.z));
}

// The dot product, in one fixed order.
DoubleFloat wide_dot_product(IN(WideVector) a, IN(WideVector) b) {
  return wide_sum(wide_sum(wide_product(a.x, b.x), wide_product(a.y, b.y)), wide_product(a.z, b.z));
}

// v / |v|, every component to half an ulp of 1 and a few u^2. |v|^2 is in [2^-90, 2^90].
vec3 narrowed_unit_vector(IN(WideVector) v) {
  DoubleFloat length = wide_square_root(wide_dot_product(v, v));
  return vec3(narrowed(wide_quotient(v.x, length)), narrowed(wide_quotient(v.y, length)), narrowed(wide_quotient(v.z, length)));
}

// The cross product.
WideVector wide_cross_product(IN(WideVector) a, IN(WideVector) b) {
  return WideVector(wide_difference(wide_product(a.y, b.z), wide_product(a.z, b.y)),
                    wide_difference(wide_product(a.z, b.x), wide_product(a.x, b.z)),
                    wide_difference(wide_product(a.x, b.y), wide_product(a.y, b.x)));
}

#endif
