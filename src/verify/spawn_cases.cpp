#include "verify/spawn_cases.h"

#include <array>
#include <cmath>
#include <limits>

#include "verify/ray_suite.h"
#include "verify/wide_oracle.h"

namespace vernier {
namespace {

/// Separate triangles as scenes of their own each: a mesh per element, scaled as a scene is.
VerifyMesh scaled_triangle(const std::array<glm::dvec3, 3>& corners) {
  VerifyMesh mesh;
  double largest = 0.0;
  for (const glm::dvec3& c : corners) largest = std::max({largest, std::abs(c.x), std::abs(c.y), std::abs(c.z)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (const glm::dvec3& c : corners) mesh.positions.push_back(glm::vec3(c * std::ldexp(1.0, -exponent)));
  mesh.triangles = {{0u, 1u, 2u}};
  return mesh;
}

/// A ray that falls on the inside of a triangle from one of its sides and goes on anywhere.
RayQuery onto_triangle(SampleRandom& random, const VerifyMesh& mesh) {
  const std::vector<BvhTriangle> triangles = triangles_of(mesh);
  const BvhTriangle& triangle = triangles[random.below(static_cast<std::uint32_t>(triangles.size()))];
  double b = random.unit(), c = random.unit();
  if (b + c > 1.0) {
    b = 1.0 - b;
    c = 1.0 - c;
  }
  const glm::dvec3 v0 = triangle.v0;
  const glm::dvec3 place = v0 + (glm::dvec3(triangle.v1) - v0) * b + (glm::dvec3(triangle.v2) - v0) * c;
  const glm::dvec3 side = wide_normal(triangle) * (random.below(2) == 0 ? 1.0 : -1.0);
  const glm::vec3 origin(place + (side + random.direction() * 0.9) * random.power_of_ten(-3.0, 0.0));
  RayQuery query = ray_query(origin, glm::vec3(place) - origin);
  query.outgoing = glm::vec3(random.direction());
  return query;
}

/// Spacing of floats at the largest coordinate of a triangle.
double step_of(const VerifyMesh& mesh, std::uint32_t triangle) {
  float largest = 0.0f;
  for (int corner = 0; corner < 3; ++corner) {
    const glm::vec3 p = glm::abs(mesh.positions[mesh.triangles[triangle][corner]]);
    largest = std::max({largest, p.x, p.y, p.z});
  }
  return std::ldexp(1.0, std::ilogb(largest) - 23);
}

std::vector<VerifyMesh> sized_triangles(const CaseSetup& setup) {
  constexpr std::uint32_t kMeshes = 8, kTriangles = 64;
  std::vector<VerifyMesh> meshes(kMeshes);
  for (std::uint32_t i = 0; i < kMeshes; ++i) {
    SampleRandom random = mesh_random(setup, "self_hit", i);
    for (std::uint32_t j = 0; j < kTriangles; ++j) {
      std::array<glm::dvec3, 3> corners;
      for (glm::dvec3& corner : corners) {
        for (int k = 0; k < 3; ++k) corner[k] = random.power_of_ten(-8.0, 8.0) * (random.below(2) == 0 ? 1.0 : -1.0);
      }
      append(meshes[i], scaled_triangle(corners));
    }
  }
  return meshes;
}

/// Mesh k has unit triangles about 10^k away from 0.
std::vector<VerifyMesh> far_triangles(const CaseSetup& setup) {
  constexpr std::uint32_t kDecades = 8, kTriangles = 64;
  std::vector<VerifyMesh> meshes(kDecades);
  for (std::uint32_t decade = 0; decade < kDecades; ++decade) {
    SampleRandom random = mesh_random(setup, "self_hit_far", decade);
    for (std::uint32_t j = 0; j < kTriangles; ++j) {
      const glm::dvec3 center = random.direction() * std::pow(10.0, decade);
      append(meshes[decade],
             scaled_triangle({center + random.direction(), center + random.direction(), center + random.direction()}));
    }
  }
  return meshes;
}

}  // namespace

CaseResult run_self_hit(const CaseSetup& setup) {
  const std::vector<VerifyMesh> meshes = sized_triangles(setup);
  Tally tally;
  std::uint64_t judged = 0;
  trace_samples(
      setup, "self_hit", VERIFY_RESPAWN, scenes_of(setup, meshes), tally,
      [&](SampleRandom& random, std::uint32_t target) { return onto_triangle(random, meshes[target]); },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        // A needle may be missed; that counts as held.
        judged += answer.triangle != NONE ? 1 : 0;
        const bool again = answer.triangle != NONE && answer.next_triangle == answer.triangle;
        tally.book(!again, [&] { return ray_inputs(query); });
      });
  return if_judged(tally.result(), judged);
}

CaseResult run_self_hit_far(const CaseSetup& setup) {
  const std::vector<VerifyMesh> meshes = far_triangles(setup);
  // 8 and 4 steps of the largest coordinate per axis; the offset has three.
  const double per_axis = setup.level == Accuracy::exact ? 4.0 : 8.0;
  const double allowed =
      setup.level == Accuracy::fast ? std::numeric_limits<double>::infinity() : per_axis * std::sqrt(3.0);
  Tally tally("ulp", allowed);
  std::uint64_t judged = 0;
  trace_samples(
      setup, "self_hit_far", VERIFY_RESPAWN, scenes_of(setup, meshes), tally,
      [&](SampleRandom& random, std::uint32_t target) { return onto_triangle(random, meshes[target]); },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t target) {
        const auto inputs = [&] { return ray_inputs(query); };
        judged += answer.triangle != NONE ? 1 : 0;
        if (answer.triangle == NONE) {
          tally.book(true, inputs);
        } else if (answer.next_triangle == answer.triangle) {
          tally.book(false, inputs);
        } else {
          const double offset = glm::length(glm::dvec3(answer.respawned) - glm::dvec3(answer.position));
          tally.book_error(offset / step_of(meshes[target], answer.triangle), inputs);
        }
      });
  return if_judged(tally.result(), judged);
}

CaseResult run_behind_origin(const CaseSetup& setup) {
  std::vector<VerifyMesh> meshes = far_triangles(setup);
  const std::vector<VerifyMesh> sized = sized_triangles(setup);
  meshes.insert(meshes.end(), sized.begin(), sized.end());
  // One triangle a scene: nothing else may be hit.
  for (VerifyMesh& mesh : meshes) mesh.triangles.resize(1);
  Tally tally;
  trace_samples(
      setup, "behind_origin", VERIFY_CLOSEST, scenes_of(setup, meshes), tally,
      [&](SampleRandom& random, std::uint32_t target) {
        const RayQuery onto = onto_triangle(random, meshes[target]);
        // The end of that ray lies on the triangle but for rounding, on either side.
        glm::vec3 origin = onto.origin + onto.direction;
        for (int i = 0; i < 3; ++i) origin[i] = SampleRandom::stepped(origin[i], static_cast<int>(random.below(5)) - 2);
        return ray_query(origin, onto.outgoing);
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t target) {
        const double t = wide_crossing(query, triangles_of(meshes[target]).front()).t;
        tally.book(answer.triangle == NONE || t > 0.0, [&] { return ray_inputs(query); });
      });
  return tally.result();
}

namespace {

/// Quads of a strip.
constexpr int kQuads = 32;

/// A strip of quads across x that bends away from +z by `angle` at each edge.
VerifyMesh bent_strip(double angle) {
  VerifyMesh mesh;
  double slope = angle * kQuads / 2, z = 0.0;
  for (int i = 0; i <= kQuads; ++i) {
    const double x = 2.0 * i / kQuads - 1.0;
    mesh.positions.push_back(glm::vec3(x, -0.5, z));
    mesh.positions.push_back(glm::vec3(x, 0.5, z));
    z += slope * 2.0 / kQuads;
    slope -= angle;
  }
  for (std::uint32_t i = 0; i < kQuads; ++i) {
    mesh.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    mesh.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  return mesh;
}

/// Strips of several angles, each as it is and turned.
std::vector<VerifyMesh> bent_strips() {
  constexpr std::array kAngles{0.0, 1e-7, 1e-6, 1e-5, 1e-4};
  std::vector<VerifyMesh> meshes;
  for (const double angle : kAngles) {
    VerifyMesh mesh = bent_strip(angle);
    meshes.push_back(mesh);
    // Turned, so that no coordinate is the same all over a triangle.
    const glm::dvec3 u(0.36, 0.48, -0.8), v(-0.8, 0.6, 0.0), n(0.48, 0.64, 0.6);
    for (glm::vec3& p : mesh.positions) p = glm::vec3((u * double{p.x} + v * double{p.y} + n * double{p.z}) * 0.75);
    meshes.push_back(mesh);
  }
  return meshes;
}

/// A ray onto a quad of `strip` near an edge to its neighbour, that goes on towards that edge.
RayQuery towards_neighbour(SampleRandom& random, const VerifyMesh& strip) {
  const std::uint32_t quad = 1 + random.below(kQuads - 2);  // with a neighbour on both sides
  // Near the edge to the neighbour: 2^-24 to 1/2 of the quad's width from it.
  const double along = std::exp2(random.in(-24.0, -1.0)), across = random.in(0.05, 0.95);
  const bool at_start = random.below(2) == 0;
  const double weight = at_start ? along : 1.0 - along;
  const auto corner = [&](std::uint32_t i) { return glm::dvec3(strip.positions[2 * quad + i]); };
  const glm::dvec3 start = glm::mix(corner(0), corner(1), across), end = glm::mix(corner(2), corner(3), across);
  const glm::dvec3 place = glm::mix(start, end, weight);
  const glm::dvec3 normal = glm::normalize(glm::cross(corner(2) - corner(0), corner(1) - corner(0)));
  const glm::vec3 origin(place + normal * 0.25 + random.direction() * 0.1);
  RayQuery query = ray_query(origin, glm::vec3(place) - origin);
  // Towards the edge, 1e-4 radians above the quad: the neighbour bends away by up to as much.
  query.outgoing = glm::vec3(glm::normalize((at_start ? start - end : end - start)) + normal * 1e-4);
  return query;
}

}  // namespace

CaseResult run_neighbour_acne(const CaseSetup& setup) {
  const std::vector<VerifyMesh> meshes = bent_strips();
  Tally tally;
  trace_samples(
      setup, "neighbour_acne", VERIFY_RESPAWN, scenes_of(setup, meshes), tally,
      [&](SampleRandom& random, std::uint32_t target) { return towards_neighbour(random, meshes[target]); },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t target) {
        // Rounded corners may bend a strip towards the ray after all: then the hit has to be a true one.
        bool is_true = answer.triangle != NONE;
        if (is_true && answer.next_triangle != NONE) {
          const RayQuery next = ray_query(answer.respawned, query.outgoing);
          const WideCrossing crossing = wide_crossing(next, triangles_of(meshes[target])[answer.next_triangle]);
          is_true = crossing.inside && crossing.t > 0.0;
        }
        tally.book(is_true, [&] { return ray_inputs(query); });
      });
  return tally.result();
}

CaseResult run_detached_shadow(const CaseSetup& setup) {
  VerifyMesh mesh = grid_mesh(4, 2, 0.0f);
  append(mesh, placed(cube_mesh(1), 0.25, {0.0, 0.0, 0.25}));
  const double elevation = glm::radians(1.0);
  Tally tally;
  trace_samples(
      setup, "detached_shadow", VERIFY_RESPAWN, scenes_of(setup, std::vector{mesh}), tally,
      [&](SampleRandom& random, std::uint32_t) {
        // 2^-20 from the wall is 16 steps, within which a ray may start on its other side.
        const glm::vec3 place(0.25 + std::exp2(random.in(-20.0, -3.0)), random.in(-0.2, 0.2), 0.0);
        const glm::vec3 origin = place + glm::vec3(random.in(0.1, 0.7), 0.0, random.in(0.1, 0.7));
        RayQuery query = ray_query(origin, place - origin);
        query.outgoing = glm::vec3(-std::cos(elevation), random.in(-0.01, 0.01), std::sin(elevation));
        query.flags = 0;
        return query;
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        tally.book(answer.triangle != NONE && answer.next_triangle != NONE, [&] { return ray_inputs(query); });
      });
  return tally.result();
}

}  // namespace vernier
