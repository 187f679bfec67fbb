#pragma once

#include "scene/gltf_document.h"

namespace vernier {

/// Checks every index of `document` but those inside extensions of materials and meshes, which are checked where they
/// are read, the lengths of node transforms, and that nodes form trees: one parent at most, no cycle. Iterative,
/// O(file). Throws Error(refused) with the place and the size of what is indexed.
void check_gltf_references(const GltfDocument& document);

/// Throws Error(refused) unless `index` < `count`; `what` names the thing indexed, `place` who refers to it.
void check_gltf_index(const GltfDocument& document, const std::string& place, const char* what, int index,
                      std::size_t count);

/// The same where -1 means none.
void check_gltf_optional_index(const GltfDocument& document, const std::string& place, const char* what, int index,
                               std::size_t count);

}  // namespace vernier
