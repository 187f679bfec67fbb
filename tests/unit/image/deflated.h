#pragma once

#include <zlib.h>

#include <string>

namespace vernier {

/// `bytes` as a zlib stream.
inline std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string stream(size, '\0');
  compress(reinterpret_cast<Bytef*>(stream.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
           static_cast<uLong>(bytes.size()));
  stream.resize(size);
  return stream;
}

}  // namespace vernier
