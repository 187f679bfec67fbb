#include "render/calibrate_forms.h"

#include <algorithm>
#include <memory>

#include "effects/detect_effects.h"
#include "error.h"

namespace vernier {
namespace {

// What another form must gain: below that the usual one is kept.
constexpr double kWorthwhile = 0.95;

/// A form on the device, ready to be timed.
struct Candidate {
  StagedScene staged;
  TimedTrace timed;
  std::vector<double> ms, ratios;

  Candidate(const Device& device, const Scene& scene, const Camera& camera, const RenderSettings& settings,
            std::uint32_t effects)
      : staged(device, scene, camera, settings), timed(staged, staged.specialization(effects), settings) {}
};

/// Null where the device refuses it; `why` says so then.
std::unique_ptr<Candidate> candidate_for(const Device& device, const Scene& scene, const Camera& camera,
                                         const RenderSettings& settings, std::string& why) {
  try {
    require_loads(device.description(), choose_scene_loads(device.description(), settings.traversal));
    const EffectSet effects = detect_effects(scene, camera, static_cast<int>(settings.max_bounces));
    return std::make_unique<Candidate>(device, scene, camera, settings, effects.bits);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::refused) throw;
    why = error.what();
    return nullptr;
  }
}

/// Traces every candidate in turn, each right after the usual one. False where it was stopped.
bool time_rounds(const std::vector<std::unique_ptr<Candidate>>& candidates, Candidate& usual, const FormBench& bench) {
  const auto count = static_cast<double>(candidates.size());
  const double steps = count * bench.rounds;
  for (int round = 0; round < bench.rounds; ++round) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (bench.stop && bench.stop()) return false;
      if (Candidate* one = candidates[i].get()) {
        const double usual_ms = usual.timed.trace().device_ms;
        one->ms.push_back(one->timed.trace().device_ms);
        one->ratios.push_back(one->ms.back() / usual_ms);
      }
      bench.progress((round * count + static_cast<double>(i) + 1.0) / steps);
    }
  }
  return true;
}

/// What a candidate took; `picture` is what it should have drawn.
void describe_times(const Candidate& one, const std::vector<float>& picture, FormTiming& timing) {
  timing.compile_ms = one.timed.compile_ms();
  timing.device_ms = spread_of(one.ms).median;
  timing.ratio = spread_of(one.ratios);
  if (one.timed.picture().values != picture) timing.left_out = "draws another picture";
}

TraversalForm best_of(const FormCalibration& found) {
  const FormTiming* best = nullptr;
  for (const FormTiming& one : found.forms) {
    const bool gains = one.left_out.empty() && one.ratio.median <= kWorthwhile && one.ratio.most < 1.0;
    if (gains && (best == nullptr || one.ratio.median < best->ratio.median)) best = &one;
  }
  return best == nullptr ? found.usual : best->form;
}

}  // namespace

std::optional<FormCalibration> calibrate_forms(const Device& device, const Scene& scene, const Camera& camera,
                                               const FormBench& bench) {
  RenderSettings settings;
  settings.width = bench.width;
  settings.height = bench.height;
  settings.sample_end = settings.spp = bench.spp;
  FormCalibration found;
  found.usual = resolve_form(device.description(), TraversalForm::automatic);
  std::vector<std::unique_ptr<Candidate>> candidates;
  Candidate* usual = nullptr;
  for (const TraversalForm form : kTraversalForms) {
    if (form == TraversalForm::automatic) continue;
    settings.traversal = form;
    FormTiming& timing = found.forms.emplace_back();
    timing.form = form;
    candidates.push_back(candidate_for(device, scene, camera, settings, timing.left_out));
    if (form == found.usual) usual = candidates.back().get();
  }
  if (usual == nullptr) throw Error(ErrorKind::refused, "the usual form of the traversal cannot be timed");
  if (!time_rounds(candidates, *usual, bench)) return std::nullopt;
  const std::vector<float> picture = usual->timed.picture().values;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i]) describe_times(*candidates[i], picture, found.forms[i]);
  }
  found.best = best_of(found);
  return found;
}

}  // namespace vernier
