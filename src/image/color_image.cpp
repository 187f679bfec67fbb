#include "image/color_image.h"

#include <algorithm>
#include <array>

#include "error.h"

namespace vernier {
namespace {

constexpr int kMissing = -1;

int index_of(const Layer& layer, const char* channel) {
  const auto found = std::find(layer.channels.begin(), layer.channels.end(), channel);
  return found == layer.channels.end() ? kMissing : static_cast<int>(found - layer.channels.begin());
}

std::array<int, 4> color_channels(const Layer& layer) {
  const int alpha = index_of(layer, "A");
  const int luminance = index_of(layer, "Y");
  std::array<int, 4> channels = {index_of(layer, "R"), index_of(layer, "G"), index_of(layer, "B"), alpha};
  const bool has_rgb = channels[0] != kMissing && channels[1] != kMissing && channels[2] != kMissing;
  return has_rgb ? channels : std::array<int, 4>{luminance, luminance, luminance, alpha};
}

}  // namespace

Image color_image(const ImageFile& file, const std::string& path) {
  const Layer* layer = find_layer(file, "");
  if (layer == nullptr) throw Error(ErrorKind::refused, path + ": has no colour layer (channels R G B)");
  const auto* values = std::get_if<std::vector<float>>(&layer->values);
  const std::array<int, 4> channels = color_channels(*layer);
  if (!values || channels[0] == kMissing)
    throw Error(ErrorKind::refused, path + ": its channels are neither R G B nor Y of real numbers");
  Image image{file.width, file.height, 4, {}};
  const std::size_t pixel_count = static_cast<std::size_t>(file.width) * file.height;
  image.values.reserve(pixel_count * 4);
  for (std::size_t pixel = 0; pixel < pixel_count; ++pixel)
    for (const int channel : channels)
      image.values.push_back(channel == kMissing ? 1.0f : (*values)[pixel * layer->channels.size() + channel]);
  return image;
}

ImageFile file_of_image(const Image& image) {
  Layer layer{"", {}, image.values};
  if (image.channel_count == 1)
    layer.channels = {"Y"};
  else if (image.channel_count == 3)
    layer.channels = {"R", "G", "B"};
  else if (image.channel_count == 4)
    layer.channels = {"R", "G", "B", "A"};
  else
    throw Error(ErrorKind::failed, "an image of " + std::to_string(image.channel_count) + " channels is no colour");
  ImageFile file;
  file.width = file.full_width = image.width;
  file.height = file.full_height = image.height;
  file.layers.push_back(std::move(layer));
  return file;
}

}  // namespace vernier
