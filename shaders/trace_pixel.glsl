// All samples of one pixel in one loop, a ray per round: lanes whose sample ends early go on with their next.
#ifndef VERNIER_TRACE_PIXEL_GLSL
#define VERNIER_TRACE_PIXEL_GLSL

#include "camera.glsl"
#include "film.glsl"
#include "sample_pattern.glsl"
#include "trace_path.glsl"

Path begun_sample(IN(PathPlace) place, IN(uint) x, IN(uint) y, IN(uint) sample_index) {
  RenderConstants constants = render_constants();
  vec2 offset = sample_offset(x, y, sample_index, constants.seed, steering_constants().spp);
  Ray ray = camera_ray(vec2(float(x), float(y)) + offset);
  return Path(place, sample_index, false, vec3(0.0f), 0u, PathRay(ray.origin, ray.direction, vec3(1.0f), 0.0f, NONE, 0u, NONE));
}

void report_counts(IN(RayCounts) counts) {
  add_to_counter(COUNTER_PRIMARY, counts.primary);
  add_to_counter(COUNTER_SHADOW, counts.shadow);
  add_to_counter(COUNTER_REFLECTION, counts.reflection);
  add_to_counter(COUNTER_REFRACTION, counts.refraction);
  add_to_counter(COUNTER_STACK_OVERFLOWS, counts.dropped);
}

// Adds samples [sample_begin, sample_end) of pixel (x, y) to the film, or as many rays of them as the budget allows; then
// the path is saved for the next dispatch. A ray counts only when it was traced to its end: what a driver's loop limit
// cuts off is traced again with a fresh limit, so nothing is lost silently.
void trace_pixel(IN(uint) x, IN(uint) y, IN(uint) invocation) {
  DispatchConstants dispatch_values = dispatch_constants();
  PathPlace place = PathPlace(invocation, dispatch_values.tile_width * dispatch_values.tile_height);
  uint pixel = (y - dispatch_values.band_y) * dispatch_values.band_width + (x - dispatch_values.band_x);
  Path path = begun_sample(place, x, y, dispatch_values.sample_begin);
  RayCounts counts = RayCounts(0u, 0u, 0u, 0u, 0u, 0u, 0u);
  if (dispatch_values.resume != 0u) {
    path = restored_path(place);
  } else {
    counts.primary++;
  }
  if (path.sample_index >= dispatch_values.sample_end) return;
  PixelSum sum = load_pixel_sum(pixel);
  bool going = true;
  uint rays = 0u;
  while (going && rays < dispatch_values.ray_budget) {
    RayCounts ray_counts = counts;
    RayResult result = trace_ray(path.current, ray_counts);
    if (!result.finished) break;
    rays++;
    counts = ray_counts;
    path.radiance += result.radiance;
    path.hit = path.hit || (result.hit && path.current.depth == 0u);
    if (!next_ray(path, result.children, counts)) {
      add_sample(sum, path.radiance, path.hit, path.sample_index);
      uint next_sample = path.sample_index + 1u;
      going = next_sample < dispatch_values.sample_end;
      path = begun_sample(place, x, y, next_sample);
      counts.primary += going ? 1u : 0u;
    }
  }
  sum.rays += rays + counts.shadow;
  sum.nodes += counts.nodes;
  sum.triangles += counts.triangles;
  store_pixel_sum(pixel, sum);
  save_path(path);
  bool unfinished = path.sample_index < dispatch_values.sample_end;
  add_to_counter(COUNTER_UNFINISHED, unfinished ? 1u : 0u);
  add_to_counter(COUNTER_STUCK, unfinished && rays == 0u ? 1u : 0u);
  report_counts(counts);
}

#endif
