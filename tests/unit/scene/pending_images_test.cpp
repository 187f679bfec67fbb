#include "scene/pending_images.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <latch>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "error.h"
#include "math/parallel_for.h"

namespace vernier {
namespace {

using TexelsPointer = std::shared_ptr<const Texels>;

TexelsPointer texels(std::uint32_t word) {
  return std::make_shared<const Texels>(Texels{TEXTURE_FORMAT_SRGB8, 1, 1, {word}});
}

ImageJob job(std::uint32_t word, const std::string& file = "") {
  return {.decode = [word] { return texels(word); }, .file = file};
}

ImageJob broken_job(const std::string& fault) {
  return {.decode = [fault]() -> TexelsPointer { throw Error(ErrorKind::refused, fault); },
          .before_fault = "image 3: ",
          .after_fault = ", alas"};
}

/// Textures 0 to `count` - 1, each used by a slot of material 0; then one of the environment.
Scene textured_scene(PendingImages& images, std::vector<ImageJob> jobs) {
  Scene scene;
  Material& material = scene.materials.emplace_back();
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    scene.textures.push_back({"", {}, images.add(std::move(jobs[i]))});
    material.textures[i].texture = static_cast<int>(i);
  }
  scene.environment.texture = static_cast<int>(scene.textures.size()) - 1;
  return scene;
}

TEST(PendingImages, come_to_all_textures_that_use_them) {
  PendingImages images;
  EXPECT_TRUE(images.empty());
  Scene scene = textured_scene(images, {job(1, "b.png"), job(2, "a.png"), job(3)});
  EXPECT_FALSE(images.empty());
  scene.textures.push_back(scene.textures[1]);
  const Texture other = scene.textures.emplace_back(Texture{"", {}, texels(9)});
  EXPECT_EQ(scene.textures[0].texels->words, std::vector<std::uint32_t>{0xffffffffu}) << "stands for it";
  images.finish(scene);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(scene.textures[i].texels->words[0], i + 1);
  EXPECT_EQ(scene.textures[3].texels, scene.textures[1].texels);
  EXPECT_EQ(scene.textures[4].texels, other.texels);
  EXPECT_EQ(scene.files, (std::vector<std::string>{"b.png", "a.png"})) << "in the order of the scene";
  EXPECT_TRUE(images.empty());
  images.finish(scene);
  EXPECT_EQ(scene.textures[2].texels->words[0], 3u);
}

TEST(PendingImages, are_decoded_before_anybody_waits) {
  std::latch begun(1);
  PendingImages images;
  images.add({.decode = [&] {
    begun.count_down();
    return texels(1);
  }});
  begun.wait();
}

TEST(PendingImages, that_are_broken_are_told_of_and_materials_go_without) {
  PendingImages images;
  Scene scene = textured_scene(images, {job(1), broken_job("torn"), job(3)});
  images.finish(scene);
  EXPECT_EQ(scene.warnings, std::vector<std::string>{"image 3: torn, alas"});
  ASSERT_EQ(scene.textures.size(), 2u);
  EXPECT_EQ(scene.textures[1].texels->words[0], 3u);
  const auto& uses = scene.materials[0].textures;
  EXPECT_EQ(uses[0].texture, 0);
  EXPECT_EQ(uses[1].texture, -1);
  EXPECT_EQ(uses[2].texture, 1);
  EXPECT_EQ(uses[3].texture, -1);
  EXPECT_EQ(scene.environment.texture, 1);
}

TEST(PendingImages, a_thousand_broken_ones_are_a_hundred_warnings) {
  PendingImages images;
  Scene scene;
  // Each for two uses.
  for (int i = 0; i < 2000; ++i) images.add(broken_job("torn " + std::to_string(i / 2)));
  images.finish(scene);
  EXPECT_EQ(scene.warnings.size(), 101u);
  EXPECT_NE(scene.warnings.back(), scene.warnings.front());
}

TEST(PendingImages, the_first_failure_is_told_as_soon_as_it_is_known) {
  if (resolve_thread_count(0) < 2) return;  // one image after the other
  std::latch first_may_end(1), second_has_failed(1);
  PendingImages images;
  ImageJob needed = broken_job("first");
  needed.needed = true;
  needed.decode = [&]() -> TexelsPointer {
    first_may_end.wait();
    throw Error(ErrorKind::refused, "first");
  };
  images.add(needed);
  images.check_so_far();
  ImageJob failing;
  failing.decode = [&]() -> TexelsPointer {
    second_has_failed.count_down();
    throw Error(ErrorKind::failed, "second");
  };
  images.add(failing);
  second_has_failed.wait();
  images.check_so_far();  // the first may wait for what this thread has: it is not waited for
  first_may_end.count_down();
  std::string told;
  while (told.empty()) {
    try {
      images.check_so_far();
    } catch (const Error& error) {
      told = error.what();
    }
  }
  EXPECT_EQ(told, "image 3: first, alas");
}

TEST(PendingImages, that_are_needed_are_refused_where_broken) {
  PendingImages images;
  ImageJob needed = broken_job("torn");
  needed.needed = true;
  Scene scene = textured_scene(images, {job(1), needed});
  try {
    images.finish(scene);
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_STREQ(error.what(), "image 3: torn, alas");
  }
}

TEST(PendingImages, failures_that_are_not_the_image_s_pass) {
  for (const bool of_memory : {true, false}) {
    PendingImages images;
    ImageJob failing;
    failing.decode = [=]() -> TexelsPointer {
      if (of_memory) throw MemoryError("too large");
      throw Error(ErrorKind::failed, "no codecs");
    };
    Scene scene = textured_scene(images, {job(1), failing});
    EXPECT_THROW(images.finish(scene), Error);
    EXPECT_TRUE(scene.warnings.empty());
  }
}

TEST(PendingImages, that_nobody_waits_for_are_left_out) {
  std::atomic<int> begun = 0;
  {
    PendingImages images;
    for (int i = 0; i < 1000; ++i) {
      images.add({.decode = [&begun] {
        ++begun;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return texels(1);
      }});
    }
  }
  EXPECT_LT(begun, 1000);
}

}  // namespace
}  // namespace vernier
