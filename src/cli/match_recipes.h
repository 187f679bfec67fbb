#pragma once

#include <map>
#include <set>
#include <string>

namespace vernier {

/// Throws Error(refused) unless the metadata `a` and `b` (render_recipe) are of renders whose samples have the same
/// bits and can be added up: the line names both and the first thing in which they differ: version, shaders, scene,
/// device, driver or an option that is not among `free_options`. Where the files of a scene lie may differ.
void match_recipes(const std::string& name_a, const std::map<std::string, std::string>& a, const std::string& name_b,
                   const std::map<std::string, std::string>& b, const std::set<std::string>& free_options);

}  // namespace vernier
