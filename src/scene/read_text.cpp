#include "scene/read_text.h"

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "error.h"

namespace vernier {
namespace {
// Beyond this the vertex counts would not fit the 31 bits of the parser.
constexpr std::uintmax_t kLargestText_bytes = std::uintmax_t{1} << 34;
}  // namespace

std::string read_text(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw Error(ErrorKind::refused, path + ": no such file");
  if (!std::filesystem::is_regular_file(path, error)) throw Error(ErrorKind::refused, path + ": not a file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > kLargestText_bytes) throw Error(ErrorKind::refused, path + ": larger than 16 GiB");
  std::ifstream stream(path, std::ios::binary);
  std::string text(size, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(size));
  if (!stream) throw Error(ErrorKind::refused, path + ": cannot be read");
  return text;
}

}  // namespace vernier
