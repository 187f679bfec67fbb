#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/scene_setup.h"
#include "render/render_settings.h"

namespace vernier::golden {

/// Tier A: what primary rays hit, exactly, where rounding cannot decide it.
struct HitBounds {
  double rounding_steps = 0.0;   ///< a ray nearer to an edge than this many steps of rounding is undecided
  double undecided_share = 0.0;  ///< most pixels that may be undecided
};

/// Tier B: linear colour.
struct LinearBounds {
  double relative = 0.0;    ///< of a pixel: max over RGB of |a - b| / max(|b|, kDarkest)
  double share_over = 0.0;  ///< most pixels that may exceed it
  double rmse = 0.0;        ///< over all pixels
};

/// Tier C: the display image.
struct DisplayBounds {
  double flip_mean = 0.0;
  double flip_p99 = 0.0;
};

/// One picture of goldens.json.
struct GoldenCase {
  std::string name;
  std::string scene;                 ///< file of scenes/
  std::vector<std::string> options;  ///< of `vernier render`
  HitBounds hits;
  LinearBounds linear;
  DisplayBounds display;
};

/// What a case renders.
struct CaseSetup {
  SceneSetup scene;
  RenderSettings settings;
};

/// Radiance below which a difference counts as absolute: 2^-10 is the default cutoff, so the renderer itself leaves out
/// what a white surface adds below it.
inline constexpr double kDarkest = 0x1p-10;

/// The cases of tests/golden/goldens.json, in its order. Throws Error(refused) for a case without bounds, a bound
/// without a reason of at least 20 letters, or one above the ceiling of its tier.
std::vector<GoldenCase> load_cases();

/// load_cases' rules for one JSON text.
std::vector<GoldenCase> parse_cases(const nlohmann::json& file);

/// The case `name`. Throws Error(usage) where there is none.
GoldenCase find_case(const std::string& name);

/// Path of the case's scene, and of a file of tests/golden/.
std::string scene_path(const GoldenCase& golden);
std::string golden_path(const std::string& file);

/// Reads the options as the command line does and loads the scene. Throws what these throw.
CaseSetup set_up_case(const GoldenCase& golden);

/// What known_failures.json says of `check` (A, B, C, or one of invariance_test.cpp) in the case `name`: the reason why
/// it fails as yet, empty where it must pass.
std::string known_failure(const std::string& name, const std::string& check);

/// `fault` of a check, empty for none, as a test must see it: empty where the check did what is expected of it. A known
/// failure that passes is a fault too, so that the list cannot outlive what it lists.
std::string unexpected(const std::string& name, const std::string& check, const std::string& fault);

/// GoogleTest's name of a case.
void PrintTo(const GoldenCase& golden, std::ostream* out);

}  // namespace vernier::golden
