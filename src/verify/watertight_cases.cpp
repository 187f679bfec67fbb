#include "verify/watertight_cases.h"

#include <cmath>
#include <limits>

#include "verify/ray_suite.h"

namespace vernier {
namespace {

Target ball(const VerifyMesh& mesh, double radius) {
  return {mesh, glm::dvec3(0.0), radius};
}

/// `target` times `scale` at `offset`, then scaled as a scene is.
Target moved(const Target& target, double scale, const glm::dvec3& offset) {
  const VerifyMesh there = placed(target.mesh, scale, offset);
  const double unit = unit_scale(there);
  return {placed(there, unit, glm::dvec3(0.0)), (target.center * scale + offset) * unit, target.radius * scale * unit};
}

Target bumpy_sphere(const CaseSetup& setup, const char* name, std::uint32_t number) {
  SampleRandom random = mesh_random(setup, name, number);
  return moved(ball(sphere_mesh(16, 16, 1.0, 6.0, random), 0.5), 1.0, glm::dvec3(0.0));
}

Target rough_cone(const CaseSetup& setup, const char* name, std::uint32_t valence) {
  SampleRandom random = mesh_random(setup, name, valence);
  return ball(double_cone(valence, 1.0, random), 0.05);
}

}  // namespace

CaseResult run_shared_edge(const CaseSetup& setup) {
  constexpr const char* kName = "shared_edge";
  const std::vector<Target> targets{bumpy_sphere(setup, kName, 0), bumpy_sphere(setup, kName, 1)};
  return closed_targets_case(setup, kName, targets, [](SampleRandom&) { return Aim::edge; });
}

CaseResult run_shared_vertex(const CaseSetup& setup) {
  constexpr const char* kName = "shared_vertex";
  const std::vector<Target> targets{bumpy_sphere(setup, kName, 0), rough_cone(setup, kName, 3),
                                    rough_cone(setup, kName, 6), rough_cone(setup, kName, 1024)};
  return closed_targets_case(setup, kName, targets, [](SampleRandom& random) {
    return random.below(4) == 0 ? Aim::near_vertex : Aim::vertex;
  });
}

CaseResult run_single_hit(const CaseSetup& setup) {
  constexpr const char* kName = "single_hit";
  // The rounded shear lets a ray on an edge hit both triangles; only the exact level decides for one of them.
  const double allowed = setup.level == Accuracy::exact ? 0.0 : std::numeric_limits<double>::infinity();
  Tally tally("extra hits", allowed);
  SampleRandom random = mesh_random(setup, kName, 0);
  const std::vector<Target> targets{ball(sphere_mesh(24, 24, 1.0, 1.0, random), 0.3),
                                    ball(double_cone(4, 0.0, random), 0.3), ball(double_cone(64, 0.0, random), 0.3),
                                    ball(double_cone(128, 0.0, random), 0.3)};
  trace_samples(
      setup, kName, VERIFY_ALL_HITS, scenes_of(setup, targets), tally,
      [&](SampleRandom& sample, std::uint32_t target) { return aimed_ray(sample, targets[target], mixed_aim(sample)); },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        const auto inputs = [&] { return ray_inputs(query); };
        if (answer.hit_count == 0) {
          tally.book(false, inputs);
        } else {
          tally.book_error(answer.hit_count - 1.0, inputs);
        }
      });
  return tally.result();
}

CaseResult run_far_mesh(const CaseSetup& setup) {
  constexpr const char* kName = "far_mesh";
  SampleRandom random = mesh_random(setup, kName, 0);
  const Target sphere = ball(sphere_mesh(16, 16, 1.0, 1.5, random), 0.4);
  // The first place is that of Embree's watertightness test; a step along z is 1/64 there. At 1e9 it is 64.
  const std::vector<Target> targets{moved(sphere, 1.0, {148376.0, 1234.0, -223423.0}),
                                    moved(sphere, 3.0, {1.0e6, 1.0e6, 1.0e6}),
                                    moved(sphere, 3000.0, {1.0e9, -1.0e9, 1.0e9})};
  return closed_targets_case(setup, kName, targets, mixed_aim);
}

CaseResult run_needles(const CaseSetup& setup) {
  constexpr const char* kName = "needles";
  std::vector<Target> targets;
  for (const double flatness : {1.0, 0.1, 0.001}) {
    SampleRandom random = mesh_random(setup, kName, static_cast<std::uint32_t>(targets.size()));
    VerifyMesh mesh = sphere_mesh(4, 256, 0.8, 1.0, random);
    for (glm::vec3& p : mesh.positions) p.z *= static_cast<float>(flatness);
    targets.push_back(ball(mesh, 0.1 * flatness));
  }
  return closed_targets_case(setup, kName, targets, mixed_aim);
}

