#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/cost_choice.h"
#include "accuracy/interval.h"
#include "accuracy/sweep.h"
#include "math/spread.h"

namespace vernier {

/// A point in figures: what cost.json and cost.csv tell of it.
struct PointSummary {
  Spread device_ms;
  Spread wall_ms;
  Interval rel_error;  ///< sqrt(relMSE)
  Interval rmse;
  Interval rel_mse;
  Interval psnr_db;
  Interval flip_mean;
  Interval flip_p99;
  Interval most;
  double claimed_error = 0.0;  ///< sqrt(relMSE) that the next seed stays below with 97.5 % confidence
  Interval bias_squared;       ///< in the measure of relMSE; mean NaN without a pair of runs
  bool is_biased = false;      ///< the squared bias lies above 0 with 97.5 % confidence
  double bias_floor = 0.0;     ///< sqrt of the squared bias, 0 where it is not told apart from noise
  double efficiency = 0.0;     ///< 1 / (relMSE x seconds on the device)
  double rays = 0.0;           ///< mean
  double mean_samples = 0.0;
  std::uint64_t non_finite = 0;  ///< pixels, the most of a run
};

/// The figures of `result`, which has at least two runs.
PointSummary summarize(const PointResult& result);

/// Time (median, on the device) and claimed error of points.
std::vector<CostAndError> costs_and_errors(const std::vector<PointSummary>& summaries);

/// Where the report of a sweep comes from, and how its points are named outside.
struct CostNames {
  std::string scene;
  std::string device;
  std::string driver;
  double budget_s = 0.0;
  std::vector<std::string> commands;  ///< by point; empty where no options say it
  std::vector<std::string> pictures;  ///< by point: files beside cost.json
  std::vector<std::string> maps;
  std::string reference_picture;
};

/// cost.json: {"schema": 1, "scene", "device", ..., "reference", "points", "pareto", "recommendations", "slope"}. Times
/// in milliseconds, errors with their 95 % interval. Numbers that are not finite are null.
nlohmann::ordered_json cost_json(const Sweep& sweep, const SweepSetup& setup, const CostNames& names);

/// cost.csv: a line of names, then one per point, the same figures.
std::string cost_csv(const Sweep& sweep);

}  // namespace vernier
