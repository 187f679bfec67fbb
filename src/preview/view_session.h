#pragma once

#include <functional>
#include <memory>
#include <string>

#include "effects/effect_set.h"
#include "preview/film_display.h"
#include "preview/interactive_scale.h"
#include "render/timed_trace.h"

namespace vernier {

/// A scene in its light, the camera it is first seen through and the path it came from.
struct ViewedScene {
  Scene scene;
  Camera camera;
};

/// A scene on the device and the picture of it that grows: through `vernier render`'s own tracer, so that the finished
/// picture has the bits of its image. Owns both.
class ViewSession {
 public:
  /// Uploads `viewed` and compiles for `settings`. The device outlives it. Throws Error as render_image does.
  ViewSession(const Device& device, ViewedScene viewed, const RenderSettings& settings);

  const Scene& scene() const { return viewed_.scene; }
  const Camera& camera() const { return camera_; }
  const RenderSettings& settings() const { return settings_; }
  const EffectSet& effects() const { return effects_; }
  Film& film() { return *film_; }

  /// Begins anew through another camera. `moving`: more will follow at once, so that a coarse picture will do.
  void set_camera(const Camera& camera, bool moving);
  /// Begins anew with other settings; compiles and makes room where they ask for it.
  void set_settings(const RenderSettings& settings);

  /// Takes the picture on: while the camera moves, a coarse one as a whole; else all samples that are missing, unless
  /// `interrupted`, which is asked between submissions, says so before. Throws Error(device_lost).
  void trace(const std::function<bool()>& interrupted);

  /// Whether there is something left to trace.
  bool is_finished() const { return !moving_ && share_ >= 1.0; }
  /// The camera came to rest: the next trace makes the full picture.
  void come_to_rest();
  /// Pixels of the film that hold a picture now.
  glm::ivec2 picture_size() const { return picture_size_; }
  /// Whether the film holds what picture_size() says; false while the first samples come in after a coarse picture.
  bool is_whole() const { return whole_; }
  /// Of the samples, in [0, 1].
  double share() const { return share_; }
  double rays_per_s() const { return rays_per_s_; }
  double eta_s() const { return eta_s_; }
  double traced_s() const { return traced_s_; }
  /// Writes depth, normals and numbers of what the pixels' centres see into the film.
  void trace_geometry();

 private:
  void prepare();
  void restart();
  void trace_coarse(const std::function<bool()>& interrupted);

  const Device& device_;
  ViewedScene viewed_;
  Camera camera_;
  RenderSettings settings_;
  EffectSet effects_;
  std::unique_ptr<StagedScene> staged_;
  TraceSpecialization specialization_;
  std::unique_ptr<Film> film_;
  std::unique_ptr<FilmTracer> tracer_;
  InteractiveScale scale_;
  glm::ivec2 picture_size_ = glm::ivec2(0);
  bool moving_ = false;
  bool whole_ = false;
  bool fresh_ = true;  // the film is to be emptied before the next sample
  double share_ = 0.0, rays_per_s_ = 0.0, eta_s_ = 0.0, traced_s_ = 0.0;
};

}  // namespace vernier
