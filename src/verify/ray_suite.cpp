#include "verify/ray_suite.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace vernier {
namespace {

float stepped_up_to_two(SampleRandom& random, float value) {
  constexpr std::uint32_t kSteps = 5;
  return SampleRandom::stepped(value, static_cast<int>(random.below(kSteps)) - 2);
}

glm::vec3 aim_at_edge(SampleRandom& random, const VerifyMesh& mesh, Aim aim) {
  const glm::uvec3& t = mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
  const auto corner = static_cast<int>(random.below(3));
  const glm::dvec3 a = mesh.positions[t[corner]];
  if (aim == Aim::vertex) return a;
  const glm::dvec3 b = mesh.positions[t[(corner + 1) % 3]];
  // Weights down to 2^-30 are below a step of the vertex's own coordinates.
  const double weight = aim == Aim::edge ? random.unit() : std::exp2(random.in(-30.0, -10.0));
  return glm::vec3(a + (b - a) * weight);
}

/// From a point on the planes of a vertex's coordinates along an axis, with zeros of either sign.
RayQuery axis_ray(SampleRandom& random, const Target& target) {
  const auto axis = static_cast<int>(random.below(3));
  glm::vec3 origin = glm::vec3(target.center + random.direction() * (target.radius * random.unit()));
  const glm::vec3 aim = aim_at_edge(random, target.mesh, Aim::vertex);
  for (int other = 0; other < 3; ++other) {
    const bool inside = std::abs(aim[other] - target.center[other]) < 0.5 * target.radius;
    if (other != axis && inside) origin[other] = aim[other];
  }
  glm::vec3 direction(0.0f);
  for (int i = 0; i < 3; ++i) direction[i] = random.below(2) == 0 ? 0.0f : -0.0f;
  direction[axis] = random.below(2) == 0 ? 1.0f : -1.0f;
  return ray_query(origin, direction);
}

/// Calls `trace(target, first, queries)` for runs of samples that go to the same target.
template <typename Trace>
void for_each_run(const CaseSetup& setup, const char* name, std::size_t targets, const MakeRay& make,
                  const Trace& trace) {
  // One target needs no turns: longer runs spare submissions.
  constexpr std::uint64_t kLongRun = 1u << 16;
  const std::uint64_t run = targets == 1 ? kLongRun : kSamplesPerTarget;
  for (std::uint64_t first = 0; setup.wants(first); first += run) {
    const auto target = static_cast<std::uint32_t>(first / run % targets);
    std::vector<RayQuery> queries(std::min(run, setup.sample_count - first));
    for (std::uint64_t i = 0; i < queries.size(); ++i) {
      SampleRandom random(setup.seed, name, first + i);
      queries[i] = make(random, target);
    }
    trace(target, queries);
  }
}

}  // namespace

Aim mixed_aim(SampleRandom& random) {
  const std::uint32_t percent = random.below(100);
  if (percent < 30) return Aim::anywhere;
  if (percent < 60) return Aim::edge;
  if (percent < 80) return Aim::vertex;
  return percent < 90 ? Aim::axis : Aim::near_vertex;
}

RayQuery aimed_ray(SampleRandom& random, const Target& target, Aim aim) {
  if (aim == Aim::axis) return axis_ray(random, target);
  const glm::vec3 origin = glm::vec3(target.center + random.direction() * (target.radius * std::cbrt(random.unit())));
  if (aim == Aim::anywhere) return ray_query(origin, glm::vec3(random.direction()));
  glm::vec3 direction = aim_at_edge(random, target.mesh, aim) - origin;
  for (int i = 0; i < 3; ++i) direction[i] = stepped_up_to_two(random, direction[i]);
  return ray_query(origin, direction);
}

