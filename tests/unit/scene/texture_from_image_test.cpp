#include "scene/texture_from_image.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <fstream>
#include <iterator>
#include <vector>

#include "error.h"
#include "temporary_folder.h"

namespace vernier {
namespace {

/// Writes a 2 x 1 image of `channels` channels; the format follows from the name's extension.
template <typename T>
std::string write_image(const TemporaryFolder& folder, const std::string& name, int channels,
                        const std::vector<T>& values) {
  const std::string path = folder.write(name, "");
  const auto type = OIIO::BaseTypeFromC<T>::value;
  OIIO::ImageSpec spec(2, 1, channels, type);
  if (channels == 4 || channels == 2) spec.attribute("oiio:UnassociatedAlpha", 1);
  const auto output = OIIO::ImageOutput::create(path);
  EXPECT_TRUE(output && output->open(path, spec) && output->write_image(type, values.data()) && output->close());
  return path;
}

using Bytes = std::vector<std::uint8_t>;
using Words = std::vector<std::uint32_t>;

void expect_refused(const std::function<void()>& work, const std::string& part) {
  try {
    work();
    ADD_FAILURE() << "no error; expected one with: " << part;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(TextureFromImage, stores_eight_bits_as_they_are_with_red_in_the_low_byte) {
  const TemporaryFolder folder;
  const std::string path = write_image<std::uint8_t>(folder, "a.png", 4, {1, 2, 3, 4, 250, 251, 252, 0});
  const auto colour = decode_texels_from_file(path, TexelEncoding::srgb);
  EXPECT_EQ(colour->format, TEXTURE_FORMAT_SRGB8);
  EXPECT_EQ(colour->width, 2u);
  EXPECT_EQ(colour->height, 1u);
  EXPECT_EQ(colour->words, (Words{0x04030201u, 0x00FCFBFAu})) << "also where alpha is 0";
  EXPECT_EQ(decode_texels_from_file(path, TexelEncoding::linear)->format, TEXTURE_FORMAT_LINEAR8);
}

TEST(TextureFromImage, expands_grey_and_grey_alpha_and_missing_alpha) {
  const TemporaryFolder folder;
  const auto words = [&](int channels, const Bytes& values) {
    return decode_texels_from_file(write_image(folder, "a.png", channels, values), TexelEncoding::linear)->words;
  };
  EXPECT_EQ(words(1, {7, 8}), (Words{0xFF070707u, 0xFF080808u}));
  EXPECT_EQ(words(2, {7, 1, 8, 2}), (Words{0x01070707u, 0x02080808u}));
  EXPECT_EQ(words(3, {1, 2, 3, 4, 5, 6}), (Words{0xFF030201u, 0xFF060504u}));
}

TEST(TextureFromImage, reads_many_formats_by_content_from_memory) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "a.bmp", "a.tga", "a.tif", "a.jpg", "a.webp"}) {
    const std::string path = write_image<std::uint8_t>(folder, name, 3, {128, 128, 128, 128, 128, 128});
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    const auto texels = decode_texels(std::as_bytes(std::span(bytes)), "image 3", TexelEncoding::srgb);
    ASSERT_EQ(texels->words.size(), 2u) << name;
    EXPECT_NEAR(int(texels->words[0] & 0xFFu), 128, 2) << name;
    EXPECT_EQ(texels->words[0] >> 24, 255u) << name;
  }
}

/// 2 x 1 texels, (255, 0, 0) of opacity 64 and (10, 200, 30) of opacity 0, by `cwebp -lossless -exact`.
constexpr std::array<std::uint8_t, 42> kSeeThroughWebp = {
    0x52, 0x49, 0x46, 0x46, 0x22, 0x00, 0x00, 0x00, 0x57, 0x45, 0x42, 0x50, 0x56, 0x50,
    0x38, 0x4c, 0x15, 0x00, 0x00, 0x00, 0x2f, 0x01, 0x00, 0x00, 0x10, 0x0f, 0x30, 0xc8,
    0x5f, 0xf8, 0x1f, 0x8f, 0x03, 0x01, 0x87, 0x34, 0x2a, 0x10, 0xd1, 0xff, 0x00, 0x00};

TEST(TextureFromImage, colours_of_webp_are_not_multiplied_by_its_alpha) {
  const auto bytes = std::as_bytes(std::span(kSeeThroughWebp));
  const auto texels = decode_texels(bytes, "image 0", TexelEncoding::srgb);
  EXPECT_EQ(texels->format, TEXTURE_FORMAT_SRGB8);
  EXPECT_EQ(texels->words, (Words{0x400000FFu, 0x001EC80Au}));
  expect_refused([&] { decode_texels(bytes.first(30), "image 0", TexelEncoding::srgb); }, "image 0");
}

TEST(TextureFromImage, stores_deeper_images_as_linear_floats) {
  const TemporaryFolder folder;
  const std::string deep = write_image<std::uint16_t>(folder, "a.png", 1, {0, 32768});
  const auto component = [](const Texels& texels, std::size_t i) { return std::bit_cast<float>(texels.words[i]); };
  const auto linear = decode_texels_from_file(deep, TexelEncoding::linear);
  EXPECT_EQ(linear->format, TEXTURE_FORMAT_FLOAT);
  ASSERT_EQ(linear->words.size(), 8u);
  EXPECT_FLOAT_EQ(component(*linear, 4), 32768.0f / 65535.0f);
  EXPECT_EQ(component(*linear, 7), 1.0f);
  EXPECT_NEAR(component(*decode_texels_from_file(deep, TexelEncoding::srgb), 4), 0.21404f, 1e-5f);
  const std::string wide = write_image<float>(folder, "a.exr", 3, {4, 0.5f, 0, 1, 1, INFINITY});
  const auto exr = decode_texels_from_file(wide, TexelEncoding::srgb);
  EXPECT_EQ(component(*exr, 0), 4.0f);
  EXPECT_EQ(component(*exr, 1), 0.5f) << "float images are linear already";
  EXPECT_EQ(component(*exr, 6), 0.0f) << "infinity";
}

TEST(TextureFromImage, refuses_what_is_no_image) {
  const TemporaryFolder folder;
  expect_refused([&] { decode_texels_from_file(folder.write("a.png", ""), TexelEncoding::srgb); }, "a.png: ");
  expect_refused([&] { decode_texels_from_file(folder.write("a.png", "text"), TexelEncoding::srgb); }, "a.png: ");
  expect_refused([&] { decode_texels_from_file("/nowhere/b.png", TexelEncoding::srgb); }, "/nowhere/b.png: ");
  expect_refused([&] { decode_texels({}, "image 3", TexelEncoding::srgb); }, "image 3: ");
}

TEST(TextureFromImage, refuses_a_jpeg_that_is_cut) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.jpg", "");
  OIIO::ImageSpec spec(64, 64, 3, OIIO::TypeDesc::UINT8);
  Bytes noise(std::size_t{3} * 64 * 64);
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = static_cast<std::uint8_t>(i * i * 7 % 251);
  for (const int progressive : {0, 1}) {
    spec.attribute("jpeg:progressive", progressive);
    const auto output = OIIO::ImageOutput::create(path);
    ASSERT_TRUE(output->open(path, spec) && output->write_image(spec.format, noise.data()) && output->close());
    std::ifstream file(path, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), {});
    const std::string half = bytes.substr(0, bytes.size() / 2);
    EXPECT_NO_THROW(decode_texels_from_file(folder.write("whole.jpg", bytes), TexelEncoding::srgb));
    for (const std::string& cut : {half, half + "\xff\xd9"}) {  // with an end of image, too
      expect_refused([&] { decode_texels_from_file(folder.write("cut.jpg", cut), TexelEncoding::srgb); },
                     "remature end");
    }
  }
}

