#include "render/render_image.h"

#include <algorithm>
#include <chrono>

#include "effects/choose_effects.h"
#include "error.h"
#include "math/elapsed.h"
#include "render/film.h"
#include "render/film_file.h"
#include "render/gpu_scene.h"
#include "render/pack_scene.h"
#include "render/read_film.h"
#include "render/tile_schedule.h"
#include "render/trace_aovs.h"
#include "render/trace_film.h"

namespace vernier {
namespace {

void describe_scene(const Scene& scene, const PackedScene& packed, RenderStatistics& statistics) {
  statistics.triangles = packed.triangle_count;
  statistics.instances = scene.instances.size();
  statistics.materials = scene.materials.size();
  statistics.textures = scene.textures.size();
  statistics.bvh_nodes = packed.bvh.node_count;
  statistics.bvh_bytes = packed.bvh.records.size() * sizeof(BvhRecord);
  statistics.sah_cost = packed.bvh.sah_cost;
  statistics.bvh_depth = packed.bvh.depth;
  statistics.bvh_build_ms = packed.bvh_build_ms;
  statistics.pack_ms = packed.bake_ms;
}

/// Triangles of all instances that validate_scene dropped, and has told of.
std::uint64_t dropped_triangles(const Scene& scene) {
  std::vector<std::uint64_t> of_mesh;
  for (const Mesh& mesh : scene.meshes) {
    of_mesh.push_back(static_cast<std::uint64_t>(std::ranges::count(mesh.triangles, glm::uvec3(0))));
  }
  std::uint64_t count = 0;
  for (const Instance& instance : scene.instances) count += of_mesh[instance.mesh];
  return count;
}

/// Tells of triangles that no ray will meet.
void describe_left_out(const Scene& scene, const PackedScene& packed, RenderStatistics& statistics) {
  const auto tell = [&](std::uint64_t count, const char* what) {
    if (count == 0) return;
    statistics.warnings.push_back(scene.source + ": " + std::to_string(count) +
                                  (count == 1 ? " triangle " : " triangles ") + what);
  };
  const std::uint64_t left_out = packed.triangle_count - packed.traced_triangles;
  tell(left_out - packed.hidden_triangles - dropped_triangles(scene), "without area, never hit");
  tell(packed.hidden_triangles, "exactly on others before, never seen");
}

void describe_trace(const TraceStatistics& trace, const RenderSettings& settings, RenderStatistics& statistics) {
  statistics.rays = trace.rays;
  statistics.stack_overflows = trace.stack_overflows;
  statistics.error = trace.error;
  statistics.stopped = trace.stopped;
  if (settings.error_target && !(trace.error && trace.error->bound() <= *settings.error_target)) {
    statistics.warnings.push_back("--error-target was not reached with " + std::to_string(settings.spp) +
                                  " samples per pixel or in the time given");
  }
  statistics.trace_device_ms = trace.device_ms;
  statistics.trace_wall_ms = trace.wall_ms;
  statistics.pipelines.insert(statistics.pipelines.end(), trace.pipelines.begin(), trace.pipelines.end());
  for (const PipelineTime& pipeline : statistics.pipelines) statistics.compile_ms += pipeline.compile_ms;
  statistics.effect_runs = trace.effect_runs;
  statistics.saved.path_stack_bytes = trace.saved.path_stack_bytes;
  statistics.saved.sample_cost_bytes = trace.saved.sample_cost_bytes;
  statistics.device_bytes += trace.device_bytes;
  if (trace.stack_overflows > 0) {
    statistics.warnings.push_back(std::to_string(trace.stack_overflows) +
                                  " rays were dropped: more waited than the stack holds; try a lower --max-bounces");
  }
}

GpuScene upload_scene(const Device& device, const PackedScene& packed, SceneLoads loads, RenderStatistics& statistics) {
  const auto start = std::chrono::steady_clock::now();
  GpuScene gpu_scene(device, packed, loads);
  gpu_scene.set_constants(device, packed.constants, packed.steering);
  statistics.upload_ms = ms_since(start);
  statistics.device_bytes = gpu_scene.size_bytes();
  return gpu_scene;
}

/// What the kernels are to know of `packed`, with the effects and the depth that `plan` calls for.
TraceSpecialization specialization_of(const PackedScene& packed, const RenderSettings& settings, const EffectSet& plan,
                                      const DeviceDescription& device) {
  TraceSpecialization specialization = specialize(plan.bits, shape_of(packed), plan.depth.bounces,
                                                  wants_aov(settings, "cost"), device, settings.traversal);
  specialization.levels = levels_of(settings);
  specialization.mutation = settings.mutation;
  specialization.count_effects = settings.count_effects;
  specialization.listed_pixels = settings.error_target.has_value();
  return specialization;
}

/// Puts the sums of `saved` into the empty film.
void resume(const Device& device, const SavedFilm& saved, Film& film) {
  const PixelRect& area = film.area();
  const bool same_size = saved.area.width == area.width && saved.area.height == area.height;
  if (!same_size || saved.area.x != area.x || saved.area.y != area.y) {
    throw Error(ErrorKind::refused, "--resume: the checkpoint is of other pixels");
  }
  if (!saved.sums.empty()) film.write_sums(device, saved.sums);
}

}  // namespace

void check_settings(const RenderSettings& settings, const DeviceDescription& device) {
  if (settings.width < 1 || settings.height < 1) throw Error(ErrorKind::usage, "--size: the image is empty");
  if (settings.sample_begin >= settings.sample_end || settings.sample_end > settings.spp) {
    throw Error(ErrorKind::usage, "--sample-range: it must lie within 0:" + std::to_string(settings.spp));
  }
  if (settings.error_target &&
      (settings.spp < 2 || settings.sample_begin != 0 || settings.sample_end != settings.spp)) {
    throw Error(ErrorKind::usage, "--error-target: it needs all samples of the image, and at least 2 per pixel");
  }
  if (settings.error_target && settings.crop) {
    throw Error(ErrorKind::usage, "--error-target: not with --crop; the whole image decides where samples pay");
  }
  const PixelRect whole{0, 0, settings.width, settings.height};
  const PixelRect area = image_area(settings);
  if (area.x < 0 || area.y < 0 || area.width < 1 || area.height < 1 || area.width > whole.width - area.x ||
      area.height > whole.height - area.y) {
    throw Error(ErrorKind::usage, "--crop: it must lie within the image of " + std::to_string(whole.width) + "x" +
                                      std::to_string(whole.height));
  }
  require_loads(device, choose_scene_loads(device, settings.traversal));
}

RenderResult render_image(const Device& device, const Scene& scene, const Camera& camera,
                          const RenderSettings& settings, const RenderCallbacks& callbacks) {
  check_settings(settings, device.description());
  return render_image(device, scene, pack_shape(scene, settings), camera, settings, callbacks);
}

RenderResult render_image(const Device& device, const Scene& scene, PackedScene packed, const Camera& camera,
                          const RenderSettings& settings, const RenderCallbacks& callbacks) {
  const PixelRect area = image_area(settings);
  RenderStatistics statistics;
  statistics.effects = plan_effects(scene, camera, settings.max_bounces, settings.cutoff, settings.effects);
  const SceneLoads loads = choose_scene_loads(device.description(), settings.traversal);

  pack_look(scene, packed);
  describe_scene(scene, packed, statistics);
  describe_left_out(scene, packed, statistics);
  set_camera(packed, camera, settings);
  RenderSettings needed = settings;
  needed.max_bounces = statistics.effects.depth.bounces;
  set_settings(packed, needed);

  GpuScene gpu_scene = upload_scene(device, packed, loads, statistics);
  const TraceSpecialization specialization =
      specialization_of(packed, settings, statistics.effects, device.description());
  packed = {};  // the device has it now

  Film film(device, area, wants_geometry(settings));
  statistics.device_bytes += film.size_bytes();
  if (wants_geometry(settings)) {
    statistics.pipelines = {trace_aovs(device, gpu_scene, loads, specialization, film)};
  } else {
    statistics.saved.aov_bytes = Film::aov_bytes(area);
  }
  RenderSettings scheduled = settings;
  scheduled.first_pass = choose_first_pass(area);
  if (callbacks.resumed) {
    resume(device, *callbacks.resumed, film);
    scheduled.tile = callbacks.resumed->position.tile;
  }
  describe_trace(FilmTracer(device, gpu_scene, loads, specialization, scheduled, film).trace(callbacks), settings,
                 statistics);
  ImageFile image = read_film(device, film, settings, statistics);
  return {.image = std::move(image), .statistics = std::move(statistics)};
}

}  // namespace vernier
