#include <gtest/gtest.h>

#include "device_test.h"

namespace vernier {
namespace {

class ChooseDeviceTest : public DeviceTest {};

DeviceDescription made_up(int index, const std::string& name, const std::string& kind) {
  DeviceDescription out;
  out.index = index;
  out.name = name;
  out.kind = kind;
  out.usable = true;
  out.is_cpu = kind == "CPU";
  out.is_llvmpipe = name.starts_with("llvmpipe");
  return out;
}

std::vector<DeviceDescription> made_up_devices() {
  return {made_up(0, "SwiftShader Device", "CPU"), made_up(1, "llvmpipe (LLVM 15)", "CPU"),
          made_up(2, "Iris Xe", "integrated GPU"), made_up(3, "Fast Card A", "discrete GPU"),
          made_up(4, "Fast Card B", "discrete GPU")};
}

std::string error_of(const std::vector<DeviceDescription>& devices, const std::string& selector) {
  try {
    choose_device(devices, selector);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::no_device);
    return error.what();
  }
  ADD_FAILURE() << "\"" << selector << "\" was found";
  return "";
}

TEST(ChooseDevice, the_best_kind_and_the_lower_index_win) {
  std::vector<DeviceDescription> devices = made_up_devices();
  EXPECT_EQ(choose_device(devices, "").index, 3);
  devices[3].usable = false;
  EXPECT_EQ(choose_device(devices, "").index, 4);
  devices[4].usable = false;
  EXPECT_EQ(choose_device(devices, "").index, 2);
  devices[2].kind = "other";
  EXPECT_EQ(choose_device(devices, "").index, 1) << "llvmpipe comes before other CPU devices";
  EXPECT_EQ(choose_device(devices, "llvmpipe (LLVM 15, 256 bits)").index, 1) << "as a recipe of another width says";
  devices[1].usable = false;
  EXPECT_EQ(choose_device(devices, "").index, 0);
}

TEST(ChooseDevice, a_number_is_an_index) {
  EXPECT_EQ(choose_device(made_up_devices(), "0").index, 0);
  EXPECT_EQ(choose_device(made_up_devices(), "4").index, 4);
}

TEST(ChooseDevice, other_text_is_a_part_of_the_name_in_any_case) {
  EXPECT_EQ(choose_device(made_up_devices(), "SWIFT").index, 0);
  EXPECT_EQ(choose_device(made_up_devices(), "card b").index, 4);
  EXPECT_EQ(choose_device(made_up_devices(), "card").index, 3);
}

TEST(ChooseDevice, a_whole_name_comes_before_a_part_of_another) {
  const std::vector<DeviceDescription> devices = {made_up(0, "Card 3080 Ti", "discrete GPU"),
                                                  made_up(1, "Card 3080", "discrete GPU")};
  EXPECT_EQ(choose_device(devices, "card 3080").index, 1);
  EXPECT_EQ(choose_device(devices, "Card 3080 Ti").index, 0);
  EXPECT_EQ(choose_device(devices, "card 308").index, 0);
}

TEST(ChooseDevice, the_error_lists_what_there_is) {
  std::vector<DeviceDescription> devices = made_up_devices();
  devices[2].usable = false;
  devices[2].unusable_reason = "Vulkan 1.1.0, 1.2 is needed";
  for (const char* selector : {"5", "-1", "nothing like it", "2", "99999999999999999999"}) {
    const std::string line = error_of(devices, selector);
    EXPECT_NE(line.find(selector), std::string::npos) << line;
    EXPECT_NE(line.find("1: llvmpipe (LLVM 15)"), std::string::npos) << line;
    EXPECT_NE(line.find("2: Iris Xe (not usable: Vulkan 1.1.0, 1.2 is needed)"), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
  EXPECT_NE(error_of({}, "").find("there is no Vulkan device"), std::string::npos);
}

TEST_F(ChooseDeviceTest, the_driver_of_this_test_is_found_and_described) {
  const std::vector<DeviceDescription> devices = list_devices(instance());
  const DeviceDescription& found = device().description();
  EXPECT_NE(found.name.find(expected_device_name()), std::string::npos);
  EXPECT_TRUE(found.usable);
  EXPECT_TRUE(found.unusable_reason.empty());
  EXPECT_EQ(choose_device(devices, std::to_string(found.index)).name, found.name);
  EXPECT_FALSE(found.driver.empty());
  EXPECT_GE(found.api_version, "1.2");
  // The least that Vulkan 1.2 allows (Required Limits).
  EXPECT_GE(found.max_storage_buffer_range_bytes, std::uint64_t{1} << 27);
  EXPECT_GE(found.max_texel_buffer_elements, 65536U);
  EXPECT_GE(found.max_allocation_bytes, std::uint64_t{1} << 30);
  EXPECT_GE(found.max_workgroup_invocations, 128U);
  EXPECT_GE(found.max_storage_buffers, 4U);
  EXPECT_GT(found.device_memory_bytes, 0U);
  EXPECT_GE(found.subgroup_size, 1U);
  EXPECT_EQ(found.is_llvmpipe, found.name.starts_with("llvmpipe"));
}

TEST_F(ChooseDeviceTest, opening_an_unusable_device_says_why) {
  DeviceDescription broken = device().description();
  broken.usable = false;
  broken.unusable_reason = "no compute queue";
  try {
    const Device opened(instance(), broken);
    ADD_FAILURE() << "opened";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::no_device);
    EXPECT_NE(std::string(error.what()).find("no compute queue"), std::string::npos);
  }
}

}  // namespace
}  // namespace vernier
