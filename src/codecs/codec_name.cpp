#include "codecs/codec_name.h"

namespace vernier {

const char* codec_name(FileFormat format) {
  switch (format) {
    case FileFormat::exr:
      return "openexr";
    case FileFormat::png:
      return "png";
    case FileFormat::jpeg:
      return "jpeg";
    case FileFormat::hdr:
      return "hdr";
    case FileFormat::tiff:
      return "tiff";
  }
  return "";
}

}  // namespace vernier
