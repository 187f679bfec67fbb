#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <string>
#include <vector>

#include "image/image.h"

namespace vernier {

/// Where one channel of a layer comes from in a file.
struct ChannelSource {
  std::string name;      ///< without the layer's name
  int file_channel = 0;  ///< index in the file's order
  bool on_srgb_curve = false;
};

/// How a layer is put together from a file's channels.
struct LayerSource {
  std::string name;
  std::vector<ChannelSource> channels;
  bool counts = false;  ///< uint32, otherwise float32
};

/// Layers of a file that names its channels `layer.channel` (EXR), in the order that read_image promises.
std::vector<LayerSource> named_layers(const OIIO::ImageSpec& spec);

/// The one layer of a file whose channels have no layer names, as read_image promises.
std::vector<LayerSource> unnamed_layer(const OIIO::ImageSpec& spec);

/// The layers of `sources` without pixels, with memory reserved (not filled) for `pixel_count`.
std::vector<Layer> empty_layers(const std::vector<LayerSource>& sources, std::size_t pixel_count);

/// Appends `pixel_count` pixels in the file's own layout at `bytes` to `layers`, which belong to `sources`.
void append_pixels(std::vector<Layer>& layers, const std::vector<LayerSource>& sources, const OIIO::ImageSpec& spec,
                   const std::byte* bytes, std::size_t pixel_count);

}  // namespace vernier
