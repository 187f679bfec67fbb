#include "accuracy/cost_json.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace vernier {
namespace {

using Json = nlohmann::ordered_json;

Interval interval_of_runs(const std::vector<CostRun>& runs, double ErrorFigures::*figure) {
  std::vector<double> values;
  for (const CostRun& run : runs) values.push_back(run.figures.*figure);
  return interval_of(values);
}

/// Of a figure that is never below 0: nor is the true one.
Interval error_interval(const std::vector<CostRun>& runs, double ErrorFigures::*figure) {
  Interval interval = interval_of_runs(runs, figure);
  if (interval.low < 0.0) interval.low = 0.0;
  return interval;
}

Spread spread_of_runs(const std::vector<CostRun>& runs, double CostRun::*time) {
  std::vector<double> values;
  for (const CostRun& run : runs) values.push_back(run.*time);
  return spread_of(values);
}

double claimed(const std::vector<CostRun>& runs) {
  std::vector<double> errors;
  for (const CostRun& run : runs) errors.push_back(run.figures.rel_error);
  return bound_of_next(errors);
}

void add_bias(const PointResult& result, PointSummary& summary) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  summary.bias_squared = {kNone, kNone, kNone};
  if (result.bias_products.empty()) return;
  summary.bias_squared = interval_of(result.bias_products);
  summary.is_biased = summary.bias_squared.low > 0.0;
  if (summary.is_biased) summary.bias_floor = std::sqrt(summary.bias_squared.mean);
}

Json interval_json(const Interval& interval) {
  return {{"mean", interval.mean}, {"low", interval.low}, {"high", interval.high}};
}

Json spread_json(const Spread& spread) {
  return {{"median", spread.median}, {"least", spread.least}, {"most", spread.most}};
}

Json options_json(const CostPoint& point) {
  Json options = Json::object();
  for (const auto& [name, value] : point.options) options[name] = value;
  return options;
}

Json point_json(const PointResult& result, const PointSummary& summary) {
  Json json{{"name", result.point.name}, {"axis", result.point.axis}, {"options", options_json(result.point)}};
  json["runs"] = result.runs.size();
  json["device_ms"] = spread_json(summary.device_ms);
  json["wall_ms"] = spread_json(summary.wall_ms);
  json["compile_ms"] = result.compile_ms;
  json["rays"] = summary.rays;
  json["mean_samples"] = summary.mean_samples;
  json["rel_error"] = interval_json(summary.rel_error);
  json["claimed_error"] = summary.claimed_error;
  json["rmse"] = interval_json(summary.rmse);
  json["rel_mse"] = interval_json(summary.rel_mse);
  json["psnr_db"] = interval_json(summary.psnr_db);
  json["flip_mean"] = interval_json(summary.flip_mean);
  json["flip_p99"] = interval_json(summary.flip_p99);
  json["max"] = interval_json(summary.most);
  json["non_finite"] = summary.non_finite;
  json["bias_squared"] = interval_json(summary.bias_squared);
  json["bias_floor"] = summary.bias_floor;
  json["efficiency"] = summary.efficiency;
  return json;
}

/// Names and times of points that render can be told, errors as claimed; others are as if they never ended.
std::vector<CostAndError> choices(const Sweep& sweep, const std::vector<PointSummary>& summaries) {
  std::vector<CostAndError> all = costs_and_errors(summaries);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!sweep.points[i].point.has_command) all[i].time_ms = std::numeric_limits<double>::infinity();
  }
  return all;
}

/// By the mean error, which is what plots show: by claims, which hold the spread over seeds too, the front would rise
/// there.
Json pareto_json(const Sweep& sweep, const std::vector<PointSummary>& summaries, std::vector<CostAndError> all) {
  for (std::size_t i = 0; i < all.size(); ++i) all[i].error = summaries[i].rel_error.mean;
  Json front = Json::array();
  for (const std::size_t i : pareto_front(all)) front.push_back(sweep.points[i].point.name);
  return front;
}

Json recommendations_json(const Sweep& sweep, const std::vector<CostAndError>& all, const CostNames& names) {
  Json list = Json::array();
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const CostAndError& one : all) {
    if (!std::isfinite(one.time_ms) || !std::isfinite(one.error)) continue;
    least = std::min(least, one.error);
    most = std::max(most, one.error);
  }
  for (const double error : round_errors(least, most)) {
    const std::optional<std::size_t> best = cheapest_within(all, error);
    if (!best || !std::isfinite(all[*best].time_ms)) continue;
    list.push_back({{"error", error},
                    {"name", sweep.points[*best].point.name},
                    {"claimed_error", all[*best].error},
                    {"device_ms", all[*best].time_ms},
                    {"command", names.commands[*best]}});
  }
  return list;
}

/// Of the points of the axis of samples that have no bias: they alone fall by samples.
Json slope_json(const Sweep& sweep, const std::vector<PointSummary>& summaries) {
  std::vector<CostAndError> points;
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const CostPoint& point = sweep.points[i].point;
    if (point.axis != "spp" || point.settings.spp == 1) continue;
    points.push_back({summaries[i].device_ms.median, summaries[i].rel_error.mean});
  }
  const std::optional<double> slope = log_slope(points);
  return slope ? Json(*slope) : Json(nullptr);
}

Json reference_json(const ConvergedReference& reference, const CostNames& names) {
  Json json{{"file", reference.file.empty() ? Json(nullptr) : Json(reference.file)},
            {"picture", names.reference_picture}};
  if (!reference.file.empty()) return json;
  json["spp"] = reference.spp;
  json["max_bounces"] = reference.settings.max_bounces;
  json["cutoff"] = reference.settings.cutoff;
  json["accuracy"] = to_string(reference.settings.accuracy);
  json["rel_error"] = reference.rel_error;
  json["rmse"] = reference.rmse;
  return json;
}

}  // namespace

