#include "verify/terminator_cases.h"

#include <cmath>

#include "verify/ray_suite.h"
#include "verify/wide_oracle.h"

namespace vernier {
namespace {

/// A place on the triangle: in half of the cases near an edge or a vertex.
glm::dvec3 place_on(SampleRandom& random, const BvhTriangle& triangle) {
  const auto weight = [&] { return random.below(2) == 0 ? random.unit() : std::exp2(random.in(-20.0, 0.0)); };
  const double a = weight(), b = weight(), c = weight();
  return (glm::dvec3(triangle.v0) * a + glm::dvec3(triangle.v1) * b + glm::dvec3(triangle.v2) * c) / (a + b + c);
}

}  // namespace

CaseResult run_terminator(const CaseSetup& setup) {
  constexpr const char* kName = "terminator";
  constexpr double kLeastElevation = 1e-4;  // docstring
  SampleRandom mesh_numbers = mesh_random(setup, kName, 0);
  const std::vector<VerifyMesh> meshes{sphere_mesh(16, 8, 1.0, 1.0, mesh_numbers)};
  const std::vector<BvhTriangle> triangles = triangles_of(meshes[0]);
  Tally tally;
  std::uint64_t judged = 0;
  trace_samples(
      setup, kName, VERIFY_RESPAWN, scenes_of(setup, meshes), tally,
      [&](SampleRandom& random, std::uint32_t) {
        const BvhTriangle& triangle = triangles[random.below(static_cast<std::uint32_t>(triangles.size()))];
        const glm::dvec3 place = place_on(random, triangle), out = glm::normalize(place);
        glm::dvec3 normal = wide_normal(triangle);
        if (glm::dot(normal, out) < 0.0) normal = -normal;
        const glm::vec3 origin(place + out * 0.5);
        RayQuery query = ray_query(origin, glm::vec3(place) - origin);
        // One step of a light's way down.
        const double elevation = kLeastElevation * std::pow(1.5 / kLeastElevation, random.unit());
        const glm::dvec3 along = glm::normalize(glm::cross(normal, random.direction()));
        query.outgoing = glm::vec3(along * std::cos(elevation) + normal * std::sin(elevation));
        return query;
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        // Beside an edge the rounded ray may meet the neighbour, above whose plane the light need not be.
        const bool faces = answer.triangle != NONE &&
                           glm::dot(glm::dvec3(answer.normal), glm::dvec3(query.outgoing)) >= 0.5 * kLeastElevation;
        judged += faces ? 1 : 0;
        tally.book(!faces || answer.next_triangle == NONE, [&] { return ray_inputs(query); });
      });
  return if_judged(tally.result(), judged);
}

}  // namespace vernier
