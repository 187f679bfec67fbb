#include "render/tile_dispatch.h"

#include <span>

#include "shared/film_layout.h"

namespace vernier {

std::uint32_t blocks_of(int pixels) {
  constexpr int kBlock = JOB_BLOCK_SIDE;
  return static_cast<std::uint32_t>((pixels + kBlock - 1) / kBlock);
}

DispatchConstants tile_constants(const GpuScene& scene, const PixelRect& tile, const PixelRect& area,
                                 const Film::Band& band) {
  DispatchConstants constants{};
  constants.tile_x = static_cast<std::uint32_t>(tile.x);
  constants.tile_y = static_cast<std::uint32_t>(tile.y);
  constants.tile_width = static_cast<std::uint32_t>(tile.width);
  constants.tile_height = static_cast<std::uint32_t>(tile.height);
  constants.band_x = static_cast<std::uint32_t>(area.x);
  constants.band_y = static_cast<std::uint32_t>(area.y + band.first_row);
  constants.band_width = static_cast<std::uint32_t>(area.width);
  constants.steering = scene.steering();
  return constants;
}

Dispatch tile_dispatch(const ComputePipeline& pipeline, const BindingSet& bindings, const PixelRect& tile) {
  return {.pipeline = &pipeline,
          .bindings = &bindings,
          .push_constants = {},
          .group_count_x = blocks_of(tile.width),
          .group_count_y = blocks_of(tile.height),
          .group_count_z = 1};
}

Buffer dispatch_buffer(const Device& device) {
  return Buffer(device, sizeof(DispatchConstants), BufferUse::storage);
}

Upload upload_of(const Buffer& buffer, const DispatchConstants& constants) {
  return {&buffer, std::as_bytes(std::span(&constants, 1))};
}

}  // namespace vernier
