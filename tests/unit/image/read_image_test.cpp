#include "image/read_image.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "expect_error.h"
#include "image/color_image.h"
#include "image/srgb_curve.h"
#include "image/write_image.h"
#include "sample_image.h"
#include "temporary_folder.h"

namespace vernier {
namespace {

// Writes by OpenImageIO directly, as other programs do.
template <typename Value>
void write_foreign(const std::string& path, const OIIO::ImageSpec& spec, const std::vector<Value>& values) {
  const auto output = OIIO::ImageOutput::create(path);
  ASSERT_TRUE(output && output->open(path, spec)) << OIIO::geterror();
  ASSERT_TRUE(output->write_image(OIIO::BaseTypeFromC<Value>::value, values.data())) << output->geterror();
  ASSERT_TRUE(output->close());
}

const std::vector<float>& floats(const Layer& layer) {
  return std::get<std::vector<float>>(layer.values);
}

TEST(ReadImage, SortsForeignLayersAndWidensHalf) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec(1, 1, 5, OIIO::TypeDesc::HALF);
  spec.channelnames = {"view.diffuse.B", "view.diffuse.R", "view.diffuse.G", "beta", "alpha"};
  write_foreign(folder.file("x.exr"), spec, std::vector<float>{3.0f, 0.5f, 0.25f, 8.0f, 16.0f});
  const ImageFile image = read_image(folder.file("x.exr"));
  ASSERT_EQ(image.layers.size(), 2u);
  EXPECT_EQ(image.layers[0].channels, (std::vector<std::string>{"alpha", "beta"}));
  EXPECT_EQ(floats(image.layers[0]), (std::vector<float>{16.0f, 8.0f}));
  EXPECT_EQ(image.layers[1].name, "view.diffuse");
  EXPECT_EQ(image.layers[1].channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ(floats(image.layers[1]), (std::vector<float>{0.5f, 0.25f, 3.0f}));
}

TEST(ReadImage, ReadsTiledFilesWithCutOffTiles) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec(50, 39, 3, OIIO::TypeDesc::FLOAT);
  spec.tile_width = spec.tile_height = 16;
  std::vector<float> values(50 * 39 * 3);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
  for (const char* name : {"x.exr", "x.tif"}) {
    write_foreign(folder.file(name), spec, values);
    EXPECT_EQ(floats(read_image(folder.file(name)).layers[0]), values) << name;
  }
}

TEST(ReadImage, DecodesBytesButNotAlphaAndDoesNotMultiply) {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  write_foreign(folder.file("x.png"), spec, std::vector<unsigned char>{255, 128, 0, 51});
  const ImageFile image = read_image(folder.file("x.png"));
  const float middle = static_cast<float>(linear_from_srgb(128 / 255.0));
  EXPECT_EQ(floats(image.layers[0]), (std::vector<float>{1.0f, middle, 0.0f, 0.2f}));
}

TEST(ReadImage, GreyBecomesColor) {
  const TemporaryFolder folder;
  write_foreign(folder.file("x.png"), OIIO::ImageSpec(1, 1, 1, OIIO::TypeDesc::UINT16),
                std::vector<unsigned short>{65535});
  const Image image = color_image(read_image(folder.file("x.png")), "x.png");
  EXPECT_EQ(image.values, (std::vector<float>{1.0f, 1.0f, 1.0f, 1.0f}));
}

TEST(ReadImage, RefusesWhatIsNoImage) {
  const TemporaryFolder folder;
  const std::string text = folder.file("text.exr");
  std::ofstream(text) << "this is no image";
  expect_error(ErrorKind::refused, text + ": ", [&] { read_image(text); });
  expect_error(ErrorKind::refused, "No such file", [&] { read_image(folder.file("none.png")); });
  expect_error(ErrorKind::refused, "unknown image format", [] { read_image("x.gif"); });
  std::filesystem::create_directory(folder.file("folder.png"));
  expect_error(ErrorKind::refused, "it is a folder", [&] { read_image(folder.file("folder.png")); });
}

TEST(ReadImage, RefusesEveryCutOffFileOrReadsAllOfIt) {
  const TemporaryFolder folder;
  for (const std::string extension : {".exr", ".png", ".hdr", ".tif"}) {
    const std::string path = folder.file("x" + extension);
    write_image(path, sample_image(), {});
    const std::string whole = bytes_of_file(path);
    for (const std::size_t size : {std::size_t{0}, std::size_t{10}, whole.size() / 3, whole.size() * 2 / 3}) {
      std::ofstream(path, std::ios::binary).write(whole.data(), static_cast<std::streamsize>(size));
      expect_error(ErrorKind::refused, path + ": ", [&] { read_image(path); });
    }
  }
}

// The header alone says 60000 x 60000: 200 bytes must not cost 43 GB.
TEST(ReadImage, RefusesHugeSizesBeforeAnyAllocation) {
  const TemporaryFolder folder;
  const std::string path = folder.file("huge.hdr");
  std::ofstream(path) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 60000 +X 60000\n";
  expect_error(ErrorKind::refused, "more than 2^31 values", [&] { read_image(path); });
}

TEST(ReadImage, RefusesSeveralParts) {
  const TemporaryFolder folder;
  const std::string path = folder.file("two.tif");
  const OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeDesc::UINT8);
  const unsigned char pixel[3] = {1, 2, 3};
  const auto output = OIIO::ImageOutput::create(path);
  ASSERT_TRUE(output->open(path, spec) && output->write_image(OIIO::TypeDesc::UINT8, pixel));
  ASSERT_TRUE(output->open(path, spec, OIIO::ImageOutput::AppendSubimage));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, pixel) && output->close());
  expect_error(ErrorKind::refused, "several parts", [&] { read_image(path); });
}

TEST(ColorImage, AddsAlphaAndRefusesOtherLayers) {
  const Image image{2, 1, 3, {1, 2, 3, 4, 5, 6}};
  EXPECT_EQ(color_image(file_of_image(image), "x").values, (std::vector<float>{1, 2, 3, 1, 4, 5, 6, 1}));
  ImageFile file = file_of_image(image);
  file.layers[0].channels = {"X", "Y", "Z"};
  file.layers[0].name = "normal";
  expect_error(ErrorKind::refused, "x.exr: has no colour layer", [&] { color_image(file, "x.exr"); });
  file.layers[0].name = "";
  file.layers[0].channels = {"1", "2", "3"};
  expect_error(ErrorKind::refused, "neither R G B nor Y", [&] { color_image(file, "x.exr"); });
}

}  // namespace
}  // namespace vernier
