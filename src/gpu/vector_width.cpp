#include "gpu/vector_width.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <limits>

namespace vernier {
namespace {

constexpr const char* kVariable = "LP_NATIVE_VECTOR_WIDTH";

constexpr const char* kCacheVariable = "MESA_SHADER_CACHE_DIR";
constexpr const char* kOwnFolder = "vernier";
constexpr const char* kOwnPrefix = "mesa-";

constexpr long kWide = 512;
// Mesa 22.3.6 crashes at the first triangle with more.
constexpr long kNarrow = 256;

// Between the 1.5 where wide vectors pay or cost nothing, and the 2 where they cost.
constexpr double kStillFast = 1.75;

#if defined(__x86_64__)

constexpr long kRounds = 2000;
constexpr int kRuns = 12;

// In assembly, so that a build without optimisation measures the same. Eight sums that do not wait for each other: more
// than any processor works on at a time.
#define ADD(vector) "vpaddd %%" vector ", %%" vector ", %%" vector "\n\t"
#define ADD_TO_EIGHT(vectors)                                                                             \
  asm volatile("1: " ADD(vectors "0") ADD(vectors "1") ADD(vectors "2") ADD(vectors "3") ADD(vectors "4") \
                   ADD(vectors "5") ADD(vectors "6") ADD(vectors "7") "dec %0\n\tjnz 1b\n\tvzeroupper"    \
               : "+r"(rounds)                                                                             \
               :                                                                                          \
               : "cc", "xmm0", "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7")

void add_256(long rounds) {
  ADD_TO_EIGHT("ymm");
}
void add_512(long rounds) {
  ADD_TO_EIGHT("zmm");
}

#undef ADD_TO_EIGHT
#undef ADD

double time_of(void (*add)(long)) {
  const auto start = std::chrono::steady_clock::now();
  add(kRounds);
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

#endif

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

std::optional<AdditionTimes> time_additions() {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512vl")) return std::nullopt;
  constexpr double kNever = std::numeric_limits<double>::infinity();
  AdditionTimes least{kNever, kNever};
  for (int run = 0; run < kRuns; ++run) {
    least.bits_256 = std::min(least.bits_256, time_of(add_256));
    least.bits_512 = std::min(least.bits_512, time_of(add_512));
  }
  return least;
#else
  return std::nullopt;
#endif
}

bool are_wide_vectors_fast(const AdditionTimes& times) {
  return times.bits_512 < kStillFast * times.bits_256;
}

void choose_vector_width() {
  if (const long bits = width_asked_for(); bits > 0) return set_width(bits);
  const std::optional<AdditionTimes> times = time_additions();
  if (times && are_wide_vectors_fast(*times)) set_width(kWide);
}

void keep_vectors_narrow() {
  if (const long bits = width_asked_for(); bits > 0) set_width(std::min(bits, kNarrow));
}

std::string without_vector_width(const std::string& name) {
  const std::size_t comma = name.rfind(", ");
  return comma != std::string::npos && name.ends_with(" bits)") ? name.substr(0, comma) + ")" : name;
}

}  // namespace vernier
