#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "effects/effect_set.h"
#include "preview/error_history.h"
#include "preview/film_display.h"
#include "preview/interactive_scale.h"
#include "preview/viewed_scene.h"
#include "render/effect_cost.h"
#include "render/timed_trace.h"
#include "render/trace_aovs.h"

namespace vernier {

/// Samples of a pixel that a picture gets by itself while the camera rests; Render asks for all. Where a pass ends.
constexpr std::uint32_t kPreviewSamples = 5;

/// How far a picture is.
struct PictureState {
  bool rendering = false;     ///< all samples are asked for
  double samples_done = 0.0;  ///< per pixel, of the full picture
  double rays_per_s = 0.0;
  double eta_s = 0.0;  ///< to the samples asked for
  double seconds = 0.0;
  double ms_per_tile = 0.0;
  double coarse_ms = 0.0;  ///< the last coarse picture
};

/// What lies under a pixel.
struct PixelFacts {
  glm::vec4 color;  ///< linear, alpha the share of hits
  std::uint32_t samples = 0;
  double rays = 0.0;  ///< per sample
  float depth_m = 0.0f;
  std::uint32_t object = 0, material = 0, primitive = 0;  ///< 2^32 - 1: nothing is there
};

/// A scene on the device and the picture of it that grows: through `vernier render`'s own tracer, so that the finished
/// picture has the bits of its image. Owns both.
class ViewSession {
 public:
  /// Uploads `viewed` and compiles for `settings`. The device outlives it. Throws Error as render_image does.
  ViewSession(const Device& device, ViewedScene viewed, const RenderSettings& settings);

  const ViewedScene& viewed() const { return viewed_; }
  /// In the light it is seen in now.
  const Scene& scene() const { return viewed_.scene; }
  const Camera& camera() const { return camera_; }
  const RenderSettings& settings() const { return settings_; }
  const EffectSet& effects() const { return effects_; }
  /// What the scene asks for, whatever the settings say.
  const EffectSet& automatic_effects() const { return automatic_; }
  /// As it was uploaded.
  const PackedScene& packed() const { return staged_.packed(); }
  Film& film() { return *film_; }
  /// Device memory of scene and film.
  std::uint64_t device_bytes() const { return staged_.gpu_scene().size_bytes() + film_->size_bytes(); }

  /// Begins anew through another camera; more will follow at once, so that a coarse picture will do.
  void set_camera(const Camera& camera);
  /// Begins anew with other settings; compiles and makes room where they ask for it. Where that fails all is as before.
  void set_settings(const RenderSettings& settings);
  /// The camera came to rest: the next trace makes the full picture.
  void come_to_rest();
  /// All samples of the settings are wanted.
  void render();
  /// No more than the preview's are wanted; those that are there stay.
  void stop();

  /// Takes the picture on: while the camera moves, a coarse one as a whole, unless the window is `closing`; else the
  /// samples that are wanted, unless `interrupted` says so before. Both are asked between submissions. Throws
  /// Error(device_lost).
  void trace(const std::function<bool()>& interrupted, const std::function<bool()>& closing);
  /// Makes sure that the film tells what the pixels of the picture see. Throws Error(device_lost).
  void trace_geometry();
  /// What `effects` that are on cost, at a small size; `stop` is asked between them.
  EffectLedger measure_effects(const std::function<void(double)>& progress, const std::function<bool()>& stop) const;

  /// Whether there is nothing to trace.
  bool is_finished() const;
  /// Whether every pixel of the settings' size has all samples.
  bool is_complete() const { return !moving_ && state_.samples_done >= settings_.spp; }
  /// Pixels of the film that hold a picture now.
  glm::ivec2 picture_size() const { return picture_size_; }
  /// Whether the film holds what picture_size() says; false while the first samples come in after a coarse picture.
  bool is_whole() const { return whole_; }
  const PictureState& state() const { return state_; }
  /// Estimates of this picture's error so far.
  const ErrorHistory& errors() const { return errors_; }
  /// Pixel (x, y) of the picture; none while there is no full picture. Waits.
  std::optional<PixelFacts> pixel(int x, int y);

 private:
  void prepare(const RenderSettings& settings);
  void restart();
  void begin_picture();
  void trace_coarse(const std::function<bool()>& closing);
  /// Where a trace of this picture was taken up.
  struct TraceStart {
    std::chrono::steady_clock::time_point time;
    double seconds = 0.0;
    double samples = 0.0;
  };
  void note(const RenderProgress& progress, const TraceStart& start);
  std::uint32_t goal() const;
  /// The settings with the depth that the effects need.
  RenderSettings needed(RenderSettings settings) const;

  const Device& device_;
  ViewedScene viewed_;
  Camera camera_;
  RenderSettings settings_;
  EffectSet effects_, automatic_;
  StagedScene staged_;
  std::unique_ptr<Film> film_;
  std::unique_ptr<FilmTracer> tracer_;
  std::unique_ptr<AovTracer> aov_tracer_;
  InteractiveScale scale_;
  ErrorHistory errors_{0, 0};
  TracePosition position_;
  std::uint64_t rays_ = 0;  // of all traces so far
  PictureState state_;
  glm::ivec2 picture_size_ = glm::ivec2(0);
  bool moving_ = true;
  bool whole_ = false;
  bool fresh_ = true;      // the film is to be emptied before the next sample
  bool geometry_ = false;  // the film's AOVs are those of the picture
};

}  // namespace vernier
