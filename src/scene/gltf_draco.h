#pragma once

#include "scene/gltf_document.h"

namespace vernier {

/// Decodes every primitive of KHR_draco_mesh_compression into buffers, views and accessors of its own and lets the
/// primitive use them in place of the uncompressed ones, so that nobody else has to know. Attributes the extension does
/// not name stay. Throws Error(refused) for data the decoder does not take, attributes that are missing in them, or
/// indices beyond the vertices.
void expand_gltf_draco(GltfDocument& document);

}  // namespace vernier
