#include <algorithm>
#include <array>
#include <vector>

#include "verify/box_cases.h"
#include "verify/build_cases.h"
#include "verify/camera_cases.h"
#include "verify/fresnel_cases.h"
#include "verify/hit_cases.h"
#include "verify/image_cases.h"
#include "verify/light_cases.h"
#include "verify/refraction_cases.h"
#include "verify/spawn_cases.h"
#include "verify/specular_cases.h"
#include "verify/sum_cases.h"
#include "verify/terminator_cases.h"
#include "verify/texture_cases.h"
#include "verify/vector_cases.h"
#include "verify/verify_case.h"
#include "verify/watertight_cases.h"

namespace vernier {
namespace {

constexpr std::array kGeometryCases = {
    VerifyCase{1, "shared_edge", "rays at edges of a closed mesh do not get out", "metamorphic", run_shared_edge},
    VerifyCase{2, "shared_vertex", "rays at vertices of a closed mesh do not get out", "metamorphic",
               run_shared_vertex},
    VerifyCase{3, "single_hit", "rays leave a convex mesh through one triangle", "metamorphic", run_single_hit},
    VerifyCase{4, "far_mesh", "the same far from the origin", "metamorphic", run_far_mesh},
    VerifyCase{5, "needles", "the same for triangles of aspect 1e2 to 1e5", "metamorphic", run_needles},
    VerifyCase{6, "tiny_mesh", "the same for meshes of 1e-6 at 1 and 1e-12 at 0", "metamorphic", run_tiny_mesh},
    VerifyCase{7, "scale", "scenes times 2^k have the same hits", "metamorphic", run_scale},
    VerifyCase{8, "mixed_scales", "triangles of 1e-6 are found over a ground of 1e6", "float128", run_mixed_scales},
    VerifyCase{9, "degenerate", "triangles without area are never hit", "analytic", run_degenerate},
    VerifyCase{10, "near_degenerate", "normals of thin triangles", "float128", run_near_degenerate},
    VerifyCase{11, "edge_on", "rays along an edge do not get out", "metamorphic", run_edge_on},
    VerifyCase{12, "coplanar_duplicates", "the lowest number of identical triangles is hit", "analytic",
               run_coplanar_duplicates},
    VerifyCase{13, "layers", "100 squares are hit once each, in order", "analytic", run_layers},
    VerifyCase{13, "layers_passed", "rays that go on meet the next square", "analytic", run_layers_passed},
    VerifyCase{14, "near_shells", "rays that go on meet the shell below", "analytic", run_near_shells},
    VerifyCase{15, "self_hit", "no ray meets its own triangle again", "analytic", run_self_hit},
    VerifyCase{15, "behind_origin", "no triangle behind the origin is hit", "float128", run_behind_origin},
    VerifyCase{16, "self_hit_far", "the same far from 0, and the offset is small", "analytic", run_self_hit_far},
    VerifyCase{17, "neighbour_acne", "no ray meets a neighbour that bends away", "float128", run_neighbour_acne},
    VerifyCase{18, "detached_shadow", "no light gets under a box on the floor", "analytic", run_detached_shadow},
    VerifyCase{19, "grazing", "t of rays along a plane", "float128", run_grazing},
    VerifyCase{20, "zero_component", "no box hides a hit from rays along axes", "metamorphic", run_zero_component},
    VerifyCase{21, "tiny_components", "the same for components down to denormals", "metamorphic", run_tiny_components},
    VerifyCase{22, "flat_boxes", "squares across the axes have no holes", "metamorphic", run_flat_boxes},
    VerifyCase{23, "box_corner", "no box hides a hit at a vertex", "metamorphic", run_box_corner},
    VerifyCase{23, "box_alone", "a ray that hits a triangle enters its box", "metamorphic", run_box_alone},
    VerifyCase{24, "origin_on_surface", "rays from the surface inwards come out again", "metamorphic",
               run_origin_on_surface},
    VerifyCase{25, "t_limits", "limits of t hold to the last bit", "metamorphic", run_t_limits},
    VerifyCase{26, "invalid_rays", "rays with NaN, infinity or no direction miss at no cost", "metamorphic",
               run_invalid_rays},
    VerifyCase{27, "garbage_mesh", "random bits are refused or traced to an end", "metamorphic", run_garbage_mesh},
    VerifyCase{28, "identical_centroids", "triangles with one centre are found, the tree is not deep", "metamorphic",
               run_identical_centroids},
    VerifyCase{29, "deep_tree", "the stack of the traversal suffices", "metamorphic", run_deep_tree},
    VerifyCase{31, "build_order", "the order of triangles changes no bit", "metamorphic", run_build_order},
    VerifyCase{34, "mirror", "a mirroring instance has the bits of a mirrored mesh", "metamorphic", run_mirror},
    VerifyCase{54, "seam", "two triangles that fill the picture show no gap", "metamorphic", run_seam},
};

std::vector<VerifyCase> joined_cases() {
  std::vector<VerifyCase> cases(kGeometryCases.begin(), kGeometryCases.end());
  const auto append = [&](std::span<const VerifyCase> more) { cases.insert(cases.end(), more.begin(), more.end()); };
  append(kFresnelCases);
  append(kRefractionCases);
  append(kSpecularCases);
  append(kVectorCases);
  append(kTextureCases);
  append(kSumCases);
  append(kLightCases);
  append(kCameraCases);
  append(kTerminatorCases);
  append(kImageCases);
  std::ranges::stable_sort(cases, {}, &VerifyCase::number);
  return cases;
}

}  // namespace

std::span<const VerifyCase> verify_cases() {
  static const std::vector<VerifyCase> cases = joined_cases();
  return cases;
}

}  // namespace vernier
