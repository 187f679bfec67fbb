#pragma once

#include <optional>
#include <string>

#include "gpu/device.h"
#include "render/traversal_form.h"
#include "scene/scene.h"

namespace vernier {

/// Where the form that was quickest on devices with `pipeline_key` is kept: beside their compiled pipelines
/// (pipeline_file), or nowhere.
std::string form_file(const std::string& pipeline_key);

/// The form in `file`; none where there is no such file, or it says something else.
std::optional<TraversalForm> read_form(const std::string& file);

/// Writes `form` as `file`, and makes its folder. Throws Error(failed) where that is not possible.
void write_form(const std::string& file, TraversalForm form);

/// `form`; in place of automatic the one that was found quickest on `device`, if any was looked for and the device has
/// it still. Not ray queries where `scene` shares meshes, of which those would make copies.
TraversalForm calibrated_form(const DeviceDescription& device, const Scene& scene, TraversalForm form);

}  // namespace vernier
