#include <gtest/gtest.h>

#include <limits>

#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::uint32_t word_3(std::uint32_t format, std::uint32_t wrap, std::uint32_t filter) {
  return format | wrap << TEXTURE_WRAP_U_SHIFT | wrap << TEXTURE_WRAP_V_SHIFT | filter << TEXTURE_FILTER_SHIFT;
}

/// Texture 0: float texels (x, y, 100 x y, 1).
Memory counting_texture(int width, int height, std::uint32_t wrap, std::uint32_t filter) {
  Memory scene;
  scene.textures = {glm::uvec4(width, height, 0, word_3(TEXTURE_FORMAT_FLOAT, wrap, filter))};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int value : {x, y, 100 * x * y, 1}) scene.texels.push_back(floatBitsToUint(static_cast<float>(value)));
    }
  }
  return scene;
}

/// Image formation 3: the coordinate wrapped, in double.
double wrapped(double x, std::uint32_t wrap) {
  if (wrap == TEXTURE_WRAP_CLAMP) return std::clamp(x, 0.0, 1.0);
  if (wrap == TEXTURE_WRAP_MIRROR) return 1 - std::abs(1 - (x - 2 * std::floor(x / 2)));
  return x - std::floor(x);
}

int wrapped_texel(int i, int size, std::uint32_t wrap) {
  if (wrap == TEXTURE_WRAP_CLAMP) return std::clamp(i, 0, size - 1);
  if (wrap == TEXTURE_WRAP_MIRROR) return i < 0 ? -1 - i : i >= size ? 2 * size - 1 - i : i;
  return (i % size + size) % size;
}

/// The first two channels of counting_texture, bilinear, in double.
glm::dvec2 exact_linear(const vec2& uv, int width, int height, std::uint32_t wrap) {
  const double x = wrapped(uv.x, wrap) * width - 0.5, y = wrapped(uv.y, wrap) * height - 0.5;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const auto between = [&](double at, int i, int size) {
    return wrapped_texel(i, size, wrap) * (1 - (at - i)) + wrapped_texel(i + 1, size, wrap) * (at - i);
  };
  return {between(x, x0, width), between(y, y0, height)};
}

const std::uint32_t kWraps[] = {TEXTURE_WRAP_REPEAT, TEXTURE_WRAP_CLAMP, TEXTURE_WRAP_MIRROR};

TEST(Texture, linear_agrees_with_double) {
  for (std::uint32_t wrap : kWraps) {
    Memory scene = counting_texture(5, 3, wrap, TEXTURE_FILTER_LINEAR);
    const BoundMemory bound(scene);
    RandomValues random(37);
    for (int i = 0; i < 50000; ++i) {
      const vec2 uv(random.in(-4, 4), random.in(-4, 4));
      const glm::dvec2 exact = exact_linear(uv, 5, 3, wrap);
      const vec4 texel = sample_texture(0u, uv);
      // The wrapped coordinate is off by at most 2^-23 (mirror: by 2^-22), times five texels and the four between
      // wraps.
      ASSERT_NEAR(texel.x, exact.x, 2e-5) << wrap << ' ' << uv.x;
      ASSERT_NEAR(texel.y, exact.y, 2e-5) << wrap << ' ' << uv.y;
      ASSERT_NEAR(texel.w, 1.0f, 1e-6);
    }
  }
}

TEST(Texture, nearest_reads_the_texel_the_coordinate_lies_in) {
  for (std::uint32_t wrap : kWraps) {
    Memory scene = counting_texture(5, 3, wrap, TEXTURE_FILTER_NEAREST);
    const BoundMemory bound(scene);
    RandomValues random(38);
    for (int i = 0; i < 50000; ++i) {
      const vec2 uv(random.in(-4, 4), random.in(-4, 4));
      const double x = wrapped(uv.x, wrap) * 5, y = wrapped(uv.y, wrap) * 3;
      if (std::abs(x - std::round(x)) < 1e-5 || std::abs(y - std::round(y)) < 1e-5) continue;
      const vec4 texel = sample_texture(0u, uv);
      ASSERT_EQ(texel.x, std::min(std::floor(x), 4.0)) << wrap << ' ' << uv.x;
      ASSERT_EQ(texel.y, std::min(std::floor(y), 2.0));
    }
  }
}

