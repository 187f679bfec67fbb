// Bounds of float arithmetic and the few operations whose rounding matters elsewhere.
#ifndef VERNIER_ROUNDING_GLSL
#define VERNIER_ROUNDING_GLSL

#include "shared/glsl.h"

const float HALF_ULP_OF_ONE = 5.9604644775390625e-8f;  // 2^-24: relative error of one rounding
const float LARGEST_FLOAT = 3.4028234663852886e38f;
const uint HALF_FLOAT_BITS = 0xffffe000u;  // of a float: sign, exponent and the digits that a half float has

// Relative error bound of n roundings in a row, n u / (1 - n u) (Higham 2002, Accuracy and Stability of Numerical
// Algorithms, section 3.1).
float gamma_bound(IN(float) n) { return n * HALF_ULP_OF_ONE / (1.0f - n * HALF_ULP_OF_ONE); }

// Neither NaN nor infinite, judged by the bits: drivers may assume that comparisons see no NaN.
bool is_finite(IN(float) x) { return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u; }

bool is_finite(IN(vec3) v) { return is_finite(v.x) && is_finite(v.y) && is_finite(v.z); }

// The smaller (larger) of two numbers, b where one is none: one instruction of a CPU, where min and max, which look for the
// one that is a number, take llvmpipe three.
float smaller(IN(float) a, IN(float) b) { return a < b ? a : b; }

float larger(IN(float) a, IN(float) b) { return a > b ? a : b; }

float max3(IN(vec3) v) { return max(v.x, max(v.y, v.z)); }

// v / |v|, the same bits for v scaled by any power of two; the zero vector for zero length or a non-finite component.
vec3 unit_vector(IN(vec3) v) {
  // Sizes as integers: in order, and NaN lies above infinity, where max() of floats would lose it.
  const uint size_bits = 0x7fffffffu;
  uint largest = max(floatBitsToUint(v.x) & size_bits, max(floatBitsToUint(v.y) & size_bits, floatBitsToUint(v.z) & size_bits));
  if (largest == 0u || largest >= 0x7f800000u) return vec3(0.0f);
  // Scaling by a power of two is exact; it keeps the squares from overflow and underflow.
  uint exponent = clamp(largest >> 23, 1u, 252u);
  float scale = uintBitsToFloat((253u - exponent) << 23);
  precise vec3 w = v * scale;
  precise float length_squared = w.x * w.x + w.y * w.y + w.z * w.z;
  precise float reciprocal = 1.0f / sqrt(length_squared);
  return w * reciprocal;
}

// dot(a, b) in one fixed order: dot() may be fused or reassociated by the driver.
float dot_product(IN(vec3) a, IN(vec3) b) {
  precise float sum = a.x * b.x + a.y * b.y + a.z * b.z;
  return sum;
}

// cross(a, b) in one fixed order.
vec3 cross_product(IN(vec3) a, IN(vec3) b) {
  precise vec3 c = vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
  return c;
}

#endif
