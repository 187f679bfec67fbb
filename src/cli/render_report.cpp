#include "cli/render_report.h"

#include <sys/resource.h>

#include <bit>
#include <cstdio>

#include "cli/effect_table.h"
#include "cli/progress_bar.h"

namespace vernier {
namespace {

// Largest resident size of this process so far; Linux tells it in KiB.
std::uint64_t peak_host_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  constexpr std::uint64_t kKibibyte = 1024;
  return static_cast<std::uint64_t>(usage.ru_maxrss) * kKibibyte;
}

nlohmann::ordered_json effects_by_name(const EffectSet& effects) {
  nlohmann::ordered_json by_name = nlohmann::ordered_json::object();
  for (const EffectReason& effect : effects.reasons) {
    by_name[effect.name] = effect.on;
  }
  return by_name;
}

nlohmann::ordered_json pipelines_json(const std::vector<PipelineTime>& pipelines) {
  nlohmann::ordered_json by_name = nlohmann::ordered_json::object();
  for (const PipelineTime& pipeline : pipelines) by_name[pipeline.name] = pipeline.compile_ms;
  return by_name;
}

nlohmann::ordered_json bvh_json(const RenderStatistics& statistics) {
  return {{"nodes", statistics.bvh_nodes},
          {"bytes", statistics.bvh_bytes},
          {"sah_cost", statistics.sah_cost},
          {"depth", statistics.bvh_depth},
          {"build_ms", statistics.bvh_build_ms}};
}

void add_input(nlohmann::ordered_json& json, const RenderReport& report) {
  const RenderSettings& settings = report.settings;
  json["scene"] = report.scene;
  json["device"] = report.device.name;
  json["driver"] = report.device.driver;
  json["size"] = {settings.width, settings.height};
  json["spp"] = settings.spp;
  json["accuracy"] = to_string(settings.accuracy);
  json["traversal"] = to_string(resolve_form(report.device, settings.traversal));
}

void add_work(nlohmann::ordered_json& json, const RenderReport& report) {
  const RenderStatistics& statistics = report.statistics;
  json["triangles"] = statistics.triangles;
  json["instances"] = statistics.instances;
  json["materials"] = statistics.materials;
  json["textures"] = statistics.textures;
  json["bvh"] = bvh_json(statistics);
  json["load_ms"] = report.load_ms;
  json["pack_ms"] = statistics.pack_ms;
  json["upload_ms"] = statistics.upload_ms;
  json["compile_ms"] = statistics.compile_ms;
  json["pipelines"] = pipelines_json(statistics.pipelines);
  json["trace_device_ms"] = statistics.trace_device_ms;
  json["trace_wall_ms"] = statistics.trace_wall_ms;
}

std::string sample_text(std::uint32_t samples) {
  return std::to_string(samples) + (samples == 1 ? " sample" : " samples");
}

/// With an error target pixels have different numbers.
std::string mean_text(double samples) {
  char text[64];
  std::snprintf(text, sizeof text, "%.1f samples on average", samples);
  return text;
}

/// Only with --count-effects.
void add_effect_runs(nlohmann::ordered_json& json, const RenderStatistics& statistics) {
  const EffectRuns& runs = statistics.effect_runs;
  if (runs.searches.empty()) return;
  for (const EffectReason& effect : statistics.effects.reasons) {
    json["effect_runs"][effect.name] = runs.searches[static_cast<std::size_t>(std::countr_zero(effect.bit))];
  }
  json["rays_by_depth"] = nlohmann::ordered_json::array();
  for (const DepthRays& rays : runs.by_depth) {
    if (rays.path == 0 && rays.shadow == 0) break;
    json["rays_by_depth"].push_back({{"path", rays.path}, {"shadow", rays.shadow}});
  }
}

/// What each pipeline took, what came of their file, and what was not allocated.
std::string pipeline_text(const RenderReport& report) {
  std::string text = "pipelines:";
  char part[160];
  for (const PipelineTime& pipeline : report.statistics.pipelines) {
    std::snprintf(part, sizeof part, " %s %.1f ms,", pipeline.name.c_str(), pipeline.compile_ms);
    text += part;
  }
  text += " " + report.pipeline_note + "\n";
  return text + saved_line(report.statistics.saved);
}

void add_outcome(nlohmann::ordered_json& json, const RenderReport& report) {
  const RenderStatistics& statistics = report.statistics;
  const RayCounts& rays = statistics.rays;
  json["rays"] = {{"primary", rays.primary},
                  {"shadow", rays.shadow},
                  {"reflection", rays.reflection},
                  {"refraction", rays.refraction}};
  json["rays_per_s"] = rays_per_s(statistics);
  const PixelRect area = image_area(report.settings);
  json["crop"] = nullptr;
  if (report.settings.crop) json["crop"] = {area.x, area.y, area.width, area.height};
  json["sample_range"] = {report.settings.sample_begin, report.settings.sample_end};
  json["stopped"] = statistics.stopped;
  json["samples_done"] = statistics.samples_done;
  json["mean_samples"] = statistics.mean_samples;
  json["effects"] = effects_by_name(statistics.effects);
  json["depth"] = depth_json(statistics.effects.depth);
  json["non_finite_pixels"] = statistics.non_finite_pixels;
  json["stack_overflows"] = statistics.stack_overflows;
  json["error_estimate"] = nullptr;  // only known with an error target
  if (statistics.error) json["error_estimate"] = statistics.error->bound();
  json["peak_memory"] = {{"host_bytes", peak_host_bytes()}, {"device_bytes", statistics.device_bytes}};
  json["needed_memory"] = {{"host_bytes", report.memory.host_bytes}, {"device_bytes", report.memory.device_bytes}};
  json["saved_memory"] = saved_json(statistics.saved);
  json["warnings"] = report.warnings;
}

}  // namespace

