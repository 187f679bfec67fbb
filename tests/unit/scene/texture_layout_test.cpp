#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <bit>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "error.h"
#include "scene/texture_from_image.h"
#include "temporary_folder.h"

namespace vernier {
namespace {

/// Writes `values` as the pixels of `spec`; the format follows from the name's extension.
template <typename T>
std::string write_image(const TemporaryFolder& folder, const std::string& name, const OIIO::ImageSpec& spec,
                        const std::vector<T>& values) {
  const std::string path = folder.write(name, "");
  const auto output = OIIO::ImageOutput::create(path);
  EXPECT_TRUE(output && output->open(path, spec) && output->write_image(spec.format, values.data()) && output->close());
  return path;
}

std::vector<float> floats_of(const Texels& texels) {
  std::vector<float> values;
  for (const std::uint32_t word : texels.words) values.push_back(std::bit_cast<float>(word));
  return values;
}

std::vector<float> decoded_floats(const std::string& path) {
  return floats_of(*decode_texels_from_file(path, TexelEncoding::srgb));
}

OIIO::ImageSpec exr_spec(int width, int height, const std::vector<std::string>& channels) {
  OIIO::ImageSpec spec(width, height, static_cast<int>(channels.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames = channels;
  spec.alpha_channel = -1;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (channels[i] == "A") spec.alpha_channel = static_cast<int>(i);
  }
  return spec;
}

TEST(TextureLayout, alpha_is_the_channel_of_that_name) {
  const TemporaryFolder folder;
  const auto pixel = [&](const std::vector<std::string>& channels, const std::vector<float>& values) {
    return decoded_floats(write_image(folder, "a.exr", exr_spec(1, 1, channels), values));
  };
  EXPECT_EQ(pixel({"R", "G", "B", "Z"}, {1, 2, 3, 0.25f}), (std::vector<float>{1, 2, 3, 1}));
  EXPECT_EQ(pixel({"R", "G"}, {1, 2}), (std::vector<float>{1, 2, 0, 1}));
  EXPECT_EQ(pixel({"Y"}, {2}), (std::vector<float>{2, 2, 2, 1}));
  EXPECT_EQ(pixel({"Y", "A"}, {2, 0.5f}), (std::vector<float>{4, 4, 4, 0.5f}));
  EXPECT_EQ(pixel({"N.X", "N.Y", "N.Z"}, {1, 2, 3}), (std::vector<float>{1, 2, 3, 1})) << "a vector";
  EXPECT_EQ(pixel({"R"}, {2}), (std::vector<float>{2, 2, 2, 1})) << "one alone is grey";
  EXPECT_EQ(pixel({"R", "G", "B", "matte.A"}, {1, 2, 3, 0.5f}), (std::vector<float>{1, 2, 3, 1}));
  EXPECT_EQ(pixel({"a.A", "b.R", "b.G", "b.B"}, {0.5f, 1, 2, 3}), (std::vector<float>{1, 2, 3, 1}));
  EXPECT_EQ(pixel({"View.Combined.A", "View.Combined.R", "View.Combined.G", "View.Combined.B", "View.Depth.Z"},
                  {0.5f, 1, 2, 3, 7}),
            (std::vector<float>{2, 4, 6, 0.5f}));
}

TEST(TextureLayout, of_a_tiff_the_last_of_two_or_four_is_alpha_whatever_its_kind) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeDesc::UINT8);
  spec.channelnames[3] = "spare";
  spec.alpha_channel = -1;
  const std::string path = write_image<std::uint8_t>(folder, "a.tif", spec, {50, 100, 128, 64});
  EXPECT_EQ(decode_texels_from_file(path, TexelEncoding::srgb)->words, std::vector<std::uint32_t>{0x40806432u});
}

TEST(TextureLayout, surroundings_and_data_are_taken_as_they_are_stored) {
  const TemporaryFolder folder;
  const std::string path =
      write_image<float>(folder, "a.exr", exr_spec(1, 1, {"R", "G", "B", "A"}), {0.5f, 0.25f, 1, 0.5f});
  for (const TexelEncoding encoding : {TexelEncoding::radiance, TexelEncoding::linear}) {
    EXPECT_EQ(floats_of(*decode_texels_from_file(path, encoding)), (std::vector<float>{0.5f, 0.25f, 1, 0.5f}));
  }
}

TEST(TextureLayout, little_in_a_huge_display_window_is_refused) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec = exr_spec(4, 4, {"Y"});
  spec.full_width = spec.full_height = 16384;
  const std::string path = write_image(folder, "a.exr", spec, std::vector<float>(16, 1.0f));
  EXPECT_THROW(decode_texels_from_file(path, TexelEncoding::srgb), Error);
  spec.full_width = spec.full_height = 4;
  spec.full_x = 100;  // it shows nothing, so it is passed over
  const std::string beside = write_image(folder, "b.exr", spec, std::vector<float>(16, 1.0f));
  EXPECT_EQ(decode_texels_from_file(beside, TexelEncoding::srgb)->width, 4u);
  EXPECT_EQ(decoded_floats(beside)[0], 1.0f);
}