TEST(Texture, hard_coordinates_stay_inside) {
  // Out of range would throw. -1e-10 wraps to 1 exactly; from 2^24 on a float has no fraction left.
  const float hard[] = {-1e-10f, -0.0f,       1.0f,  1.0f - 0x1p-24f, -1.0f, 1e7f,
                        -1e7f,   16777217.0f, 1e30f, -1e30f,          2.0f,  -1e-45f};
  for (std::uint32_t wrap : kWraps) {
    for (std::uint32_t filter : {TEXTURE_FILTER_NEAREST, TEXTURE_FILTER_LINEAR}) {
      for (const glm::ivec2& size : {glm::ivec2(1, 1), glm::ivec2(4096, 1), glm::ivec2(3, 7)}) {
        Memory scene = counting_texture(size.x, size.y, wrap, filter);
        const BoundMemory bound(scene);
        for (float u : hard) {
          for (float v : hard) {
            const vec4 texel = sample_texture(0u, vec2(u, v));
            ASSERT_GE(texel.x, 0.0f);
            ASSERT_LE(texel.x, static_cast<float>(size.x - 1));
            ASSERT_LE(texel.y, static_cast<float>(size.y - 1));
          }
        }
      }
    }
  }
}

TEST(Texture, a_place_that_is_not_finite_is_the_first_texel) {
  for (float bad : {kNan, std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}) {
    for (std::uint32_t wrap : kWraps) {
      for (std::uint32_t filter : {TEXTURE_FILTER_NEAREST, TEXTURE_FILTER_LINEAR}) {
        Memory scene = counting_texture(4, 4, wrap, filter);
        const BoundMemory bound(scene);
        EXPECT_EQ(sample_texture(0u, vec2(bad, 0.3f)), vec4(0, 0, 0, 1));
        EXPECT_EQ(sample_texture(0u, vec2(0.3f, bad)), vec4(0, 0, 0, 1));
      }
    }
  }
}

TEST(Texture, nearest_does_not_look_at_its_neighbours) {
  Memory scene = counting_texture(4, 4, TEXTURE_WRAP_REPEAT, TEXTURE_FILTER_NEAREST);
  for (uint i = 0; i < 16; ++i) {
    if (i != 5) scene.texels[4 * i] = floatBitsToUint(std::numeric_limits<float>::infinity());
  }
  const BoundMemory bound(scene);
  EXPECT_EQ(sample_texture(0u, vec2(0.3f, 0.45f)), vec4(1, 1, 100, 1));
}

TEST(Texture, a_tiny_negative_coordinate_belongs_to_the_last_texel) {
  Memory scene = counting_texture(4, 4, TEXTURE_WRAP_REPEAT, TEXTURE_FILTER_NEAREST);
  const BoundMemory bound(scene);
  EXPECT_EQ(sample_texture(0u, vec2(-1e-10f, 0.1f)).x, 3.0f);
  EXPECT_EQ(sample_texture(0u, vec2(-1e-10f, -1e-10f)).y, 3.0f);
}

TEST(Texture, wrapped_index_of_any_index) {
  for (int size : {1, 2, 3, 7, 4096}) {
    for (int i = -3 * size; i <= 3 * size; ++i) {
      ASSERT_EQ(wrapped_index(i, size, TEXTURE_WRAP_REPEAT), (i % size + size) % size);
      ASSERT_EQ(wrapped_index(i, size, TEXTURE_WRAP_CLAMP), std::clamp(i, 0, size - 1));
      const int m = (i % (2 * size) + 2 * size) % (2 * size);
      ASSERT_EQ(wrapped_index(i, size, TEXTURE_WRAP_MIRROR), std::min(m, 2 * size - 1 - m));
    }
  }
}

TEST(Texture, bytes_are_decoded_before_they_are_filtered) {
  Memory scene;
  for (int i = 0; i < 256; ++i) scene.texels.push_back(floatBitsToUint(static_cast<float>(i) * 10.0f));  // "sRGB curve"
  scene.texels.insert(scene.texels.end(), {0x80030201u, 0xff0000ffu});
  const auto texture = [](std::uint32_t format) {
    return glm::uvec4(2, 1, SRGB_CURVE_WORDS, word_3(format, TEXTURE_WRAP_CLAMP, TEXTURE_FILTER_LINEAR));
  };
  scene.textures = {texture(TEXTURE_FORMAT_SRGB8), texture(TEXTURE_FORMAT_LINEAR8)};
  const BoundMemory bound(scene);
  EXPECT_EQ(sample_texture(0u, vec2(0, 0)), vec4(10, 20, 30, 128 / 255.0f));
  EXPECT_EQ(sample_texture(0u, vec2(0.5f, 0)).x, (10.0f + 2550.0f) / 2);
  EXPECT_EQ(sample_texture(1u, vec2(0, 0)), vec4(1, 2, 3, 128) / 255.0f);
}

}  // namespace
}  // namespace vernier::shader
