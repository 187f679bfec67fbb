#pragma once

#include <algorithm>
#include <string_view>

#include "verify/verify_case.h"

namespace vernier {

/// Whole scenes at (148376, 1234, -223423), their corners rounded to float there: nothing outside is seen from inside a
/// closed mesh, and shadows darken no pixel of a convex body.
CaseResult run_far_scene(const CaseSetup& setup);
/// A scene 2^k times as large, k from -60 to 60, has the picture's bits.
CaseResult run_image_scale(const CaseSetup& setup);
/// 100 layers one step of float apart are seen, and darken a shadow, once each.
CaseResult run_image_layers(const CaseSetup& setup);
/// Rays on 2 million triangles hit what the same rays against each triangle alone hit, bit for bit. The first 2^13
/// samples go to a mesh of 2^17 triangles.
CaseResult run_millions(const CaseSetup& setup);
/// Hits of instances against float128 on the corners as they are transformed without rounding. Scales of 1e-4 to 1e4
/// per axis, mirrors, shears, moves of 1e6.
CaseResult run_instance_transform(const CaseSetup& setup);
/// The same for meshes that are traced in their own space.
CaseResult run_instance_shared(const CaseSetup& setup);
/// Instances whose transform is singular are told of and change no bit of the rest of the picture.
CaseResult run_singular_transform(const CaseSetup& setup);
/// Glass boxes and spheres are not seen in a white world, within the level's Fresnel bound.
CaseResult run_white_furnace(const CaseSetup& setup);
/// The light between two glowing mirrors is the geometric series of their reflectance, up to 1000 bounces.
CaseResult run_light_trap(const CaseSetup& setup);
/// A ray leaves a corridor of mirrors, after up to 1000 bounces, where the straight ray of the unfolded corridor does.
CaseResult run_mirror_corridor(const CaseSetup& setup);
/// A ray leaves a corner of three mirrors parallel to itself.
CaseResult run_corner_cube(const CaseSetup& setup);
/// Boxes one in the other, overlapping and face to face absorb what the boxes last entered do, and nothing outside.
CaseResult run_nested_dielectrics(const CaseSetup& setup);
/// A coarse sphere with vertex normals is lit as the round one that they mean, facets that face away from the light
/// included.
CaseResult run_rounded_terminator(const CaseSetup& setup);
/// Texture coordinates on a ground that runs on behind the camera, and no gap in it.
CaseResult run_perspective_uv(const CaseSetup& setup);
/// Tiles, dispatches and crops change no bit.
CaseResult run_image_order(const CaseSetup& setup);
/// The first two devices hit the same triangles at exact and have the same colours but for a step of an 8-bit picture.
CaseResult run_driver_difference(const CaseSetup& setup);
/// Pictures against the reference renderer, where rounding cannot decide them.
CaseResult run_reference_scene(const CaseSetup& setup);

inline constexpr VerifyCase kImageCases[] = {
    {4, "far_scene", "far from 0 no leak and no false shadow is seen", "metamorphic", run_far_scene},
    {7, "image_scale", "pictures of scenes times 2^k have the same bits", "metamorphic", run_image_scale},
    {13, "image_layers", "100 layers one step apart count once each", "analytic", run_image_layers},
    {30, "millions", "hits among 2 million triangles are those of brute force", "metamorphic", run_millions},
    {32, "instance_transform", "instances are hit where their transform puts them", "float128", run_instance_transform},
    {32, "instance_shared", "so are those that share their mesh, and no ray meets its own triangle again", "float128",
     run_instance_shared},
    {33, "singular_transform", "singular instances are dropped with a warning", "metamorphic", run_singular_transform},
    {39, "white_furnace", "clear glass is not seen in a white world", "conservation", run_white_furnace},
    {40, "light_trap", "light between mirrors is a geometric series", "analytic", run_light_trap},
    {40, "mirror_corridor", "directions hold through 1000 bounces", "analytic", run_mirror_corridor},
    {40, "corner_cube", "three mirrors send a ray back parallel to itself", "analytic", run_corner_cube},
    {41, "nested_dielectrics", "no medium is left behind outside", "analytic", run_nested_dielectrics},
    {47, "rounded_terminator", "vertex normals shade a coarse sphere as a round one", "analytic",
     run_rounded_terminator},
    {49, "perspective_uv", "texture coordinates of a ground up to the horizon", "analytic", run_perspective_uv},
    {51, "image_order", "tiles, dispatches and crops change no bit", "metamorphic", run_image_order},
    {55, "driver_difference", "two devices make the same picture", "metamorphic", run_driver_difference},
    {56, "reference_scene", "pictures against the renderer in double", "double", run_reference_scene},
};

/// Whether `name` is that of one of these cases.
inline bool is_image_case(std::string_view name) {
  return std::ranges::any_of(kImageCases, [&](const VerifyCase& one) { return one.name == name; });
}

}  // namespace vernier
