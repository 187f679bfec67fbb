#include "image/read_image.h"

#include "image/codec_module.h"
#include "image/image_codecs.h"

namespace vernier {

ImageFile read_image(const std::string& path) {
  ImageFile image;
  codec<decltype(read_image_file)>("read_image_file")(path, file_format(path, ErrorKind::refused), image);
  return image;
}

}  // namespace vernier
