// Logarithm and exponential of the exact level: Vulkan promises log() to 2^-21 only, and exp() to 3 + 2 |x| ulps.
#ifndef VERNIER_EXACT_POWER_GLSL
#define VERNIER_EXACT_POWER_GLSL

#include "double_float.glsl"

// ln 2 as a number of 9 bits, of which any multiple by an exponent is exact, and the rest (Cody and Waite 1980, "Software
// Manual for the Elementary Functions", chapter 6).
const float LN2_HIGH = 0.693359375f;
const float LN2_LOW = -2.12194440054690583e-4f;  // ln 2 - LN2_HIGH

// log(1 - s) for s in [0, 1/4): the leading term exactly, the series of the others in floats.
DoubleFloat wide_log_one_minus(IN(DoubleFloat) s) {
  float x = s.hi;
  // -log(1 - x) - x = x^2 (1/2 + x (1/3 + ...)); terms from x^16 on are below 2^-33 of the first.
  float series = 1.0f / 15.0f;
  series = 1.0f / 14.0f + x * series;
  series = 1.0f / 13.0f + x * series;
  series = 1.0f / 12.0f + x * series;
  series = 1.0f / 11.0f + x * series;
  series = 1.0f / 10.0f + x * series;
  series = 1.0f / 9.0f + x * series;
  series = 1.0f / 8.0f + x * series;
  series = 1.0f / 7.0f + x * series;
  series = 1.0f / 6.0f + x * series;
  series = 1.0f / 5.0f + x * series;
  series = 1.0f / 4.0f + x * series;
  series = 1.0f / 3.0f + x * series;
  series = 1.0f / 2.0f + x * series;
  return negated(wide_sum(s, widened(x * x * series)));
}

// log(m) of m in [0, 1]; -200 stands for log(0), whose exponential is 0.
DoubleFloat wide_log(IN(DoubleFloat) m) {
  const float least_normal = 1.17549435e-38f;  // 2^-126
  if (!(m.hi > least_normal)) return widened(-200.0f);
  uint bits = floatBitsToUint(m.hi);
  // m = 2^k f with f in [0.7, 1.42)
  int k = int((bits - 0x3f350000u) >> 23) - (bits < 0x3f350000u ? 512 : 0);
  float f = uintBitsToFloat(bits - (uint(k) << 23));
  float z = (f - 1.0f) / (f + 1.0f);
  float q = z * z;
  float rest = 2.0f * z * (1.0f + q * (1.0f / 3.0f + q * (1.0f / 5.0f + q * (1.0f / 7.0f + q * (1.0f / 9.0f + q * (1.0f / 11.0f))))));
  return two_sum(float(k) * LN2_HIGH, rest + float(k) * LN2_LOW + m.lo / m.hi);
}

// exp(y) for y <= 0, right to an ulp of 1; 0 below -87.
float wide_exp(IN(DoubleFloat) y) {
  if (!(y.hi > -87.0f)) return 0.0f;
  float k = floor(y.hi * 1.44269504088896340736f + 0.5f);
  precise float r = ((y.hi - k * LN2_HIGH) - k * LN2_LOW) + y.lo;
  float series = 1.0f / 2.0f + r * (1.0f / 6.0f + r * (1.0f / 24.0f + r * (1.0f / 120.0f + r * (1.0f / 720.0f + r * (1.0f / 5040.0f)))));
  precise float near_one = 1.0f + (r + r * r * series);
  return near_one * uintBitsToFloat(uint(int(k) + 127) << 23);
}

#endif
