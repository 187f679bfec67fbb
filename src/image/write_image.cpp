#include "image/write_image.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <set>

#include "error.h"
#include "image/file_format.h"
#include "image/file_metadata.h"
#include "image/write_exr.h"
#include "image/write_pixels.h"

namespace vernier {
namespace {

void check_layer(const std::string& path, const ImageFile& image, const Layer& layer) {
  const std::string place = path + ": layer '" + layer.name + "': ";
  const std::size_t value_count = std::visit([](const auto& values) { return values.size(); }, layer.values);
  if (layer.channels.empty()) throw Error(ErrorKind::failed, place + "has no channel");
  if (value_count != layer.channels.size() * image.width * image.height)
    throw Error(ErrorKind::failed, place + "has " + std::to_string(value_count) + " values, not width x height x " +
                                       std::to_string(layer.channels.size()));
}

void check_image(const std::string& path, const ImageFile& image) {
  if (image.width < 1 || image.height < 1 || image.full_width < 1 || image.full_height < 1)
    throw Error(ErrorKind::failed, path + ": the image has no pixels");
  if (image.layers.empty()) throw Error(ErrorKind::failed, path + ": the image has no layers");
  std::set<std::string> names;
  for (const Layer& layer : image.layers) {
    check_layer(path, image, layer);
    for (const std::string& channel : layer.channels)
      if (!names.insert(layer.name + "." + channel).second)
        throw Error(ErrorKind::failed, path + ": channel " + layer.name + "." + channel + " is there twice");
  }
}

OIIO::ImageSpec single_layer_spec(const ImageFile& image, FileFormat format, int channel_count, OIIO::TypeDesc type) {
  OIIO::ImageSpec spec(image.width, image.height, channel_count, type);
  spec.attribute("Software", "Vernier");
  const std::string text = text_of_metadata(image.metadata);
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
        OIIO::ImageSpec spec = single_layer_spec(image, FileFormat::tiff, static_cast<int>(channel_count),
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
  const OIIO::ImageSpec spec = single_layer_spec(image, FileFormat::hdr, 3, OIIO::TypeDesc::FLOAT);
  write_pixels(path, FileFormat::hdr, spec, [&](int begin, int end, std::byte* bytes) {
    std::memcpy(bytes, picture.values.data() + begin * row_size, (end - begin) * row_size * sizeof(float));
  });
}

void write_8_bit(const std::string& path, FileFormat format, const ImageFile& image, const Layer& layer,
                 const DisplayTransform& display) {
  const Image picture = display_picture(layer, image.width, image.height, display);
  const std::size_t row_size = static_cast<std::size_t>(image.width) * 3;
  OIIO::ImageSpec spec = single_layer_spec(image, format, 3, OIIO::TypeDesc::UINT8);
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

std::string layer_path(const std::string& path, const std::string& layer_name) {
  if (layer_name.empty()) return path;
  const std::filesystem::path file(path);
  return (file.parent_path() / (file.stem().string() + "." + layer_name + file.extension().string())).string();
}

void write_image(const std::string& path, const ImageFile& image, const DisplayTransform& display) {
  const FileFormat format = file_format(path, ErrorKind::usage);
  check_image(path, image);
  // Beyond, 2^EV times a value leaves the range of numbers.
  if (!(std::fabs(display.exposure_ev) <= 100.0f))
    throw Error(ErrorKind::usage, path + ": the exposure must be within +-100 EV");
  if (format == FileFormat::exr) return write_exr(path, image);
  for (const Layer& layer : image.layers) {
    if (layer.name.find('/') != std::string::npos)
      throw Error(ErrorKind::failed, path + ": layer '" + layer.name + "': the name cannot be part of a file name");
    const std::string file = layer_path(path, layer.name);
    if (format == FileFormat::tiff)
      write_tiff(file, image, layer);
    else if (format == FileFormat::hdr)
      write_hdr(file, image, layer);
    else
      write_8_bit(file, format, image, layer, display);
  }
}

}  // namespace vernier
