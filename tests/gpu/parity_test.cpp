// The shipped functions on the device against the same text compiled as C++.
#include "spirv/parity.h"

#include <array>
#include <bit>
#include <cstdlib>

#include "device_test.h"
#include "gpu/compute_pipeline.h"
#include "gpu/submission.h"
#include "shader/random_values.h"
#include "shader/shader.h"

namespace vernier::shader {
namespace {

constexpr std::size_t kOperands = 16;
constexpr std::size_t kAnswers = 18;
constexpr std::size_t kRows = 64 * 512;

enum Answer {
  kFirstInteger = 0,
  kIntersects = 5,
  kT,
  kB1,
  kB2,
  kUnit,
  kDot = 12,
  kReflected,
  kTransmitted,
  kRefracted,
  kHighlight,
  kSchlick
};

std::vector<float> random_operands() {
  RandomValues random(50);
  std::vector<float> operands;
  for (std::size_t row = 0; row < kRows; ++row) {
    for (int i = 0; i < 12; ++i) operands.push_back(random.in(-1, 1));
    operands.push_back(random.in(0, 1));             // x: a cosine, and where the ray is aimed at
    operands.push_back(random.in(0.4, 2.5));         // y: an index ratio
    operands.push_back(random.power_of_ten(-3, 6));  // z: an exponent, a scale, a radiance
    operands.push_back(std::bit_cast<float>(random.word() & 0x7f7fffffu));  // a word that is a finite float
  }
  return operands;
}

std::vector<std::uint32_t> answers_on_host(const std::vector<float>& operands) {
  std::vector<std::uint32_t> answers;
  for (std::size_t row = 0; row < kRows; ++row) {
    const auto number = [&](uint i) { return operands[row * kOperands + i]; };
    const auto put = [&](std::uint32_t answer) { answers.push_back(answer); };
#include "parity_answers.h"
  }
  return answers;
}

class ParityTest : public DeviceTest {
 protected:
  void SetUp() override {
    DeviceTest::SetUp();
    const std::vector<float> numbers = random_operands();
    host_ = answers_on_host(numbers);
    ASSERT_EQ(host_.size(), kRows * kAnswers);
    Buffer operands(device(), numbers.size() * 4, BufferUse::storage);
    operands.upload(device(), std::as_bytes(std::span(numbers)));
    const Buffer answers(device(), host_.size() * 4, BufferUse::storage);
    const std::array<Binding, 2> bindings{Binding{0, &operands}, Binding{1, &answers}};
    const ComputePipeline pipeline(device(), kParitySpirv, bindings, 0, {});
    const BindingSet set(device(), pipeline, bindings);
    const Dispatch dispatch{&pipeline, &set, {}, kRows / 64, 1, 1};
    Submitter(device()).run({&dispatch, 1});
    device_answers_.resize(host_.size());
    answers.download(device(), std::as_writable_bytes(std::span(device_answers_)));
  }

  /// Rows whose answers differ in a bit.
  int different(int answer) const {
    int count = 0;
    for (std::size_t row = 0; row < kRows; ++row) {
      count += host_[row * kAnswers + answer] != device_answers_[row * kAnswers + answer] ? 1 : 0;
    }
    return count;
  }

  /// Largest difference of a float answer, over max(1, its size) unless the row misses its triangle.
  double worst(int answer) const {
    double largest = 0;
    for (std::size_t row = 0; row < kRows; ++row) {
      const double expected = std::bit_cast<float>(host_[row * kAnswers + answer]);
      const double found = std::bit_cast<float>(device_answers_[row * kAnswers + answer]);
      const double difference = std::abs(found - expected) / std::max(1.0, std::abs(expected));
      if (!(difference <= largest)) largest = difference;
    }
    return largest;
  }

 private:
  std::vector<std::uint32_t> host_, device_answers_;
};

TEST_F(ParityTest, integer_functions_are_the_same) {
  for (int answer = kFirstInteger; answer < kIntersects; ++answer) EXPECT_EQ(different(answer), 0) << answer;
}

TEST_F(ParityTest, hits_are_the_same) {
  EXPECT_EQ(different(kIntersects), 0);
}

TEST_F(ParityTest, precise_floats_are_the_same_bits) {
  // Both drivers divide and take roots as IEEE 754 says; what `precise` keeps in order has one result then.
  for (int answer = kT; answer <= kDot; ++answer) EXPECT_EQ(different(answer), 0) << answer;
}

TEST_F(ParityTest, other_floats_are_near) {
  // Ten roundings of 2^-24 each, by 1 / eta^2 at the most (fresnel.glsl), which a fused product may change.
  EXPECT_LE(worst(kReflected), 2e-6);
  EXPECT_LE(worst(kTransmitted), 2e-6);
  // The root of a difference that loses its digits at the critical angle: 2^-12.
  EXPECT_LE(worst(kRefracted), 3e-4);
  EXPECT_LE(worst(kSchlick), 1e-6);
  // exp2 and log of the driver: 3 + 2 ulp of their argument (Vulkan specification, appendix on precision), and exp2's
  // argument, up to 150 where the result is no 0, passes its own error on.
  EXPECT_LE(worst(kHighlight), 2e-5);
}

}  // namespace
}  // namespace vernier::shader
