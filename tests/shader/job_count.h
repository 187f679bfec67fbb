#pragma once

#include "shader/shader.h"

namespace vernier::shader {

/// Jobs of the dispatch, those of incomplete blocks that have no pixel counted too: what the host counts by
/// jobs_per_sample (render/tile_schedule.h).
inline uint job_count() {
  const DispatchConstants constants = dispatch_constants();
  if (LISTED_PIXELS) return constants.pixel_count * samples_of_pass();
  return blocks_of(constants.tile_width) * blocks_of(constants.tile_height) * JOB_BLOCK_SIDE * JOB_BLOCK_SIDE *
         samples_of_pass();
}

}  // namespace vernier::shader
