#pragma once

#include "gpu/submission.h"
#include "render/film.h"
#include "render/gpu_scene.h"
#include "render/render_settings.h"
#include "shared/render_constants.h"

namespace vernier {

/// Pixels of a tile's side: on a CPU its samples stay in the caches; of a GPU's many invocations each gets several
/// paths, so that none waits long for the longest.
constexpr int tile_side(bool is_cpu) {
  return is_cpu ? 256 : 1024;
}

/// Blocks of JOB_BLOCK_SIDE that `pixels` in a row fill; incomplete ones count as whole.
std::uint32_t blocks_of(int pixels);

/// What a dispatch on `tile` of the film `area`, in its `band`, has to be told; samples and budgets are 0.
DispatchConstants tile_constants(const GpuScene& scene, const PixelRect& tile, const PixelRect& area,
                                 const Film::Band& band);

/// One invocation per pixel of `tile`. `pipeline` and `bindings` outlive the dispatch.
Dispatch tile_dispatch(const ComputePipeline& pipeline, const BindingSet& bindings, const PixelRect& tile);

/// A buffer for what changes from dispatch to dispatch (render_constants.h says why not push constants).
Buffer dispatch_buffer(const Device& device);

/// Puts `constants`, which stay where they are until then, into `buffer`, which dispatch_buffer made.
Upload upload_of(const Buffer& buffer, const DispatchConstants& constants);

}  // namespace vernier
