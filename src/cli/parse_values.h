#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>

#include "render/render_settings.h"

namespace vernier {

/// All functions here read the text of one option. They throw Error(usage) with one line
/// `option: `text` is not ...` for anything else than what they describe: no spaces, no signs of a unit, no rest.

/// A finite decimal number, or a fraction `a/b` of two with b other than 0.
double parse_number(const std::string& option, const std::string& text);

/// A number in [`low`, `high`].
double parse_number_in(const std::string& option, const std::string& text, double low, double high);

/// A whole decimal number in [`low`, `high`], digits only.
std::uint32_t parse_count(const std::string& option, const std::string& text, std::uint32_t low, std::uint32_t high);

/// `WxH`, each from 1 to kMaxSide_px.
glm::ivec2 parse_size(const std::string& option, const std::string& text);

/// `X,Y,W,H`: X and Y from 0, W and H from 1, up to kMaxSide_px.
PixelRect parse_rect(const std::string& option, const std::string& text);

/// `x,y,z`: three finite numbers.
glm::dvec3 parse_vec3(const std::string& option, const std::string& text);

/// `r,g,b`: three finite numbers from 0 that fit float32.
glm::vec3 parse_color(const std::string& option, const std::string& text);

/// `--exposure`: stops from -100 to 100, so that no factor of two leaves float32.
float parse_exposure(const std::string& text);

/// Samples [begin, end).
struct SampleRange {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// `A:B` with A < B <= `spp`.
SampleRange parse_sample_range(const std::string& option, const std::string& text, std::uint32_t spp);

}  // namespace vernier