TEST(TextureLayout, colours_that_are_stored_times_alpha_are_divided) {
  const TemporaryFolder folder;
  const std::string exr = write_image<float>(folder, "a.exr", exr_spec(2, 1, {"R", "G", "B", "A"}),
                                             {0.5f, 0.25f, 1, 0.5f, 0, 0.125f, 0, 0});
  EXPECT_EQ(decoded_floats(exr), (std::vector<float>{1, 0.5f, 2, 0.5f, 0, 0.125f, 0, 0}));
  OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeDesc::UINT8);
  const std::vector<std::uint8_t> bytes = {50, 100, 128, 128};
  const std::string associated = write_image(folder, "a.tif", spec, bytes);
  EXPECT_EQ(decode_texels_from_file(associated, TexelEncoding::srgb)->words, std::vector<std::uint32_t>{0x80ffc764u});
  spec.attribute("oiio:UnassociatedAlpha", 1);
  const std::string straight = write_image(folder, "b.tif", spec, bytes);
  EXPECT_EQ(decode_texels_from_file(straight, TexelEncoding::srgb)->words, std::vector<std::uint32_t>{0x80806432u});
}

TEST(TextureLayout, exr_is_its_display_window) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec = exr_spec(2, 1, {"Y"});
  spec.full_width = 3;
  spec.full_height = 2;
  spec.x = 2;
  spec.y = 1;  // of the two pixels one lies outside
  const std::string path = write_image<float>(folder, "a.exr", spec, {5, 6});
  const auto texels = decode_texels_from_file(path, TexelEncoding::linear);
  EXPECT_EQ(texels->width, 3u);
  EXPECT_EQ(texels->height, 2u);
  std::vector<float> expected(24, 0.0f);
  std::fill_n(expected.begin() + 20, 3, 5.0f);
  expected[23] = 1.0f;
  EXPECT_EQ(floats_of(*texels), expected);
}

TEST(TextureLayout, radiance_pictures_begin_where_their_first_line_says) {
  const TemporaryFolder folder;
  const auto reds = [&](const std::string& resolution) {
    const std::string pixels("\x80\0\0\x81\x40\0\0\x81\x20\0\0\x81\x10\0\0\x81", 16);  // 1, 1/2, 1/4, 1/8
    const auto values =
        decoded_floats(folder.write("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + resolution + "\n" + pixels));
    return std::vector<float>{values[0], values[4], values[8], values[12]};
  };
  EXPECT_EQ(reds("-Y 2 +X 2"), (std::vector<float>{1, 0.5f, 0.25f, 0.125f}));
  EXPECT_EQ(reds("+Y 2 +X 2"), (std::vector<float>{0.25f, 0.125f, 1, 0.5f}));
  EXPECT_EQ(reds("-Y 2 -X 2"), (std::vector<float>{0.5f, 1, 0.125f, 0.25f}));
  EXPECT_EQ(reds("+Y 2 -X 2"), (std::vector<float>{0.125f, 0.25f, 0.5f, 1}));
  EXPECT_THROW(reds("+X 2 -Y 2"), Error);
}

TEST(TextureLayout, the_fourth_byte_of_a_bmp_is_alpha_where_the_header_says_so) {
  const TemporaryFolder folder;
  const auto word = [](std::uint32_t value) { return std::string(reinterpret_cast<const char*>(&value), 4); };
  const auto texel = [&](std::uint32_t header, std::uint32_t compression, const std::string& masks) {
    const std::string info = word(header) + word(1) + word(1) + word(1 | 32u << 16) + word(compression) + word(4) +
                             std::string(16, '\0') + masks;
    const std::string pixel("\x03\x02\x01\x40", 4);
    const std::string file = word(14 + static_cast<std::uint32_t>(info.size()) + 4) + word(0) +
                             word(14 + static_cast<std::uint32_t>(info.size())) + info + pixel;
    return decode_texels_from_file(folder.write("a.bmp", "BM" + file), TexelEncoding::srgb)->words.at(0);
  };
  EXPECT_EQ(texel(40, 0, ""), 0xff030201u);
  const std::string with_alpha = word(0xff0000) + word(0xff00) + word(0xff) + word(0xff000000u);
  EXPECT_EQ(texel(108, 3, with_alpha + std::string(52, '\0')), 0x40030201u);
}

TEST(TextureLayout, deep_tiff_whose_zero_is_white_is_turned_round) {
  const TemporaryFolder folder;
  const auto path =
      write_image<std::uint16_t>(folder, "a.tif", OIIO::ImageSpec(1, 1, 1, OIIO::TypeDesc::UINT16), {13107});
  std::ifstream file(path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(file)), {});
  // The entry PhotometricInterpretation, SHORT, 1 value: 1 (black is zero) becomes 0.
  const std::size_t entry = bytes.find(std::string("\x06\x01\x03\0\x01\0\0\0\x01", 9));
  ASSERT_NE(entry, std::string::npos);
  const auto value = [](const std::string& name) {
    return floats_of(*decode_texels_from_file(name, TexelEncoding::linear))[0];
  };
  EXPECT_FLOAT_EQ(value(path), 0.2f);
  bytes[entry + 8] = 0;
  EXPECT_FLOAT_EQ(value(folder.write("b.tif", bytes)), 0.8f);
}

}  // namespace
}  // namespace vernier
