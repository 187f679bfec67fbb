#include "render/timed_trace.h"

#include <algorithm>

namespace vernier {
namespace {

RayCounts difference(const RayCounts& after, const RayCounts& before) {
  return {.primary = after.primary - before.primary,
          .shadow = after.shadow - before.shadow,
          .reflection = after.reflection - before.reflection,
          .refraction = after.refraction - before.refraction};
}

}  // namespace

StagedScene::StagedScene(const Device& device, const Scene& scene, const Camera& camera, const RenderSettings& settings)
    : StagedScene(device, pack_scene(scene, settings), camera, settings) {}

StagedScene::StagedScene(const Device& device, PackedScene packed, const Camera& camera, const RenderSettings& settings)
    : device_(device),
      settings_(settings),
      loads_(choose_scene_loads(device.description(), settings.traversal)),
      packed_(std::move(packed)),
      gpu_scene_(device, packed_, loads_) {
  set_view(camera, settings);
}

TraceSpecialization StagedScene::specialization(std::uint32_t effects) const {
  TraceSpecialization values =
      specialize(effects, shape_of(packed_), settings_.max_bounces, false, device_.description(), settings_.traversal);
  values.levels = levels_of(settings_);
  return values;
}

void StagedScene::set_settings(const RenderSettings& settings) {
  vernier::set_settings(packed_, settings);
  gpu_scene_.set_textures(device_, packed_.textures);
  gpu_scene_.set_constants(device_, packed_.constants, packed_.steering);
}

void StagedScene::set_view(const Camera& camera, const RenderSettings& settings) {
  set_camera(packed_, camera, settings);
  set_settings(settings);
}

void StagedScene::set_lights(const std::vector<Light>& lights) {
  packed_.lights = pack_lights(lights, packed_.space);
  gpu_scene_.set_lights(device_, packed_.lights);
}

TimedTrace::TimedTrace(const StagedScene& scene, const TraceSpecialization& specialization,
                       const RenderSettings& settings)
    : device_(scene.device()),
      film_(scene.device(), {0, 0, settings.width, settings.height}, false),
      tracer_(scene.device(), scene.gpu_scene(), scene.loads(), specialization, settings, film_) {}

TraceTime TimedTrace::trace(const std::function<bool()>& stop) {
  RenderCallbacks callbacks;
  callbacks.cancelled = stop;
  const TraceStatistics after = tracer_.trace(callbacks);
  TraceTime time{after.device_ms - before_.device_ms, difference(after.rays, before_.rays), after.wall_ms, after.saved};
  time.saved.aov_bytes = Film::aov_bytes(film_.area());
  before_ = {after.device_ms, after.rays, after.wall_ms, {}};
  compile_ms_ = 0.0;
  for (const PipelineTime& pipeline : after.pipelines) compile_ms_ += pipeline.compile_ms;
  return time;
}

TraceTime TimedTrace::trace_anew(const RenderSettings& settings, const std::function<bool()>& stop) {
  film_.clear(device_);
  tracer_.set_settings(settings);
  return trace(stop);
}

Image TimedTrace::picture() const {
  const PixelRect& area = film_.area();
  return {.width = area.width,
          .height = area.height,
          .channel_count = 4,
          .values = develop(film_.read_sums(device_), area).color};
}

}  // namespace vernier
