#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/load_scene.h"
#include "scene/obj_textures.h"
#include "scene/parse_mtl.h"
#include "scene/scene.h"

namespace vernier {

/// `source` as a material of Workflow::blinn, without textures. Absent values:
/// Kd 0.8 grey (white under a map_Kd); Ks, Ke black (white under their map); Ns 10; illum 2 where Ks is not black and
/// Ns is given above 0, else 1. Ka: as given, but absent, white or black is Kd: both are what exporters write who know
/// no Ka, and literally white makes every surface glow like the sky, black leaves shadows without any light. illum: 0
/// unlit Kd; 1 diffuse; 2 and more with highlight where Ns is above 0; 3, 8 mirror of Ks; 5 mirror with Fresnel; 4, 7,
/// 9 glass with Fresnel; 6 glass without. Glass lets Tf through (Kt the same); without Tf white or, where d < 1, 1 - d,
/// and Kd then counts d times. Ni absent or not above 0 is 1.5, with a warning for glass. Others: d < 1 is blended.
/// `warnings` gets lines that start with `place`.
Material blinn_material(const MtlMaterial& source, const std::string& place, std::vector<std::string>& warnings);

/// Reads the MTL files `libraries` (as written in mtllib, relative to the OBJ at `obj_path`) into the materials of
/// `loading`, with their textures. Returns the index by name; of two with one name the first counts. Missing
/// files and unsupported statements are warnings, or with options.strict an Error(refused).
std::map<std::string, std::uint32_t> load_obj_materials(LoadingScene& loading, const std::string& obj_path,
                                                        const std::vector<std::string>& libraries,
                                                        const LoadOptions& options);

/// Tells about a feature that is not supported: a warning, or with options.strict an Error(refused) with the same line.
void warn_unsupported(Scene& scene, const LoadOptions& options, const std::string& line);

/// What a face without a material shows: 0.8 grey, diffuse.
Material default_obj_material();

}  // namespace vernier
