#include <array>
#include <cmath>

#include "verify/ray_suite.h"
#include "verify/spawn_cases.h"

namespace vernier {
namespace {

constexpr std::uint32_t kLayers = 100;

/// Squares across z, one behind the other.
struct Stack {
  VerifyMesh mesh;
  glm::dvec3 place;  ///< middle of the first
  double size;       ///< half a square's side
  double gap;        ///< between two of them
};

/// `gap_steps` steps of float at the stack's z apart.
Stack stack_of(const glm::dvec3& place, double size, double gap_steps) {
  // Around 0 the steps are those of the squares' corners.
  const double reach = place.z == 0.0 ? size : place.z;
  Stack stack{{}, place, size, gap_steps * std::ldexp(1.0, std::ilogb(reach) - 23)};
  for (std::uint32_t i = 0; i < kLayers; ++i) {
    append(stack.mesh, placed(grid_mesh(1, 2, 0.0f), size, place + glm::dvec3(0.0, 0.0, i * stack.gap)));
  }
  return stack;
}

/// At 0, and as metre-sized squares a kilometre and a thousand kilometres away lie in the traced space.
std::vector<Stack> stacks_with(const std::vector<double>& gaps) {
  std::vector<Stack> stacks;
  for (const double gap_steps : gaps) {
    stacks.push_back(stack_of(glm::dvec3(0.0), 1.0, gap_steps));
    stacks.push_back(stack_of({0.5, -0.75, 0.5625}, 0x1p-10, gap_steps));
    stacks.push_back(stack_of({-0.5, 0.75, 0.5625}, 0x1p-17, gap_steps));
  }
  return stacks;
}

/// A ray upwards that starts `below` under layer 0 and stays away from the squares' diagonal and outline.
RayQuery ray_through(SampleRandom& random, const Stack& stack, double below) {
  const double u = random.in(-0.6, 0.6), turn = random.in(0.2, 0.3);
  const double v = random.below(2) == 0 ? u + turn : u - turn;
  const glm::dvec3 start = stack.place + glm::dvec3(u * stack.size, v * stack.size, -below);
  // Through all layers the ray moves aside by at most a twentieth of a square.
  const double rise = kLayers * stack.gap + below;
  const double aside = std::min(rise, 0.05 * stack.size);
  return ray_query(glm::vec3(start), glm::vec3(random.in(-1, 1) * aside, random.in(-1, 1) * aside, rise));
}

}  // namespace

CaseResult run_layers(const CaseSetup& setup) {
  // From 2^16 steps on the stack at 0 is as high as wide.
  const std::vector<Stack> stacks = stacks_with({1.0, 16.0, 4096.0, 65536.0});
  Tally tally;
  trace_samples(
      setup, "layers", VERIFY_ALL_HITS, scenes_of(setup, stacks), tally,
      [&](SampleRandom& random, std::uint32_t target) {
        // As near as the stack is high: from further off the order of layers one step apart is below t's last bit.
        const Stack& stack = stacks[target];
        return ray_through(random, stack, stack.gap * (1.0 + random.below(kLayers)));
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        tally.book(answer.hit_count == kLayers && answer.descents == 0, [&] { return ray_inputs(query); });
      });
  return tally.result();
}

CaseResult run_layers_passed(const CaseSetup& setup) {
  // Secondary rays may start 8 sqrt(3) steps off, below 16.
  const std::vector<Stack> stacks = stacks_with({16.0, 256.0, 65536.0});
  Tally tally;
  trace_samples(
      setup, "layers_passed", VERIFY_RESPAWN, scenes_of(setup, stacks), tally,
      [&](SampleRandom& random, std::uint32_t target) {
        const Stack& stack = stacks[target];
        RayQuery query = ray_through(random, stack, 0.0);
        const double layer = random.below(kLayers - 1);
        query.origin.z = static_cast<float>(stack.place.z + (layer - 0.5) * stack.gap);
        query.outgoing = query.direction;
        return query;
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        const bool next = answer.triangle != NONE && answer.next_triangle / 2 == answer.triangle / 2 + 1;
        tally.book(next, [&] { return ray_inputs(query); });
      });
  return tally.result();
}

CaseResult run_near_shells(const CaseSetup& setup) {
  constexpr const char* kName = "near_shells";
  // The outer two of three shells are 3.6e-5 apart, the outer two of the others 4e-6.
  const std::array<std::vector<double>, 2> radii{std::vector{1.0 + 4e-5, 1.0 + 4e-6, 1.0},
                                                 std::vector{1.0 + 4e-6, 1.0}};
  std::vector<RayScene> scenes;
  std::uint32_t per_shell = 0;
  for (const std::vector<double>& shells : radii) {
    VerifyMesh mesh;
    for (const double radius : shells) {
      SampleRandom numbers = mesh_random(setup, kName, 0);
      append(mesh, placed(sphere_mesh(32, 32, 1.0, 1.0, numbers), 0.5 * radius, glm::dvec3(0.0)));
    }
    per_shell = static_cast<std::uint32_t>(mesh.triangles.size() / shells.size());
    scenes.emplace_back(*setup.device, triangles_of(mesh), setup.traversal);
  }
  Tally tally;
  trace_samples(
      setup, kName, VERIFY_RESPAWN, scenes, tally,
      [&](SampleRandom& random, std::uint32_t) {
        // Towards the inner half: nearer to the outline a ray may pass between two shells.
        const glm::vec3 origin(random.direction());
        RayQuery query = ray_query(origin, glm::vec3(random.direction() * 0.25) - origin);
        query.outgoing = query.direction;
        return query;
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        const bool next = answer.triangle < per_shell && answer.next_triangle / per_shell == 1;
        tally.book(next, [&] { return ray_inputs(query); });
      });
  return tally.result();
}

}  // namespace vernier