nlohmann::ordered_json saved_json(const SavedMemory& saved) {
  return {{"path_stack_bytes", saved.path_stack_bytes},
          {"sample_cost_bytes", saved.sample_cost_bytes},
          {"aov_bytes", saved.aov_bytes}};
}

nlohmann::ordered_json depth_json(const DepthNeed& depth) {
  return {{"bounces", depth.bounces}, {"allowed", depth.allowed}, {"reason", depth.reason}};
}

std::string saved_line(const SavedMemory& saved) {
  constexpr double kMebibyte = 1024.0 * 1024.0;
  std::string line;
  for (const auto& [what, bytes] : {std::pair{"path stack", saved.path_stack_bytes},
                                    {"sample costs", saved.sample_cost_bytes},
                                    {"AOVs", saved.aov_bytes}}) {
    if (bytes == 0) continue;
    char text[64];
    std::snprintf(text, sizeof text, " %s %.2f MiB", what, static_cast<double>(bytes) / kMebibyte);
    line += (line.empty() ? "not allocated:" : ",") + std::string(text);
  }
  return line.empty() ? line : line + "\n";
}

double rays_per_s(const RenderStatistics& statistics) {
  constexpr double kMillisecond_s = 1e-3;
  const double seconds = statistics.trace_wall_ms * kMillisecond_s;
  return seconds > 0.0 ? static_cast<double>(total(statistics.rays)) / seconds : 0.0;
}

nlohmann::ordered_json render_json(const RenderReport& report) {
  nlohmann::ordered_json json;
  json["schema"] = 1;
  add_input(json, report);
  add_work(json, report);
  add_outcome(json, report);
  add_effect_runs(json, report.statistics);
  return json;
}

std::string summary_line(const RenderReport& report, const std::string& file) {
  const RenderStatistics& statistics = report.statistics;
  const PixelRect rect = report.settings.crop.value_or(PixelRect{0, 0, report.settings.width, report.settings.height});
  char text[160];
  const std::string samples =
      statistics.error ? mean_text(statistics.mean_samples) : sample_text(statistics.samples_done);
  std::snprintf(text, sizeof text, ": %dx%d, %s, %.3f Mrays in %.2f s, ", rect.width, rect.height, samples.c_str(),
                static_cast<double>(total(statistics.rays)) * 1e-6, statistics.trace_wall_ms * 1e-3);
  const std::string reached = statistics.error ? ", " + error_text(*statistics.error) : "";
  return file + text + rate_text(rays_per_s(statistics)) + reached;
}

std::string error_text(const ErrorEstimate& error) {
  char text[64];
  std::snprintf(text, sizeof text, "sqrt(relMSE) at most %.3g (95 %%)", error.bound());
  return text;
}

std::string non_finite_text(const RenderStatistics& statistics) {
  const SamplePlace& first = statistics.first_non_finite;
  return std::to_string(statistics.non_finite_pixels) +
         (statistics.non_finite_pixels == 1 ? " pixel is" : " pixels are") + " not finite, the first: pixel " +
         std::to_string(first.x) + "," + std::to_string(first.y) + ", sample " + std::to_string(first.sample);
}

std::string verbose_text(const RenderReport& report) {
  const RenderStatistics& statistics = report.statistics;
  char text[256];
  std::snprintf(
      text, sizeof text,
      "load %.1f ms, BVH %.1f ms, pack %.1f ms, upload %.1f ms, compile %.1f ms, trace %.1f ms (device %.1f ms)\n",
      report.load_ms, statistics.bvh_build_ms, statistics.pack_ms, statistics.upload_ms, statistics.compile_ms,
      statistics.trace_wall_ms, statistics.trace_device_ms);
  return "device " + report.device.name + ", " + report.device.driver + "\n" + std::to_string(statistics.triangles) +
         " triangles, " + std::to_string(statistics.bvh_nodes) + " BVH nodes\n" + text + pipeline_text(report) +
         effect_table(statistics.effects);
}

}  // namespace vernier
