#include "verify/verify_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string_view>

namespace vernier {
namespace {

/// "1.2e-07", or "-" where there is nothing to say.
std::string figure(bool there, double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return there ? text : "-";
}

template <typename... Values>
std::string row(const char* format, Values... values) {
  char text[512];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// Whether samples could have failed and none did.
bool none_failed(const CaseReport& report) {
  return report.has_target && report.result.failures == 0;
}

std::string verdict(const CaseReport& report) {
  if (!report.result.not_run.empty()) return "not run: " + report.result.not_run;
  return !report.held ? "FAILED" : report.has_target ? "held" : "no target";
}

nlohmann::json case_json(const CaseReport& report) {
  const CaseResult& result = report.result;
  nlohmann::json json = {{"number", report.verify_case->number},
                         {"name", report.verify_case->name},
                         {"property", report.verify_case->property},
                         {"oracle", report.verify_case->oracle},
                         {"samples", result.samples},
                         {"failures", result.failures},
                         {"non_finite", result.non_finite},
                         {"seconds", report.seconds},
                         {"held", report.held},
                         {"has_target", report.has_target}};
  json["rate_bound"] = none_failed(report) ? nlohmann::json(rate_bound(result.samples)) : nlohmann::json(nullptr);
  if (result.has_errors) {
    json["error"] = {
        {"unit", result.unit}, {"p50", result.p50}, {"p99", result.p99}, {"max", result.max}, {"rms", result.rms}};
    json["error"]["bound"] = std::isfinite(result.bound) ? nlohmann::json(result.bound) : nlohmann::json(nullptr);
  }
  if (!result.not_run.empty()) json["not_run"] = result.not_run;
  if (result.failures > 0) json["first_failure"] = result.first_failure;
  json["worst_inputs"] = result.worst_inputs;
  return json;
}

/// tutorials/verify of Embree, watertight_triangles: rays of all its packet sizes, none of them aimed, and the share of
/// them that may get out (numerics.md 2.1).
constexpr std::uint64_t kEmbreeRays = 10900;
constexpr double kEmbreeRate = 2e-5;

nlohmann::json leak_json(const LeakCount& count) {
  return {{"rays", count.rays},
          {"leaks", count.leaks},
          {"rate_bound", count.leaks == 0 ? nlohmann::json(rate_bound(count.rays)) : nlohmann::json(nullptr)},
          {"embree", {{"rays", kEmbreeRays}, {"allowed_rate", kEmbreeRate}}}};
}

nlohmann::json device_json(const DeviceReport& device) {
  return devices_json({&device, 1})["devices"][0];
}

}  // namespace

std::string case_table_head() {
  return row("%3s %-20s %-12s %9s %9s %8s %9s %9s %9s %-12s %7s  %s\n", "", "case", "oracle", "samples", "failures",
             "bound", "p50", "p99", "max", "unit", "seconds", "");
}

std::string case_line(const CaseReport& report) {
  const CaseResult& result = report.result;
  return row(
      "%3d %-20s %-12s %9llu %9llu %8s %9s %9s %9s %-12s %7.2f  %s\n", report.verify_case->number,
      report.verify_case->name, report.verify_case->oracle, static_cast<unsigned long long>(result.samples),
      static_cast<unsigned long long>(result.failures), figure(none_failed(report), rate_bound(result.samples)).c_str(),
      figure(result.has_errors, result.p50).c_str(), figure(result.has_errors, result.p99).c_str(),
      figure(result.has_errors, result.max).c_str(), result.unit.c_str(), report.seconds, verdict(report).c_str());
}

std::string failure_text(const CaseReport& report, const CaseSetup& setup, const std::string& arguments) {
  const CaseResult& result = report.result;
  const std::string name = report.verify_case->name;
  if (result.samples == 0) return "    " + name + ": no samples\n";
  const std::string sample = std::to_string(result.first_failure);
  const std::string seed = std::to_string(setup.seed);
  return "    " + std::string(report.verify_case->property) + ": not at sample " + sample + " of seed " + seed + "\n" +
         "    inputs: " + result.worst_inputs + "\n" + "    again: vernier verify --case " + name + " --seed " + seed +
         " --sample " + sample + arguments + "\n";
}

LeakCount count_leaks(std::span<const CaseReport> reports) {
  constexpr std::array<std::string_view, 4> kAimed{"shared_edge", "shared_vertex", "far_mesh", "needles"};
  LeakCount count;
  for (const CaseReport& report : reports) {
    if (std::ranges::find(kAimed, report.verify_case->name) == kAimed.end()) continue;
    count.rays += report.result.samples;
    count.leaks += report.result.failures;
  }
  return count;
}

std::string leak_line(const LeakCount& count) {
  if (count.rays == 0) return "";
  const std::string bound =
      count.leaks == 0 ? row("a rate below %.2g", rate_bound(count.rays))
                       : row("a rate of %.2g", static_cast<double>(count.leaks) / static_cast<double>(count.rays));
  return row(
      "\n    %llu of %llu rays aimed at edges and corners got out, %s.\n"
      "    Embree's own test: %llu rays at random, a rate of %.2g allowed.\n",
      static_cast<unsigned long long>(count.leaks), static_cast<unsigned long long>(count.rays), bound.c_str(),
      static_cast<unsigned long long>(kEmbreeRays), kEmbreeRate);
}

std::string level_cost_table(std::span<const LevelCost> costs) {
  std::string table =
      row("\n    time of the built-in scene to the level fast: median of rounds (least to most)\n    %-10s %-22s %s\n",
          "spot", "robust", "exact");
  const auto figures = [](const LevelCost& cost) {
    return row("%.2f (%.2f to %.2f)", cost.ratio.median, cost.ratio.least, cost.ratio.most);
  };
  const std::size_t spots = costs.size() / 2;  // all of robust, then all of exact
  for (std::size_t i = 0; i < spots; ++i) {
    table += row("    %-10s %-22s %s\n", costs[i].spot.c_str(), figures(costs[i]).c_str(),
                 figures(costs[spots + i]).c_str());
  }
  return table;
}

nlohmann::json verify_json(const DeviceReport& device, const CaseSetup& setup, std::span<const CaseReport> reports,
                           std::span<const LevelCost> costs) {
  nlohmann::json cases = nlohmann::json::array();
  bool held = true;
  for (const CaseReport& report : reports) {
    cases.push_back(case_json(report));
    held = held && report.held;
  }
  nlohmann::json json = {
      {"schema", 1},  {"device", device_json(device)},          {"seed", setup.seed}, {"level", to_string(setup.level)},
      {"held", held}, {"samples_per_case", setup.sample_count}, {"cases", cases}};
  if (const LeakCount leaks = count_leaks(reports); leaks.rays > 0) json["watertight"] = leak_json(leaks);
  for (const LevelCost& cost : costs) {
    json["level_costs"].push_back({{"spot", cost.spot},
                                   {"level", cost.level},
                                   {"time_to_fast", cost.ratio.median},
                                   {"least", cost.ratio.least},
                                   {"most", cost.ratio.most}});
  }
  return json;
}

std::string mutation_line(const Mutation& mutation, std::span<const CaseReport> reports) {
  for (const CaseReport& report : reports) {
    if (report.held) continue;
    const CaseResult& result = report.result;
    return row("%-17s caught by %-18s %9llu failures of %9llu  %s\n", mutation.name, report.verify_case->name,
               static_cast<unsigned long long>(result.failures), static_cast<unsigned long long>(result.samples),
               mutation.what);
  }
  return row("%-17s MISSED by %3zu cases %47s%s\n", mutation.name, reports.size(), "", mutation.what);
}

nlohmann::json mutations_json(const DeviceReport& device, const CaseSetup& setup,
                              std::span<const Mutation> seeded_faults,
                              std::span<const std::vector<CaseReport>> reports) {
  nlohmann::json rows = nlohmann::json::array();
  bool all_caught = true;
  for (std::size_t i = 0; i < seeded_faults.size(); ++i) {
    nlohmann::json cases = nlohmann::json::array();
    for (const CaseReport& report : reports[i]) cases.push_back(case_json(report));
    const bool caught = is_caught(reports[i]);
    all_caught = all_caught && caught;
    rows.push_back(
        {{"name", seeded_faults[i].name}, {"what", seeded_faults[i].what}, {"caught", caught}, {"cases", cases}});
  }
  return {{"schema", 1},
          {"device", device_json(device)},
          {"seed", setup.seed},
          {"caught", all_caught},
          {"mutations", rows}};
}

}  // namespace vernier
