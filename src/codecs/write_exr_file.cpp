#include <cstring>

#include "codecs/write_pixels.h"
#include "image/image_codecs.h"

namespace vernier {
namespace {

constexpr std::size_t kValueBytes = 4;  // float32 and uint32 alike

const std::byte* bytes_of(const Layer& layer) {
  return std::visit([](const auto& values) { return reinterpret_cast<const std::byte*>(values.data()); }, layer.values);
}

OIIO::ImageSpec exr_spec(const ImageFile& image) {
  OIIO::ImageSpec spec(image.width, image.height, 0, OIIO::TypeDesc::FLOAT);
  spec.x = image.x;
  spec.y = image.y;
  spec.full_width = image.full_width;
  spec.full_height = image.full_height;
  for (const auto& [name, value] : image.metadata) spec.attribute(name, value);
  spec.attribute("compression", "zip");
  for (const Layer& layer : image.layers) {
    const bool real = std::holds_alternative<std::vector<float>>(layer.values);
    for (const std::string& channel : layer.channels) {
      spec.channelnames.push_back(layer.name.empty() ? channel : layer.name + "." + channel);
      spec.channelformats.push_back(real ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT);
    }
  }
  spec.nchannels = static_cast<int>(spec.channelnames.size());
  return spec;
}

}  // namespace

void write_exr_file(const std::string& path, const ImageFile& image) {
  const OIIO::ImageSpec spec = exr_spec(image);
  const std::size_t pixel_bytes = spec.nchannels * kValueBytes;
  write_pixels(path, FileFormat::exr, spec, [&](int row_begin, int row_end, std::byte* bytes) {
    const std::size_t first = static_cast<std::size_t>(row_begin) * image.width;
    const std::size_t last = static_cast<std::size_t>(row_end) * image.width;
    std::size_t offset = 0;
    for (const Layer& layer : image.layers) {
      const std::size_t layer_bytes = layer.channels.size() * kValueBytes;
      for (std::size_t pixel = first; pixel < last; ++pixel)
        std::memcpy(bytes + (pixel - first) * pixel_bytes + offset, bytes_of(layer) + pixel * layer_bytes, layer_bytes);
      offset += layer_bytes;
    }
  });
}

}  // namespace vernier