PointSummary summarize(const PointResult& result) {
  const std::vector<CostRun>& runs = result.runs;
  PointSummary summary;
  summary.device_ms = spread_of_runs(runs, &CostRun::device_ms);
  summary.wall_ms = spread_of_runs(runs, &CostRun::wall_ms);
  summary.rel_error = error_interval(runs, &ErrorFigures::rel_error);
  summary.rmse = error_interval(runs, &ErrorFigures::rmse);
  summary.rel_mse = error_interval(runs, &ErrorFigures::rel_mse);
  summary.psnr_db = interval_of_runs(runs, &ErrorFigures::psnr_db);
  summary.flip_mean = error_interval(runs, &ErrorFigures::flip_mean);
  summary.flip_p99 = error_interval(runs, &ErrorFigures::flip_p99);
  summary.most = error_interval(runs, &ErrorFigures::most);
  summary.claimed_error = claimed(runs);
  add_bias(result, summary);
  summary.efficiency = 1000.0 / (summary.rel_mse.mean * summary.device_ms.median);
  const double count = static_cast<double>(runs.size());
  for (const CostRun& run : runs) {
    summary.rays += static_cast<double>(run.rays) / count;
    summary.mean_samples += run.mean_samples / count;
    summary.non_finite = std::max(summary.non_finite, run.figures.non_finite);
  }
  return summary;
}

std::vector<CostAndError> costs_and_errors(const std::vector<PointSummary>& summaries) {
  std::vector<CostAndError> all;
  for (const PointSummary& summary : summaries) all.push_back({summary.device_ms.median, summary.claimed_error});
  return all;
}

nlohmann::ordered_json cost_json(const Sweep& sweep, const SweepSetup& setup, const CostNames& names) {
  std::vector<PointSummary> summaries;
  for (const PointResult& result : sweep.points) summaries.push_back(summarize(result));
  const std::vector<CostAndError> all = choices(sweep, summaries);
  const RenderSettings& settings = setup.settings;
  Json json{{"schema", 1}, {"scene", names.scene}, {"device", names.device}, {"driver", names.driver}};
  json["size"] = {settings.width, settings.height};
  json["settings"] = {{"spp", settings.spp},
                      {"max_bounces", settings.max_bounces},
                      {"cutoff", settings.cutoff},
                      {"accuracy", to_string(settings.accuracy)},
                      {"effects", settings.effects},
                      {"filter", to_string(settings.pixel_filter)},
                      {"texture_filter", to_string(settings.texture_filter)}};
  json["complete"] = sweep.complete;
  json["budget_s"] = names.budget_s;
  json["seconds"] = sweep.seconds;
  json["build_ms"] = sweep.build_ms;
  json["upload_ms"] = sweep.upload_ms;
  json["reference"] = reference_json(sweep.reference, names);
  json["slope"] = slope_json(sweep, summaries);
  json["points"] = Json::array();
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    Json point = point_json(sweep.points[i], summaries[i]);
    point["command"] = sweep.points[i].point.has_command ? Json(names.commands[i]) : Json(nullptr);
    point["picture"] = names.pictures[i];
    point["flip_map"] = names.maps[i];
    json["points"].push_back(point);
  }
  json["pareto"] = pareto_json(sweep, summaries, all);
  json["recommendations"] = recommendations_json(sweep, all, names);
  json["left_out"] = sweep.left_out;
  return json;
}

namespace {

/// In the order of the columns of cost.csv, from build_ms on.
std::vector<double> csv_figures(const Sweep& sweep, const PointResult& result) {
  const PointSummary summary = summarize(result);
  std::vector<double> values{
      sweep.build_ms,          sweep.upload_ms,        result.compile_ms,      summary.device_ms.median,
      summary.device_ms.least, summary.device_ms.most, summary.wall_ms.median, summary.rays,
      summary.mean_samples};
  const auto add = [&](const Interval& interval) {
    values.insert(values.end(), {interval.mean, interval.low, interval.high});
  };
  add(summary.rel_error);
  values.insert(values.end(), {summary.claimed_error, summary.bias_floor});
  for (const Interval* one :
       {&summary.rmse, &summary.rel_mse, &summary.psnr_db, &summary.flip_mean, &summary.flip_p99, &summary.most}) {
    add(*one);
  }
  values.insert(values.end(), {static_cast<double>(summary.non_finite), summary.efficiency});
  return values;
}

}  // namespace

std::string cost_csv(const Sweep& sweep) {
  std::string text =
      "name,axis,runs,build_ms,upload_ms,compile_ms,device_ms,device_ms_least,device_ms_most,wall_ms,rays,mean_samples,"
      "rel_error,rel_error_low,rel_error_high,claimed_error,bias_floor,rmse,rmse_low,rmse_high,rel_mse,rel_mse_low,"
      "rel_mse_high,psnr_db,psnr_db_low,psnr_db_high,flip_mean,flip_mean_low,flip_mean_high,flip_p99,flip_p99_low,"
      "flip_p99_high,max,max_low,max_high,non_finite,efficiency\n";
  for (const PointResult& result : sweep.points) {
    text += "\"" + result.point.name + "\"," + result.point.axis + "," + std::to_string(result.runs.size());
    for (const double value : csv_figures(sweep, result)) {
      char figure[32];
      std::snprintf(figure, sizeof figure, ",%.9g", value);
      text += figure;
    }
    text += "\n";
  }
  return text;
}

}  // namespace vernier
