#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace vernier {

/// A case at a level that misses its target as yet, with what is known of it. A listed case that meets its target is a
/// fault too, so that the list cannot outlive what it lists.
struct KnownFailure {
  std::string_view name;
  std::string_view reason;
};

inline constexpr std::array<KnownFailure, 0> kKnownFailures = {};

/// The same on SwiftShader alone.
inline constexpr std::array<KnownFailure, 0> kKnownSwiftShaderFailures = {};

/// Whether `name` is listed for the driver that the test runs on.
inline bool is_known_failure(std::string_view name, bool is_swiftshader) {
  const auto has_name = [&](const KnownFailure& one) { return one.name == name; };
  return std::ranges::any_of(kKnownFailures, has_name) ||
         (is_swiftshader && std::ranges::any_of(kKnownSwiftShaderFailures, has_name));
}

}  // namespace vernier
