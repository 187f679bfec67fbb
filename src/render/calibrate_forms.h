#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "math/spread.h"
#include "render/render_settings.h"
#include "render/timed_trace.h"
#include "scene/scene.h"

namespace vernier {

/// What one form took on a device.
struct FormTiming {
  TraversalForm form = TraversalForm::automatic;
  std::string left_out;  ///< why there are no times: the device refuses it, or it draws another picture
  double compile_ms = 0.0;
  double device_ms = 0.0;  ///< of a picture, median
  Spread ratio;            ///< of its time to that of the device's default right before
};

/// All forms on a device, and which is best there.
struct FormCalibration {
  TraversalForm usual = TraversalForm::automatic;  ///< resolve_form without a calibration
  TraversalForm best = TraversalForm::automatic;   ///< `usual`, unless another was quicker each time, by 5 % or more
  std::vector<FormTiming> forms;                   ///< of kTraversalForms but automatic
};

/// The picture that is timed.
struct FormBench {
  int width = 192;  ///< pixels
  int height = 108;
  std::uint32_t spp = 2;
  int rounds = 5;
  std::function<void(double share)> progress = [](double) {};
  std::function<bool()> stop;  ///< true: give up; may be empty
};

/// Draws `scene` by every form in turn, `bench.rounds` times, each right after the usual one. None where it was
/// stopped.
std::optional<FormCalibration> calibrate_forms(const Device& device, const Scene& scene, const Camera& camera,
                                               const FormBench& bench);

}  // namespace vernier
