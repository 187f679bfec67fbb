#include <algorithm>
#include <cmath>

#include "verify/image_cases.h"
#include "verify/picture.h"
#include "verify/ray_suite.h"

namespace vernier {
namespace {

constexpr int kSide = 64;

/// The plane of a triangle of a convex body: dot(normal, p) = offset, the normal outwards.
struct Plane {
  glm::dvec3 normal;
  double offset;
};

std::vector<Plane> planes_of(const VerifyMesh& mesh, const glm::dmat4& world_from_object) {
  std::vector<Plane> planes;
  for (const glm::uvec3& t : mesh.triangles) {
    const auto at = [&](std::uint32_t i) { return glm::dvec3(world_from_object * glm::dvec4(mesh.positions[i], 1.0)); };
    const glm::dvec3 normal = glm::normalize(glm::cross(at(t.y) - at(t.x), at(t.z) - at(t.x)));
    planes.push_back({normal, glm::dot(normal, at(t.x))});
  }
  return planes;
}

/// Unpolarised reflectance from where the index is `n` times the other side's inverse: n = ior from outside, 1 / ior
/// from inside (Born and Wolf 1999, Principles of Optics, section 1.5.2).
double fresnel(double cosine, double n) {
  const double square = 1.0 - (1.0 - cosine * cosine) / (n * n);
  if (square <= 0.0) return 1.0;
  const double inside = std::sqrt(square);
  const double s = (cosine - n * inside) / (cosine + n * inside), p = (n * cosine - inside) / (n * cosine + inside);
  return (s * s + p * p) / 2.0;
}

/// The share of a ray's light that still goes round inside a convex body of glass after `bounces`: what a picture of a
/// world of radiance 1 lacks.
double light_inside(const std::vector<Plane>& planes, const PixelRay& ray, double ior, std::uint32_t bounces) {
  double entry = -1e300, exit = 1e300;
  glm::dvec3 normal(0.0);
  for (const Plane& plane : planes) {
    const double slope = glm::dot(plane.normal, ray.direction);
    const double t = (plane.offset - glm::dot(plane.normal, ray.origin)) / slope;
    if (slope > 0.0) exit = std::min(exit, t);
    if (slope < 0.0 && t > entry) {
      entry = t;
      normal = plane.normal;
    }
  }
  if (entry >= exit || entry < 0.0) return 0.0;
  const double cosine = -glm::dot(normal, ray.direction);
  double left = 1.0 - fresnel(cosine, ior);
  glm::dvec3 place = ray.origin + entry * ray.direction, way = glm::refract(ray.direction, normal, 1.0 / ior);
  for (std::uint32_t depth = 1; depth <= bounces; ++depth) {
    double nearest = 1e300;
    for (const Plane& plane : planes) {
      const double slope = glm::dot(plane.normal, way);
      if (slope <= 0.0) continue;
      const double t = (plane.offset - glm::dot(plane.normal, place)) / slope;
      if (t < nearest) {
        nearest = t;
        normal = plane.normal;
      }
    }
    left *= fresnel(glm::dot(normal, way), 1.0 / ior);
    place += nearest * way;
    way = glm::reflect(way, normal);
  }
  return left;
}

/// A crossing of a straight ray with a box of glass.
struct BoxCrossing {
  double t;
  double absorption_behind;  ///< of the box where it is entered, 0 where it is left
};

/// A box of absorbing matter that bends nothing.
struct DyedBox {
  glm::vec3 lo, hi;
  float absorption;  ///< per metre
};

/// Adds where the ray crosses `box`, if it does.
void add_crossings(const DyedBox& box, const PixelRay& ray, std::vector<BoxCrossing>& crossings) {
  double entry = 0.0, exit = 1e300;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.lo[axis] - ray.origin[axis]) / ray.direction[axis];
    const double b = (box.hi[axis] - ray.origin[axis]) / ray.direction[axis];
    entry = std::max(entry, std::min(a, b));
    exit = std::min(exit, std::max(a, b));
  }
  if (entry >= exit) return;
  crossings.push_back({entry, box.absorption});
  crossings.push_back({exit, 0.0});
}

/// Least and largest light that gets through.
struct LightRange {
  double least, most;
};

/// What gets through `boxes` on the ray when the last crossing names the medium, as README, Limits, has it. Where faces
/// coincide any of them may be the last.
LightRange light_through(const std::vector<DyedBox>& boxes, const PixelRay& ray) {
  // Far above the offset that a ray starts with, 8 steps of 2^-24 of some metres, and far below a box.
  constexpr double kTogether = 1e-5;
  std::vector<BoxCrossing> crossings;
  for (const DyedBox& box : boxes) add_crossings(box, ray, crossings);
  std::ranges::sort(crossings, {}, &BoxCrossing::t);
  double least = 0.0, most = 0.0;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    double low = crossings[i].absorption_behind, high = low;
    for (std::size_t j = i; j-- > 0 && crossings[i].t - crossings[j].t < kTogether;) {
      low = std::min(low, crossings[j].absorption_behind);
      high = std::max(high, crossings[j].absorption_behind);
    }
    const double length = crossings[i + 1].t - crossings[i].t;
    least += low * length;
    most += high * length;
  }
  return {std::exp(-most), std::exp(-least)};
}

