#pragma once

#include "verify/verify_case.h"

namespace vernier {

// Closed meshes, from inside: no ray may get out. Rays are aimed, for rays at random find no leak at all.

/// 1: edges of bumpy spheres.
CaseResult run_shared_edge(const CaseSetup& setup);
/// 2: vertices where 3, 4 to 7 and 1024 triangles meet.
CaseResult run_shared_vertex(const CaseSetup& setup);
/// 3: exactly one hit out of a convex mesh; the error is the number of hits too many.
CaseResult run_single_hit(const CaseSetup& setup);
/// 4: meshes so far from the origin that their edges have few steps.
CaseResult run_far_mesh(const CaseSetup& setup);
/// 5: triangles of aspect 100 to 100000.
CaseResult run_needles(const CaseSetup& setup);
/// 6: meshes of 1e-6 at 1 and of 1e-12 at 0.
CaseResult run_tiny_mesh(const CaseSetup& setup);
/// 11: rays in the plane of a triangle along its edge.
CaseResult run_edge_on(const CaseSetup& setup);
/// 24: rays that start in a vertex, on an edge, on a face, and cross the mesh.
CaseResult run_origin_on_surface(const CaseSetup& setup);
/// 54: two triangles that fill the picture.
CaseResult run_seam(const CaseSetup& setup);

}  // namespace vernier
