// What one invocation does: job after job, a search per round. Lanes whose ray ends early go on with their next, of whatever
// kind and of whatever pixel, so none waits for the others' longer paths.
#ifndef VERNIER_TRACE_JOBS_GLSL
#define VERNIER_TRACE_JOBS_GLSL

#include "camera.glsl"
#include "job.glsl"
#include "sample_pattern.glsl"
#include "trace_path.glsl"

// Puts job number `job` into `path`, which has none; leaves it without where the job does not exist or has no pixel.
void begin_path(INOUT(Path) path, IN(uint) job) {
  RenderConstants constants = render_constants();
  Job place = job_at(job);
  uint x = dispatch_constants().tile_x + place.x;
  uint y = dispatch_constants().tile_y + place.y;
  uvec2 key = mutated(MUTATION_TILE_PATTERN) ? uvec2(place.x, place.y) : uvec2(x, y);
  SteeringConstants steering = steering_constants();
  vec2 offset = sample_offset(key.x, key.y, place.sample_index, constants.seed, steering.spp);
  // One sample stays in the middle, which a tent leaves where it is.
  offset = filtered_offset(offset, steering.pixel_filter);
  Ray ray = camera_ray(vec2(float(x), float(y)) + offset);
  path.job = job < dispatch_constants().job_end && is_in_tile(place) ? job : NONE;
  path.hit = false;
  path.radiance = vec3(0.0f);
  path.waiting = 0u;
  path.phase = PHASE_HIT;
  path.cost = SampleCost(1u, 0u, 0u);
  path.current = PathRay(ray.origin, ray.direction, vec3(1.0f), 0.0f, NONE, 0u, NONE);
}

void store_finished_sample(IN(Path) path) {
  uint first = path.job * SAMPLE_BLOCKS(COUNT_COST);
  store_sample(first, block_of(path.radiance, path.cost.rays | (path.hit ? SAMPLE_HIT : 0u)));
  if (COUNT_COST) store_sample(first + 1u, uvec4(path.cost.nodes, path.cost.triangles, 0u, 0u));
}

void report_counts(IN(RayCounts) counts) {
  add_to_counter(COUNTER_PRIMARY, counts.primary);
  add_to_counter(COUNTER_SHADOW, counts.shadow);
  add_to_counter(COUNTER_REFLECTION, counts.reflection);
  add_to_counter(COUNTER_REFRACTION, counts.refraction);
  add_to_counter(COUNTER_STACK_OVERFLOWS, counts.dropped);
}

// Goes from the answer to the path's search to its next search; the sample is stored when its last ray is done. False when
// a loop limit cut this off: nothing has changed then.
bool go_on(IN(uint) place, INOUT(Path) path, IN(Found) found, INOUT(RayCounts) counts) {
  Step result = step_of(path, found);
  uint shadow_rays = result.asks_light ? 1u : 0u;
  counts.shadow += shadow_rays;
  path.cost.rays += shadow_rays;
  if (COUNT_EFFECTS && result.finished) {
    count_runs();
    add_to_counter(COUNTER_SHADOW_RAYS + counted_depth(path.current.depth), shadow_rays);
  }
  if (COUNT_COST && result.finished) {
    path.cost.nodes += found.nodes;
    path.cost.triangles += found.triangles;
  }
  if (result.ray_done) {
    if (next_ray(place, path, result.children, counts)) {
      path.cost.rays++;
    } else {
      store_finished_sample(path);
      path.job = NONE;
    }
  }
  return result.finished;
}

// Takes jobs of the dispatch until none is left or the budget is spent; a path that is not done at the limit behind it is
// saved for the next dispatch. A search counts only when it came to its end: one that a driver's loop limit cut off is made
// again in the next dispatch, so nothing is lost silently.
void trace_jobs(IN(uint) invocation) {
  uint budget = dispatch_constants().search_budget;
  uint limit = dispatch_constants().search_limit;
  uint place = path_place(invocation);
  Path path = no_path();
  if (dispatch_constants().resume != 0u) path = restored_path(place);
  RayCounts counts = RayCounts(0u, 0u, 0u, 0u, 0u);
  uint searches = 0u;
  bool going = true;
  for (uint rounds = 0u; going && searches < (path.job == NONE ? budget : limit) && rounds < LOOP_ROUND_LIMIT; rounds++) {
    if (path.job == NONE) {
      uint job = take_job();
      going = job < dispatch_constants().job_end;
      begin_path(path, job);
      counts.primary += path.job != NONE ? 1u : 0u;
    }
    Found found = search_scene(path_search(path));
    if (path.job != NONE) {
      going = go_on(place, path, found, counts);
      searches += going ? 1u : 0u;
    }
  }
  save_path(place, path);
  bool unfinished = path.job != NONE;
  add_to_counter(COUNTER_UNFINISHED, unfinished ? 1u : 0u);
  add_to_counter(COUNTER_STUCK, unfinished && searches == 0u ? 1u : 0u);
  report_counts(counts);
}

#endif
