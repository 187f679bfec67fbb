#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>

#include "codecs/codec_name.h"
#include "codecs/file_layers.h"
#include "codecs/jpeg_fault.h"
#include "codecs/pixel_rows.h"
#include "error.h"
#include "image/essential_png.h"
#include "image/file_metadata.h"
#include "image/image_codecs.h"
#include "image/read_image.h"

namespace vernier {
namespace {

/// `reason` is the library's, of any number of lines.
[[noreturn]] void refuse_as_told(const std::string& path, std::string reason) {
  std::ranges::replace(reason, '\n', ' ');
  refuse(path, reason.empty() ? "cannot be read as this image format" : reason);
}

bool known_type(OIIO::TypeDesc type) {
  switch (type.basetype) {
    case OIIO::TypeDesc::FLOAT:
    case OIIO::TypeDesc::DOUBLE:
    case OIIO::TypeDesc::HALF:
    case OIIO::TypeDesc::UINT8:
    case OIIO::TypeDesc::UINT16:
    case OIIO::TypeDesc::UINT32:
      return type.aggregate == OIIO::TypeDesc::SCALAR && type.arraylen == 0;
    default:
      return false;
  }
}

void check_spec(const std::string& path, const OIIO::ImageSpec& spec) {
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) refuse(path, "the image has no pixels");
  if (spec.deep || spec.depth > 1) refuse(path, "deep and volumetric images are not supported");
  const std::int64_t row_values = std::int64_t{spec.width} * spec.nchannels;
  if (row_values > kMostImageValues / spec.height)
    refuse(path, std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels of " +
                     std::to_string(spec.nchannels) + " channels are more than 2^31 values");
  if (spec.full_width < 1 || spec.full_height < 1) refuse(path, "the full image has no pixels");
  for (int channel = 0; channel < spec.nchannels; ++channel)
    if (!known_type(spec.channelformat(channel)))
      refuse(path, std::string("channels of type ") + spec.channelformat(channel).c_str() + " are not supported");
}

/// What is left of the PNG file `path` when damage has been looked for: libpng would print a line of its own about it.
/// Empty where the file does not begin as one does, of which OpenImageIO tells.
std::vector<std::byte> checked_png(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string start(kPngSignature.size(), '\0');
  if (!file.read(start.data(), static_cast<std::streamsize>(start.size())) || start != kPngSignature) return {};
  const std::streamoff size = file.seekg(0, std::ios::end).tellg();
  if (size < 0) refuse(path, "the file cannot be read");
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  file.seekg(0);
  if (!file.read(reinterpret_cast<char*>(bytes.data()), size)) refuse(path, "the file cannot be read");
  return essential_png(bytes, path, kMostImageValues, PngText::kept);
}

/// An image that is being read, and the memory it is read from where it is no file.
struct OpenImage {
  std::vector<std::byte> bytes;
  std::unique_ptr<OIIO::Filesystem::IOMemReader> memory;
  std::unique_ptr<OIIO::ImageInput> input;
};

OpenImage open_image(const std::string& path, FileFormat format) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) refuse(path, error ? error.message() : "there is no such file");
  if (std::filesystem::is_directory(status)) refuse(path, "it is a folder");
  if (!std::filesystem::is_regular_file(status)) refuse(path, "not a regular file");  // a pipe would be waited for
  OpenImage image;
  if (format == FileFormat::png) image.bytes = checked_png(path);
  image.input = OIIO::ImageInput::create(codec_name(format));
  const std::unique_ptr<OIIO::ImageInput>& input = image.input;
  if (!input) refuse_as_told(path, OIIO::geterror());
  OIIO::ImageSpec spec;
  OIIO::ImageSpec as_stored;
  as_stored.attribute("oiio:UnassociatedAlpha", 1);
  if (!image.bytes.empty()) {
    image.memory = std::make_unique<OIIO::Filesystem::IOMemReader>(image.bytes.data(), image.bytes.size());
    input->set_ioproxy(image.memory.get());
  }
  if (!input->open(path, spec, as_stored)) refuse_as_told(path, input->geterror());
  check_spec(path, spec);
  if (const std::string fault = input->geterror(); is_cut_jpeg(fault)) refuse_as_told(path, fault);
  if (input->seek_subimage(1, 0)) refuse(path, "files of several parts or pages are not supported");
  input->geterror();  // the missing second part is no failure
  if (!input->seek_subimage(0, 0)) refuse_as_told(path, input->geterror());
  return image;
}

// Attributes that describe how the file is stored or that the writer adds by itself are not what its author said.
bool is_storage_attribute(const std::string& name) {
  return name == "compression" || name.starts_with("oiio:") || name.starts_with("openexr:");
}

std::map<std::string, std::string> metadata_of(const OIIO::ImageSpec& spec, FileFormat format) {
  if (format != FileFormat::exr) return metadata_of_text(spec.get_string_attribute("ImageDescription"));
  std::map<std::string, std::string> metadata;
  for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
    const std::string name = attribute.name().string();
    if (attribute.type() != OIIO::TypeString || is_storage_attribute(name)) continue;
    const std::string value = attribute.get_string();
    if (name != "DateTime" || !value.empty()) metadata[name] = value;
  }
  return metadata;
}

ImageFile image_of_spec(const OIIO::ImageSpec& spec, FileFormat format) {
  ImageFile image;
  image.width = spec.width;
  image.height = spec.height;
  if (format == FileFormat::exr) {
    // Positions are relative to the full image, which other programs may let start anywhere.
    image.x = spec.x - spec.full_x;
    image.y = spec.y - spec.full_y;
  }
  image.full_width = format == FileFormat::exr ? spec.full_width : spec.width;
  image.full_height = format == FileFormat::exr ? spec.full_height : spec.height;
  image.metadata = metadata_of(spec, format);
  return image;
}

}  // namespace

void read_image_file(const std::string& path, FileFormat format, ImageFile& image) {
  try {
    const OpenImage opened = open_image(path, format);
    const OIIO::ImageSpec spec = opened.input->spec();
    image = image_of_spec(spec, format);
    const std::vector<LayerSource> sources = format == FileFormat::exr ? named_layers(spec) : unnamed_layer(spec);
    image.layers = empty_layers(sources, static_cast<std::size_t>(spec.width) * spec.height);
    read_rows(path, *opened.input, [&](const std::byte* bytes, int row_count) {
      append_pixels(image.layers, sources, spec, bytes, static_cast<std::size_t>(row_count) * spec.width);
    });
  } catch (const std::bad_alloc&) {
    refuse(path, "not enough memory for its pixels");
  } catch (const std::length_error&) {
    refuse(path, "not enough memory for its pixels");
  }
}

}  // namespace vernier
