#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "verify/image_cases.h"
#include "verify/picture.h"
#include "verify/ray_suite.h"

namespace vernier {
namespace {

/// A thousand bounces are a thousand searches: fewer pixels than elsewhere.
constexpr int kSide = 48;

/// Sum of the first `count` powers of `ratio`.
double power_sum(double ratio, double count) {
  return ratio == 1.0 ? count : (1.0 - std::pow(ratio, count)) / (1.0 - ratio);
}

/// The corridor's length, where the ruler behind it stands and how far that reaches; what is 1 in the traced space.
constexpr double kLength = 15.0, kRuler = 16.0, kRulerHalf = 8.0, kUnit = 16.0;

/// A ruler across the end of a corridor of lossless mirrors at y = +-half, seen through all of it. Its colour rises
/// with y from 0 to 1.
ImageScene corridor_scene(SampleRandom& random, double half) {
  ImageScene made;
  const auto gap = static_cast<float>(2.0 * half);
  constexpr auto kEnd = static_cast<float>(kLength), kReach = static_cast<float>(kRulerHalf);
  add_rectangle(made.scene, {0.0f, -gap / 2.0f, -4.0f}, {0.0f, 0.0f, 8.0f}, {kEnd, 0.0f, 0.0f}, mirror(1.0f));
  add_rectangle(made.scene, {0.0f, gap / 2.0f, -4.0f}, {kEnd, 0.0f, 0.0f}, {0.0f, 0.0f, 8.0f}, mirror(1.0f));
  add_rectangle(made.scene, {static_cast<float>(kRuler), -kReach, -kReach}, {0, 0, 2 * kReach}, {0, 2 * kReach, 0},
                unlit(glm::vec3(1.0f)));
  made.scene.meshes.back().colors = {{0, 0, 0, 1}, {0, 0, 0, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}};
  const double slope = random.below(2) == 0 ? random.in(0.5, 0.9) : random.in(-0.9, -0.5);
  const glm::dvec3 eye(0.0625, random.in(-0.25, 0.25) * half, 0.0);
  made.camera = looking(eye, eye + glm::dvec3(1.0, slope, 0.0), 0.05);
  return made;
}

/// How far `mark`, where the ray meets the ruler, is off, in parts of what is allowed: per bounce the direction drifts
/// by 4 ulp, over half of the way on the mean, and the place by the 8 steps in each axis that a ray starts off the
/// surface and 4 half ulps along it. Then ten roundings of 1 in reading the ruler.
double corridor_error(const PixelRay& ray, double half, double mark) {
  const double rise = ray.direction.y / ray.direction.x;
  const double unfolded = ray.origin.y + rise * (kLength - ray.origin.x);
  const double bounces = std::floor((unfolded + half) / (2.0 * half));
  const double turn = std::abs(bounces) * 4.0 * 0x1p-23 * (1.0 + rise * rise);
  const double place = std::abs(bounces) * kUnit * 0x1p-24 * (8.0 * std::sqrt(3.0) + 4.0 * std::abs(rise));
  const double at_end = place + turn * kLength * std::sqrt(1.0 + rise * rise) / 2.0;
  const double reading = turn * (kRuler - kLength) + 10.0 * 0x1p-24 * 2.0 * kRulerHalf;
  const double away = rise * (kRuler - kLength);
  const double sign = std::fmod(bounces, 2.0) == 0.0 ? 1.0 : -1.0;
  const double end = sign * (unfolded - bounces * 2.0 * half);
  if (half - std::abs(end) > at_end) return std::abs(mark - (end + sign * away)) / (at_end + reading);
  // Whether it bounces once more at the very end is up to rounding: up or down, from somewhere between the mirrors.
  return std::min(std::abs(mark - away), std::abs(mark + away)) / (half + at_end + reading);
}

}  // namespace

CaseResult run_light_trap(const CaseSetup& setup) {
  constexpr const char* kName = "light_trap";
  constexpr std::array<std::uint32_t, 3> kDepths = {64, 250, 1000};
  constexpr std::array<float, 3> kReflectances = {1.0f, 0.96875f, 0.75f};
  // In parts of what two roundings per bounce, of the weight and of the sum, and two at the ends may do.
  Tally tally("bounds", 1.0);
  for_each_picture(setup, kName, kSide, 9, [&](SampleRandom& random, std::uint64_t number) {
    const std::uint32_t depth = kDepths[number % 3];
    const float reflectance = kReflectances[number / 3 % 3];
    Material glowing = mirror(reflectance);
    glowing.emission = glm::vec3(1.0f);
    ImageScene made;
    // Wide enough for a thousand bounces of 1 m at 0.4 of a right angle.
    constexpr float kWide = 1024.0f;
    add_rectangle(made.scene, {-kWide, -kWide, -0.5f}, {2.0f * kWide, 0.0f, 0.0f}, {0.0f, 2.0f * kWide, 0.0f}, glowing);
    add_rectangle(made.scene, {-kWide, -kWide, 0.5f}, {0.0f, 2.0f * kWide, 0.0f}, {2.0f * kWide, 0.0f, 0.0f}, glowing);
    const glm::dvec3 aside = random.direction() * 0.25;
    made.camera = looking(glm::dvec3(0.0), {aside.x, aside.y, -1.0}, 0.5);
    RenderSettings settings = picture_settings(setup, kSide);
    settings.max_bounces = depth;
    Picture picture = render_picture(setup, made, settings);
    picture.number = number;
    const double expected = power_sum(reflectance, depth + 1.0);
    const double allowed = 2.0 * (depth + 1.0) * 0x1p-24 * expected;
    book_pixel_errors(tally, picture,
                      [&](std::size_t pixel) { return std::abs(picture.color(pixel).x - expected) / allowed; });
  });
  return tally.result();
}

CaseResult run_mirror_corridor(const CaseSetup& setup) {
  constexpr const char* kName = "mirror_corridor";
  Tally tally("bounds", 1.0);
  for_each_picture(setup, kName, kSide, 9, [&](SampleRandom& random, std::uint64_t number) {
    // Up to 60, 240 and 960 bounces.
    const double half = std::ldexp(1.0, -3 - 2 * static_cast<int>(number % 3));
    const ImageScene made = corridor_scene(random, half);
    RenderSettings settings = picture_settings(setup, kSide);
    settings.max_bounces = 1000;
    Picture picture = render_picture(setup, made, settings);
    picture.number = number;
    book_pixel_errors(tally, picture, [&](std::size_t pixel) {
      const double mark = (2.0 * picture.color(pixel).x - 1.0) * kRulerHalf;
      return corridor_error(pixel_ray(made.camera, picture, pixel), half, mark);
    });
  });
  return tally.result();
}

namespace {

/// The ruler of the corner: half its length, and where it stands along z.
constexpr float kCornerRulerHalf = 4.0f, kCornerRulerPlace = 3.0f;

/// Three mirrors that meet at the origin, seen from within. A ruler stands behind the eye, across z: the ray comes back
/// parallel to itself, mirrored at the corner.
ImageScene corner_scene(SampleRandom& random) {
  constexpr float kHalf = kCornerRulerHalf;
  ImageScene made;
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 u(0.0f), v(0.0f);
    u[(axis + 1) % 3] = v[(axis + 2) % 3] = 2.0f;
    add_rectangle(made.scene, glm::vec3(0.0f), u, v, mirror(1.0f));
  }
  add_rectangle(made.scene, {-kHalf, -kHalf, kCornerRulerPlace}, {0, 2 * kHalf, 0}, {2 * kHalf, 0, 0},
                unlit(glm::vec3(1.0f)));
  made.scene.meshes.back().colors = {{0, 0, 0, 1}, {0, 0, 0, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}};
  const glm::dvec3 eye(random.in(0.5, 1.0), random.in(0.5, 1.0), random.in(1.5, 2.5));
  made.camera = looking(eye, glm::dvec3(0.0), 0.5);
  return made;
}

/// Where on the ruler `ray` ends that went into the corner; none where it misses a mirror or the ruler, or passes their
/// rims too near to tell.
std::optional<double> corner_mark(const PixelRay& ray) {
  // Unfolded, the ray goes straight on through the corner's planes, each of which has to be met within its square.
  for (int axis = 0; axis < 3; ++axis) {
    const double t = -ray.origin[axis] / ray.direction[axis];
    const glm::dvec3 at = glm::abs(ray.origin + t * ray.direction);
    if (!(t > 0.0) || std::max({at.x, at.y, at.z}) > 1.999) return std::nullopt;
  }
  // A ray within 1e-4 of a seam of two mirrors may miss neither, but which comes first is up to rounding; both
  // orders end in the same place, so it counts.
  const double t = (-kCornerRulerPlace - ray.origin.z) / ray.direction.z;
  const double mark = -(ray.origin.x + t * ray.direction.x);
  const double aside = std::max(std::abs(mark), std::abs(ray.origin.y + t * ray.direction.y));
  return aside > 0.999 * kCornerRulerHalf ? std::nullopt : std::optional(mark);
}

}  // namespace

