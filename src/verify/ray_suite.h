#pragma once

#include <functional>
#include <vector>

#include "verify/random.h"
#include "verify/ray_kernel.h"
#include "verify/tally.h"
#include "verify/verify_mesh.h"

namespace vernier {

/// A scene to shoot at, or what a case makes of it.
struct Target {
  VerifyMesh mesh;    ///< as it is traced
  glm::dvec3 center;  ///< rays start around it
  double radius;      ///< at most that far from it
};

/// What a ray is aimed at.
enum class Aim { anywhere, edge, near_vertex, vertex, axis };

/// Which of them sample after sample: 30 % anywhere, 30 % edges, 20 % vertices, 10 % along axes on planes of vertices,
/// 10 % points of edges so near to a vertex that rounding decides.
Aim mixed_aim(SampleRandom& random);

/// A ray from the target's inside at what `aim` says, each component of its direction off by up to two steps.
RayQuery aimed_ray(SampleRandom& random, const Target& target, Aim aim);

/// A ray to a corner of one of the target's triangles, nearly in its plane: by a cosine of 2^-4 to 2^-12.
RayQuery grazing_ray(SampleRandom& random, const Target& target);

/// Random numbers for mesh number `mesh` of a case: apart from those of all samples.
SampleRandom mesh_random(const CaseSetup& setup, const char* name, std::uint32_t mesh);

/// Makes the ray of a sample that goes to target number `target`.
using MakeRay = std::function<RayQuery(SampleRandom& random, std::uint32_t target)>;
/// Books a finished answer.
using JudgeRay = std::function<void(const RayQuery& query, const RayAnswer& answer, std::uint32_t target)>;

/// Samples that go to the same target one after the other; then it is the next one's turn.
constexpr std::uint64_t kSamplesPerTarget = 1024;

/// Traces setup.sample_count rays with VERIFY_* `function` and lets `judge` book each answer. A search that was cut off
/// is booked as a failure and not judged. `name` is the case's.
void trace_samples(const CaseSetup& setup, const char* name, std::uint32_t function,
                   const std::vector<RayScene>& scenes, Tally& tally, const MakeRay& make, const JudgeRay& judge);

/// `meshes` on the device of `setup`.
std::vector<RayScene> scenes_of(const CaseSetup& setup, const std::vector<VerifyMesh>& meshes);

/// The same of what has a mesh: targets, stacks of squares.
template <typename WithMesh>
std::vector<RayScene> scenes_of(const CaseSetup& setup, const std::vector<WithMesh>& each_with_mesh) {
  std::vector<VerifyMesh> meshes;
  for (const WithMesh& one : each_with_mesh) meshes.push_back(one.mesh);
  return scenes_of(setup, meshes);
}

/// Whether two searches came to their end at the same hit, bit for bit, or both at none.
bool same_hit(const RayAnswer& a, const RayAnswer& b);

/// `result` with a failure more where fewer than half of its samples could be judged: a case that judges nothing shows
/// nothing.
CaseResult if_judged(CaseResult result, std::uint64_t judged);

/// Every ray from inside closed targets must hit something.
CaseResult closed_targets_case(const CaseSetup& setup, const char* name, const std::vector<Target>& targets,
                               const std::function<Aim(SampleRandom&)>& aim);

/// The same rays against each triangle of targets[i] alone: traverse_bvh must find the same hit, bit for bit. `steps`
/// gets the nodes and triangles of every search, if given.
CaseResult against_every_triangle(const CaseSetup& setup, const char* name, const std::vector<VerifyMesh>& meshes,
                                  const MakeRay& make, std::vector<std::uint32_t>* steps = nullptr);

}  // namespace vernier
