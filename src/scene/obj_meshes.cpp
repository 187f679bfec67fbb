#include "scene/obj_meshes.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "image/srgb_curve.h"
#include "scene/obj_smooth_normals.h"

namespace vernier {
namespace {

// A middle this many extents away costs 3 of the 24 bits of a float; nearer files keep their coordinates as they are.
constexpr double kFarExtents = 8.0;

// What makes two corners one vertex. normal: the file's from 0, -1 flat, a smoothing group g as -1 - g.
struct VertexKey {
  int position;
  int uv;
  std::int64_t normal;
  bool operator==(const VertexKey&) const = default;
};

struct VertexKeyHash {
  std::size_t operator()(const VertexKey& key) const {
    constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15u;  // golden ratio, spreads neighbouring numbers
    std::uint64_t h = static_cast<std::uint32_t>(key.position) * kOdd;
    h = (h ^ (h >> 29) ^ static_cast<std::uint32_t>(key.uv)) * kOdd;
    h = (h ^ (h >> 29) ^ static_cast<std::uint64_t>(key.normal)) * kOdd;
    return h ^ (h >> 32);
  }
};

glm::vec3 unit_normal(const glm::dvec3& normal) {
  const double size = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  if (!(size > 0.0) || !std::isfinite(size)) return glm::vec3(0.0f);
  return glm::vec3(glm::normalize(normal / size));
}

class MeshBuilder {
 public:
  MeshBuilder(const ObjGeometry& geometry, const SmoothNormals& smooth, const glm::dvec3& origin)
      : geometry_(geometry), smooth_(smooth), origin_(origin) {}

  Mesh build(const ObjShape& shape, const std::vector<std::uint32_t>& material_of_name, std::uint32_t no_material) {
    start(shape);
    for (const ObjTriangle& triangle : shape.triangles) {
      glm::uvec3 indices;
      for (int i = 0; i < 3; ++i) {
        indices[i] = vertex(triangle.corners[static_cast<std::size_t>(i)], triangle.smoothing_group);
      }
      mesh_.triangles.push_back(indices);
      const auto name = static_cast<std::size_t>(triangle.material);
      mesh_.triangle_materials.push_back(triangle.material < 0 ? no_material : material_of_name[name]);
    }
    return std::move(mesh_);
  }

 private:
  void start(const ObjShape& shape) {
    mesh_ = Mesh{};
    mesh_.name = shape.name;
    vertex_by_key_.clear();
    has_uvs_ = false;
    has_normals_ = false;
    for (const ObjTriangle& triangle : shape.triangles) {
      for (const ObjCorner& corner : triangle.corners) {
        has_uvs_ |= corner.uv >= 0;
        has_normals_ |= corner.normal >= 0 || triangle.smoothing_group != 0;
      }
    }
    mesh_.triangles.reserve(shape.triangles.size());
    mesh_.triangle_materials.reserve(shape.triangles.size());
    vertex_by_key_.reserve(shape.triangles.size());
  }

  std::uint32_t vertex(const ObjCorner& corner, std::uint32_t group) {
    const std::int64_t normal = corner.normal >= 0 ? corner.normal : -1 - std::int64_t{group};
    const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto [found, is_new] = vertex_by_key_.try_emplace({corner.position, corner.uv, normal}, next);
    if (is_new) add_vertex(corner, group);
    return found->second;
  }

  void add_vertex(const ObjCorner& corner, std::uint32_t group) {
    const auto position = static_cast<std::size_t>(corner.position);
    mesh_.positions.emplace_back(geometry_.positions[position] - origin_);
    if (has_normals_) mesh_.normals.push_back(normal_of(corner, group));
    if (has_uvs_) {
      const glm::dvec2 uv = corner.uv < 0 ? glm::dvec2(0.0, 1.0) : geometry_.uvs[static_cast<std::size_t>(corner.uv)];
      mesh_.uvs[0].emplace_back(uv.x, 1.0 - uv.y);
    }
    if (geometry_.colors.empty()) return;
    glm::vec4 color(1.0f);
    for (int c = 0; c < 3; ++c) color[c] = float(linear_from_srgb(std::max(geometry_.colors[position][c], 0.0)));
    mesh_.colors.push_back(color);
  }

  glm::vec3 normal_of(const ObjCorner& corner, std::uint32_t group) const {
    if (corner.normal >= 0) return unit_normal(geometry_.normals[static_cast<std::size_t>(corner.normal)]);
    if (group == 0) return glm::vec3(0.0f);
    return glm::vec3(smooth_.at(smooth_normal_key(corner.position, group)));
  }

  const ObjGeometry& geometry_;
  const SmoothNormals& smooth_;
  glm::dvec3 origin_;
  Mesh mesh_;
  std::unordered_map<VertexKey, std::uint32_t, VertexKeyHash> vertex_by_key_;
  bool has_uvs_ = false;
  bool has_normals_ = false;
};

bool is_finite(const glm::dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

glm::dvec3 object_origin(const ObjGeometry& geometry) {
  glm::dvec3 lo(std::numeric_limits<double>::infinity());
  glm::dvec3 hi(-lo);
  for (const ObjShape& shape : geometry.shapes) {
    for (const ObjTriangle& triangle : shape.triangles) {
      for (const ObjCorner& corner : triangle.corners) {
        const glm::dvec3& p = geometry.positions[static_cast<std::size_t>(corner.position)];
        if (!is_finite(p)) continue;
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
      }
    }
  }
  glm::dvec3 origin(0.0);
  const glm::dvec3 size = hi - lo;
  const double extent = std::max({size.x, size.y, size.z});
  if (!(extent > 0.0) || !std::isfinite(extent)) return origin;
  // A coarse grid keeps the subtraction exact for coordinates of a file with ordinary digits.
  const double grid = std::exp2(std::ceil(std::log2(extent)));
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = 0.5 * lo[axis] + 0.5 * hi[axis];
    if (std::abs(middle) > kFarExtents * extent) origin[axis] = std::round(middle / grid) * grid;
  }
  return origin;
}

void add_obj_meshes(Scene& scene, const ObjGeometry& geometry, const std::vector<std::uint32_t>& material_of_name,
                    std::uint32_t no_material) {
  const glm::dvec3 origin = object_origin(geometry);
  const SmoothNormals smooth = smooth_normals(geometry);
  MeshBuilder builder(geometry, smooth, origin);
  for (const ObjShape& shape : geometry.shapes) {
    Instance instance;
    instance.name = shape.name;
    instance.mesh = static_cast<std::uint32_t>(scene.meshes.size());
    instance.world_from_object[3] = glm::dvec4(origin, 1.0);
    scene.meshes.push_back(builder.build(shape, material_of_name, no_material));
    scene.instances.push_back(std::move(instance));
  }
}

}  // namespace vernier
