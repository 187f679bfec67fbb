#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace vernier {

/// Refuses (Error with the place in the file) objects that lack a member which glTF 2.0, or an extension that is
/// supported, calls for, and values that are none of theirs: the parser says what is wrong but not where, or passes
/// over the object. check_gltf_types has passed `root`.
void check_gltf_required(const nlohmann::json& root, const std::string& path);

}  // namespace vernier
