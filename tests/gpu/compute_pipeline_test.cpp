#include "gpu/compute_pipeline.h"

#include <array>
#include <bit>
#include <cstring>

#include "device_test.h"
#include "gpu/submission.h"
#include "spirv/copy_words.h"
#include "spirv/fetch_texels.h"

namespace vernier {
namespace {

using Words = std::vector<std::uint32_t>;

class ComputePipelineTest : public DeviceTest {
 protected:
  Buffer filled(const Words& words, BufferUse use) const {
    Buffer out(device(), words.size() * 4, use);
    out.upload(device(), std::as_bytes(std::span(words)));
    return out;
  }

  Words download(const Buffer& buffer) const {
    Words words(buffer.size_bytes() / 4);
    buffer.download(device(), std::as_writable_bytes(std::span(words)));
    return words;
  }

  /// What copy_words makes of {10, 20, 30, 40}.
  Words copied(std::array<std::uint32_t, 2> count_and_first, std::span<const SpecializationValue> constants) const {
    const Buffer from = filled({10, 20, 30, 40}, BufferUse::storage);
    const Buffer to = filled({0, 0, 0, 0}, BufferUse::storage_host_visible);
    const std::array<Binding, 2> bindings{Binding{0, &from}, Binding{4, &to}};
    const ComputePipeline pipeline(device(), kCopyWordsSpirv, bindings, sizeof(count_and_first), constants);
    const BindingSet set(device(), pipeline, bindings);
    Dispatch dispatch{&pipeline, &set, std::vector<std::byte>(sizeof(count_and_first)), 1, 1, 1};
    std::memcpy(dispatch.push_constants.data(), count_and_first.data(), sizeof(count_and_first));
    Submitter(device()).run({&dispatch, 1});
    return download(to);
  }
};

TEST_F(ComputePipelineTest, push_constants_arrive) {
  EXPECT_EQ(copied({4, 0}, {}), (Words{10, 20, 30, 40}));
  EXPECT_EQ(copied({2, 1}, {}), (Words{0, 20, 30, 0}));
  EXPECT_EQ(copied({0, 0}, {}), (Words{0, 0, 0, 0}));
}

TEST_F(ComputePipelineTest, specialization_constants_arrive_by_their_ids) {
  const std::array<SpecializationValue, 2> constants{SpecializationValue{3, std::bit_cast<std::uint32_t>(5.0F)},
                                                     SpecializationValue{0, 3}};
  EXPECT_EQ(copied({4, 0}, constants), (Words{35, 65, 95, 125}));
  EXPECT_EQ(copied({4, 0}, std::span(constants).first(1)), (Words{15, 25, 35, 45}));
}

TEST_F(ComputePipelineTest, texel_and_uniform_buffers_are_read) {
  const Words wide_words{1, 2, 3, 4, 5, 6, 7, 0x7fffffff};
  const Words narrow_words{11, 12, 13, 14, 15, 16, 17, 18};
  const Buffer wide = filled(wide_words, BufferUse::texels_rgba32ui);
  const Buffer narrow = filled(narrow_words, BufferUse::texels_r32ui);
  const Buffer scale = filled({2}, BufferUse::uniform);
  const Buffer words(device(), 16 * 4, BufferUse::storage);
  const std::array<Binding, 4> bindings{Binding{0, &wide}, Binding{1, &narrow}, Binding{2, &scale}, Binding{3, &words}};
  const ComputePipeline pipeline(device(), kFetchTexelsSpirv, bindings, 0, {});
  EXPECT_GT(pipeline.compile_ms(), 0.0);
  const BindingSet set(device(), pipeline, bindings);
  const Dispatch dispatch{&pipeline, &set, {}, 1, 1, 1};
  Submitter(device()).run({&dispatch, 1});
  EXPECT_EQ(download(words), (Words{2, 4, 6, 8, 22, 24, 26, 28, 10, 12, 14, 0xfffffffe, 30, 32, 34, 36}));
}

TEST_F(ComputePipelineTest, what_was_compiled_before_is_taken_again) {
  const Buffer words = filled({1, 2, 3, 4}, BufferUse::storage);
  const std::array<Binding, 2> bindings{Binding{0, &words}, Binding{4, &words}};
  const auto made = [&](std::uint32_t value, std::uint32_t push_constant_bytes) {
    const std::array<SpecializationValue, 1> constants{SpecializationValue{0, value}};
    return ComputePipeline(device(), kCopyWordsSpirv, bindings, push_constant_bytes, constants);
  };
  const ComputePipeline first = made(3, 8);
  EXPECT_EQ(*made(3, 8).vk(), *first.vk());
  EXPECT_NE(*made(4, 8).vk(), *first.vk());
  EXPECT_NE(*made(3, 16).vk(), *first.vk());
}

TEST_F(ComputePipelineTest, the_store_lets_go_of_what_was_asked_for_least_lately) {
  PipelineStore store;
  std::uint64_t compiled = 0;
  const auto ask = [&](std::uint64_t key) {
    store.find_or_make({key}, [&] {
      ++compiled;
      return CompiledPipeline{};
    });
  };
  for (std::uint64_t key = 0; key < PipelineStore::kMostPipelines; ++key) ask(key);
  ask(0);
  EXPECT_EQ(compiled, PipelineStore::kMostPipelines) << "all are there";
  ask(PipelineStore::kMostPipelines);
  ask(0);
  EXPECT_EQ(compiled, PipelineStore::kMostPipelines + 1) << "1 went";
  ask(1);
  EXPECT_EQ(compiled, PipelineStore::kMostPipelines + 2);
}

TEST_F(ComputePipelineTest, pipelines_and_sets_can_be_replaced) {
  const Buffer from = filled({1, 2, 3, 4}, BufferUse::storage);
  const Buffer to(device(), 16, BufferUse::storage);
  const std::array<Binding, 2> bindings{Binding{0, &from}, Binding{4, &to}};
  ComputePipeline pipeline;
  BindingSet set;
  for (std::uint32_t factor : {1U, 7U}) {
    const SpecializationValue constant{0, factor};
    pipeline = ComputePipeline(device(), kCopyWordsSpirv, bindings, 8, {&constant, 1});
    set = BindingSet(device(), pipeline, bindings);
  }
  Dispatch dispatch{&pipeline, &set, std::vector<std::byte>(8), 1, 1, 1};
  dispatch.push_constants[0] = std::byte{4};
  Submitter(device()).run({&dispatch, 1});
  EXPECT_EQ(download(to), (Words{7, 14, 21, 28}));
}

TEST(Spirv, the_embedded_module_has_its_magic_number_and_hash) {
  ASSERT_GT(kCopyWordsSpirv.size(), 5U);
  EXPECT_EQ(kCopyWordsSpirv[0], 0x07230203U);
  EXPECT_EQ(kCopyWordsSha256.size(), 64U);
  EXPECT_NE(kCopyWordsSha256, kFetchTexelsSha256);
}

}  // namespace
}  // namespace vernier