TEST(TextureFromImage, refuses_formats_whose_readers_cannot_be_trusted) {
  const TemporaryFolder folder;
  for (const char* name : {"a.sgi", "a.iff", "a.dpx", "a.psd"}) {
    expect_refused([&] { decode_texels_from_file(folder.write(name, "8BPS of some kind"), TexelEncoding::srgb); },
                   "not an image in a format that can be read");
  }
}

/// A TGA image of 2 x 1 indices into a palette of `colors` colours, the first of which is number `first`.
std::string palette_tga(char first, char colors, const std::string& indices) {
  return std::string("\0\1\1", 3) + first + '\0' + colors + std::string("\0\x18\0\0\0\0\2\0\1\0\x08\0", 12) +
         std::string(std::size_t(3) * std::size_t(colors), '\x40') + indices;
}

TEST(TextureFromImage, refuses_colours_beyond_a_palette) {
  const TemporaryFolder folder;
  const auto decode = [&](const std::string& bytes) {
    return decode_texels_from_file(folder.write("a.tga", bytes), TexelEncoding::srgb);
  };
  EXPECT_EQ(decode(palette_tga(0, 2, "\1\1"))->words, (Words{0xFF404040u, 0xFF404040u}));
  expect_refused([&] { decode(palette_tga(0, 2, "\1\2")); }, "outside its palette");
  expect_refused([&] { decode(palette_tga(1, 2, "\1\1")); }, "outside its palette");
  std::string packed = palette_tga(0, 2, std::string("\x81\2", 2));
  packed[2] = '\x09';
  expect_refused([&] { decode(packed); }, "outside its palette");
}

