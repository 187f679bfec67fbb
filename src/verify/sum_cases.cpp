#include "verify/sum_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/film_layout.h"
#include "verify/function_kernel.h"
#include "verify/level_bound.h"
#include "verify/random.h"
#include "verify/tally.h"

namespace vernier {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr std::uint64_t kChain = 1u << 26;
constexpr std::uint64_t kPiece = 50000;  // even, and below llvmpipe's limit of 65535 rounds

/// A sample in the film's steps, to the nearest.
Wide steps_of(float value) {
  return static_cast<Wide>(std::floor(std::ldexp(static_cast<long double>(value), FILM_FRACTION_BITS) + 0.5L));
}

Wide sum_of(const FunctionOperands& o, std::uint64_t count) {
  return steps_of(o[0]) * ((count + 1) / 2) + steps_of(o[1]) * (count / 2);
}

}  // namespace

CaseResult run_many_samples(const CaseSetup& setup) {
  constexpr float kPatterns[][2] = {{1.0f, 1.0f}, {0.1f, 0.1f}, {1e-8f, 1e4f}, {1e-8f, 1e-8f}, {0x1p-44f, 1e6f}};
  std::vector<FunctionOperands> operands;
  std::vector<Wide> ends;
  for (const auto& pattern : kPatterns) {
    for (std::uint64_t done = 0; done < kChain; done += kPiece) {
      FunctionOperands o{pattern[0], pattern[1], static_cast<float>(std::min(kPiece, kChain - done))};
      const Wide start = sum_of(o, done);
      for (std::size_t k = 0; k < 6; ++k)
        o[3 + k] = static_cast<float>(static_cast<std::uint32_t>(start >> (16 * k)) & 0xffffu);
      operands.push_back(o);
      ends.push_back(sum_of(o, std::min(done + kPiece, kChain)));
    }
  }
  const auto answers = call_shader_function(setup, VERIFY_SUM, operands);
  Tally tally("relative", level_bound(setup, 1e-7, 0.0));  // numerics.md 5.3
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const FunctionOperands& o = operands[i];
    Wide got = 0;
    for (std::size_t k = 0; k < 6; ++k) got |= static_cast<Wide>(answers[i][k]) << (16 * k);
    const Wide apart = got > ends[i] ? got - ends[i] : ends[i] - got;
    const bool counted = answers[i][6] == o[2] && answers[i][7] == 0.0f;
    const auto error = static_cast<double>(static_cast<long double>(apart) / static_cast<long double>(ends[i]));
    tally.book_error(counted ? error : 1.0, [&] {
      return hex_floats({{"even", o[0]}, {"odd", o[1]}, {"count", o[2]}});
    });
  }
  return tally.result();
}

}  // namespace vernier
