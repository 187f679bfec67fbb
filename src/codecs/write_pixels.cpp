#include "codecs/write_pixels.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "codecs/checked_file.h"
#include "codecs/codec_name.h"
#include "error.h"
#include "image/whole_file.h"

namespace vernier {
namespace {

// Rows handed over at once: a multiple of the rows that EXR compresses together (16 for zip).
constexpr int kRowsPerBlock = 64;

[[noreturn]] void fail(const std::string& path, std::string reason) {
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  throw Error(ErrorKind::failed, path + ": cannot write: " + (reason.empty() ? "unknown reason" : reason));
}

}  // namespace

void write_pixels(const std::string& path, FileFormat format, OIIO::ImageSpec spec, const FillRows& fill) {
  // EXR and TIFF get the time of writing unless there is such an attribute.
  spec.attribute("DateTime", "");
  write_whole(path, [&](const std::string& file) {
    CheckedFile checked(file);  // outlives the codec, whose destructor may still write
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(codec_name(format));
    if (!output) fail(path, OIIO::geterror());
    output->set_ioproxy(&checked);
    if (!output->open(file, spec)) fail(path, output->geterror());
    const auto pixel_bytes = static_cast<OIIO::stride_t>(spec.pixel_bytes(true));
    const auto row_bytes = static_cast<OIIO::stride_t>(spec.scanline_bytes(true));
    std::vector<std::byte> bytes(row_bytes * std::min(kRowsPerBlock, spec.height));
    for (int row = 0; row < spec.height; row += kRowsPerBlock) {
      const int row_end = std::min(row + kRowsPerBlock, spec.height);
      fill(row, row_end, bytes.data());
      // The distances are said, since the PNG writer of OpenImageIO 2.5 takes those of an unknown type for zero.
      if (!output->write_scanlines(spec.y + row, spec.y + row_end, 0, OIIO::TypeUnknown, bytes.data(), pixel_bytes,
                                   row_bytes))
        fail(path, output->geterror());
    }
    if (!output->close()) fail(path, output->geterror());
    if (!checked.finish().empty()) fail(path, checked.finish());
  });
}

}  // namespace vernier
