#include "accuracy/converged_reference.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "accuracy/error_figures.h"
#include "error.h"
#include "image/difference.h"
#include "math/elapsed.h"
#include "render/setting_limits.h"
#include "render/timed_trace.h"

namespace vernier {
namespace {

constexpr std::uint32_t kLeastPartSpp = 4;
constexpr std::uint32_t kMostPartSpp = 64;
constexpr std::uint64_t kMostSpp = 65536;
/// Points count their seeds up from the user's, these go down from the largest.
constexpr std::uint32_t kFirstSeed = 0xffffffffu;

/// Sums of pictures in double.
class PictureSum {
 public:
  void add(const Image& image) {
    if (shape_.values.empty()) {
      shape_ = image;
      sums_.assign(image.values.size(), 0.0);
    }
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += image.values[i];
    ++count_;
  }

  Image mean() const {
    Image image = shape_;
    for (std::size_t i = 0; i < sums_.size(); ++i) image.values[i] = static_cast<float>(sums_[i] / count_);
    return image;
  }

 private:
  Image shape_;
  std::vector<double> sums_;
  int count_ = 0;
};

}  // namespace

std::uint32_t choose_part_spp(double budget_ms, double ms_per_sample) {
  constexpr double kSlower = 2.0;  // exact and deeper than the points
  std::uint32_t spp = kMostPartSpp;
  while (spp > kLeastPartSpp && 2.0 * kSlower * spp * ms_per_sample > budget_ms) spp /= 2;
  return spp;
}

RenderSettings reference_settings(const RenderSettings& settings, std::uint32_t part_spp) {
  RenderSettings part = settings;
  part.accuracy = Accuracy::exact;
  part.max_bounces = std::min(2 * settings.max_bounces, kMaxBounces);
  part.cutoff = settings.cutoff / 16.0f;
  part.sample_begin = 0;
  part.sample_end = part.spp = part_spp;
  part.error_target.reset();
  return part;
}

ConvergedReference render_reference_parts(StagedScene& staged, TimedTrace& trace, const RenderSettings& settings,
                                          const ReferenceRun& run) {
  const auto start = std::chrono::steady_clock::now();
  ConvergedReference reference;
  reference.settings = settings;
  PictureSum sums[2];
  std::uint32_t seed = kFirstSeed;
  do {
    Image pictures[2];
    for (Image& picture : pictures) {
      reference.settings.seed = seed--;
      staged.set_settings(reference.settings);
      trace.trace_anew(reference.settings, run.stop);
      picture = trace.picture();
    }
    if (run.stop && run.stop()) break;
    for (int half = 0; half < 2; ++half) sums[half].add(pictures[half]);
    reference.spp += 2 * settings.spp;
    if (run.progress) run.progress();
  } while (ms_since(start) < run.budget_ms && reference.spp < kMostSpp);
  if (reference.spp == 0) throw Error(ErrorKind::failed, "interrupted before the reference was rendered");
  for (int half = 0; half < 2; ++half) reference.halves[half] = sums[half].mean();
  reference.image = mean_image(reference.halves[0], reference.halves[1]);
  // The difference of two halves has 4 times the variance of their mean.
  const Difference apart = compare_images(reference.halves[0], reference.halves[1]);
  reference.rmse = apart.rmse / 2.0;
  reference.rel_error = std::sqrt(apart.rel_mse) / 2.0;
  return reference;
}

}  // namespace vernier
