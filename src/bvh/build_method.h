#pragma once

#include <array>
#include <string_view>

namespace vernier {

/// How the binary tree under a BVH is found. None changes a bit of a picture at the levels robust and exact, whose
/// boxes lose no hit; only the layer `cost` counts what a tree makes of it.
enum class BuildMethod {
  fast,      ///< by Morton codes: quickest to build
  standard,  ///< by the surface area heuristic over 16 bins
  quality    ///< like standard, then subtrees move to where their nodes have less area
};

/// All of them.
inline constexpr std::array kBuildMethods = {BuildMethod::fast, BuildMethod::standard, BuildMethod::quality};

/// The method's name on the command line.
constexpr std::string_view to_string(BuildMethod method) {
  return method == BuildMethod::fast ? "fast" : method == BuildMethod::standard ? "default" : "quality";
}

}  // namespace vernier
