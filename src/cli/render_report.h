#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gpu/device.h"
#include "render/memory_need.h"
#include "render/render_settings.h"
#include "render/render_statistics.h"

namespace vernier {

/// What `render --json` tells of one render.
struct RenderReport {
  std::string scene;  ///< as the user named it
  DeviceDescription device;
  RenderSettings settings;
  RenderStatistics statistics;
  double load_ms = 0.0;
  std::vector<std::string> warnings;  ///< of the scene and of the render
  std::string pipeline_note;          ///< what came of the file of compiled pipelines
  MemoryNeed memory;                  ///< as it was foreseen
};

/// What was not allocated, in bytes.
nlohmann::ordered_json saved_json(const SavedMemory& saved);

/// {"bounces", "allowed", "reason"}.
nlohmann::ordered_json depth_json(const DepthNeed& depth);

/// What was not allocated, for people.
std::string saved_line(const SavedMemory& saved);

/// Rays per second of wall time spent tracing; 0 where no time was measured.
double rays_per_s(const RenderStatistics& statistics);

/// The object of schema 1; null for what does not apply. Times in milliseconds, memory in bytes (peak_memory of the
/// host: of the whole process; needed_memory: what the scene was foreseen to take at most).
nlohmann::ordered_json render_json(const RenderReport& report);

/// One line for stderr: size, samples, rays, rays per second, seconds, file.
std::string summary_line(const RenderReport& report, const std::string& file);

/// The bound of the error with what it means: `sqrt(relMSE) at most 0.0093 (95 %)`.
std::string error_text(const ErrorEstimate& error);

/// How many pixels are not finite and which pixel and sample is the first: "3 pixels are not finite, the first: pixel
/// 12,34, sample 5". At least one is.
std::string non_finite_text(const RenderStatistics& statistics);

/// The lines --verbose adds: device, effects with reasons, sizes, times, pipelines and the memory that effects which
/// are off did not take.
std::string verbose_text(const RenderReport& report);

}  // namespace vernier
