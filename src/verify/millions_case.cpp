#include <cmath>
#include <memory>

#include "verify/image_cases.h"
#include "verify/ray_suite.h"

namespace vernier {
namespace {

/// Highest and lowest point of the landscape.
constexpr double kRelief = 0x1p-9;
/// Cells of a patch to each side of its middle, and how far from that rays are aimed.
constexpr std::uint32_t kReach = 24, kAimReach = 4;
/// A ray moves aside by at most so much of its height: over the relief 2 x 4 x 2^-9, 8 of the larger mesh's cells.
constexpr double kMostSlant = 4.0;
constexpr std::uint64_t kRaysPerPatch = 128;
/// Samples of the small landscape; those behind go to the large one.
constexpr std::uint64_t kSmallSamples = 1u << 13;
constexpr std::uint32_t kSmallCells = 256, kLargeCells = 1024;

/// A landscape over [-1, 1]^2, its vertices moved up and down at random, and its tree.
struct Landscape {
  std::uint32_t cells;
  std::vector<BvhTriangle> triangles;
  RayScene scene;
};

Landscape landscape(const CaseSetup& setup, const char* name, std::uint32_t cells) {
  SampleRandom random = mesh_random(setup, name, cells);
  VerifyMesh mesh = grid_mesh(cells, 1, 0.0f);
  for (glm::vec3& p : mesh.positions) p.y = static_cast<float>(random.in(-kRelief, kRelief));
  std::vector<BvhTriangle> triangles = triangles_of(mesh);
  RayScene scene(*setup.device, triangles, setup.traversal);
  return {cells, std::move(triangles), std::move(scene)};
}

/// The triangles of the cells within `reach` of `cell`.
std::vector<BvhTriangle> patch(const Landscape& land, const glm::uvec2& cell, std::uint32_t reach) {
  std::vector<BvhTriangle> triangles;
  for (std::uint32_t v = cell.y - reach; v < cell.y + reach; ++v) {
    const auto first = land.triangles.begin() + 2 * (static_cast<std::ptrdiff_t>(v) * land.cells + cell.x - reach);
    triangles.insert(triangles.end(), first, first + 4 * static_cast<std::ptrdiff_t>(reach));
  }
  return triangles;
}

/// A ray from above or below at an edge, a corner or the inside of one of `targets`.
RayQuery ray_at(SampleRandom& random, const std::vector<BvhTriangle>& targets) {
  const BvhTriangle& t = targets[random.below(static_cast<std::uint32_t>(targets.size()))];
  const double u = random.below(4) == 0 ? 0.0 : random.unit(),
               v = random.below(2) == 0 ? 0.0 : random.unit() * (1.0 - u);
  const glm::dvec3 v0 = t.v0;
  const glm::dvec3 aim = v0 + (glm::dvec3(t.v1) - v0) * u + (glm::dvec3(t.v2) - v0) * v;
  const glm::dvec3 way(random.in(-1.0, 1.0) * kMostSlant / 2.0, random.below(2) == 0 ? 1.0 : -1.0,
                       random.in(-1.0, 1.0) * kMostSlant / 2.0);
  const glm::vec3 origin(aim - way * random.in(2.0 * kRelief, 1.0));
  return ray_query(origin, glm::vec3(aim - glm::dvec3(origin)));
}

}  // namespace

CaseResult run_millions(const CaseSetup& setup) {
  constexpr const char* kName = "millions";
  RayKernel kernel(setup, VERIFY_CLOSEST);
  RecordKernel every(setup, VERIFY_TRIANGLES);
  std::unique_ptr<Landscape> land;
  Tally tally;
  for (std::uint64_t first = 0; setup.wants(first); first += kRaysPerPatch) {
    const std::uint32_t cells = first < kSmallSamples ? kSmallCells : kLargeCells;
    if (!land || land->cells != cells) land = std::make_unique<Landscape>(landscape(setup, kName, cells));
    SampleRandom random(setup.seed, kName, first);
    const auto along = [&] { return kReach + random.below(cells - 2 * kReach + 1); };
    const glm::uvec2 cell(along(), along());
    const std::vector<BvhTriangle> aims = patch(*land, cell, kAimReach);
    std::vector<RayQuery> queries;
    for (std::uint64_t i = 0; i < kRaysPerPatch; ++i) queries.push_back(ray_at(random, aims));
    const std::vector<RayAnswer> answers = kernel.trace(land->scene, queries);
    // Outside the patch a ray is above or below all of the landscape: brute force over the patch is one over all.
    const std::vector<RayAnswer> expected = every.test(triangle_records(patch(*land, cell, kReach)), queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      tally.book(answers[i].triangle != NONE && same_hit(answers[i], expected[i]), [&] {
        return ray_inputs(queries[i]) + " hit=" + std::to_string(answers[i].triangle) +
               " expected=" + std::to_string(expected[i].triangle);
      });
    }
  }
  return tally.result();
}

}  // namespace vernier
