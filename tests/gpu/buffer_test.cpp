#include "gpu/buffer.h"

#include <numeric>
#include <vector>

#include "device_test.h"
#include "error.h"

namespace vernier {
namespace {

class BufferTest : public DeviceTest {
 protected:
  std::vector<std::uint32_t> download(const Buffer& buffer) const {
    std::vector<std::uint32_t> words(buffer.size_bytes() / 4);
    buffer.download(device(), std::as_writable_bytes(std::span(words)));
    return words;
  }

  static std::vector<std::uint32_t> counting_words(std::size_t count) {
    std::vector<std::uint32_t> words(count);
    std::iota(words.begin(), words.end(), 0x01020304U);
    return words;
  }

  /// Expects Error(refused) whose text has both numbers.
  void expect_refused(std::uint64_t bytes, BufferUse use, const std::string& first, const std::string& second) const {
    try {
      const Buffer buffer(device(), bytes, use);
      ADD_FAILURE() << bytes << " bytes were not refused";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::refused);
      EXPECT_NE(std::string(error.what()).find(first), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(second), std::string::npos) << error.what();
    }
  }
};

constexpr BufferUse kAllUses[] = {BufferUse::storage, BufferUse::uniform, BufferUse::texels_rgba32ui,
                                  BufferUse::texels_r32ui, BufferUse::storage_host_visible};

TEST_F(BufferTest, round_trip_of_odd_sizes_in_every_use) {
  for (const BufferUse use : kAllUses) {
    for (const std::size_t words : {1U, 3U, 5U, 63U, 1021U, 4095U}) {
      Buffer buffer(device(), words * 4, use);
      ASSERT_EQ(buffer.size_bytes(), words * 4);
      EXPECT_EQ(buffer.use(), use);
      EXPECT_EQ(download(buffer), std::vector<std::uint32_t>(words, 0)) << "not zero at first";
      const std::vector<std::uint32_t> sent = counting_words(words);
      buffer.upload(device(), std::as_bytes(std::span(sent)));
      EXPECT_EQ(download(buffer), sent);
    }
  }
}

TEST_F(BufferTest, sizes_are_rounded_up) {
  EXPECT_EQ(Buffer(device(), 0, BufferUse::storage).size_bytes(), 16U);
  EXPECT_EQ(Buffer(device(), 1, BufferUse::storage).size_bytes(), 4U);
  EXPECT_EQ(Buffer(device(), 17, BufferUse::uniform).size_bytes(), 20U);
}

TEST_F(BufferTest, more_than_one_staging_buffer) {
  constexpr std::size_t kWords = (std::size_t{16} << 20) / 4 * 2 + 7;  // two chunks of 16 MiB and a bit
  Buffer buffer(device(), kWords * 4, BufferUse::storage);
  const std::vector<std::uint32_t> sent = counting_words(kWords);
  buffer.upload(device(), std::as_bytes(std::span(sent)));
  EXPECT_EQ(download(buffer), sent);
}

TEST_F(BufferTest, offsets_leave_the_rest_alone) {
  Buffer buffer(device(), 8 * 4, BufferUse::storage);
  const std::vector<std::uint32_t> sent{7, 8, 9};
  buffer.upload(device(), std::as_bytes(std::span(sent)), 2 * 4);
  EXPECT_EQ(download(buffer), (std::vector<std::uint32_t>{0, 0, 7, 8, 9, 0, 0, 0}));
  std::vector<std::uint32_t> part(2);
  buffer.download(device(), std::as_writable_bytes(std::span(part)), 3 * 4);
  EXPECT_EQ(part, (std::vector<std::uint32_t>{8, 9}));
  buffer.upload(device(), {}, 8 * 4);
  EXPECT_EQ(download(buffer)[7], 0U);
}

TEST_F(BufferTest, a_copy_that_does_not_fit_is_a_logic_error) {
  Buffer buffer(device(), 16, BufferUse::storage);
  std::vector<std::uint32_t> words(5);
  EXPECT_THROW(buffer.upload(device(), std::as_bytes(std::span(words))), std::logic_error);
  EXPECT_THROW(buffer.download(device(), std::as_writable_bytes(std::span(words)).first(16), 4), std::logic_error);
  EXPECT_THROW(buffer.upload(device(), std::as_bytes(std::span(words)).first(4), 20), std::logic_error);
  EXPECT_THROW(buffer.upload(device(), std::as_bytes(std::span(words)).first(4), 2), std::logic_error);
}

TEST_F(BufferTest, clear_makes_all_zero) {
  for (const BufferUse use : kAllUses) {
    Buffer buffer(device(), 100 * 4, use);
    const std::vector<std::uint32_t> sent = counting_words(100);
    buffer.upload(device(), std::as_bytes(std::span(sent)));
    buffer.clear(device());
    EXPECT_EQ(download(buffer), std::vector<std::uint32_t>(100, 0));
  }
}

TEST_F(BufferTest, host_visible_memory_is_mapped) {
  Buffer buffer(device(), 12, BufferUse::storage_host_visible);
  ASSERT_EQ(buffer.mapped().size(), 12U);
  buffer.mapped()[5] = std::byte{0xab};
  EXPECT_EQ(download(buffer)[1], 0xab00U);
}

TEST_F(BufferTest, moving_keeps_the_content) {
  Buffer first(device(), 8, BufferUse::texels_r32ui);
  const std::vector<std::uint32_t> sent{5, 6};
  first.upload(device(), std::as_bytes(std::span(sent)));
  Buffer second(device(), 64, BufferUse::storage);
  second = std::move(first);
  EXPECT_EQ(download(second), sent);
}

TEST_F(BufferTest, limits_are_refused_with_both_numbers) {
  const DeviceDescription& limits = device().description();
  const std::uint64_t storage = limits.max_storage_buffer_range_bytes;
  expect_refused(storage + 4, BufferUse::storage, std::to_string(storage + 4), std::to_string(storage));
  expect_refused(storage + 4, BufferUse::storage_host_visible, std::to_string(storage + 4), std::to_string(storage));
  const std::uint64_t texels = limits.max_texel_buffer_elements;
  expect_refused(16 * (texels + 1), BufferUse::texels_rgba32ui, std::to_string(16 * (texels + 1)),
                 std::to_string(texels));
  expect_refused(4 * (texels + 1), BufferUse::texels_r32ui, std::to_string(4 * (texels + 1)), std::to_string(texels));
  const std::uint64_t uniform = device().physical().getProperties().limits.maxUniformBufferRange;
  expect_refused(uniform + 4, BufferUse::uniform, std::to_string(uniform + 4), std::to_string(uniform));
  const std::uint64_t most = ~std::uint64_t{0};
  expect_refused(most, BufferUse::storage, std::to_string(most), std::to_string(storage));
}

}  // namespace
}  // namespace vernier
