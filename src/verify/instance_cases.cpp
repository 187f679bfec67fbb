#include <algorithm>
#include <cmath>
#include <cstring>

#include "shared/instance_layout.h"
#include "verify/image_cases.h"
#include "verify/image_scenes.h"
#include "verify/ray_suite.h"
#include "verify/wide_oracle.h"

namespace vernier {
namespace {

using Corners = std::array<LongPoint, 3>;

/// An instance as it is traced, and where its corners are without rounding.
struct PlacedMesh {
  RayScene scene;
  std::vector<Corners> corners;
  double corner_error;  ///< of a traced coordinate, as baking in double and rounding to float make it
};

/// Scales of 1e-1.5 to 1e1.5 per axis, every fourth time of 1e-4 to 1e4, with either sign; a shear; a move of 1e6. With
/// the mesh in whatever position before, unless it is to be shared: along its own axes roundings do not spread.
glm::dmat4 random_transform(SampleRandom& random, Sharing sharing) {
  const double range = random.below(4) == 0 ? 4.0 : 1.5;
  glm::dvec3 scale(random.power_of_ten(-range, range), random.power_of_ten(-range, range),
                   random.power_of_ten(-range, range));
  for (int i = 0; i < 3; ++i) scale[i] = random.below(2) == 0 ? scale[i] : -scale[i];
  glm::dmat4 shear(1.0);
  shear[1].x = random.in(-1.0, 1.0);
  glm::dmat4 transform = rotation(random);
  transform *= sharing == Sharing::always ? shear * scaling(scale) : scaling(scale) * shear * rotation(random);
  if (random.below(2) == 0) transform[3] = glm::dvec4(random.direction() * 1e6, 1.0);
  return transform;
}

/// Bound of how far rays meet a shared mesh from where it lies: its corners are rounded in its own space, the map in
/// its numbers, and rays that begin up to 4 away go through that (shaders/instance.glsl).
double map_error(const PackedScene& packed) {
  constexpr double kReach = 5.0, kRoundings = 6.0;
  DeviceInstance instance;
  std::memcpy(&instance, packed.instances.data() + sizeof(instance) / 4, sizeof(instance));
  const glm::dvec4 in[3] = {instance.object_from_traced_x, instance.object_from_traced_y,
                            instance.object_from_traced_z};
  double most = 0.0;
  for (const glm::dvec4 out :
       {instance.traced_from_object_x, instance.traced_from_object_y, instance.traced_from_object_z}) {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
      const double size = kReach * (std::abs(in[i].x) + std::abs(in[i].y) + std::abs(in[i].z)) + std::abs(in[i].w);
      sum += std::abs(out[i]) * (1.0 + kRoundings * size) * 0x1p-24;
    }
    most = std::max(most, sum);
  }
  return most;
}

PlacedMesh placed_mesh(const CaseSetup& setup, SampleRandom& random, Sharing sharing) {
  using LongMatrix = glm::mat<4, 4, long double>;
  Scene scene;
  const VerifyMesh mesh = sphere_mesh(8, 6, 0.8, 1.0, random);
  const glm::dmat4 transform = random_transform(random, sharing);
  add_object(scene, mesh, matte(glm::vec3(1.0f)), transform);
  PackedScene packed = pack_scene(scene, 0, BuildMethod::standard, sharing);
  const TracedSpace space = packed.space;
  const auto traced = [&](std::uint32_t i) {
    const auto world = LongMatrix(transform) * glm::vec<4, long double>(glm::vec<3, long double>(mesh.positions[i]), 1);
    return (LongPoint(world) - LongPoint(space.center)) / static_cast<long double>(space.metres_per_unit);
  };
  std::vector<Corners> corners;
  for (const glm::uvec3& t : mesh.triangles) corners.push_back({traced(t.x), traced(t.y), traced(t.z)});
  // Half a step of float at 1; and in double three products and four sums of up to the move's size.
  const double farthest = glm::length(glm::dvec3(transform[3])) + space.metres_per_unit;
  double corner_error = 0x1p-25 + 8.0 * 0x1p-53 * farthest / space.metres_per_unit;
  if (packed.bvh.instance_count > 0) corner_error += map_error(packed);
  return {RayScene(*setup.device, std::move(packed), setup.traversal), std::move(corners), corner_error};
}

glm::dvec3 point_of(SampleRandom& random, const Corners& corners) {
  const double u = random.below(4) == 0 ? 0.0 : random.unit(), v = random.unit() * (1.0 - u);
  const glm::dvec3 v0(corners[0]), v1(corners[1]), v2(corners[2]);
  return v0 + (v1 - v0) * u + (v2 - v0) * v;
}

/// What rounding may do to a crossing: to its weights and to t.
struct Band {
  double weight, t;
};

/// Corners are off by corner_error, and come into the ray's frame with up to 16 roundings of their distance; weights
/// are counted in the triangle's height as the ray sees it, t in the cosine to the normal.
Band band_of(const PlacedMesh& placed, const RayQuery& query, const Corners& corners, double cosine) {
  const glm::dvec3 v0(corners[0]), v1(corners[1]), v2(corners[2]), origin = query.origin;
  const double distance = std::max({glm::length(v0 - origin), glm::length(v1 - origin), glm::length(v2 - origin)});
  const double longest = std::max({glm::length(v1 - v0), glm::length(v2 - v1), glm::length(v0 - v2)});
  const double area = glm::length(glm::cross(v1 - v0, v2 - v0));
  const double off = std::sqrt(3.0) * placed.corner_error + 16.0 * 0x1p-24 * distance;
  // A corner that is off turns the triangle too: by its share of the least height.
  const double height = area / longest;
  const double turned = height > 2.0 * off ? cosine - 2.0 * off / height : 0.0;
  if (!(turned > 0.0)) return {1e300, 1e300};
  return {2.0 * off * longest / (area * turned), 2.0 * off / turned / glm::length(glm::dvec3(query.direction))};
}

/// Whether `triangle` may be the answer: nothing that is surely hit lies surely nearer, and the ray does not surely
/// miss it.
bool may_be_hit(const PlacedMesh& placed, const RayQuery& query, std::uint32_t triangle) {
  double sure = 1e300;  // the farthest that the nearest sure hit can be
  double least = 1e300;
  for (std::uint32_t i = 0; i < placed.corners.size(); ++i) {
    const WideCrossing crossing = wide_crossing(query, placed.corners[i]);
    const Band band = band_of(placed, query, placed.corners[i], crossing.cosine);
    if (i == triangle) {
      if (crossing.nearest_edge < -band.weight) return false;
      least = crossing.t - band.t;
    }
    if (crossing.nearest_edge > band.weight && crossing.t > band.t) sure = std::min(sure, crossing.t + band.t);
  }
  return triangle == NONE ? sure == 1e300 : least <= sure;
}

/// Whether `normal` is that of the triangle, but for what corners that are off turn it by: their share of the least
/// height.
bool is_normal_of(const PlacedMesh& placed, std::uint32_t triangle, const glm::dvec3& normal) {
  const Corners& corners = placed.corners[triangle];
  const glm::dvec3 v0(corners[0]), v1(corners[1]), v2(corners[2]);
  const glm::dvec3 cross = glm::cross(v1 - v0, v2 - v0);
  const double longest = std::max({glm::length(v1 - v0), glm::length(v2 - v1), glm::length(v0 - v2)});
  const double height = glm::length(cross) / longest;
  // Its own rounding: two products, sums and the scaling to 1.
  constexpr double kRounding = 8.0 * 0x1p-24;
  const double turned = 4.0 * std::sqrt(3.0) * placed.corner_error / height + kRounding;
  return turned > 0.5 || glm::length(glm::cross(normal, glm::normalize(cross))) <= turned;
}

CaseResult placed_meshes_case(const CaseSetup& setup, const char* name, Sharing sharing) {
  constexpr std::uint32_t kMeshes = 16;
  constexpr std::uint64_t kRaysPerMesh = 256;
  const std::uint64_t count = std::min<std::uint64_t>(setup.sample_count, 1u << 15);  // the oracle tests every triangle
  SampleRandom numbers = mesh_random(setup, name, 0);
  std::vector<PlacedMesh> meshes;
  for (std::uint32_t i = 0; i < kMeshes; ++i) meshes.push_back(placed_mesh(setup, numbers, sharing));
  RayKernel kernel(setup, VERIFY_RESPAWN);
  Tally tally;
  for (std::uint64_t first = 0; first < count; first += kRaysPerMesh) {
    const PlacedMesh& placed = meshes[first / kRaysPerMesh % kMeshes];
    std::vector<RayQuery> queries;
    for (std::uint64_t i = first; i < std::min(first + kRaysPerMesh, count); ++i) {
      SampleRandom random(setup.seed, name, i);
      const auto triangles = static_cast<std::uint32_t>(placed.corners.size());
      const glm::dvec3 aim = point_of(random, placed.corners[random.below(triangles)]);
      const glm::vec3 origin(aim + random.direction() * random.power_of_ten(-2.0, 0.5));
      queries.push_back(ray_query(origin, glm::vec3(aim - glm::dvec3(origin))));
      queries.back().outgoing = glm::vec3(random.direction());
    }
    const std::vector<RayAnswer> answers = kernel.trace(placed.scene, queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const bool hits_itself = answers[i].triangle != NONE && answers[i].next_triangle == answers[i].triangle;
      const bool right_normal =
          answers[i].triangle == NONE || is_normal_of(placed, answers[i].triangle, answers[i].normal);
      const bool held = answers[i].finished == 1 && !hits_itself && right_normal &&
                        may_be_hit(placed, queries[i], answers[i].triangle);
      tally.book(held, [&] {
        return "mesh " + std::to_string(first / kRaysPerMesh % kMeshes) + " " + ray_inputs(queries[i]) +
               " hit=" + std::to_string(answers[i].triangle) + " " + hex_floats({{"t", answers[i].t}}) +
               " next=" + std::to_string(answers[i].next_triangle);
      });
    }
  }
  return tally.result();
}

}  // namespace

CaseResult run_instance_transform(const CaseSetup& setup) {
  return placed_meshes_case(setup, "instance_transform", Sharing::never);
}

CaseResult run_instance_shared(const CaseSetup& setup) {
  if (setup.traversal == TraversalForm::ray_query) {
    CaseResult result;
    result.not_run = "with ray queries every mesh is copied";
    return result;
  }
  return placed_meshes_case(setup, "instance_shared", Sharing::always);
}

}  // namespace vernier