RayQuery grazing_ray(SampleRandom& random, const Target& target) {
  const VerifyMesh& mesh = target.mesh;
  const glm::uvec3 corners = mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
  const auto corner = [&](std::uint32_t i) { return glm::dvec3(mesh.positions[corners[static_cast<int>(i % 3)]]); };
  const std::uint32_t aim = random.below(3);
  const glm::dvec3 along = corner(aim + 1) - corner(aim), beside = corner(aim + 2) - corner(aim);
  const glm::dvec3 flat = glm::normalize(along * random.in(-1.0, 1.0) + beside * random.in(-1.0, 1.0));
  const glm::dvec3 normal = glm::normalize(glm::cross(along, beside));
  const glm::dvec3 back = flat + normal * std::exp2(random.in(-12.0, -4.0));
  const glm::vec3 origin(corner(aim) + back * random.in(0.1, 1.0));
  return ray_query(origin, glm::vec3(corner(aim) - glm::dvec3(origin)));
}

SampleRandom mesh_random(const CaseSetup& setup, const char* name, std::uint32_t mesh) {
  return SampleRandom(setup.seed, name, ~std::uint64_t{mesh});
}

void trace_samples(const CaseSetup& setup, const char* name, std::uint32_t function,
                   const std::vector<RayScene>& scenes, Tally& tally, const MakeRay& make, const JudgeRay& judge) {
  RayKernel kernel(setup, function);
  for_each_run(setup, name, scenes.size(), make, [&](std::uint32_t target, const std::vector<RayQuery>& queries) {
    const std::vector<RayAnswer> answers = kernel.trace(scenes[target], queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (answers[i].finished == 0) {
        tally.book(false, [&] { return "cut off: " + ray_inputs(queries[i]); });
      } else {
        judge(queries[i], answers[i], target);
      }
    }
  });
}

std::vector<RayScene> scenes_of(const CaseSetup& setup, const std::vector<VerifyMesh>& meshes) {
  std::vector<RayScene> scenes;
  for (const VerifyMesh& mesh : meshes) scenes.emplace_back(*setup.device, triangles_of(mesh), setup.traversal);
  return scenes;
}

bool same_hit(const RayAnswer& a, const RayAnswer& b) {
  if (a.finished != 1 || b.finished != 1 || a.triangle != b.triangle) return false;
  return a.triangle == NONE || std::bit_cast<std::uint32_t>(a.t) == std::bit_cast<std::uint32_t>(b.t);
}

CaseResult if_judged(CaseResult result, std::uint64_t judged) {
  if (2 * judged >= result.samples) return result;
  if (result.failures == 0) result.worst_inputs = "only " + std::to_string(judged) + " samples could be judged";
  ++result.failures;
  return result;
}

CaseResult closed_targets_case(const CaseSetup& setup, const char* name, const std::vector<Target>& targets,
                               const std::function<Aim(SampleRandom&)>& aim) {
  Tally tally;
  const auto make = [&](SampleRandom& random, std::uint32_t target) {
    const Aim at = aim(random);
    return aimed_ray(random, targets[target], at);
  };
  trace_samples(setup, name, VERIFY_CLOSEST, scenes_of(setup, targets), tally, make,
                [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
                  tally.book(answer.triangle != NONE, [&] { return ray_inputs(query); });
                });
  return tally.result();
}

CaseResult against_every_triangle(const CaseSetup& setup, const char* name, const std::vector<VerifyMesh>& meshes,
                                  const MakeRay& make, std::vector<std::uint32_t>* steps) {
  Tally tally;
  RayKernel kernel(setup, VERIFY_CLOSEST);
  RecordKernel every(setup, VERIFY_TRIANGLES);
  const std::vector<RayScene> scenes = scenes_of(setup, meshes);
  for_each_run(setup, name, scenes.size(), make, [&](std::uint32_t target, const std::vector<RayQuery>& queries) {
    const std::vector<RayAnswer> answers = kernel.trace(scenes[target], queries);
    const std::vector<RayAnswer> expected = every.test(triangle_records(triangles_of(meshes[target])), queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      tally.book(same_hit(answers[i], expected[i]), [&] {
        return ray_inputs(queries[i]) + " hit=" + std::to_string(answers[i].triangle) + " " +
               hex_floats({{"t", answers[i].t}}) + " expected=" + std::to_string(expected[i].triangle) + " " +
               hex_floats({{"t", expected[i].t}});
      });
      if (steps != nullptr) steps->push_back(answers[i].nodes + answers[i].tested);
    }
  });
  return tally.result();
}

}  // namespace vernier
