#pragma once

#include <string_view>

namespace vernier {

/// Whether what OpenImageIO's JPEG reader said is that data are missing: libjpeg fills up with grey and goes on.
inline bool is_cut_jpeg(std::string_view fault) {
  // "Premature end of JPEG file", or "Corrupt JPEG data: premature end of data segment".
  return fault.find("remature end") != std::string_view::npos;
}

}  // namespace vernier
