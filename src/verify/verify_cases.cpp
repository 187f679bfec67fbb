#include <array>

#include "verify/verify_case.h"
#include "verify/watertight_cases.h"

namespace vernier {
namespace {

constexpr std::array kCases = {
    VerifyCase{1, "shared_edge", "rays at edges of a closed mesh do not get out", "metamorphic", run_shared_edge},
    VerifyCase{2, "shared_vertex", "rays at vertices of a closed mesh do not get out", "metamorphic",
               run_shared_vertex},
    VerifyCase{3, "single_hit", "rays leave a convex mesh through one triangle", "metamorphic", run_single_hit},
    VerifyCase{4, "far_mesh", "the same far from the origin", "metamorphic", run_far_mesh},
    VerifyCase{5, "needles", "the same for triangles of aspect 1e2 to 1e5", "metamorphic", run_needles},
    VerifyCase{6, "tiny_mesh", "the same for meshes of 1e-6 at 1 and 1e-12 at 0", "metamorphic", run_tiny_mesh},
    VerifyCase{11, "edge_on", "rays along an edge do not get out", "metamorphic", run_edge_on},
    VerifyCase{24, "origin_on_surface", "rays from the surface inwards come out again", "metamorphic",
               run_origin_on_surface},
    VerifyCase{54, "seam", "two triangles that fill the picture show no gap", "metamorphic", run_seam},
};

}  // namespace

std::span<const VerifyCase> verify_cases() {
  return kCases;
}

}  // namespace vernier
