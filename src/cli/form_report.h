#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "render/calibrate_forms.h"

namespace vernier {

/// A line for each form, and which one `auto` is from now on.
std::string form_table(const FormCalibration& found);

/// {"device", "usual", "best", "forms": [{"form", "left_out", "compile_ms", "device_ms", "over_usual": {"median",
/// "least", "most"}}]}; times are null where there are none.
nlohmann::ordered_json form_json(const std::string& device, const FormCalibration& found);

}  // namespace vernier
