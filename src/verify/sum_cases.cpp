#include "verify/sum_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "shared/film_layout.h"
#include "verify/function_suite.h"
#include "verify/level_bound.h"

namespace vernier {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr std::uint64_t kChain = 1u << 26;
constexpr std::uint64_t kPiece = 50000;  // even, and below llvmpipe's limit of 65535 rounds
constexpr std::size_t kDigits = 6;       // of 16 bits each
constexpr std::size_t kStart = 3;        // operand of the first digit

/// A sample in the film's steps, to the nearest.
Wide steps_of(float value) {
  return static_cast<Wide>(std::floor(std::ldexp(static_cast<long double>(value), FILM_FRACTION_BITS) + 0.5L));
}

Wide sum_of(const FunctionOperands& o, std::uint64_t count) {
  return steps_of(o[0]) * ((count + 1) / 2) + steps_of(o[1]) * (count / 2);
}

void put_sum(FunctionOperands& o, Wide sum) {
  for (std::size_t k = 0; k < kDigits; ++k) {
    o[kStart + k] = static_cast<float>(static_cast<std::uint32_t>(sum >> (16 * k)) & 0xffffu);
  }
}

template <std::size_t count>
Wide sum_in(const std::array<float, count>& words, std::size_t first) {
  Wide sum = 0;
  for (std::size_t k = 0; k < kDigits; ++k) sum |= static_cast<Wide>(words[first + k]) << (16 * k);
  return sum;
}

}  // namespace

CaseResult run_many_samples(const CaseSetup& setup) {
  constexpr float kPatterns[][2] = {{1.0f, 1.0f}, {0.1f, 0.1f}, {1e-8f, 1e4f}, {1e-8f, 1e-8f}, {0x1p-44f, 1e6f}};
  std::vector<FunctionOperands> operands;
  std::vector<Wide> ends;
  for (const auto& pattern : kPatterns) {
    for (std::uint64_t done = 0; done < kChain; done += kPiece) {
      FunctionOperands o{pattern[0], pattern[1], static_cast<float>(std::min(kPiece, kChain - done))};
      put_sum(o, sum_of(o, done));
      operands.push_back(o);
      ends.push_back(sum_of(o, std::min(done + kPiece, kChain)));
    }
  }
  const auto answers = call_shader_function(setup, VERIFY_SUM, operands);
  Tally tally("relative", level_bound(setup, 1e-7, 0.0));  // numerics.md 5.3
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const Wide got = sum_in(answers[i], 0);
    const Wide apart = got > ends[i] ? got - ends[i] : ends[i] - got;
    const bool counted = answers[i][6] == operands[i][2] && answers[i][7] == 0.0f;
    const auto error = static_cast<double>(static_cast<long double>(apart) / static_cast<long double>(ends[i]));
    tally.book_error(counted ? error : 1.0, [&] { return operand_text(VERIFY_SUM, operands[i]); });
  }
  return tally.result();
}

CaseResult run_film_firewall(const CaseSetup& setup) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kBroken[] = {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity};
  constexpr std::size_t kOddGreen = kStart + kDigits;
  return judged_calls(
      setup, "film_firewall", VERIFY_SUM,
      [&](SampleRandom& random, std::uint64_t i) {
        FunctionOperands o{};
        // 3e38 is beyond what the film can hold, and finite.
        o[0] = i % 16 == 0 ? 3e38f : static_cast<float>(random.power_of_ten(-13.0, 9.0));
        const bool in_red = random.below(2) == 0;
        o[1] = in_red ? kBroken[random.below(std::size(kBroken))] : 1.0f;
        o[kOddGreen] = in_red ? 0.0f : kBroken[random.below(std::size(kBroken))];
        o[2] = static_cast<float>(random.below(64));
        put_sum(o, static_cast<Wide>(random.bits()) << random.below(16));
        return o;
      },
      [&](const FunctionOperands& o, const FunctionAnswers& a) {
        const auto count = static_cast<std::uint64_t>(o[2]);
        const Wide largest = static_cast<Wide>(1) << (FILM_FRACTION_BITS + FILM_SAMPLE_MAX_EXPONENT);
        const Wide sum = sum_in(o, kStart) + std::min(steps_of(std::min(o[0], 1e10f)), largest) * ((count + 1) / 2);
        const auto broken = static_cast<float>(count / 2);
        const float first = count < 2 ? 0.0f : 2.0f;  // sample 1, counted from 1
        return sum_in(a, 0) == sum && a[6] == o[2] && a[7] == broken && a[8] == first;
      });
}

}  // namespace vernier