/// Boxes one in the other, overlapping, and face to face.
std::vector<DyedBox> random_boxes(SampleRandom& random) {
  const auto step = [&](int lo, int hi) {
    return static_cast<float>(lo + static_cast<int>(random.below(static_cast<std::uint32_t>(hi - lo)))) / 16.0f;
  };
  const float face = step(8, 20), inner = step(2, 7), edge = step(0, 8);
  return {{glm::vec3(-1.0f), {face, 1.0f, 1.0f}, 0.125f},                      // glass
          {glm::vec3(-inner), glm::vec3(inner), 0.5f},                         // a drop of water in it
          {{face, -1.0f, -1.0f}, {face + 1.0f, 1.0f, 0.75f}, 0.25f},           // against it, two edges in common
          {glm::vec3(edge, edge, -0.25f), {face + 0.5f, 1.5f, 0.25f}, 1.0f}};  // across both
}

}  // namespace

CaseResult run_white_furnace(const CaseSetup& setup) {
  constexpr const char* kName = "white_furnace";
  constexpr std::uint32_t kBounces = 64;
  constexpr double kLeastKnown = 1e-6;
  // Reflected and transmitted power make 1 within the level's bound, and what a ray still carries falls from hit to hit
  // as fast as light leaves: two such errors in all. Each of up to 64 products of weights is rounded twice.
  const double power_bound = setup.level == Accuracy::exact ? 1e-7 : 1e-6;
  Tally tally("absolute", 2.0 * power_bound + kBounces * 0x1p-23);
  std::uint64_t judged = 0;
  for_each_picture(setup, kName, kSide, 16, [&](SampleRandom& random, std::uint64_t number) {
    const VerifyMesh body =
        number % 2 == 0 ? box_mesh(glm::vec3(-1.0f), glm::vec3(1.0f)) : sphere_mesh(16, 12, 1.25, 1.25, random);
    const glm::dmat4 turn = rotation(random);
    ImageScene made;
    add_object(made.scene, body, clear_glass(1.5f), turn);
    surround(made.scene, glm::vec3(1.0f));
    made.camera = looking(random.direction() * 5.0, glm::dvec3(0.0), 0.5);
    RenderSettings settings = picture_settings(setup, kSide);
    settings.max_bounces = kBounces;
    Picture picture = render_picture(setup, made, settings);
    picture.number = number;
    const std::vector<Plane> planes = planes_of(body, turn);
    book_pixel_errors(tally, picture, [&](std::size_t pixel) {
      double left = 0.0;
      for (const PixelRay& ray : nearby_rays(pixel_ray(made.camera, picture, pixel), 1e-6)) {
        left = std::max(left, light_inside(planes, ray, 1.5, kBounces / 2));
      }
      // What is inside at the last bounce is lost by the cap: where it is much, the pixel says nothing. A path that
      // rounding turns aside at an edge has the second half of its bounces to lose as much as the double one does.
      if (left > kLeastKnown) return 0.0;
      ++judged;
      const glm::vec3 color = picture.color(pixel);
      return std::max({std::abs(color.x - 1.0), std::abs(color.y - 1.0), std::abs(color.z - 1.0)});
    });
  });
  return if_judged(tally.result(), judged);
}

CaseResult run_nested_dielectrics(const CaseSetup& setup) {
  constexpr const char* kName = "nested_dielectrics";
  // Distances of up to 4 m are known within 2^-20 of them, the largest absorption is 1 per metre, and exp() is
  // right to 10 ulp there.
  constexpr double kBound = 4.0 * 0x1p-20 + 10.0 * 0x1p-24;
  Tally tally("absolute", kBound);
  for_each_picture(setup, kName, kSide, 8, [&](SampleRandom& random, std::uint64_t number) {
    const std::vector<DyedBox> boxes = random_boxes(random);
    ImageScene made;
    for (const DyedBox& box : boxes) {
      Material dyed = clear_glass(1.0f);
      dyed.absorption = glm::vec3(box.absorption);
      add_object(made.scene, box_mesh(box.lo, box.hi), dyed);
    }
    surround(made.scene, glm::vec3(1.0f));
    made.camera = looking(random.direction() * 6.0, glm::dvec3(0.5, 0.0, 0.0), 0.6);
    RenderSettings settings = picture_settings(setup, kSide);
    settings.max_bounces = 16;
    Picture picture = render_picture(setup, made, settings);
    picture.number = number;
    book_pixel_errors(tally, picture, [&](std::size_t pixel) {
      LightRange range{1.0, 0.0};
      for (const PixelRay& ray : nearby_rays(pixel_ray(made.camera, picture, pixel), 1e-6)) {
        const LightRange one = light_through(boxes, ray);
        range = {std::min(range.least, one.least), std::max(range.most, one.most)};
      }
      const double value = picture.color(pixel).x;
      return std::max({0.0, value - range.most, range.least - value});
    });
  });
  return tally.result();
}

}  // namespace vernier
