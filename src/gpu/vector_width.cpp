#include "gpu/vector_width.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace vernier {
namespace {

constexpr const char* kVariable = "LP_NATIVE_VECTOR_WIDTH";

constexpr const char* kCacheVariable = "MESA_SHADER_CACHE_DIR";
constexpr const char* kOwnFolder = "vernier";
constexpr const char* kOwnPrefix = "mesa-";

constexpr long kWide = 512;
// Mesa 22.3.6 crashes at the first triangle with more.
constexpr long kNarrow = 256;

/// The width that the environment asks for; 0 for none.
long width_asked_for() {
  const char* value = std::getenv(kVariable);
  return value != nullptr ? std::strtol(value, nullptr, 0) : 0;
}

/// The folder that the driver would make its cache in. None where it would look up the user's home, or where it is no
/// absolute one.
std::filesystem::path cache_folder() {
  for (const char* name : {kCacheVariable, "XDG_CACHE_HOME", "HOME"}) {
    const char* value = std::getenv(name);
    std::filesystem::path folder = value != nullptr ? value : "";
    if (!folder.is_absolute()) continue;
    // As set_width left it for a process that this one has started.
    if (folder.parent_path().filename() == kOwnFolder && folder.filename().string().starts_with(kOwnPrefix)) {
      return folder.parent_path().parent_path();
    }
    return std::string_view(name) == "HOME" ? folder / ".cache" : folder;
  }
  return {};
}

/// Sets the width and a cache for it: code of another one, taken from the cache, leaves every second row of a picture
/// black (Mesa 25.0.7).
void set_width(long bits) {
  setenv(kVariable, std::to_string(bits).c_str(), 1);
  const std::filesystem::path folder = cache_folder();
  if (folder.empty()) {
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    return;
  }
  const std::filesystem::path own = folder / kOwnFolder / (kOwnPrefix + std::to_string(bits) + "-bits");
  std::error_code failure;  // without it the driver does without a cache
  std::filesystem::create_directories(own, failure);
  setenv(kCacheVariable, own.c_str(), 1);
}

}  // namespace

bool has_wide_vectors() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx512vl") != 0;
#else
  return false;
#endif
}

void choose_vector_width() {
  if (const long bits = width_asked_for(); bits > 0) return set_width(bits);
  if (has_wide_vectors()) set_width(kWide);
}

void keep_vectors_narrow() {
  if (const long bits = width_asked_for(); bits > 0) set_width(std::min(bits, kNarrow));
}

std::string without_vector_width(const std::string& name) {
  const std::size_t comma = name.rfind(", ");
  return comma != std::string::npos && name.ends_with(" bits)") ? name.substr(0, comma) + ")" : name;
}

}  // namespace vernier
