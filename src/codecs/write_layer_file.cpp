#include <algorithm>
#include <cmath>
#include <cstring>

#include "codecs/write_pixels.h"
#include "error.h"
#include "image/file_metadata.h"
#include "image/image_codecs.h"

namespace vernier {
namespace {

OIIO::ImageSpec single_layer_spec(const ImageFile& image, const Layer& layer, FileFormat format, int channel_count,
                                  OIIO::TypeDesc type) {
  OIIO::ImageSpec spec(image.width, image.height, channel_count, type);
  spec.attribute("Software", "Vernier");
  std::map<std::string, std::string> metadata = image.metadata;
  if (!layer.name.empty()) metadata["vernier:layer"] = layer.name;
  const std::string text = text_of_metadata(metadata);
  // A JPEG segment ends at 65533 bytes, and the writer stores the text in two of them with headers.
  constexpr std::size_t kMostJpegText = 60000;
  if (!text.empty() && (format != FileFormat::jpeg || text.size() <= kMostJpegText))
    spec.attribute("ImageDescription", text);
  return spec;
}

void write_tiff(const std::string& path, const ImageFile& image, const Layer& layer) {
  const std::size_t channel_count = layer.channels.size();
  std::visit(
      [&](const auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        OIIO::ImageSpec spec = single_layer_spec(image, layer, FileFormat::tiff, static_cast<int>(channel_count),
                                                 OIIO::BaseTypeFromC<Value>::value);
        spec.attribute("compression", "zip");
        spec.alpha_channel = channel_count == 4 && layer.channels[3] == "A" ? 3 : -1;
        const std::size_t row_size = channel_count * image.width;
        write_pixels(path, FileFormat::tiff, spec, [&](int begin, int end, std::byte* bytes) {
          std::memcpy(bytes, values.data() + begin * row_size, (end - begin) * row_size * sizeof(Value));
        });
      },
      layer.values);
}

void write_hdr(const std::string& path, const ImageFile& image, const Layer& layer) {
  const Image picture = unsigned_picture(layer, image.width, image.height);
  const std::size_t row_size = static_cast<std::size_t>(image.width) * 3;
  const OIIO::ImageSpec spec = single_layer_spec(image, layer, FileFormat::hdr, 3, OIIO::TypeDesc::FLOAT);
  write_pixels(path, FileFormat::hdr, spec, [&](int begin, int end, std::byte* bytes) {
    std::memcpy(bytes, picture.values.data() + begin * row_size, (end - begin) * row_size * sizeof(float));
  });
}

void write_8_bit(const std::string& path, FileFormat format, const ImageFile& image, const Layer& layer,
                 const DisplayTransform& display) {
  const Image picture = display_picture(layer, image.width, image.height, display);
  const std::size_t row_size = static_cast<std::size_t>(image.width) * 3;
  // The library would end the process.
  if (format == FileFormat::jpeg && std::max(image.width, image.height) > kMostJpegSide_px)
    throw Error(ErrorKind::failed,
                path + ": cannot write: a side of a JPEG has at most " + std::to_string(kMostJpegSide_px) + " pixels");
  OIIO::ImageSpec spec = single_layer_spec(image, layer, format, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  if (format == FileFormat::jpeg) {
    spec.attribute("compression", "jpeg:95");
    spec.attribute("jpeg:subsampling", "4:4:4");
  }
  write_pixels(path, format, spec, [&](int begin, int end, std::byte* bytes) {
    for (std::size_t i = begin * row_size; i < end * row_size; ++i)
      *bytes++ = static_cast<std::byte>(std::lround(picture.values[i] * 255.0f));
  });
}

}  // namespace

void write_layer_file(const std::string& path, FileFormat format, const ImageFile& image, const Layer& layer,
                      const DisplayTransform& display) {
  if (format == FileFormat::tiff)
    write_tiff(path, image, layer);
  else if (format == FileFormat::hdr)
    write_hdr(path, image, layer);
  else
    write_8_bit(path, format, image, layer, display);
}

}  // namespace vernier
