#include "gpu/submission.h"

#include <array>
#include <cstring>

#include "device_test.h"
#include "gpu/vk_check.h"
#include "spirv/copy_words.h"
#include "spirv/spin.h"

namespace vernier {
namespace {

using Words = std::vector<std::uint32_t>;

template <typename Value>
std::vector<std::byte> bytes_of(const Value& value) {
  std::vector<std::byte> out(sizeof(Value));
  std::memcpy(out.data(), &value, sizeof(Value));
  return out;
}

/// A buffer of 64 words with the spin shader bound to it.
class SubmissionTest : public DeviceTest {
 protected:
  void SetUp() override {
    DeviceTest::SetUp();
    states_ = Buffer(device(), 64 * 4, BufferUse::storage_host_visible);
    const Words ones(64, 1);
    states_.upload(device(), std::as_bytes(std::span(ones)));
    const Binding binding{0, &states_};
    pipeline_ = ComputePipeline(device(), kSpinSpirv, {&binding, 1}, 4, {});
    set_ = BindingSet(device(), pipeline_, {&binding, 1});
  }

  void TearDown() override {
    set_ = {};
    pipeline_ = {};
    states_ = {};
    DeviceTest::TearDown();
  }

  Dispatch spin(std::uint32_t rounds) const { return {&pipeline_, &set_, bytes_of(rounds), 1, 1, 1}; }

  std::uint32_t state() const {
    std::uint32_t out = 0;
    std::memcpy(&out, states_.mapped().data(), sizeof(out));
    return out;
  }

  static std::uint32_t expected_state(std::uint32_t rounds) {
    std::uint32_t out = 1;
    for (std::uint32_t i = 0; i < rounds * 32; ++i) {
      out ^= out << 13;
      out ^= out >> 17;
      out ^= out << 5;
    }
    return out;
  }

 private:
  Buffer states_;
  ComputePipeline pipeline_;
  BindingSet set_;
};

TEST_F(SubmissionTest, dispatches_see_what_the_ones_before_wrote) {
  Submitter submitter(device());
  const std::array<Dispatch, 3> dispatches{spin(10), spin(20), spin(30)};
  submitter.run(dispatches);
  EXPECT_EQ(state(), expected_state(60));
  submitter.run(dispatches);
  EXPECT_EQ(state(), expected_state(120)) << "a submitter can be used again";
}

TEST_F(SubmissionTest, a_chain_through_two_buffers_keeps_its_order) {
  Buffer a(device(), 64 * 4, BufferUse::storage);
  Buffer b(device(), 64 * 4, BufferUse::storage);
  const Words ones(64, 1);
  a.upload(device(), std::as_bytes(std::span(ones)));
  const std::array<Binding, 2> a_to_b{Binding{0, &a}, Binding{4, &b}};
  const std::array<Binding, 2> b_to_a{Binding{0, &b}, Binding{4, &a}};
  const SpecializationValue factor{0, 3};
  const ComputePipeline pipeline(device(), kCopyWordsSpirv, a_to_b, 8, {&factor, 1});
  const BindingSet there(device(), pipeline, a_to_b);
  const BindingSet back(device(), pipeline, b_to_a);
  const std::vector<std::byte> push = bytes_of(std::array<std::uint32_t, 2>{64, 0});
  std::vector<Dispatch> dispatches;
  for (int i = 0; i < 10; ++i) dispatches.push_back({&pipeline, i % 2 == 0 ? &there : &back, push, 1, 1, 1});
  Submitter(device()).run(dispatches);
  Words words(64);
  a.download(device(), std::as_writable_bytes(std::span(words)));
  EXPECT_EQ(words, Words(64, 59049)) << "3^10";
}

TEST_F(SubmissionTest, the_host_puts_words_before_dispatches_and_takes_them_behind) {
  Buffer from(device(), 64 * 4, BufferUse::storage);
  Buffer to(device(), 64 * 4, BufferUse::storage);
  const std::array<Binding, 2> bindings{Binding{0, &from}, Binding{4, &to}};
  const SpecializationValue factor{0, 3};
  const ComputePipeline pipeline(device(), kCopyWordsSpirv, bindings, 8, {&factor, 1});
  const BindingSet set(device(), pipeline, bindings);
  const Dispatch triple{&pipeline, &set, bytes_of(std::array<std::uint32_t, 2>{64, 0}), 1, 1, 1};
  Submitter submitter(device());
  for (const std::uint32_t value : {5u, 7u}) {
    const Words put(64, value);
    Words head(8), all(64);
    submitter.run({&triple, 1},
                  {{{&from, std::as_bytes(std::span(put))}},
                   {{&from, std::as_writable_bytes(std::span(head))}, {&to, std::as_writable_bytes(std::span(all))}}});
    EXPECT_EQ(head, Words(8, value));
    EXPECT_EQ(all, Words(64, 3 * value));
  }
}

TEST_F(SubmissionTest, nothing_to_dispatch_is_allowed) {
  const SubmissionTime time = Submitter(device()).run({});
  EXPECT_GE(time.device_ms, 0.0);
  EXPECT_LT(time.device_ms, 1000.0);
}

TEST_F(SubmissionTest, times_grow_with_the_work) {
  Submitter submitter(device());
  const Dispatch little = spin(100);
  const Dispatch much = spin(60'000);
  const SubmissionTime little_time = submitter.run({&little, 1});
  const SubmissionTime much_time = submitter.run({&much, 1});
  EXPECT_GT(much_time.device_ms, little_time.device_ms);
  EXPECT_LE(much_time.device_ms, much_time.wall_ms * 1.01 + 1.0) << "the device works inside the wall time";
  EXPECT_GE(much_time.device_ms, much_time.wall_ms * 0.25) << "and the wait is nearly all work";
}

TEST_F(SubmissionTest, no_answer_in_time_counts_as_loss_for_good) {
  Submitter submitter(device());
  const Dispatch much = spin(60'000);
  const Dispatch little = spin(1);
  for (const Dispatch& dispatch : {much, little}) {
    try {
      submitter.run({&dispatch, 1}, {}, 0.0);
      ADD_FAILURE() << "answered at once";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::device_lost);
      EXPECT_NE(std::string(error.what()).find(expected_device_name()), std::string::npos) << error.what();
    }
  }
}

TEST_F(SubmissionTest, a_failing_call_is_an_error_with_its_place) {
  const auto kind_of = [](auto call) {
    try {
      vk_check("testing", call);
    } catch (const Error& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("testing: ")) << error.what();
      return error.kind();
    }
    return ErrorKind::usage;
  };
  EXPECT_EQ(kind_of([] { throw vk::DeviceLostError("lost"); }), ErrorKind::device_lost);
  EXPECT_EQ(kind_of([] { throw vk::OutOfDeviceMemoryError("memory"); }), ErrorKind::failed);
  EXPECT_EQ(kind_of([] { throw vk::InitializationFailedError("other"); }), ErrorKind::failed);
  EXPECT_EQ(vk_check("testing", [] { return 7; }), 7);
}

}  // namespace
}  // namespace vernier
