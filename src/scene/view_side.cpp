#include "scene/view_side.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace vernier {
namespace {

// Pixels of a side: enough to tell a wall from a leaf.
constexpr int kPixels = 48;
// So that a hostile file of huge triangles takes no longer than a second.
constexpr std::size_t kMostTriangles = 1 << 16;
// The usual view may show this share of backs: leaves and open vessels do.
constexpr double kManyBacks = 0.25;
// A view into a room shows none but for odd furniture.
constexpr double kFewBacks = 0.1;
// Against views along a sheet, which show neither side.
constexpr double kEnoughOfUsual = 0.5;
constexpr std::array<glm::dvec3, 4> kOtherSides{{{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}}};

struct Pixel {
  double depth = -std::numeric_limits<double>::infinity();
  bool back = false;
};

// Pixels from the lower left; z towards the eye.
struct View {
  glm::dvec3 middle;
  glm::dmat3 axes;
  double scale;
  std::vector<Pixel> pixels;
};

View view_from(const WorldBounds& bounds, const glm::dvec3& side) {
  const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), side));
  const double diagonal = glm::length(bounds.hi - bounds.lo);
  return {0.5 * bounds.lo + 0.5 * bounds.hi, glm::dmat3(x, glm::cross(side, x), side), kPixels / diagonal,
          std::vector<Pixel>(kPixels * kPixels)};
}

// In pixels, the middle of the scene in the middle of the picture.
glm::dvec3 project(const View& view, const glm::dvec3& point) {
  return glm::transpose(view.axes) * (point - view.middle) * view.scale + glm::dvec3(0.5 * kPixels, 0.5 * kPixels, 0.0);
}

double cross_2d(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

int first_pixel(double low) {
  return static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, double(kPixels)));
}

int end_pixel(double high) {
  return static_cast<int>(std::clamp(std::floor(high - 0.5) + 1.0, 0.0, double(kPixels)));
}

void draw(View& view, const std::array<glm::dvec3, 3>& p, bool mirrored) {
  const glm::dvec2 a(p[0]), b(p[1]), c(p[2]);
  const double area = cross_2d(b - a, c - a);
  // Edge-on, or not a number.
  if (!(std::abs(area) > 0.0)) return;
  const glm::dvec2 lo = glm::min(a, glm::min(b, c));
  const glm::dvec2 hi = glm::max(a, glm::max(b, c));
  for (int y = first_pixel(lo.y); y < end_pixel(hi.y); ++y) {
    for (int x = first_pixel(lo.x); x < end_pixel(hi.x); ++x) {
      const glm::dvec2 centre(x + 0.5, y + 0.5);
      const double w1 = cross_2d(centre - a, c - a) / area;
      const double w2 = cross_2d(b - a, centre - a) / area;
      if (!(w1 >= 0.0 && w2 >= 0.0 && w1 + w2 <= 1.0)) continue;
      const double depth = p[0].z + w1 * (p[1].z - p[0].z) + w2 * (p[2].z - p[0].z);
      Pixel& pixel = view.pixels[static_cast<std::size_t>(y * kPixels + x)];
      if (depth > pixel.depth) pixel = {depth, (area < 0.0) != mirrored};
    }
  }
}

std::size_t triangle_count(const Scene& scene) {
  std::size_t count = 0;
  for (const Instance& instance : scene.instances) count += scene.meshes[instance.mesh].triangles.size();
  return count;
}

SideView shares_of(const std::vector<Pixel>& pixels) {
  const auto covered = std::ranges::count_if(pixels, [](const Pixel& pixel) { return std::isfinite(pixel.depth); });
  const auto backs = std::ranges::count_if(pixels, &Pixel::back);
  return {double(covered) / double(pixels.size()), covered == 0 ? 0.0 : double(backs) / double(covered)};
}

}  // namespace

SideView look_from(const Scene& scene, const WorldBounds& bounds, const glm::dvec3& side) {
  if (!(glm::length(bounds.hi - bounds.lo) > 0.0)) return {0.0, 0.0};
  View view = view_from(bounds, side);
  const std::size_t stride = 1 + triangle_count(scene) / kMostTriangles;
  std::size_t number = 0;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const bool mirrored = glm::determinant(glm::dmat3(instance.world_from_object)) < 0.0;
    // As if all triangles were counted, every stride-th is looked at.
    std::size_t i = (stride - number % stride) % stride;
    number += mesh.triangles.size();
    for (; i < mesh.triangles.size(); i += stride) {
      const glm::uvec3& triangle = mesh.triangles[i];
      std::array<glm::dvec3, 3> corners;
      for (int c = 0; c < 3; ++c) {
        const glm::dvec4 corner(mesh.positions[triangle[c]], 1.0);
        corners[static_cast<std::size_t>(c)] = project(view, glm::dvec3(instance.world_from_object * corner));
      }
      draw(view, corners, mirrored);
    }
  }
  return shares_of(view.pixels);
}

glm::dvec3 choose_view_side(const Scene& scene, const WorldBounds& bounds, const glm::dvec3& usual) {
  const SideView usual_view = look_from(scene, bounds, usual);
  if (usual_view.backs <= kManyBacks) return usual;
  for (const glm::dvec3& side : kOtherSides) {
    const SideView view = look_from(scene, bounds, side);
    if (view.backs <= kFewBacks && view.covered >= kEnoughOfUsual * usual_view.covered) return side;
  }
  return usual;
}

}  // namespace vernier
