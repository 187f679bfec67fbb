// Traced samples into the film.
#ifndef VERNIER_ACCUMULATE_SAMPLES_GLSL
#define VERNIER_ACCUMULATE_SAMPLES_GLSL

#include "film.glsl"
#include "job.glsl"
#include "path.glsl"

// Whether the dispatches before have traced every job of the pass.
bool pass_is_traced() { return load_counter(COUNTER_UNFINISHED) == 0u && load_counter(COUNTER_NEXT_JOB) >= job_count(); }

// Adds the traced samples of the pass at pixel (x, y) of the tile to the film, once all are there. This follows every
// dispatch of the trace kernel in the same submission: asking here spares the host a round trip.
void accumulate_samples(IN(uint) x, IN(uint) y) {
  if (!pass_is_traced()) return;
  DispatchConstants constants = dispatch_constants();
  uint pixel = (constants.tile_y + y - constants.band_y) * constants.band_width + (constants.tile_x + x - constants.band_x);
  PixelSum sum = load_pixel_sum(pixel);
  uint first = first_job_of(x, y);
  for (uint i = 0u; i < samples_of_pass(); i++) {
    uvec4 traced = load_sample((first + i) * SAMPLE_BLOCKS(COUNT_COST));
    add_sample(sum, vector_of(traced), (traced.w & SAMPLE_HIT) != 0u, constants.sample_begin + i);
    sum.rays += traced.w & ~SAMPLE_HIT;
    if (COUNT_COST) {
      uvec4 cost = load_sample((first + i) * SAMPLE_BLOCKS(COUNT_COST) + 1u);
      sum.nodes += cost.x;
      sum.triangles += cost.y;
    }
  }
  store_pixel_sum(pixel, sum);
}

#endif
