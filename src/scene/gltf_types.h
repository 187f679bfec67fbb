#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace vernier {

/// "material 3" for element 3 of `materials`.
std::string gltf_element_name(const std::string& array, std::size_t index);

/// Whether the members of the extension are checked: it is supported, and its content not compressed.
bool is_checked_gltf_extension(std::string_view name);

/// Refuses (Error with the place in the file) a member of a type that glTF 2.0, or an extension that is supported, does
/// not give it: a parser further down takes what is below 0 or no number for not given.
void check_gltf_types(const nlohmann::json& root, const std::string& path);

}  // namespace vernier
