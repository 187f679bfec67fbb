#include "golden_case.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <ostream>

#include "cli/render_options.h"
#include "error.h"

namespace vernier::golden {
namespace {

// No reason written into goldens.json lifts a bound above these: a picture that needs more shows a fault.
constexpr HitBounds kMostHits{64.0, 0.02};
constexpr LinearBounds kMostLinear{1e-3, 1e-3, 1e-4};
constexpr DisplayBounds kMostDisplay{0.015, 0.03};
constexpr std::size_t kShortestReason = 20;

[[noreturn]] void refuse(const std::string& what) {
  throw Error(ErrorKind::refused, "goldens.json: " + what);
}

double bound(const nlohmann::json& tier, const std::string& place, const char* key, double ceiling) {
  if (!tier.contains(key)) refuse(place + ": no " + key);
  const double value = tier.at(key).get<double>();
  if (!(value >= 0.0 && value <= ceiling)) {
    refuse(place + ": " + key + " is " + std::to_string(value) + ", the ceiling is " + std::to_string(ceiling));
  }
  return value;
}

const nlohmann::json& reasoned_tier(const nlohmann::json& bounds, const std::string& place, const char* tier) {
  if (!bounds.contains(tier)) refuse(place + ": no tier " + tier);
  if (bounds.at(tier).value("reason", "").size() < kShortestReason) refuse(place + ": tier " + tier + " has no reason");
  return bounds.at(tier);
}

void read_bounds(const nlohmann::json& bounds, const std::string& place, GoldenCase& golden) {
  const nlohmann::json& a = reasoned_tier(bounds, place, "A");
  golden.hits = {bound(a, place, "rounding_steps", kMostHits.rounding_steps),
                 bound(a, place, "undecided_share", kMostHits.undecided_share)};
  const nlohmann::json& b = reasoned_tier(bounds, place, "B");
  golden.linear = {bound(b, place, "relative", kMostLinear.relative),
                   bound(b, place, "share_over", kMostLinear.share_over), bound(b, place, "rmse", kMostLinear.rmse)};
  const nlohmann::json& c = reasoned_tier(bounds, place, "C");
  golden.display = {bound(c, place, "flip_mean", kMostDisplay.flip_mean),
                    bound(c, place, "flip_p99", kMostDisplay.flip_p99)};
}

}  // namespace

std::vector<GoldenCase> parse_cases(const nlohmann::json& file) {
  std::vector<GoldenCase> cases;
  for (const nlohmann::json& entry : file.at("cases")) {
    GoldenCase golden;
    golden.name = entry.at("name").get<std::string>();
    golden.scene = entry.at("scene").get<std::string>();
    golden.options = file.at("options").get<std::vector<std::string>>();
    const auto own = entry.value("options", std::vector<std::string>{});
    golden.options.insert(golden.options.end(), own.begin(), own.end());
    const std::string bounds = entry.at("bounds").get<std::string>();
    if (!file.at("bounds").contains(bounds)) refuse(golden.name + ": no bounds '" + bounds + "'");
    read_bounds(file.at("bounds").at(bounds), golden.name, golden);
    cases.push_back(golden);
  }
  return cases;
}

std::vector<GoldenCase> load_cases() {
  return parse_cases(nlohmann::json::parse(std::ifstream(golden_path("goldens.json"))));
}

GoldenCase find_case(const std::string& name) {
  const std::vector<GoldenCase> cases = load_cases();
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const GoldenCase& c) { return c.name == name; });
  if (found == cases.end()) throw Error(ErrorKind::usage, "goldens.json: there is no case '" + name + "'");
  return *found;
}

std::string golden_path(const std::string& file) {
  return std::string(VERNIER_SOURCE_DIR) + "/tests/golden/" + file;
}

std::string scene_path(const GoldenCase& golden) {
  return std::string(VERNIER_SOURCE_DIR) + "/scenes/" + golden.scene;
}

CaseSetup set_up_case(const GoldenCase& golden) {
  CLI::App app;
  SceneArguments scene;
  RenderArguments render;
  add_scene_options(app, scene);
  add_render_options(app, render);
  // CLI11 takes the words last first.
  app.parse(std::vector<std::string>(golden.options.rbegin(), golden.options.rend()));
  scene.scene = scene_path(golden);
  CaseSetup setup;
  setup.settings = parse_render_settings(render);
  const double aspect = static_cast<double>(setup.settings.width) / setup.settings.height;
  setup.scene = set_up_scene(parse_scene_settings(scene), aspect);
  return setup;
}

std::string known_failure(const std::string& name, const std::string& check) {
  const nlohmann::json known = nlohmann::json::parse(std::ifstream(golden_path("known_failures.json")));
  for (const nlohmann::json& entry : known.at("failures")) {
    if (entry.at("case") == name && entry.at("check") == check) return entry.at("reason").get<std::string>();
  }
  return "";
}

std::string unexpected(const std::string& name, const std::string& check, const std::string& fault) {
  if (known_failure(name, check).empty()) return fault.empty() ? "" : check + ": " + fault;
  return fault.empty() ? check + ": a known failure passes, take it from known_failures.json; " : "";
}

void PrintTo(const GoldenCase& golden, std::ostream* out) {
  *out << golden.name;
}

}  // namespace vernier::golden
