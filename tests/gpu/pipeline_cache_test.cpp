// Compiled pipelines on their way from one device to the next, through a file.
#include <filesystem>

#include "device_test.h"
#include "render/pipeline_file.h"
#include "temporary_folder.h"
#include "traced_film.h"

namespace vernier {
namespace {

namespace fs = std::filesystem;

class PipelineCacheTest : public DeviceTest {
 protected:
  std::string file() const { return folder_.file(device().description().pipeline_key + ".pipelines"); }

  static std::vector<std::uint32_t> film(const Device& device) {
    const RenderSettings settings = test::small_image(8, 8, 1);
    const Scene scene = test::tiny_scene();
    const Camera camera = test::camera_at(3.5);
    return traced_film(device, test::packed_for(scene, camera, settings), settings,
                       choose_scene_loads(device.description()), detect_effects(scene, camera, 8).bits);
  }

  TemporaryFolder folder_;
};

TEST_F(PipelineCacheTest, the_key_names_vendor_device_driver_and_uuid) {
  const std::string& key = device().description().pipeline_key;
  EXPECT_EQ(key.size(), 8u + 1 + 8 + 1 + 8 + 1 + 32) << key;
  EXPECT_EQ(key.find_first_not_of("0123456789abcdef-"), std::string::npos) << key;
}

TEST_F(PipelineCacheTest, a_device_takes_what_another_compiled) {
  std::vector<std::uint32_t> cold;
  {
    const CachedDevice first(instance(), device().description(), file());
    cold = film(first.device());
    const std::string note = first.store();
    EXPECT_NE(note.find("not there yet"), std::string::npos) << note;
    EXPECT_NE(note.find("bytes written"), std::string::npos) << note;
  }
  const StoredPipelines stored = read_pipelines(file(), device().description().pipeline_key);
  // Vulkan 1.3, VkPipelineCacheHeaderVersionOne: every driver's bytes begin with a header of 32.
  EXPECT_GE(stored.bytes.size(), 32u);
  const CachedDevice second(instance(), device().description(), file());
  EXPECT_EQ(film(second.device()), cold) << "the same pipelines, the same bits";
  const std::string note = second.store();
  EXPECT_NE(note.find("bytes read"), std::string::npos) << note;
}

TEST_F(PipelineCacheTest, a_damaged_file_is_compiled_anew_and_replaced) {
  write_pipelines(file(), device().description().pipeline_key, device().compiled_pipelines());
  fs::resize_file(file(), fs::file_size(file()) - 1);
  const CachedDevice opened(instance(), device().description(), file());
  const std::string note = opened.store();
  EXPECT_NE(note.find("cut short"), std::string::npos) << note;
  EXPECT_NE(note.find("bytes written"), std::string::npos) << note;
  EXPECT_FALSE(read_pipelines(file(), device().description().pipeline_key).bytes.empty());
}

TEST_F(PipelineCacheTest, bytes_that_the_driver_does_not_know_are_no_error) {
  // The file is whole, what it holds is not this driver's: that is the driver's to notice.
  std::vector<std::byte> strange = device().compiled_pipelines();
  for (std::size_t i = 16; i < strange.size(); ++i) strange[i] ^= std::byte{0x5a};
  write_pipelines(file(), device().description().pipeline_key, strange);
  const CachedDevice opened(instance(), device().description(), file());
  EXPECT_EQ(film(opened.device()), film(device()));
}

TEST_F(PipelineCacheTest, no_file_is_no_error) {
  const CachedDevice opened(instance(), device().description(), "");
  EXPECT_EQ(opened.store(), "no file of compiled pipelines");
}

}  // namespace
}  // namespace vernier
