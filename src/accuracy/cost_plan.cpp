#include "accuracy/cost_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

#include "render/setting_limits.h"
#include "shared/accuracy.h"

namespace vernier {
namespace {

void set_spp(RenderSettings& settings, std::uint32_t spp) {
  settings.sample_end = settings.spp = spp;
}

/// A point that differs from `settings` by the option `name` alone.
CostPoint point_of(const std::string& axis, const std::string& label, const RenderSettings& settings,
                   const std::string& option, const std::string& value) {
  CostPoint point{label, axis, settings, {{"spp", std::to_string(settings.spp)}}, true};
  if (option == "spp") return point;
  if (option == "error-target") point.options.clear();
  point.options.emplace_back(option, value);
  return point;
}

void add_samples(const CostPlanInput& input, std::vector<CostPoint>& points) {
  std::set<std::uint32_t> counts{1, input.settings.spp};
  // Two samples tell little that four do not; the pixel centre alone is what previews take.
  for (std::uint32_t spp = 4; spp <= input.most_spp; spp *= 2) counts.insert(spp);
  RenderSettings settings = input.settings;
  for (const std::uint32_t spp : counts) {
    set_spp(settings, spp);
    points.push_back(point_of("spp", std::to_string(spp) + " spp", settings, "spp", ""));
  }
}

void add_levels(const CostPlanInput& input, std::vector<CostPoint>& points) {
  for (const Accuracy level : kAccuracies) {
    if (level == input.settings.accuracy) continue;
    RenderSettings settings = input.settings;
    settings.accuracy = level;
    const std::string name(to_string(level));
    points.push_back(point_of("level", name, settings, "accuracy", name));
  }
}

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1g", value);
  return text;
}

/// Errors that 16 and 64 samples would have. Stratified samples: the error falls about by 0.6 of a power of them.
void add_targets(const CostPlanInput& input, std::vector<CostPoint>& points) {
  constexpr double kFallPerSample = 0.6;
  if (!(input.error_at_16 > 0.0)) return;
  std::string before;
  for (const double spp : {16.0, 64.0, 256.0}) {
    if (spp > input.most_spp) break;
    const std::string text = rounded(input.error_at_16 * std::pow(16.0 / spp, kFallPerSample));
    if (text == before) continue;
    before = text;
    RenderSettings settings = input.settings;
    set_spp(settings, kErrorTargetSpp);
    settings.error_target = std::stod(text);
    points.push_back(point_of("adaptive", "error target " + text, settings, "error-target", text));
  }
}

void add_bounces(const CostPlanInput& input, std::vector<CostPoint>& points) {
  for (const std::uint32_t bounces : {4u, 2u, 1u, 0u}) {
    if (bounces >= input.settings.max_bounces) continue;
    RenderSettings settings = input.settings;
    settings.max_bounces = bounces;
    const std::string text = std::to_string(bounces);
    points.push_back(
        point_of("bounces", text + (bounces == 1 ? " bounce" : " bounces"), settings, "max-bounces", text));
  }
}

void add_cutoffs(const CostPlanInput& input, std::vector<CostPoint>& points) {
  for (const int parts : {256, 64, 16}) {
    const float cutoff = 1.0f / static_cast<float>(parts);
    if (cutoff <= input.settings.cutoff) continue;
    RenderSettings settings = input.settings;
    settings.cutoff = cutoff;
    const std::string text = "1/" + std::to_string(parts);
    points.push_back(point_of("cutoff", "cut-off " + text, settings, "cutoff", text));
  }
}

void add_filters(const CostPlanInput& input, std::vector<CostPoint>& points) {
  RenderSettings settings = input.settings;
  settings.pixel_filter = PixelFilter::tent;
  if (input.settings.pixel_filter != settings.pixel_filter) {
    points.push_back(point_of("filter", "tent filter", settings, "filter", "tent"));
  }
  settings = input.settings;
  settings.texture_filter = TextureFilter::nearest;
  if (input.has_textures && input.settings.texture_filter != settings.texture_filter) {
    points.push_back(point_of("filter", "nearest texels", settings, "texture-filter", "nearest"));
  }
}

void add_effects(const CostPlanInput& input, std::vector<CostPoint>& points) {
  for (const EffectReason& effect : input.effects.reasons) {
    if (!effect.on) continue;
    RenderSettings settings = input.settings;
    settings.effects += ",-" + effect.name;
    points.push_back(point_of("effects", "without " + effect.name, settings, "effects", settings.effects));
  }
}

/// Fast everywhere but at one spot, which is exact.
void add_spots(const CostPlanInput& input, std::vector<CostPoint>& points) {
  for (std::uint32_t spot = 0; spot < SPOT_COUNT; ++spot) {
    RenderSettings settings = input.settings;
    settings.spot_levels = LEVELS_OF(LEVEL_FAST) | (LEVEL_EXACT << (2 * spot));
    CostPoint point = point_of("spot", std::string("exact at ") + kSpotNames[spot], settings, "spp", "");
    point.has_command = false;
    points.push_back(point);
  }
}

}  // namespace

std::vector<CostPoint> plan_points(const CostPlanInput& input) {
  std::vector<CostPoint> points;
  add_samples(input, points);
  add_targets(input, points);
  add_levels(input, points);
  add_bounces(input, points);
  add_cutoffs(input, points);
  add_filters(input, points);
  add_effects(input, points);
  if (input.with_spots) add_spots(input, points);
  return points;
}

std::size_t points_that_fit(const std::vector<PointTime>& points, int runs, double budget_ms) {
  double sum_ms = 0.0;
  std::size_t count = 0;
  for (const PointTime& point : points) {
    sum_ms += point.once_ms + runs * point.run_ms;
    if (sum_ms > budget_ms && count > 0) break;
    ++count;
  }
  return count;
}

std::uint32_t most_spp(std::uint64_t reference_spp, double ms_per_sample, double longest_ms) {
  std::uint32_t spp = 4;
  while (std::uint64_t{2} * spp * 16 <= reference_spp && 2.0 * spp * ms_per_sample <= longest_ms) spp *= 2;
  return spp;
}

}  // namespace vernier
