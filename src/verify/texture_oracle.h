#pragma once

#include <cstdint>

namespace vernier {

/// The coordinate `x`, finite, within one period in exact arithmetic: [0, 1] by a wrap mode TEXTURE_WRAP_*
/// (shaders/README.md, Image formation 3).
long double wrapped_place(long double x, std::uint32_t wrap);

/// Texel of `size` that a place in [0, 1] lies in; 1 belongs to the last.
long texel_of(long double place, long size);

/// A row of texels 0, 1, 2 ... of which texel i has the value i, read with a linear filter.
struct LinearRead {
  long double value;
  long double slope;  ///< by how much the value changes per texel there, at most
};

/// At coordinate `x`, finite, of a row of `size` texels.
LinearRead exact_linear(long double x, long size, std::uint32_t wrap);

}  // namespace vernier
