#pragma once

#include <string_view>

namespace vernier {

/// Whether what OpenImageIO's JPEG reader said is that data are missing: libjpeg fills up with grey and goes on.
inline bool is_cut_jpeg(std::string_view fault) {
  return fault.find("remature end") !=
         std::string_view::npos;  // "Premature end of JPEG file", "Corrupt ...: premature"
}

}  // namespace vernier
