#include "cli/ledger_table.h"

#include <algorithm>
#include <cstdio>

#include "cli/effect_table.h"
#include "cli/render_report.h"
#include "cli/warnings.h"

namespace vernier {
namespace {

template <typename... Values>
std::string row(const char* format, Values... values) {
  char text[512];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

const EffectCost* cost_of(const EffectLedger& ledger, std::uint32_t bit) {
  const auto found = std::ranges::find(ledger.effects, bit, &EffectCost::bit);
  return found == ledger.effects.end() ? nullptr : &*found;
}

double share_of(const EffectCost& cost) {
  return 1.0 - cost.ratio.median;
}

/// Rays, time, share and loss in columns of fixed width.
std::string cost_columns(const EffectLedger& ledger, const EffectCost* cost) {
  if (cost == nullptr) return row("%10s %9s %8s %10s %8s", "-", "-", "-", "-", "-");
  constexpr double kPercent = 100.0;
  const std::string time = is_noise(cost->ratio)
                               ? row("%9s %8s", "noise", "noise")
                               : row("%9.3f %6.1f %%", share_of(*cost) * ledger.frame_ms, share_of(*cost) * kPercent);
  return row("%10lld %s %10.3g %8.4f", static_cast<long long>(cost->rays), time.c_str(), cost->rmse, cost->flip_mean);
}

std::string frame_lines(const Explanation& explanation) {
  const EffectLedger& ledger = explanation.ledger;
  const RenderSettings& settings = explanation.settings;
  std::string lines = row("frame: %.3f ms of device time, %llu rays, %dx%d, %u %s per pixel, on %s\n", ledger.frame_ms,
                          static_cast<unsigned long long>(total(ledger.rays)), settings.width, settings.height,
                          settings.spp, settings.spp == 1 ? "sample" : "samples", explanation.device.c_str());
  for (const BounceCost& bounce : ledger.bounces) {
    lines +=
        row("bounce %u: %.3f ms, %llu rays\n", bounce.depth, bounce.ms, static_cast<unsigned long long>(bounce.rays));
  }
  lines += saved_line(ledger.saved);
  return lines + row("every effect compiled in: %.2f times the frame's time (%.2f to %.2f)\n", ledger.all.median,
                     ledger.all.least, ledger.all.most);
}

nlohmann::ordered_json cost_json(const EffectSet& plan, const EffectLedger& ledger, const EffectCost* cost) {
  if (cost == nullptr) return nullptr;
  nlohmann::ordered_json without = nlohmann::ordered_json::array();
  for (const EffectReason& effect : plan.reasons) {
    if (cost->without & effect.bit) without.push_back(effect.name);
  }
  return {{"without", without},
          {"rays", cost->rays},
          {"ms", share_of(*cost) * ledger.frame_ms},
          {"share", share_of(*cost)},
          {"least_share", 1.0 - cost->ratio.most},
          {"most_share", 1.0 - cost->ratio.least},
          {"rmse", cost->rmse},
          {"flip_mean", cost->flip_mean}};
}

nlohmann::ordered_json fixed_json(const EffectSet& plan) {
  nlohmann::ordered_json fixed = nlohmann::ordered_json::array();
  for (const EffectReason& one : plan.fixed) {
    fixed.push_back({{"name", one.name}, {"on", one.on}, {"reason", one.reason}});
  }
  return fixed;
}

void add_frame(nlohmann::ordered_json& json, const Explanation& explanation) {
  const EffectLedger& ledger = explanation.ledger;
  json["device"] = explanation.device;
  json["driver"] = explanation.driver;
  json["frame"] = {{"size", {explanation.settings.width, explanation.settings.height}},
                   {"spp", explanation.settings.spp},
                   {"accuracy", to_string(explanation.settings.accuracy)},
                   {"device_ms", ledger.frame_ms},
                   {"rays", total(ledger.rays)}};
  json["saved_memory"] = saved_json(ledger.saved);
  json["all_effects"] = {{"time_to_frame", ledger.all.median}, {"least", ledger.all.least}, {"most", ledger.all.most}};
  json["bounces"] = nlohmann::ordered_json::array();
  for (const BounceCost& bounce : ledger.bounces) {
    json["bounces"].push_back({{"depth", bounce.depth}, {"rays", bounce.rays}, {"ms", bounce.ms}});
  }
}

}  // namespace

std::string ledger_table(const Explanation& explanation) {
  std::size_t widest = 0;
  for (const EffectReason& effect : explanation.plan.reasons) widest = std::max(widest, effect.name.size());
  std::string table = row("%-*s %10s %9s %8s %10s %8s  %s\n", static_cast<int>(widest + 5), "", "rays", "ms", "share",
                          "RMSE", "FLIP", "why");
  std::size_t on_count = 0;
  for (const EffectReason& effect : explanation.plan.reasons) {
    on_count += effect.on ? 1 : 0;
    table += row("%-4s %-*s ", effect.on ? "on" : "off", static_cast<int>(widest), effect.name.c_str());
    table += cost_columns(explanation.ledger, cost_of(explanation.ledger, effect.bit)) + "  " +
             terminal_line(effect.reason) + "\n";
  }
  table += std::to_string(on_count) + " of " + std::to_string(explanation.plan.reasons.size()) + " effects on\n";
  return table + unswitched_lines(explanation.plan) + frame_lines(explanation);
}

nlohmann::ordered_json explain_json(const Explanation& explanation) {
  nlohmann::ordered_json json = {{"schema", 1}, {"scene", explanation.scene}, {"plan_ms", explanation.plan_ms}};
  json["effects"] = nlohmann::ordered_json::array();
  for (const EffectReason& effect : explanation.plan.reasons) {
    const EffectCost* cost = cost_of(explanation.ledger, effect.bit);
    json["effects"].push_back({{"name", effect.name},
                               {"on", effect.on},
                               {"reason", effect.reason},
                               {"cost", cost_json(explanation.plan, explanation.ledger, cost)}});
  }
  json["fixed"] = fixed_json(explanation.plan);
  json["depth"] = depth_json(explanation.plan.depth);
  for (const char* measured : {"device", "driver", "frame", "saved_memory", "all_effects", "bounces"}) {
    json[measured] = nullptr;
  }
  if (!explanation.device.empty()) add_frame(json, explanation);
  return json;
}

}  // namespace vernier
