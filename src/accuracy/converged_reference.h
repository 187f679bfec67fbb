#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "image/image.h"
#include "render/render_settings.h"

namespace vernier {

class StagedScene;
class TimedTrace;

/// What the points of a sweep are held against.
struct ConvergedReference {
  Image image;              ///< mean of the halves
  Image halves[2];          ///< of independent samples; both the same for an image from a file
  std::uint64_t spp = 0;    ///< samples of a pixel in all; 0: from a file
  double rel_error = 0.0;   ///< own sqrt(relMSE), from the difference of the halves; 0 for a file, which tells none
  double rmse = 0.0;        ///< likewise
  std::string file;         ///< empty: rendered
  RenderSettings settings;  ///< of a part
};

/// Settings of a part of the reference, of `part_spp` samples, for points around `settings`: exact, twice as deep, a
/// sixteenth of the cutoff.
RenderSettings reference_settings(const RenderSettings& settings, std::uint32_t part_spp);

/// Samples of a part, 4 to 64, so that two take about `budget_ms` at most where a sample of the points takes so long.
std::uint32_t choose_part_spp(double budget_ms, double ms_per_sample);

/// How long and by whose leave a reference is rendered.
struct ReferenceRun {
  double budget_ms = 0.0;          ///< wall time
  std::function<void()> progress;  ///< called after each pair of parts; may be empty
  std::function<bool()> stop;      ///< true: ends it and drops an unfinished pair of parts; may be empty
};

/// Renders parts, of seeds that no point has, to two halves in turn, as long as `run` says, at least one
/// part each and at most 65536 samples. Throws Error(failed) where the first pair of parts is stopped.
ConvergedReference render_reference_parts(StagedScene& staged, TimedTrace& trace, const RenderSettings& settings,
                                          const ReferenceRun& run);

}  // namespace vernier