CaseResult run_corner_cube(const CaseSetup& setup) {
  constexpr const char* kName = "corner_cube";
  // Three bounces that each turn the direction by at most 4 ulp and move the ray by 8 steps of coordinates up to 4 m,
  // over at most 6 m of way; then the ruler's ten roundings of 1.
  const double bound =
      (3.0 * 8.0 * 4.0 * 0x1p-24 + 3.0 * 4.0 * 0x1p-23 * 6.0) / (2.0 * kCornerRulerHalf) + 10.0 * 0x1p-24;
  Tally tally("absolute", bound);
  std::uint64_t judged = 0;
  for_each_picture(setup, kName, kSide, 8, [&](SampleRandom& random, std::uint64_t number) {
    const ImageScene made = corner_scene(random);
    RenderSettings settings = picture_settings(setup, kSide);
    settings.max_bounces = 3;
    Picture picture = render_picture(setup, made, settings);
    picture.number = number;
    book_pixel_errors(tally, picture, [&](std::size_t pixel) {
      const std::optional<double> mark = corner_mark(pixel_ray(made.camera, picture, pixel));
      if (!mark) return 0.0;
      ++judged;
      return std::abs(picture.color(pixel).x - (*mark + kCornerRulerHalf) / (2.0 * kCornerRulerHalf));
    });
  });
  return if_judged(tally.result(), judged);
}

}  // namespace vernier
