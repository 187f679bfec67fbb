#include "preview/view_session.h"

#include <chrono>

#include "effects/detect_effects.h"
#include "render/trace_aovs.h"

namespace vernier {
namespace {

/// One coarse picture while the camera moves.
constexpr double kInteractiveMs = 80.0;

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

ViewSession::ViewSession(const Device& device, ViewedScene viewed, const RenderSettings& settings)
    : device_(device),
      viewed_(std::move(viewed)),
      camera_(viewed_.camera),
      settings_(settings),
      staged_(std::make_unique<StagedScene>(device, viewed_.scene, camera_, settings)),
      scale_(kInteractiveMs) {
  prepare();
}

/// Effects, film and tracer of the settings.
void ViewSession::prepare() {
  effects_ = plan_effects(viewed_.scene, camera_, settings_.max_bounces, settings_.cutoff, settings_.effects);
  specialization_ = staged_->specialization(effects_.bits);
  specialization_.levels = levels_of(settings_.accuracy);
  tracer_.reset();
  film_ = std::make_unique<Film>(device_, PixelRect{0, 0, settings_.width, settings_.height}, true);
  tracer_ = std::make_unique<FilmTracer>(device_, staged_->gpu_scene(), staged_->loads(), specialization_, settings_,
                                         *film_);
  moving_ = true;  // something to see at once
  restart();
}

void ViewSession::restart() {
  fresh_ = true;
  share_ = rays_per_s_ = eta_s_ = traced_s_ = 0.0;
}

void ViewSession::set_camera(const Camera& camera, bool moving) {
  camera_ = camera;
  moving_ = moving;
  restart();
}

void ViewSession::set_settings(const RenderSettings& settings) {
  const bool compiled = settings.effects == settings_.effects && settings.accuracy == settings_.accuracy &&
                        settings.max_bounces == settings_.max_bounces && settings.width == settings_.width &&
                        settings.height == settings_.height && settings.sample_end <= settings_.sample_end;
  settings_ = settings;
  if (compiled) {
    restart();
  } else {
    prepare();
  }
}

void ViewSession::come_to_rest() {
  if (moving_) restart();
  moving_ = false;
}

void ViewSession::trace(const std::function<bool()>& interrupted) {
  if (moving_) return trace_coarse(interrupted);
  if (fresh_) {
    staged_->set_view(camera_, settings_);
    film_->clear(device_);
    whole_ = false;
    fresh_ = false;
    share_ = 0.0;
  }
  const Clock::time_point start = Clock::now();
  RenderCallbacks callbacks;
  bool stopped = false;
  callbacks.cancelled = [&] { return stopped = stopped || interrupted(); };
  callbacks.progress = [&](const RenderProgress& progress) {
    share_ = progress.share;
    rays_per_s_ = progress.rays_per_s;
    eta_s_ = progress.eta_s;
    traced_s_ = milliseconds_since(start) / 1000.0;
    // Tiles without a sample would be black: the coarse picture stays until all have one.
    if (share_ * settings_.spp < 1.0) return;
    picture_size_ = {settings_.width, settings_.height};
    whole_ = true;
  };
  tracer_->trace_part(film_->area(), settings_, callbacks);
}

/// One sample in the middle of each pixel of a smaller picture.
void ViewSession::trace_coarse(const std::function<bool()>& interrupted) {
  RenderSettings coarse = settings_;
  const glm::ivec2 size = scale_.size({settings_.width, settings_.height});
  coarse.width = size.x;
  coarse.height = size.y;
  coarse.spp = coarse.sample_end = 1;
  coarse.sample_begin = 0;
  staged_->set_view(camera_, coarse);
  film_->clear(device_);
  whole_ = false;
  const Clock::time_point start = Clock::now();
  RenderCallbacks callbacks;
  // Half a picture is worth nothing while the camera moves: only closing the window stops it.
  callbacks.cancelled = interrupted;
  tracer_->trace_part({0, 0, size.x, size.y}, coarse, callbacks);
  scale_.took(static_cast<double>(size.x) * size.y, milliseconds_since(start));
  picture_size_ = size;
  whole_ = true;
  fresh_ = true;
}

void ViewSession::trace_geometry() {
  staged_->set_view(camera_, settings_);
  trace_aovs(device_, staged_->gpu_scene(), staged_->loads(), specialization_, *film_);
}

}  // namespace vernier
