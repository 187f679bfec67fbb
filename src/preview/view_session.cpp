#include "preview/view_session.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

#include "effects/choose_effects.h"
#include "effects/detect_effects.h"
#include "math/elapsed.h"
#include "render/develop.h"
#include "scene/frame_scene.h"
#include "shared/film_layout.h"

namespace vernier {
namespace {

/// One coarse picture while the camera moves: input that comes right after one was begun waits for it, for its own and
/// for two frames of the window, and still shows within 150 ms. With 35 ms mirrors and glass took up to 169 at 1280x720
/// on lavapipe, with 20 up to 142.
constexpr double kInteractiveMs = 20.0;
/// Input waits for the submission under way too. Never changes a bit.
constexpr double kLongestDispatchMs = 45.0;

using Clock = std::chrono::steady_clock;

/// `samples`, whole where only the rounding of a share keeps it from being so: a tile is more than a billionth of a
/// picture.
double without_rounding(double samples) {
  constexpr double kLessThanATile = 1e-9;
  const double nearest = std::round(samples);
  return std::fabs(samples - nearest) < kLessThanATile ? nearest : samples;
}

/// Whether kernels, film and buffers made for `before` do for `after`.
bool fits(const RenderSettings& before, const RenderSettings& after) {
  return after.effects == before.effects && after.accuracy == before.accuracy &&
         after.max_bounces == before.max_bounces && after.width == before.width && after.height == before.height &&
         after.tile == before.tile && after.dispatch_ms == before.dispatch_ms && after.sample_end <= before.sample_end;
}

}  // namespace

ViewSession::ViewSession(const Device& device, ViewedScene viewed, const RenderSettings& settings)
    : device_(device),
      viewed_(std::move(viewed)),
      camera_(viewed_.camera),
      settings_(settings),
      staged_(device, std::move(viewed_.packed), camera_, settings),
      scale_(kInteractiveMs) {
  prepare(settings);
}

/// Effects, film and tracers of `settings`; all of them or none.
void ViewSession::prepare(const RenderSettings& settings) {
  const EffectSet automatic =
      detect_effects(viewed_.scene, camera_, static_cast<int>(settings.max_bounces), settings.cutoff);
  const EffectSet effects = choose_effects(automatic, settings.effects);
  TraceSpecialization specialization = specialize(effects.bits, shape_of(staged_.packed()), effects.depth.bounces,
                                                  wants_aov(settings, "cost"), device_.description());
  specialization.levels = levels_of(settings);
  auto film = std::make_unique<Film>(device_, PixelRect{0, 0, settings.width, settings.height}, true);
  RenderSettings scheduled = settings;
  scheduled.dispatch_ms = std::min(settings.dispatch_ms, kLongestDispatchMs);
  auto tracer =
      std::make_unique<FilmTracer>(device_, staged_.gpu_scene(), staged_.loads(), specialization, scheduled, *film);
  auto aov_tracer = std::make_unique<AovTracer>(device_, staged_.gpu_scene(), staged_.loads(), specialization, *film);
  // llvmpipe compiles at the first dispatch, for up to a second: at the first look for what lies under the mouse, a
  // click would begin and end unseen meanwhile.
  aov_tracer->trace({0, 0, 1, 1});
  effects_ = effects;
  automatic_ = automatic;
  settings_ = settings;
  aov_tracer_ = std::move(aov_tracer);
  tracer_ = std::move(tracer);
  rays_ = 0;
  film_ = std::move(film);
  picture_size_ = glm::ivec2(0);
  whole_ = false;
  restart();
}

void ViewSession::restart() {
  fresh_ = true;
  moving_ = true;  // something to see at once
  geometry_ = false;
  const double coarse_ms = state_.coarse_ms;
  state_ = {};
  state_.coarse_ms = coarse_ms;
}

void ViewSession::set_camera(const Camera& camera) {
  const bool other_kind = camera.orthographic != camera_.orthographic;
  camera_ = camera;
  if (viewed_.lights_follow) {
    viewed_.scene.lights = default_lights(camera);
    staged_.set_lights(viewed_.scene.lights);
  }
  if (other_kind) {
    prepare(settings_);
  } else {
    restart();
  }
}

void ViewSession::set_settings(const RenderSettings& settings) {
  if (!fits(settings_, settings)) return prepare(settings);
  settings_ = settings;
  restart();
}

void ViewSession::come_to_rest() {
  moving_ = false;
}

void ViewSession::render() {
  moving_ = false;
  state_.rendering = !is_complete();
}

void ViewSession::stop() {
  state_.rendering = false;
}

std::uint32_t ViewSession::goal() const {
  return state_.rendering ? settings_.spp : std::min(settings_.spp, kPreviewSamples);
}

bool ViewSession::is_finished() const {
  return !moving_ && state_.samples_done >= goal();
}

RenderSettings ViewSession::needed(RenderSettings settings) const {
  settings.max_bounces = effects_.depth.bounces;
  return settings;
}

void ViewSession::begin_picture() {
  staged_.set_view(camera_, needed(settings_));
  film_->clear(device_);
  errors_ = ErrorHistory(settings_.width, settings_.height);
  position_ = tracer_->start_of(settings_);
  whole_ = fresh_ = geometry_ = false;
}

void ViewSession::trace(const std::function<bool()>& interrupted, const std::function<bool()>& closing) {
  if (moving_) return trace_coarse(closing);
  if (fresh_) begin_picture();
  const TraceStart start{Clock::now(), state_.seconds, state_.samples_done};
  RenderCallbacks callbacks;
  bool stopped = false;
  callbacks.cancelled = [&] { return stopped = stopped || is_finished() || interrupted(); };
  callbacks.progress = [&](const RenderProgress& progress) { note(progress, start); };
  rays_ = total(tracer_->trace_on(position_, settings_, callbacks).rays);
  state_.rendering = state_.rendering && !is_complete();
}

/// After each tile.
void ViewSession::note(const RenderProgress& progress, const TraceStart& start) {
  const double traced_s = std::max(seconds_since(start.time), 1e-6);
  const double seconds = start.seconds + traced_s;
  state_.ms_per_tile = (seconds - state_.seconds) * 1000.0;
  state_.seconds = seconds;
  state_.samples_done = without_rounding(progress.share * settings_.spp);
  state_.rays_per_s = static_cast<double>(progress.rays - rays_) / traced_s;
  const double samples_per_s = (state_.samples_done - start.samples) / traced_s;
  state_.eta_s = samples_per_s > 0.0 ? std::max(goal() - state_.samples_done, 0.0) / samples_per_s : 0.0;
  // Tiles without a sample would be black: the coarse picture stays until all have one.
  if (state_.samples_done < 1.0) return;
  picture_size_ = {settings_.width, settings_.height};
  whole_ = true;
  const auto samples = static_cast<std::uint32_t>(state_.samples_done);
  if (samples != state_.samples_done || !errors_.wants(samples)) return;
  const DevelopedFilm developed = develop(film_->read_sums(device_), film_->area());
  // In the middle of a pass the mean may be whole too.
  if (developed.least_samples == samples) errors_.add(developed, samples, state_.seconds);
}

/// One sample in the middle of each pixel of a smaller picture.
void ViewSession::trace_coarse(const std::function<bool()>& closing) {
  RenderSettings coarse = needed(settings_);
  const glm::ivec2 size = scale_.size({settings_.width, settings_.height});
  coarse.width = size.x;
  coarse.height = size.y;
  coarse.spp = coarse.sample_end = 1;
  coarse.sample_begin = 0;
  staged_.set_view(camera_, coarse);
  film_->clear_rows(device_, size.y);
  whole_ = false;
  const Clock::time_point start = Clock::now();
  RenderCallbacks callbacks;
  // Half a picture is worth nothing while the camera moves.
  callbacks.cancelled = closing;
  rays_ = total(tracer_->trace_part({0, 0, size.x, size.y}, coarse, callbacks).rays);
  state_.coarse_ms = seconds_since(start) * 1000.0;
  scale_.took(static_cast<double>(size.x) * size.y, state_.coarse_ms);
  picture_size_ = size;
  whole_ = fresh_ = true;
  geometry_ = false;
}

void ViewSession::trace_geometry() {
  if (geometry_ || picture_size_.x == 0) return;
  aov_tracer_->trace({0, 0, picture_size_.x, picture_size_.y});
  geometry_ = true;
}

EffectLedger ViewSession::measure_effects(const std::function<void(double)>& progress,
                                          const std::function<bool()>& stop) const {
  RenderSettings small = settings_;
  small.width = 160;
  small.height = std::max(160 * settings_.height / settings_.width, 1);
  small.spp = small.sample_end = 2;
  small.sample_begin = 0;
  EffectCostSetup setup;
  setup.rounds = 5;
  setup.progress = progress;
  setup.stop = stop;
  return measure_effect_costs(device_, viewed_.scene, camera_, small, effects_, setup);
}

std::optional<PixelFacts> ViewSession::pixel(int x, int y) {
  if (!whole_ || fresh_ || x < 0 || y < 0 || x >= settings_.width || y >= settings_.height) return std::nullopt;
  trace_geometry();
  const DevelopedFilm developed = develop(film_->read_pixel(device_, x, y), {x, y, 1, 1});
  const std::vector<std::uint32_t> words = film_->read_pixel_aovs(device_, x, y);
  const std::vector<float>& color = developed.color;
  return PixelFacts{.color = {color[0], color[1], color[2], color[3]},
                    .samples = developed.sample_count[0],
                    .rays = developed.cost[0],
                    .depth_m = std::bit_cast<float>(words[AOV_DEPTH]),
                    .object = words[AOV_OBJECT_ID],
                    .material = words[AOV_MATERIAL_ID],
                    .primitive = words[AOV_PRIMITIVE_ID]};
}

}  // namespace vernier
