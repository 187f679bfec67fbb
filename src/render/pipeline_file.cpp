#include "render/pipeline_file.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include "error.h"
#include "image/whole_file.h"
#include "render/checksum.h"

namespace vernier {
namespace {

namespace fs = std::filesystem;

/// Begins every file; the last character counts the layouts.
constexpr std::string_view kMagic = "vernier-pipes-1\n";

/// What stands before the driver's bytes. Drivers check what their own header says, but not all notice damage behind
/// it. Who can write here can change the program too: a checksum will do.
struct FileHeader {
  std::array<char, 16> magic;
  std::array<char, 64> pipeline_key;  // 0 behind its end
  std::uint64_t payload_bytes;
  std::uint64_t payload_hash;
};
static_assert(sizeof(FileHeader) == 96 && kMagic.size() == 16);

FileHeader header_of(const std::string& pipeline_key, std::span<const std::byte> bytes) {
  FileHeader header{};
  std::memcpy(header.magic.data(), kMagic.data(), kMagic.size());
  std::memcpy(header.pipeline_key.data(), pipeline_key.data(),
              std::min(pipeline_key.size(), header.pipeline_key.size()));
  header.payload_bytes = bytes.size();
  header.payload_hash = checksum(bytes);
  return header;
}

std::optional<std::string> absolute_path(const char* variable) {
  const char* value = std::getenv(variable);
  if (value == nullptr || !fs::path(value).is_absolute()) return std::nullopt;
  return value;
}

/// Puts what is behind the file's header into `bytes`, or tells why there is nothing.
std::string read_checked(const std::string& file, const std::string& pipeline_key, std::uint64_t most_bytes,
                         std::vector<std::byte>& bytes) {
  std::error_code failure;
  if (!fs::is_regular_file(file, failure)) return "is not there yet";
  const std::uintmax_t size = fs::file_size(file, failure);
  if (failure) return "cannot be read: " + failure.message();
  if (size > most_bytes + sizeof(FileHeader)) return "is larger than " + std::to_string(most_bytes) + " bytes";
  FileHeader header{};
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return "cannot be read";
  if (!stream.read(reinterpret_cast<char*>(&header), sizeof header)) return "is cut short";
  const FileHeader own = header_of(pipeline_key, {});
  if (header.magic != own.magic) return "is no file of this version";
  if (header.pipeline_key != own.pipeline_key) return "belongs to another device or driver";
  if (header.payload_bytes != size - sizeof header) return "is cut short";
  std::vector<std::byte> payload(header.payload_bytes);
  if (!stream.read(reinterpret_cast<char*>(payload.data()), static_cast<std::streamsize>(payload.size()))) {
    return "is cut short";
  }
  if (checksum(payload) != header.payload_hash) return "is damaged";
  bytes = std::move(payload);
  return "";
}

void write_file(const std::string& file, const FileHeader& header, std::span<const std::byte> bytes) {
  std::error_code failure;
  fs::create_directories(fs::path(file).parent_path(), failure);  // a failure shows again below
  std::string text(sizeof header + bytes.size(), '\0');
  std::memcpy(text.data(), &header, sizeof header);
  if (!bytes.empty()) std::memcpy(text.data() + sizeof header, bytes.data(), bytes.size());
  write_text(file, text);
}

}  // namespace

std::string cache_file(const std::string& name) {
  const char* own = std::getenv("VERNIER_PIPELINE_CACHE");
  if (own != nullptr && std::string_view(own) == "none") return "";
  if (const auto folder = absolute_path("VERNIER_PIPELINE_CACHE")) return fs::path(*folder) / name;
  if (const auto folder = absolute_path("XDG_CACHE_HOME")) return fs::path(*folder) / "vernier" / name;
  if (const auto folder = absolute_path("HOME")) return fs::path(*folder) / ".cache" / "vernier" / name;
  return "";
}

std::string pipeline_file(const std::string& pipeline_key) {
  return cache_file(pipeline_key + ".pipelines");
}

StoredPipelines read_pipelines(const std::string& file, const std::string& pipeline_key, std::uint64_t most_bytes) {
  if (file.empty()) return {{}, "no file of compiled pipelines"};
  StoredPipelines stored;
  const std::string fault = read_checked(file, pipeline_key, most_bytes, stored.bytes);
  stored.note = file + (fault.empty() ? ": " + std::to_string(stored.bytes.size()) + " bytes read" : " " + fault);
  return stored;
}

std::string write_pipelines(const std::string& file, const std::string& pipeline_key, std::span<const std::byte> bytes,
                            std::uint64_t most_bytes) {
  if (file.empty()) return "";
  if (bytes.size() > most_bytes) {
    std::error_code ignored;
    fs::remove(file, ignored);
    return "removed, since more than " + std::to_string(most_bytes) + " bytes came together";
  }
  try {
    write_file(file, header_of(pipeline_key, bytes), bytes);
  } catch (const Error& error) {
    return std::string("not written: ") + error.what();
  }
  return std::to_string(bytes.size()) + " bytes written";
}

CachedDevice::CachedDevice(const VulkanInstance& instance, const DeviceDescription& description, std::string file,
                           const std::vector<const char*>& extensions)
    : file_(std::move(file)),
      stored_(read_pipelines(file_, description.pipeline_key)),
      device_(instance, description, stored_.bytes, extensions) {}

std::string CachedDevice::store() const {
  if (file_.empty()) return stored_.note;
  try {
    const std::vector<std::byte> bytes = device_.compiled_pipelines();
    if (bytes == stored_.bytes) return stored_.note + ", nothing new";
    return stored_.note + ", " + write_pipelines(file_, device_.description().pipeline_key, bytes);
  } catch (const Error& error) {
    return stored_.note + ", " + error.what();
  }
}

}  // namespace vernier
