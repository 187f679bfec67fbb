// The jobs of a dispatch: every sample of the pass at every pixel of the tile, or at those of a list.
#ifndef VERNIER_JOB_GLSL
#define VERNIER_JOB_GLSL

#include "shared/film_layout.h"
#include "shared/render_constants.h"

struct Job {
  uint x, y;  // pixel of the tile; in an incomplete block it may lie outside
  uint sample_index;
};

uint blocks_of(IN(uint) pixels) { return (pixels + JOB_BLOCK_SIDE - 1u) / JOB_BLOCK_SIDE; }

uint samples_of_pass() { return dispatch_constants().sample_end - dispatch_constants().sample_begin; }

// a / b for a < 2^22: drivers for CPUs divide integers lane by lane. The quotient of the floats is off by one at most.
uint divided(IN(uint) a, IN(uint) b) {
  uint quotient = uint(float(a) / float(b));
  quotient -= quotient * b > a ? 1u : 0u;
  return quotient + (a - quotient * b >= b ? 1u : 0u);
}

// Sample `sample_index` of pixel number `rank` of the list.
Job listed_job(IN(uint) rank, IN(uint) sample_index) {
  uint pixel = load_pixel(rank);
  return Job(pixel & 0xffffu, pixel >> 16, sample_index);
}

// Job number `job`. The samples of a pixel follow each other, so that lanes in lockstep begin with rays that stay together.
Job job_at(IN(uint) job) {
  uint samples = samples_of_pass();
  uint rank = divided(job, samples);
  uint sample_index = dispatch_constants().sample_begin + (job - rank * samples);
  if (LISTED_PIXELS) return listed_job(min(rank, max(dispatch_constants().pixel_count, 1u) - 1u), sample_index);
  uint block = rank / (JOB_BLOCK_SIDE * JOB_BLOCK_SIDE);
  uint columns = blocks_of(dispatch_constants().tile_width);
  uint row = divided(block, columns);
  return Job((block - row * columns) * JOB_BLOCK_SIDE + rank % JOB_BLOCK_SIDE, row * JOB_BLOCK_SIDE + rank / JOB_BLOCK_SIDE % JOB_BLOCK_SIDE, sample_index);
}

// The inverse of job_at: the first job of pixel (x, y) of the tile, where there is no list.
uint first_job_of(IN(uint) x, IN(uint) y) {
  uint block = y / JOB_BLOCK_SIDE * blocks_of(dispatch_constants().tile_width) + x / JOB_BLOCK_SIDE;
  return (block * JOB_BLOCK_SIDE * JOB_BLOCK_SIDE + y % JOB_BLOCK_SIDE * JOB_BLOCK_SIDE + x % JOB_BLOCK_SIDE) * samples_of_pass();
}

bool is_in_tile(IN(Job) job) { return job.x < dispatch_constants().tile_width && job.y < dispatch_constants().tile_height; }

#endif
