#pragma once

#include <cstdint>

namespace vernier {

/// Widest and highest image, pixels.
inline constexpr int kMaxSide_px = 65536;
/// Most pixels one render holds at once: 2^28 of 16 bytes are 4 GiB on the host.
inline constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;
/// Most samples of a pixel: the film's sums hold so many of the largest (shaders/shared/film_layout.h).
inline constexpr std::uint32_t kMaxSpp = 1u << 20;
/// Most samples of a pixel with an error target, unless the user says how many.
inline constexpr std::uint32_t kErrorTargetSpp = 65536;
/// Most bounces: lossless mirrors go on for ever, so this bounds the work of cutoff 0.
inline constexpr std::uint32_t kMaxBounces = 1000;

}  // namespace vernier
