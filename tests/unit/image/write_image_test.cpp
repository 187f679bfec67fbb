#include "image/write_image.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "expect_error.h"
#include "file_size_limit.h"
#include "image/read_image.h"
#include "image/srgb_curve.h"
#include "sample_image.h"
#include "temporary_folder.h"

namespace vernier {
namespace {

constexpr const char* kExtensions[] = {".exr", ".png", ".jpg", ".hdr", ".tif"};

const std::vector<float>& floats(const Layer& layer) {
  return std::get<std::vector<float>>(layer.values);
}

TEST(WriteImage, ExrGivesBackEverything) {
  const TemporaryFolder folder;
  const ImageFile image = sample_image();
  write_image(folder.file("x.exr"), image, {});
  EXPECT_EQ(folder.entry_count(), 1);
  const ImageFile read = read_image(folder.file("x.exr"));
  EXPECT_EQ(read.width, image.width);
  EXPECT_EQ(read.height, image.height);
  EXPECT_EQ(read.x, image.x);
  EXPECT_EQ(read.y, image.y);
  EXPECT_EQ(read.full_width, image.full_width);
  EXPECT_EQ(read.full_height, image.full_height);
  EXPECT_EQ(read.metadata, image.metadata);
  ASSERT_EQ(read.layers.size(), image.layers.size());
  for (std::size_t i = 0; i < image.layers.size(); ++i) {
    EXPECT_EQ(read.layers[i].name, image.layers[i].name);
    EXPECT_EQ(read.layers[i].channels, image.layers[i].channels);
    EXPECT_EQ(read.layers[i].values, image.layers[i].values);
  }
}

TEST(WriteImage, ExrAndTiffKeepEveryBitOfNonFiniteValues) {
  const TemporaryFolder folder;
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<float> values = {std::numeric_limits<float>::quiet_NaN(),  infinity, -infinity,
                                     std::numeric_limits<float>::denorm_min(), -0.0f,    1e30f};
  ImageFile image;
  image.width = image.full_width = 2;
  image.height = image.full_height = 1;
  image.layers = {{"", {"R", "G", "B"}, values}};
  for (const char* name : {"x.exr", "x.tif"}) {
    write_image(folder.file(name), image, {});
    const ImageFile read = read_image(folder.file(name));
    ASSERT_EQ(floats(read.layers[0]).size(), values.size());
    EXPECT_EQ(std::memcmp(floats(read.layers[0]).data(), values.data(), values.size() * sizeof(float)), 0) << name;
  }
}

TEST(WriteImage, EqualImagesMakeEqualBytesAtAnyTime) {
  const TemporaryFolder folder;
  for (const std::string extension : kExtensions) write_image(folder.file("a" + extension), sample_image(), {});
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // longer than the seconds that headers count in
  for (const std::string extension : kExtensions) {
    write_image(folder.file("b" + extension), sample_image(), {});
    EXPECT_FALSE(bytes_of_file(folder.file("a" + extension)).empty());
    EXPECT_EQ(bytes_of_file(folder.file("a" + extension)), bytes_of_file(folder.file("b" + extension))) << extension;
  }
}

TEST(WriteImage, PngHoldsTheRoundedCurve) {
  const TemporaryFolder folder;
  ImageFile image = sample_image();
  image.layers.resize(1);
  write_image(folder.file("x.png"), image, DisplayTransform{-1.0f});
  const ImageFile read = read_image(folder.file("x.png"));
  ASSERT_EQ(read.layers[0].channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ(read.metadata, image.metadata);
  for (std::size_t pixel = 0; pixel < static_cast<std::size_t>(image.width * image.height); ++pixel)
    for (std::size_t c = 0; c < 3; ++c) {
      const double linear = std::min(floats(image.layers[0])[pixel * 4 + c] * 0.5, 1.0);
      const double code = srgb_from_linear(floats(read.layers[0])[pixel * 3 + c]);
      EXPECT_EQ(std::lround(code * 255.0), std::lround(srgb_from_linear(linear) * 255.0));
    }
}

TEST(WriteImage, JpegIsCloseAndKeepsMetadata) {
  const TemporaryFolder folder;
  ImageFile image = sample_image();
  std::get<std::vector<float>>(image.layers[0].values).assign(image.width * image.height * 4, 0.5f);
  write_image(folder.file("x.jpeg"), image, {});
  const ImageFile read = read_image(folder.file("x.jpeg"));
  EXPECT_EQ(read.metadata, image.metadata);
  // A constant block survives all but the rounding of its mean: one step of 1/255 is below 0.008 linear at 0.5.
  for (const float value : floats(read.layers[0])) EXPECT_NEAR(value, 0.5f, 0.008f);
}

TEST(WriteImage, JpegLeavesOutMetadataThatDoNotFit) {
  const TemporaryFolder folder;
  ImageFile image = sample_image();
  image.metadata = {{"vernier:recipe", std::string(70000, 'x')}};
  write_image(folder.file("x.jpg"), image, {});
  EXPECT_TRUE(read_image(folder.file("x.jpg")).metadata.empty());
  image.metadata = {{"vernier:recipe", std::string(59000, 'x')}};
  write_image(folder.file("x.jpg"), image, {});
  EXPECT_EQ(read_image(folder.file("x.jpg")).metadata, image.metadata);
}

TEST(WriteImage, HdrIsWithinHalfAStepOfItsMantissa) {
  const TemporaryFolder folder;
  const ImageFile image = sample_image();
  write_image(folder.file("x.hdr"), image, {});
  const ImageFile read = read_image(folder.file("x.hdr"));
  for (std::size_t pixel = 0; pixel < static_cast<std::size_t>(image.width * image.height); ++pixel) {
    const float* written = floats(image.layers[0]).data() + pixel * 4;
    const float largest = std::max({written[0], written[1], written[2]});
    // The largest channel has at least 128 of 256 steps; the codec cuts off instead of rounding: one step.
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(floats(read.layers[0])[pixel * 3 + c], written[c], largest / 128.0f) << pixel;
  }
}

TEST(WriteImage, OtherFormatsGetAFilePerLayer) {
  const TemporaryFolder folder;
  const ImageFile image = sample_image();
  write_image(folder.file("x.tif"), image, {});
  EXPECT_EQ(folder.entry_count(), 4);
  EXPECT_EQ(read_image(folder.file("x.tif")).layers[0].values, image.layers[0].values);
  EXPECT_EQ(read_image(folder.file("x.depth.tif")).layers[0].values, image.layers[1].values);
  EXPECT_EQ(read_image(folder.file("x.normal.tif")).layers[0].values, image.layers[2].values);
  EXPECT_EQ(read_image(folder.file("x.object_id.tif")).layers[0].values, image.layers[3].values);
  std::map<std::string, std::string> of_layer = image.metadata;
  of_layer["vernier:layer"] = "object_id";
  EXPECT_EQ(read_image(folder.file("x.object_id.tif")).metadata, of_layer);
}

TEST(WriteImage, AFullDiskIsAnErrorInEveryFormat) {
  const TemporaryFolder folder;
  ImageFile image = sample_image();
  image.layers.resize(1);
  for (const std::string extension : kExtensions)
    for (const rlim_t bytes : {0, 100, 400}) {
      const std::string path = folder.file("x" + extension);
      const FileSizeLimit limit(bytes);
      expect_error(ErrorKind::failed, path + ": cannot write: File too large", [&] { write_image(path, image, {}); });
    }
  EXPECT_EQ(folder.entry_count(), 0);
}

TEST(WriteImage, AMissingFolderIsAnError) {
  const TemporaryFolder folder;
  for (const std::string extension : kExtensions)
    expect_error(ErrorKind::failed, "No such file or directory",
                 [&] { write_image(folder.file("none/x" + extension), sample_image(), {}); });
}

TEST(WriteImage, RefusesWhatItCannotWrite) {
  const TemporaryFolder folder;
  const std::string path = folder.file("x.exr");
  expect_error(ErrorKind::usage, "possible are .exr .png", [] { write_image("x.bmp", sample_image(), {}); });
  expect_error(ErrorKind::usage, "possible are", [] { write_image("noextension", sample_image(), {}); });
  expect_error(ErrorKind::usage, "exposure", [&] { write_image(path, sample_image(), DisplayTransform{NAN}); });
  ImageFile image = sample_image();
  image.layers[2].channels = {"X", "Y"};
  expect_error(ErrorKind::failed, "layer 'normal': has 2331 values", [&] { write_image(path, image, {}); });
  image = sample_image();
  image.layers.push_back(image.layers[1]);
  expect_error(ErrorKind::failed, "channel depth.Z is there twice", [&] { write_image(path, image, {}); });
  image.layers.clear();
  expect_error(ErrorKind::failed, "no layers", [&] { write_image(path, image, {}); });
  expect_error(ErrorKind::failed, "no pixels", [&] { write_image(path, ImageFile{}, {}); });
  EXPECT_EQ(folder.entry_count(), 0);
}

TEST(WriteImage, UnderstandsExtensionsInCapitals) {
  const TemporaryFolder folder;
  write_image(folder.file("x.PNG"), sample_image(), {});
  EXPECT_EQ(bytes_of_file(folder.file("x.PNG")).substr(1, 3), "PNG");
}

TEST(LayerPath, PutsTheLayerBeforeTheExtension) {
  EXPECT_EQ(layer_path("out/a.b.png", "depth"), "out/a.b.depth.png");
  EXPECT_EQ(layer_path("a.png", ""), "a.png");
}

}  // namespace
}  // namespace vernier
