// Traced samples into the film.
#ifndef VERNIER_ACCUMULATE_SAMPLES_GLSL
#define VERNIER_ACCUMULATE_SAMPLES_GLSL

#include "film.glsl"
#include "job.glsl"
#include "path.glsl"

// Whether the dispatch before, which might take every job of the pass that was left, has left none.
bool pass_is_traced() { return load_counter(COUNTER_UNFINISHED) == 0u && load_counter(COUNTER_NEXT_JOB) >= dispatch_constants().job_end; }

// Adds the traced samples of the pass at pixel (x, y) of the tile, which begin with job number `first_job`, to the film, once
// all are there. This follows a dispatch of the trace kernel in the same submission: asking here spares the host a round trip.
void accumulate_samples(IN(uint) x, IN(uint) y, IN(uint) first_job) {
  if (!pass_is_traced()) return;
  DispatchConstants constants = dispatch_constants();
  uint pixel = (constants.tile_y + y - constants.band_y) * constants.band_width + (constants.tile_x + x - constants.band_x);
  PixelSum sum = load_pixel_sum(pixel);
  uint samples = samples_of_pass();
  uint i = 0u;
  for (;;) {
    uvec4 traced = load_sample((first_job + i) * SAMPLE_BLOCKS(COUNT_COST));
    add_sample(sum, vector_of(traced), (traced.w & SAMPLE_HIT) != 0u, constants.sample_begin + i);
    sum.rays = saturated_sum(sum.rays, traced.w & ~SAMPLE_HIT);
    if (COUNT_COST) {
      uvec4 cost = load_sample((first_job + i) * SAMPLE_BLOCKS(COUNT_COST) + 1u);
      sum.nodes = saturated_sum(sum.nodes, cost.x);
      sum.triangles = saturated_sum(sum.triangles, cost.y);
    }
    i++;
    if (i >= samples) break;
  }
  store_pixel_sum(pixel, sum);
}

// The same for pixel number `rank` of the list; nothing beyond its end.
void accumulate_listed(IN(uint) rank) {
  if (rank >= dispatch_constants().pixel_count) return;
  Job place = listed_job(rank, 0u);
  accumulate_samples(place.x, place.y, rank * samples_of_pass());
}

#endif
