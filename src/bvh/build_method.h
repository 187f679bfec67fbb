#pragma once

namespace vernier {

/// How the binary tree under a BVH is found. None changes a bit of a picture.
enum class BuildMethod {
  fast,      ///< by Morton codes: quickest to build
  standard,  ///< by the surface area heuristic over 16 bins
};

}  // namespace vernier
