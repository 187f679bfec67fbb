// Texture look-up on plain words: the same bits on every driver, and no limit on the number of textures.
#ifndef VERNIER_TEXTURE_GLSL
#define VERNIER_TEXTURE_GLSL

#include "effect_runs.glsl"
#include "material.glsl"

// Bring texel index i, at most one texture width outside, or of any size for repeat and mirror, into [0, size).
int wrapped_index(IN(int) i, IN(int) size, IN(uint) wrap) {
  if (wrap == TEXTURE_WRAP_CLAMP) return clamp(i, 0, size - 1);
  int period = wrap == TEXTURE_WRAP_MIRROR ? 2 * size : size;
  int inside = i - period * int(floor(float(i) / float(period)));
  // The float quotient may be off by one next to a multiple of the period.
  inside = inside < 0 ? inside + period : inside >= period ? inside - period : inside;
  return inside < size ? inside : period - 1 - inside;
}

// A finite x brought into one period before it is scaled, so that no large number meets the integer conversion.
float wrapped_coordinate(IN(float) x, IN(uint) wrap) {
  if (wrap == TEXTURE_WRAP_CLAMP) return clamp(x, 0.0f, 1.0f);
  if (wrap == TEXTURE_WRAP_MIRROR) return x - 2.0f * floor(x * 0.5f);
  return x - floor(x);
}

float srgb_to_linear(IN(uint) byte_value) { return uintBitsToFloat(load_curve(byte_value)); }

// One decoded texel; `texture` is word 0 to 3 of its description.
vec4 decoded_texel(IN(uvec4) texture_words, IN(int) x, IN(int) y) {
  uint format = texture_words.w & TEXTURE_FORMAT_MASK;
  uint index = uint(y) * texture_words.x + uint(x);
  if (effect_on(EFFECT_FLOAT_TEXTURES) && format == TEXTURE_FORMAT_FLOAT) {
    note_run(EFFECT_FLOAT_TEXTURES);
    return float_texel(load_texel_quad(texture_words.z / 4u + index));
  }
  uint word = load_texel(texture_words.z + index);
  uvec4 bytes = uvec4(word & 255u, (word >> 8) & 255u, (word >> 16) & 255u, word >> 24);
  if (format == TEXTURE_FORMAT_SRGB8) {
    return vec4(srgb_to_linear(bytes.x), srgb_to_linear(bytes.y), srgb_to_linear(bytes.z), float(bytes.w) / 255.0f);
  }
  return vec4(float(bytes.x), float(bytes.y), float(bytes.z), float(bytes.w)) / 255.0f;
}

// Texture number `index` at (u, v), v down, with its wrap modes: bilinear, or nearest as bilinear of one texel with itself.
// Texel (0, 0) where u or v is not finite.
vec4 sample_texture(IN(uint) index, IN(vec2) place) {
  uvec4 words = load_texture(index);
  ivec2 size = ivec2(int(words.x), int(words.y));
  uint wrap_u = (words.w >> TEXTURE_WRAP_U_SHIFT) & 3u;
  uint wrap_v = (words.w >> TEXTURE_WRAP_V_SHIFT) & 3u;
  bool defined = is_finite(place.x) && is_finite(place.y);
  vec2 uv = defined ? place : vec2(0.0f);
  bool nearest = !defined || ((words.w >> TEXTURE_FILTER_SHIFT) & 1u) == TEXTURE_FILTER_NEAREST;
  vec2 position = vec2(wrapped_coordinate(uv.x, wrap_u), wrapped_coordinate(uv.y, wrap_v)) * vec2(size);
  vec2 corner = nearest ? position : position - 0.5f;
  vec2 whole = floor(corner);
  vec2 part = nearest ? vec2(0.0f) : corner - whole;
  // Nearest: u = 1 of clamp, and of repeat where a tiny negative u rounds up to it, belongs to the last texel.
  bool clamps = nearest && !mutated(MUTATION_UNCLAMPED_FRACT);
  uint repeat_u = clamps && wrap_u == TEXTURE_WRAP_REPEAT ? TEXTURE_WRAP_CLAMP : wrap_u;
  uint repeat_v = clamps && wrap_v == TEXTURE_WRAP_REPEAT ? TEXTURE_WRAP_CLAMP : wrap_v;
  int x0 = wrapped_index(int(whole.x), size.x, repeat_u);
  int x1 = nearest ? x0 : wrapped_index(int(whole.x) + 1, size.x, repeat_u);
  int y0 = wrapped_index(int(whole.y), size.y, repeat_v);
  int y1 = nearest ? y0 : wrapped_index(int(whole.y) + 1, size.y, repeat_v);
  vec4 top = mix(decoded_texel(words, x0, y0), decoded_texel(words, x1, y0), part.x);
  vec4 bottom = mix(decoded_texel(words, x0, y1), decoded_texel(words, x1, y1), part.x);
  return mix(top, bottom, part.y);
}

#endif