/// A DDS image of 1 x 1 texels of 32 bits with these masks of red, green and blue.
std::string plain_dds(const std::string& red, const std::string& green, const std::string& blue) {
  std::string bytes = std::string("DDS \x7c\0\0\0\x07\x10\0\0\1\0\0\0\1\0\0\0", 20) + std::string(56, '\0') +
                      std::string("\x20\0\0\0\x40\0\0\0\0\0\0\0\x20\0\0\0", 16) + red + green + blue;
  bytes.resize(109, '\0');
  return bytes + std::string("\x10", 1) + std::string(18, '\0') + "\1\2\3\4";
}

/// A DDS image of 4 x 4 texels in blocks of the format `code`.
std::string block_dds(const std::string& code, const std::string& blocks) {
  std::string bytes = std::string("DDS \x7c\0\0\0\x07\x10\0\0\4\0\0\0\4\0\0\0", 20) + std::string(56, '\0') +
                      std::string("\x20\0\0\0\4\0\0\0", 8) + code;
  bytes.resize(109, '\0');
  return bytes + '\x10' + std::string(18, '\0') + blocks;
}

TEST(TextureFromImage, reads_dds_of_blocks_of_colours) {
  const std::string red("\0\xf8\0\0\0\0\0\0", 8);  // colour 0 everywhere
  const auto decode = [](const std::string& bytes) {
    return decode_texels(std::as_bytes(std::span(bytes)), "image 0", TexelEncoding::srgb);
  };
  EXPECT_EQ(decode(block_dds("DXT1", red))->words, Words(16, 0xFF0000FFu));
  EXPECT_EQ(decode(block_dds("DXT5", std::string("\x80\x80\0\0\0\0\0\0", 8) + red))->words, Words(16, 0x800000FFu));
  expect_refused([&] { decode(block_dds("ATI2", red + red)); }, "DDS images are read with");
}

TEST(TextureFromImage, reads_plain_dds_and_refuses_masks_of_nothing) {
  const std::string low("\xff\0\0\0", 4), middle("\0\xff\0\0", 4), high("\0\0\xff\0", 4), none(4, '\0');
  const auto decode = [](const std::string& bytes) {
    return decode_texels(std::as_bytes(std::span(bytes)), "image 0", TexelEncoding::srgb);
  };
  EXPECT_EQ(decode(plain_dds(low, middle, high))->words, (Words{0xFF030201u}));
  EXPECT_EQ(decode(plain_dds(high, middle, low))->words, (Words{0xFF010203u}));
  expect_refused([&] { decode(plain_dds(low, none, high)); }, "DDS images are read with");
}

TEST(TextureFromImage, refuses_a_large_image_of_a_few_bytes) {
  const TemporaryFolder folder;
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8192 +X 8192\n";
  expect_refused([&] { decode_texels_from_file(folder.write("a.hdr", header), TexelEncoding::linear); }, "too short");
}

TEST(TextureFromImage, refuses_a_huge_image_by_its_header) {
  const TemporaryFolder folder;
  // A BMP header that promises 40000 x 40000 texels.
  const std::string header = std::string("BM\x3a\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0", 18) +
                             std::string("\x40\x9c\0\0\x40\x9c\0\0\x01\0\x18\0", 12) + std::string(24, '\0');
  expect_refused([&] { decode_texels_from_file(folder.write("a.bmp", header), TexelEncoding::srgb); }, "40000x40000");
}

}  // namespace
}  // namespace vernier
