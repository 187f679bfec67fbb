#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "accuracy/converged_reference.h"
#include "accuracy/cost_plan.h"
#include "accuracy/error_figures.h"
#include "gpu/device.h"
#include "scene/scene.h"

namespace vernier {

/// One render of a point.
struct CostRun {
  std::uint32_t seed = 0;
  double device_ms = 0.0;  ///< by timestamps
  double wall_ms = 0.0;
  double mean_samples = 0.0;  ///< per pixel
  std::uint64_t rays = 0;     ///< of all kinds
  ErrorFigures figures;
};

/// A point and what was measured of it.
struct PointResult {
  CostPoint point;
  double compile_ms = 0.0;  ///< of its pipeline, which points of the same effects and levels share
  std::vector<CostRun> runs;
  std::vector<double> bias_products;  ///< of pairs of runs (bias_product), for the floor
  Image first_picture;
  FlipError first_map;
};

/// What a sweep goes by.
struct SweepSetup {
  RenderSettings settings;
  double budget_s = 300.0;     ///< wall time of the whole sweep
  bool quick = false;          ///< the most telling points alone
  std::optional<Image> truth;  ///< a reference that somebody else made, [height][width][4]
  std::string truth_file;
  /// Called with the share of the budget that is spent and what is being done, "reference" or "round 2"; may be empty.
  std::function<void(double, std::string_view)> progress;
  std::function<bool()> stop;  ///< true: return what is measured; may be empty
};

/// What a sweep found.
struct Sweep {
  ConvergedReference reference;
  double build_ms = 0.0;   ///< packing the scene and building its BVH
  double upload_ms = 0.0;  ///< to the device
  std::vector<PointResult> points;
  std::vector<std::string> left_out;  ///< names of points for which there was no time
  bool complete = true;               ///< false: stopped before each point had two runs
  double seconds = 0.0;               ///< wall time
};

/// Renders `scene`, which has passed validate_scene, at all points of the plan in turn, a round for a seed, until the
/// budget is spent: times and errors of all points come from the same minutes. All points have the same number of runs,
/// 2 to 16. The budget is kept but for one run of each point. Throws Error as a render does, and Error(usage) for a
/// reference of another size.
Sweep measure_costs(const Device& device, const Scene& scene, const Camera& camera, const SweepSetup& setup);

}  // namespace vernier
