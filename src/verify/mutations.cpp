#include "verify/mutations.h"

#include <algorithm>

namespace vernier {
namespace {

/// Everything robust but `spot`, which is fast.
constexpr std::uint32_t fast_at(std::uint32_t spot) {
  return (LEVELS_OF(LEVEL_ROBUST) & ~(3u << (2 * spot))) | LEVEL_FAST << (2 * spot);
}

constexpr std::uint32_t kRobust = LEVELS_OF(LEVEL_ROBUST);

}  // namespace

std::span<const Mutation> mutations() {
  static const std::vector<Mutation> all = {
      {"moeller_trumbore",
       "triangles are tested as by Moeller and Trumbore",
       fast_at(SPOT_TRIANGLE),
       MUTATION_NONE,
       {"shared_edge", "shared_vertex", "far_mesh", "needles", "millions"}},
      {"contracted_edge",
       "one product of each edge value is not rounded, as by an fma",
       kRobust,
       MUTATION_CONTRACTED_EDGE,
       {"shared_edge", "shared_vertex", "far_mesh", "needles", "seam"}},
      {"unpadded_boxes",
       "box planes are not moved outwards by their error",
       fast_at(SPOT_BOX),
       MUTATION_NONE,
       {"flat_boxes", "box_alone", "box_corner", "zero_component"}},
      {"zero_direction",
       "direction components of 0 become 1e-18",
       kRobust,
       MUTATION_ZERO_DIRECTION,
       {"box_alone", "zero_component", "flat_boxes"}},
      {"fixed_epsilon",
       "secondary rays start a fixed distance off",
       fast_at(SPOT_SPAWN),
       MUTATION_NONE,
       {"self_hit_far", "self_hit", "near_shells", "layers_passed"}},
      {"no_lower_bound",
       "hits nearer than the error of t are taken",
       kRobust,
       MUTATION_NO_LOWER_BOUND,
       {"behind_origin", "self_hit", "self_hit_far", "neighbour_acne", "instance_transform"}},
      {"short_stack",
       "the traversal stack has two entries",
       kRobust,
       MUTATION_SHORT_STACK,
       {"deep_tree", "zero_component", "box_corner"}},
      {"textbook_fresnel",
       "Fresnel terms by the textbook",
       fast_at(SPOT_FRESNEL),
       MUTATION_NONE,
       {"fresnel_near_one", "fresnel_sweep", "fresnel_critical", "grazing_glass"}},
      {"pow_specular",
       "the highlight is a power of the cosine",
       fast_at(SPOT_SPECULAR),
       MUTATION_NONE,
       {"extreme_exponent"}},
      {"sign_in_frame",
       "sign() chooses the side of a shading normal",
       kRobust,
       MUTATION_SIGN_IN_FRAME,
       {"shading_normal"}},
      {"unclamped_fract",
       "a texture is read at x - floor(x), which may be 1",
       kRobust,
       MUTATION_UNCLAMPED_FRACT,
       {"texture_wrap"}},
      {"naive_sum", "samples are summed up in one float", fast_at(SPOT_SUM), MUTATION_NONE, {"many_samples"}},
      {"narrow_sum", "the carry into the film's high word is lost", kRobust, MUTATION_NARROW_SUM, {"many_samples"}},
      {"eye_plus_t",
       "places of hits are the eye plus t times the direction",
       fast_at(SPOT_POSITION),
       MUTATION_NONE,
       {"corner_cube", "mirror_corridor", "reference_scene", "instance_transform"}},
      {"metre_offset",
       "secondary rays start 1e-4 m off, however large the scene",
       kRobust,
       MUTATION_METRE_OFFSET,
       {"image_scale", "scale", "mirror_corridor", "nested_dielectrics"}},
      {"world_origin",
       "secondary rays start at world coordinates rounded to float",
       kRobust,
       MUTATION_WORLD_ORIGIN,
       {"far_scene"}},
      {"ties_skipped",
       "a ray that goes on leaves out what lies at the same t",
       kRobust,
       MUTATION_TIES_SKIPPED,
       {"image_layers"}},
      {"total_lost", "total reflection ends a ray", kRobust, MUTATION_TOTAL_LOST, {"white_furnace", "reference_scene"}},
      {"medium_kept",
       "a ray that leaves a body takes its medium along",
       kRobust,
       MUTATION_MEDIUM_KEPT,
       {"nested_dielectrics"}},
      {"short_floats",
       "weights of rays and texture coordinates keep the digits of a half float",
       kRobust,
       MUTATION_SHORT_FLOATS,
       {"light_trap", "perspective_uv", "white_furnace", "image_layers"}},
      {"tile_pattern",
       "samples lie by the place in the tile, not in the image",
       kRobust,
       MUTATION_TILE_PATTERN,
       {"image_order"}},
      {"point_normal",
       "normals of shared meshes are mapped as points are",
       kRobust,
       MUTATION_POINT_NORMAL,
       {"instance_shared"}},
      {"facet_terminator",
       "a triangle that faces away from a light is black, whatever its vertex normals",
       kRobust,
       MUTATION_FACET_TERMINATOR,
       {"rounded_terminator"}},
  };
  return all;
}

const Mutation* find_mutation(const std::string& name) {
  const std::span<const Mutation> all = mutations();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Mutation& one) { return name == one.name; });
  return found == all.end() ? nullptr : &*found;
}

std::string mutation_names() {
  std::string names;
  for (const Mutation& one : mutations()) names += (names.empty() ? "" : ", ") + std::string(one.name);
  return names;
}

CaseSetup seeded(const CaseSetup& setup, const Mutation& mutation) {
  CaseSetup with_fault = setup;
  with_fault.level = Accuracy::robust;
  with_fault.levels = mutation.levels;
  with_fault.mutation = mutation.mutation;
  return with_fault;
}

std::vector<CaseReport> run_mutation(const Mutation& mutation, const CaseSetup& setup) {
  std::vector<CaseReport> reports;
  CaseSetup sound = setup;
  sound.level = Accuracy::robust;
  sound.levels = kRobust;
  for (const char* name : mutation.cases) {
    const VerifyCase* verify_case = find_case(name);
    if (verify_case == nullptr || !run_case(*verify_case, sound).held) continue;
    reports.push_back(run_case(*verify_case, seeded(setup, mutation)));
  }
  return reports;
}

bool is_caught(std::span<const CaseReport> reports) {
  return std::any_of(reports.begin(), reports.end(), [](const CaseReport& report) { return !report.held; });
}

}  // namespace vernier
