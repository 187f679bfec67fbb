#include "render/plan_instances.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/render_constants.h"

namespace vernier {
namespace {

/// Copies of triangles that are made before meshes are shared: some 80 MB.
constexpr std::uint64_t kMostCopies = std::uint64_t{1} << 20;
/// Triangles that take the memory of an instance.
constexpr std::uint64_t kInstanceTriangles = 2;
/// Roundings may become that much larger.
constexpr double kMostSpread = 32.0;
/// An instance is no smaller beside the scene: squares of the ratio are far from the ends of floats.
constexpr double kLeastSize = 0x1p-40;

struct MeshUse {
  std::uint32_t mesh;
  std::uint64_t instances;
  std::uint64_t saved;  ///< triangles that sharing spares
};

TracedSpace mesh_space(const Mesh& mesh) {
  WorldBounds bounds;
  for (const glm::uvec3& triangle : mesh.triangles) {
    if (triangle == glm::uvec3(0)) continue;  // dropped
    for (int corner = 0; corner < 3; ++corner) {
      grow(bounds, glm::dvec3(mesh.positions[triangle[corner]]));
    }
  }
  return choose_traced_space(bounds);
}

double largest(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The longest side of an object of size 1 in the world.
double size_of(const glm::dmat4& m, const TracedSpace& space) {
  return space.metres_per_unit *
         std::max({largest(glm::dvec3(m[0])), largest(glm::dvec3(m[1])), largest(glm::dvec3(m[2]))});
}

/// How far the scene reaches at most.
double reach_of(const Scene& scene, const std::vector<TracedSpace>& spaces) {
  double reach = 0.0;
  for (const Instance& instance : scene.instances) {
    const TracedSpace& space = spaces[instance.mesh];
    const glm::dvec4 center = instance.world_from_object * glm::dvec4(space.center, 1.0);
    reach = std::max(reach, largest(glm::dvec3(center)) + 3.0 * size_of(instance.world_from_object, space));
  }
  return reach;
}

/// [instance] whether its transform may be left to floats.
std::vector<bool> can_be_shared(const Scene& scene, const std::vector<TracedSpace>& spaces) {
  const double reach = reach_of(scene, spaces);
  std::vector<bool> can;
  for (const Instance& instance : scene.instances) {
    const glm::dmat4& m = instance.world_from_object;
    can.push_back(rounding_spread(glm::dmat3(m)) <= kMostSpread &&
                  size_of(m, spaces[instance.mesh]) >= kLeastSize * reach);
  }
  return can;
}

std::vector<MeshUse> uses_of(const Scene& scene, const std::vector<bool>& can) {
  std::vector<MeshUse> uses(scene.meshes.size());
  for (std::uint32_t i = 0; i < scene.meshes.size(); ++i) uses[i] = {.mesh = i, .instances = 0, .saved = 0};
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    if (can[i]) ++uses[scene.instances[i].mesh].instances;
  }
  for (MeshUse& use : uses) {
    if (use.instances < 2) continue;
    const std::uint64_t copied = (use.instances - 1) * scene.meshes[use.mesh].triangles.size();
    use.saved = copied - std::min(copied, kInstanceTriangles * use.instances);
  }
  return uses;
}

/// [mesh] whether it is shared.
std::vector<bool> choose_meshes(const Scene& scene, std::vector<MeshUse> uses, Sharing sharing) {
  std::vector<bool> shared(scene.meshes.size(), false);
  if (sharing == Sharing::never) return shared;
  std::uint64_t copies = 0;
  for (const MeshUse& use : uses) copies += use.saved;
  std::ranges::stable_sort(uses, std::ranges::greater{}, &MeshUse::saved);
  for (const MeshUse& use : uses) {
    if (sharing == Sharing::always) {
      shared[use.mesh] = use.instances > 0 && !scene.meshes[use.mesh].triangles.empty();
    } else if (copies > kMostCopies && use.saved > 0) {
      shared[use.mesh] = true;
      copies -= use.saved;
    }
  }
  return shared;
}

}  // namespace

double rounding_spread(const glm::dmat3& m) {
  const glm::dmat3 inverse = glm::inverse(m);
  double most = 0.0;
  for (int row = 0; row < 3; ++row) {
    double sum = 0.0;
    for (int column = 0; column < 3; ++column) {
      for (int k = 0; k < 3; ++k) sum += std::abs(m[k][row]) * std::abs(inverse[column][k]);
    }
    // Written so that a NaN is the most.
    if (!(sum <= std::numeric_limits<double>::max())) return std::numeric_limits<double>::infinity();
    most = std::max(most, sum);
  }
  return most;
}

InstancePlan plan_instances(const Scene& scene, Sharing sharing) {
  std::vector<TracedSpace> spaces;
  for (const Mesh& mesh : scene.meshes) spaces.push_back(mesh_space(mesh));
  const std::vector<bool> can = can_be_shared(scene, spaces);
  const std::vector<bool> shared = choose_meshes(scene, uses_of(scene, can), sharing);
  InstancePlan plan;
  std::vector<std::uint32_t> place(scene.meshes.size(), NONE);
  const auto store = [&](const Mesh& mesh) {
    plan.stored_triangles += mesh.triangles.size();
    plan.stored_vertices += mesh.positions.size();
  };
  for (std::uint32_t i = 0; i < scene.meshes.size(); ++i) {
    if (!shared[i]) continue;
    place[i] = static_cast<std::uint32_t>(plan.meshes.size());
    plan.meshes.push_back(i);
    plan.spaces.push_back(spaces[i]);
    store(scene.meshes[i]);
  }
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const std::uint32_t mesh = scene.instances[i].mesh;
    plan.place.push_back(can[i] ? place[mesh] : NONE);
    plan.triangles += scene.meshes[mesh].triangles.size();
    if (plan.place.back() == NONE) store(scene.meshes[mesh]);
    plan.shared_instances += plan.place.back() == NONE ? 0 : 1;
  }
  return plan;
}

}  // namespace vernier
