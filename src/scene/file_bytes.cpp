#include "scene/file_bytes.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>

#include "error.h"
#include "math/host_memory.h"

namespace vernier {
namespace {

// Beyond this the vertex counts would not fit the 31 bits of the parser.
constexpr std::uint64_t kLargestText = std::uint64_t{1} << 34;
constexpr std::uint64_t kStartBytes = 512;

/// The file at `path`, opened at its end: where that is, is its size.
std::ifstream open_at_end(const std::string& path, const std::string& place) {
  std::error_code failure;
  // Opening a pipe would wait for its writer, a directory has no size: both are refused unopened.
  const auto status = std::filesystem::status(path, failure);
  if (status.type() == std::filesystem::file_type::not_found) refuse(place, "the file does not exist");
  if (failure) refuse(place, failure.message());
  if (!std::filesystem::is_regular_file(status)) refuse(place, "not a regular file");
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) refuse(place, "the file cannot be opened");
  return file;
}

void check_size(const std::string& place, std::uint64_t size, std::uint64_t max_bytes) {
  if (size > max_bytes) {
    refuse(place, "the file has " + std::to_string(size) + " bytes, more than " + std::to_string(max_bytes));
  }
  const std::uint64_t there = host_memory_there().value_or(std::numeric_limits<std::uint64_t>::max());
  if (size > there) {
    throw MemoryError(place + ": it needs " + needed_memory_text(size) + " of the host's memory, " +
                      memory_there_text(there) + " are there");
  }
}

/// As `Bytes`, a vector or string of bytes.
template <class Bytes>
Bytes read_whole(const std::string& path, const std::string& place, std::uint64_t max_bytes,
                 const StartCheck& check_start) {
  std::ifstream file = open_at_end(path, place);
  const std::streamoff size = file.tellg();
  if (size < 0) refuse(place, "the file cannot be read");
  check_size(place, static_cast<std::uint64_t>(size), max_bytes);
  const auto read = [&](auto& bytes) {
    file.seekg(0);
    if (!file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
      refuse(place, "the file cannot be read");
  };
  if (check_start) {
    std::string start(static_cast<std::size_t>(std::min<std::uint64_t>(size, kStartBytes)), '\0');
    read(start);
    check_start(start);
  }
  Bytes bytes(static_cast<std::size_t>(size), typename Bytes::value_type{});
  read(bytes);
  return bytes;
}

}  // namespace

std::vector<std::byte> read_file_bytes(const std::string& path, const std::string& place, std::uint64_t max_bytes,
                                       const StartCheck& check_start) {
  return read_whole<std::vector<std::byte>>(path, place, max_bytes, check_start);
}

std::string read_text(const std::string& path) {
  return read_whole<std::string>(path, path, kLargestText, [&](std::string_view start) {
    const std::size_t zero = start.find('\0');
    if (zero != std::string_view::npos) refuse(path, "not a text file: byte " + std::to_string(zero) + " is 0");
  });
}

}  // namespace vernier