CaseResult run_tiny_mesh(const CaseSetup& setup) {
  constexpr const char* kName = "tiny_mesh";
  SampleRandom random = mesh_random(setup, kName, 0);
  // At 1 the sphere's radius is 16 steps wide; more vertices would fall into one another.
  const Target coarse = ball(sphere_mesh(6, 4, 1.0, 1.5, random), 0.3);
  const Target fine = ball(sphere_mesh(16, 16, 1.0, 1.5, random), 0.4);
  Target at_zero = fine;
  at_zero.mesh = placed(fine.mesh, 1e-12, glm::dvec3(0.0));
  at_zero.radius *= 1e-12;
  return closed_targets_case(setup, kName, {moved(coarse, 1e-6, glm::dvec3(1.0)), at_zero}, mixed_aim);
}

CaseResult run_edge_on(const CaseSetup& setup) {
  constexpr const char* kName = "edge_on";
  // Each edge's line is followed to its point nearest to the centre; where that lies in the ball that is inside for
  // certain, a ray from there runs along the edge. 0.7: vertices are at 1 or beyond, and facets nowhere nearer than
  // 0.9.
  constexpr double kInside = 0.7;
  SampleRandom mesh_numbers = mesh_random(setup, kName, 0);
  const VerifyMesh mesh = sphere_mesh(16, 16, 1.0, 6.0, mesh_numbers);
  std::vector<std::pair<glm::dvec3, glm::dvec3>> lines;
  for (const glm::uvec3& t : mesh.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const glm::dvec3 a = mesh.positions[t[corner]], b = mesh.positions[t[(corner + 1) % 3]];
      const glm::dvec3 foot = a + (a - b) * (glm::dot(a, b - a) / glm::dot(b - a, b - a));
      const bool before_edge = glm::dot(a, b - a) > 0.0;
      if (before_edge && glm::length(foot) < kInside) lines.emplace_back(foot, b);
    }
  }
  Tally tally;
  trace_samples(
      setup, kName, VERIFY_CLOSEST, scenes_of(setup, std::vector{mesh}), tally,
      [&](SampleRandom& random, std::uint32_t) {
        const auto& [foot, far_end] = lines[random.below(static_cast<std::uint32_t>(lines.size()))];
        const glm::vec3 origin(foot);
        glm::vec3 direction = glm::vec3(far_end) - origin;
        const auto axis = static_cast<int>(random.below(3));
        direction[axis] = SampleRandom::stepped(direction[axis], static_cast<int>(random.below(3)) - 1);
        return ray_query(origin, direction);
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        tally.book(answer.triangle != NONE && std::isfinite(answer.t), [&] { return ray_inputs(query); });
      });
  return tally.result();
}

CaseResult run_origin_on_surface(const CaseSetup& setup) {
  constexpr const char* kName = "origin_on_surface";
  const std::vector<Target> targets{bumpy_sphere(setup, kName, 0), ball(cube_mesh(8), 0.5)};
  Tally tally;
  trace_samples(
      setup, kName, VERIFY_CLOSEST, scenes_of(setup, targets), tally,
      [&](SampleRandom& random, std::uint32_t number) {
        const VerifyMesh& mesh = targets[number].mesh;
        const glm::uvec3& t = mesh.triangles[random.below(static_cast<std::uint32_t>(mesh.triangles.size()))];
        // A vertex, a point of an edge, a point of the face: as near as floats come to it.
        const std::uint32_t kind = random.below(3);
        const double b = kind == 0 ? 0.0 : random.unit(), c = kind == 2 ? random.unit() * (1.0 - b) : 0.0;
        const glm::dvec3 v0 = mesh.positions[t.x], v1 = mesh.positions[t.y], v2 = mesh.positions[t.z];
        const glm::vec3 origin(v0 + (v1 - v0) * b + (v2 - v0) * c);
        const double inside = targets[number].radius * 0.5;
        return ray_query(origin, glm::vec3(random.direction() * inside) - origin);
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        // The ray passes a place inside at t = 1 and has to come out again behind it: a hit before would do as well.
        tally.book(answer.triangle != NONE && answer.t > 0.0f, [&] { return ray_inputs(query); });
      });
  return tally.result();
}

CaseResult run_seam(const CaseSetup& setup) {
  constexpr const char* kName = "seam";
  // Turned about all axes, so that the diagonal meets no special case.
  VerifyMesh mesh = grid_mesh(1, 2, 0.0f);
  const glm::dvec3 u(0.36, 0.48, -0.8), v(-0.8, 0.6, 0.0), away(0.48, 0.64, 0.6);
  for (glm::vec3& p : mesh.positions) p = glm::vec3((u * double{p.x} + v * double{p.y}) * 0.5);
  Tally tally;
  trace_samples(
      setup, kName, VERIFY_CLOSEST, scenes_of(setup, std::vector{mesh}), tally,
      [&](SampleRandom& random, std::uint32_t) {
        // Half of the samples lie on the diagonal; 0.99 keeps the others within the outline.
        const double x = random.in(-0.99, 0.99), y = random.below(2) == 0 ? x : random.in(-0.99, 0.99);
        const glm::vec3 eye(away * random.in(0.1, 1.0) + u * random.in(-0.2, 0.2) + v * random.in(-0.2, 0.2));
        return ray_query(eye, glm::vec3((u * x + v * y) * 0.5) - eye);
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        tally.book(answer.triangle != NONE, [&] { return ray_inputs(query); });
      });
  return tally.result();
}

}  // namespace vernier
