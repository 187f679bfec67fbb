#include "image/write_image.h"

#include <cmath>
#include <filesystem>
#include <set>

#include "error.h"
#include "image/codec_module.h"
#include "image/image_codecs.h"

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
  if (format == FileFormat::exr) return codec<decltype(write_exr_file)>("write_exr_file")(path, image);
  for (const Layer& layer : image.layers) {
    if (layer.name.find('/') != std::string::npos)
      throw Error(ErrorKind::failed, path + ": layer '" + layer.name + "': the name cannot be part of a file name");
    const auto& write_layer = codec<decltype(write_layer_file)>("write_layer_file");
    write_layer(layer_path(path, layer.name), format, image, layer, display);
  }
}

}  // namespace vernier
