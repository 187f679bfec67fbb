#include "gpu/describe_devices.h"

#include <nlohmann/json.hpp>

#include "device_test.h"

namespace vernier {
namespace {

class DescribeDevicesTest : public DeviceTest {};

DeviceReport made_up_report() {
  DeviceReport report;
  report.device.index = 3;
  report.device.name = "Made up";
  report.device.kind = "other";
  report.device.unusable_reason = "no scalar block layout";
  report.device.max_texel_buffer_elements = 65536;
  return report;
}

TEST(DescribeDevices, no_device_is_said) {
  EXPECT_EQ(describe_devices({}), "There is no Vulkan device.\n");
  EXPECT_EQ(devices_json({}), (nlohmann::json{{"schema", 1}, {"devices", nlohmann::json::array()}}));
}

TEST(DescribeDevices, an_unusable_device_has_a_reason_and_no_probe) {
  const std::vector<DeviceReport> reports{made_up_report()};
  const std::string text = describe_devices(reports);
  EXPECT_TRUE(text.starts_with("3   Made up\n")) << text;
  EXPECT_NE(text.find("no: no scalar block layout"), std::string::npos) << text;
  EXPECT_EQ(text.find("fma"), std::string::npos);
  const nlohmann::json json = devices_json(reports);
  EXPECT_EQ(json["devices"][0]["index"], 3);
  EXPECT_EQ(json["devices"][0]["max_texel_buffer_elements"], 65536);
  EXPECT_FALSE(json["devices"][0]["usable"]);
  EXPECT_TRUE(json["devices"][0]["probe"].is_null());
}

TEST_F(DescribeDevicesTest, the_driver_of_this_test_is_probed) {
  const std::vector<DeviceReport> reports = report_devices(instance());
  ASSERT_GT(reports.size(), static_cast<std::size_t>(device().description().index));
  const DeviceReport& report = reports[static_cast<std::size_t>(device().description().index)];
  EXPECT_EQ(report.device.name, device().description().name);
  ASSERT_TRUE(report.probe.has_value()) << report.probe_failure;
  EXPECT_TRUE(report.probe_failure.empty());
  const std::string text = describe_devices(reports);
  EXPECT_NE(text.find(report.device.name), std::string::npos) << text;
  EXPECT_NE(text.find("fma() is fused"), std::string::npos) << text;
  const nlohmann::json json = devices_json(reports)["devices"][static_cast<std::size_t>(report.device.index)];
  EXPECT_EQ(json["probe"]["fma_is_fused"], report.probe->fma_is_fused);
  EXPECT_EQ(json["max_storage_buffer_range_bytes"], report.device.max_storage_buffer_range_bytes);
  RecordProperty("devices", text);
}

}  // namespace
}  // namespace vernier
