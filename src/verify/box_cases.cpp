#include "verify/box_cases.h"

#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "bvh/build_bvh.h"
#include "bvh/decode_record.h"
#include "verify/ray_suite.h"

namespace vernier {
namespace {

/// A heap of boxes on a grid, so that many faces lie in the same planes, and a bumpy sphere around it.
std::vector<VerifyMesh> planes_and_bumps(const CaseSetup& setup, const char* name) {
  SampleRandom random = mesh_random(setup, name, 0);
  VerifyMesh boxes;
  constexpr std::uint32_t kBoxes = 24;
  constexpr int kGrid = 16;
  for (std::uint32_t i = 0; i < kBoxes; ++i) {
    const auto at = [&] { return (static_cast<int>(random.below(2 * kGrid - 2)) - kGrid + 1.0) / kGrid; };
    append(boxes, placed(cube_mesh(1), 1.0 / kGrid, {at(), at(), at()}));
  }
  VerifyMesh sphere = sphere_mesh(16, 16, 0.5, 1.0, random);
  return {boxes, sphere};
}

glm::vec3 any_vertex(SampleRandom& random, const VerifyMesh& mesh) {
  return mesh.positions[random.below(static_cast<std::uint32_t>(mesh.positions.size()))];
}

/// A place on one, two or three of the planes through a vertex.
glm::vec3 on_vertex_planes(SampleRandom& random, const VerifyMesh& mesh) {
  const glm::vec3 vertex = any_vertex(random, mesh);
  glm::vec3 place(random.in(-1.5, 1.5), random.in(-1.5, 1.5), random.in(-1.5, 1.5));
  const auto axis = static_cast<int>(random.below(3));
  place[axis] = vertex[axis];
  if (random.below(2) == 0) place[(axis + 1) % 3] = vertex[(axis + 1) % 3];
  if (random.below(8) == 0) place = vertex;
  return place;
}

float zero_of_any_sign(SampleRandom& random) {
  return random.below(2) == 0 ? 0.0f : -0.0f;
}

RayQuery onto_corner(SampleRandom& random, const glm::vec3& corner) {
  const glm::vec3 origin(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
  return ray_query(origin, corner - origin);
}

/// The same within one or two planes across the axes, which are planes of the box before it is padded. What stands in
/// for 0 in a direction must be small next to the rest of it, and that is not unit: a shadow ray's is the way to its
/// light. It is drawn down to 2^-45 of the scene's size.
RayQuery in_corner_plane(SampleRandom& random, const glm::vec3& corner) {
  RayQuery query = onto_corner(random, corner);
  const auto axis = static_cast<int>(random.below(3));
  query.origin[axis] = corner[axis];
  if (random.below(2) == 0) query.origin[(axis + 1) % 3] = corner[(axis + 1) % 3];
  query.direction = (corner - query.origin) * std::exp2(-static_cast<float>(random.below(46)));
  for (int i = 0; i < 3; ++i) {
    if (query.direction[i] == 0.0f) query.direction[i] = zero_of_any_sign(random);
  }
  return query;
}

double mean(const std::vector<std::uint32_t>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / std::max<double>(1.0, static_cast<double>(values.size()));
}

}  // namespace

CaseResult run_zero_component(const CaseSetup& setup) {
  constexpr const char* kName = "zero_component";
  const std::vector<VerifyMesh> meshes = planes_and_bumps(setup, kName);
  return against_every_triangle(setup, kName, meshes, [&](SampleRandom& random, std::uint32_t target) {
    glm::vec3 direction(random.direction());
    const auto axis = static_cast<int>(random.below(3));
    direction[axis] = zero_of_any_sign(random);
    if (random.below(2) == 0) direction[(axis + 1) % 3] = zero_of_any_sign(random);
    return ray_query(on_vertex_planes(random, meshes[target]), direction);
  });
}

CaseResult run_tiny_components(const CaseSetup& setup) {
  constexpr const char* kName = "tiny_components";
  const std::vector<VerifyMesh> meshes = planes_and_bumps(setup, kName);
  const auto tiny_ray = [&](SampleRandom& random, std::uint32_t target) {
    // The last is a denormal: a device may take it for 0.
    constexpr std::array kSizes{1e-8f, 1e-20f, 1e-30f, 1e-38f, 1e-40f};
    glm::vec3 direction;
    for (int i = 0; i < 3; ++i) {
      const float size = kSizes[random.below(kSizes.size())];
      direction[i] = random.below(2) == 0 ? size : -size;
    }
    direction[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1.0f : -1.0f;
    return ray_query(on_vertex_planes(random, meshes[target]), direction);
  };
  const auto usual_ray = [&](SampleRandom& random, std::uint32_t target) {
    return ray_query(on_vertex_planes(random, meshes[target]), glm::vec3(random.direction()));
  };
  std::vector<std::uint32_t> tiny_steps, usual_steps;
  CaseResult result = against_every_triangle(setup, kName, meshes, tiny_ray, &tiny_steps);
  against_every_triangle(setup, kName, meshes, usual_ray, &usual_steps);
  // 2.5: as much as Embree's tests allow rays that are not valid.
  const bool bounded = mean(tiny_steps) <= 2.5 * mean(usual_steps);
  if (!bounded && result.failures == 0) result.worst_inputs = "mean steps " + std::to_string(mean(tiny_steps));
  result.failures += bounded ? 0 : 1;
  return result;
}

CaseResult run_flat_boxes(const CaseSetup& setup) {
  constexpr const char* kName = "flat_boxes";
  // Three squares across the axes, at heights that rounding would have to move to reach the next plane.
  std::vector<VerifyMesh> meshes;
  for (int axis = 0; axis < 3; ++axis) {
    meshes.push_back(grid_mesh(16, axis, 0.0f));
    meshes.push_back(grid_mesh(16, axis, 0.7f));
  }
  const std::vector<RayScene> scenes = scenes_of(setup, meshes);
  Tally tally;
  trace_samples(
      setup, kName, VERIFY_CLOSEST, scenes, tally,
      [&](SampleRandom& random, std::uint32_t target) {
        const int axis = static_cast<int>(target) / 2;
        const float height = meshes[target].positions.front()[axis];
        // Within the outline by 1/64, more than two steps of a direction move the ray.
        glm::vec3 aim(random.in(-0.98, 0.98), random.in(-0.98, 0.98), random.in(-0.98, 0.98));
        if (random.below(2) == 0) aim = any_vertex(random, meshes[target]) * 0.875f;
        aim[axis] = height;
        glm::vec3 origin(random.in(-1.0, 1.0), random.in(-1.0, 1.0), random.in(-1.0, 1.0));
        const double away = std::exp2(random.in(-20.0, 0.0));
        origin[axis] = static_cast<float>(height + (random.below(2) == 0 ? away : -away));
        if (random.below(2) == 0) {  // straight down, with zeros
          for (int i = 1; i < 3; ++i) origin[(axis + i) % 3] = aim[(axis + i) % 3];
        }
        glm::vec3 direction = aim - origin;
        for (int i = 0; i < 3; ++i) {
          if (direction[i] == 0.0f) direction[i] = zero_of_any_sign(random);
        }
        return ray_query(origin, direction);
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        tally.book(answer.triangle != NONE, [&] { return ray_inputs(query); });
      });
  return tally.result();
}

CaseResult run_box_corner(const CaseSetup& setup) {
  constexpr const char* kName = "box_corner";
  SampleRandom numbers = mesh_random(setup, kName, 0);
  const std::vector<VerifyMesh> meshes{triangle_soup(256, 0.1, numbers), triangle_soup(256, 0.001, numbers)};
  return against_every_triangle(setup, kName, meshes, [&](SampleRandom& random, std::uint32_t target) {
    return aimed_ray(random, {meshes[target], glm::dvec3(0.0), 1.0}, random.below(4) == 0 ? Aim::edge : Aim::vertex);
  });
}

CaseResult run_box_alone(const CaseSetup& setup) {
  constexpr const char* kName = "box_alone";
  // A node with four children that are triangles each; a ray at a triangle's corner must enter its box.
  constexpr std::uint64_t kRaysPerNode = 1024;
  Tally tally;
  RecordKernel boxes(setup, VERIFY_BOXES);
  RecordKernel triangles(setup, VERIFY_TRIANGLES);
  for (std::uint64_t first = 0; setup.wants(first); first += kRaysPerNode) {
    SampleRandom numbers = mesh_random(setup, kName, static_cast<std::uint32_t>(first / kRaysPerNode));
    // In half of the nodes close together: the boxes of a wide node have more room than any fault takes.
    VerifyMesh mesh = triangle_soup(4, numbers.power_of_ten(-6.0, -0.5), numbers);
    if (first / kRaysPerNode % 2 == 1) {
      const VerifyMesh soup = triangle_soup(4, numbers.power_of_ten(-2.0, -0.5), numbers);
      mesh = placed(soup, numbers.power_of_ten(-4.0, -2.0), numbers.direction() * 0.5);
    }
    const Bvh bvh = build_bvh(triangles_of(mesh), {}, 1);
    std::vector<RayQuery> queries(std::min(kRaysPerNode, setup.sample_count - first));
    std::vector<std::uint32_t> aimed_at(queries.size());
    for (std::uint64_t i = 0; i < queries.size(); ++i) {
      SampleRandom random(setup.seed, kName, first + i);
      aimed_at[i] = random.below(4);
      const glm::vec3 aim = mesh.positions[mesh.triangles[aimed_at[i]][static_cast<int>(random.below(3))]];
      queries[i] = random.below(2) == 0 ? in_corner_plane(random, aim) : onto_corner(random, aim);
    }
    const std::vector<RayAnswer> entered = boxes.test(std::span(bvh.records).first(1), queries);
    const std::vector<RayAnswer> hits = triangles.test(triangle_records(triangles_of(mesh)), queries);
    const std::uint32_t first_child = decode_node(bvh.records[0]).child_base;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      std::uint32_t child = 0;
      while (child < 4 && bvh.records[first_child + child][11] != aimed_at[i]) ++child;
      // The direction is rounded: a ray that misses the triangle may miss its box as well.
      const bool may_miss = hits[i].triangle != aimed_at[i];
      tally.book(may_miss || (entered[i].hit_count >> child & 1u) == 1u, [&] { return ray_inputs(queries[i]); });
    }
  }
  return tally.result();
}

CaseResult run_invalid_rays(const CaseSetup& setup) {
  constexpr const char* kName = "invalid_rays";
  const std::vector<RayScene> scenes = scenes_of(setup, planes_and_bumps(setup, kName));
  const auto usual_ray = [](SampleRandom& random, std::uint32_t) {
    return ray_query(glm::vec3(random.direction() * 0.3), glm::vec3(random.direction()));
  };
  const auto broken_ray = [&](SampleRandom& random, std::uint32_t target) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    constexpr std::array kValues{std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity};
    RayQuery query = usual_ray(random, target);
    const std::uint32_t what = random.below(3);
    const float value = kValues[random.below(kValues.size())];
    if (what == 0)
      query.direction = glm::vec3(zero_of_any_sign(random), zero_of_any_sign(random), zero_of_any_sign(random));
    if (what != 0) (what == 1 ? query.origin : query.direction)[static_cast<int>(random.below(3))] = value;
    return query;
  };
  std::vector<std::uint32_t> usual_steps;
  Tally ignored, tally;
  CaseSetup few = setup;
  few.sample_count = 2 * kSamplesPerTarget;  // enough for a mean
  trace_samples(few, kName, VERIFY_CLOSEST, scenes, ignored, usual_ray,
                [&](const RayQuery&, const RayAnswer& answer, std::uint32_t) {
                  usual_steps.push_back(answer.nodes + answer.tested);
                });
  // 2.5: what Embree's tests allow them.
  const double allowed_steps = 2.5 * mean(usual_steps);
  trace_samples(setup, kName, VERIFY_CLOSEST, scenes, tally, broken_ray,
                [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
                  const bool cheap = answer.nodes + answer.tested <= allowed_steps;
                  tally.book(answer.triangle == NONE && cheap, [&] { return ray_inputs(query); });
                });
  return tally.result();
}

}  // namespace vernier
