#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"

namespace vernier {

/// The name of film_layer's layer.
inline constexpr const char* kFilmLayer = "film";

/// The words of a film, [height][width][FILM_WORDS], as a layer of uint32: colour sums that are exact, so that parts of
/// the samples can be merged.
Layer film_layer(const std::vector<std::uint32_t>& sums);

/// The words of `layer`, whose channels are film_layer's in any order; empty where they are others.
std::vector<std::uint32_t> sums_of_layer(const Layer& layer);

/// Adds the sums of one pixel to those of the same pixel from other samples, both FILM_WORDS words. They are exact, so
/// any order has the same bits; sums of the fast level, which are floats, are not for adding.
void add_sums(std::span<std::uint32_t> sums, std::span<const std::uint32_t> more);

}  // namespace vernier
