#pragma once

#include "scene/gltf_document.h"

namespace vernier {

/// Decodes every bufferView of EXT_meshopt_compression (modes ATTRIBUTES, TRIANGLES, INDICES; filters OCTAHEDRAL,
/// QUATERNION, EXPONENTIAL) into a buffer of its own and lets the view show it, so that nobody else has to know. Throws
/// Error(refused) for wrong parameters, data the decoder does not take or sizes beyond kMaxGltfBytes.
void expand_gltf_meshopt(GltfDocument& document);

}  // namespace vernier
