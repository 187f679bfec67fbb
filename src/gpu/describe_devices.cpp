#include "gpu/describe_devices.h"

#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "error.h"

namespace vernier {
namespace {

std::string yes_no(bool value) {
  return value ? "yes" : "no";
}

std::string mebibytes(std::uint64_t bytes) {
  constexpr std::uint64_t kBytesPerMebibyte = std::uint64_t{1} << 20;
  return std::to_string(bytes / kBytesPerMebibyte) + " MiB";
}

void line(std::ostringstream& out, const std::string& label, const std::string& value) {
  constexpr int kLabelWidth = 34;
  out << "    " << std::left << std::setw(kLabelWidth) << label << value << "\n";
}

void describe_limits(std::ostringstream& out, const DeviceDescription& device) {
  line(out, "device memory", mebibytes(device.device_memory_bytes));
  line(out, "largest allocation", mebibytes(device.max_allocation_bytes));
  line(out, "largest storage buffer", mebibytes(device.max_storage_buffer_range_bytes));
  line(out, "texels of a texel buffer", std::to_string(device.max_texel_buffer_elements));
  line(out, "storage buffers of a shader", std::to_string(device.max_storage_buffers));
  line(out, "invocations of a workgroup", std::to_string(device.max_workgroup_invocations));
  line(out, "invocations of a subgroup", std::to_string(device.subgroup_size));
  line(out, "ray queries", yes_no(device.ray_query));
  std::ostringstream period;
  period << device.timestamp_period_ns << " ns";
  line(out, "timestamps", device.timestamp_bits > 0 ? period.str() : "none");
}

void describe_probe(std::ostringstream& out, const ProbeResult& probe) {
  line(out, "float64", yes_no(probe.float64));
  line(out, "fma() is fused", yes_no(probe.fma_is_fused));
  line(out, "a*b+c is fused",
       yes_no(probe.plain_sum_is_fused) + ", with precise " + yes_no(probe.precise_sum_is_fused));
  line(out, "two-sum keeps its error",
       yes_no(probe.two_sum_survives) + ", with precise " + yes_no(probe.precise_two_sum_survives));
  line(out, "denormals are kept",
       "by + " + yes_no(probe.denormals_kept_by_sum) + ", by * " + yes_no(probe.denormals_kept_by_product));
  line(out, "isnan() of a loaded NaN works", yes_no(probe.isnan_works));
  line(out, "min, max of NaN and a number", to_string(probe.min_of_nan) + ", " + to_string(probe.max_of_nan));
  std::ostringstream error;
  error << std::setprecision(3) << probe.max_division_error_ulps << " ulps at most";
  line(out, "division is off by", error.str());
}

nlohmann::json probe_json(const ProbeResult& probe) {
  return {{"float64", probe.float64},
          {"fma_is_fused", probe.fma_is_fused},
          {"plain_sum_is_fused", probe.plain_sum_is_fused},
          {"precise_sum_is_fused", probe.precise_sum_is_fused},
          {"two_sum_survives", probe.two_sum_survives},
          {"precise_two_sum_survives", probe.precise_two_sum_survives},
          {"denormals_kept_by_sum", probe.denormals_kept_by_sum},
          {"denormals_kept_by_product", probe.denormals_kept_by_product},
          {"isnan_works", probe.isnan_works},
          {"min_of_nan", to_string(probe.min_of_nan)},
          {"max_of_nan", to_string(probe.max_of_nan)},
          {"max_division_error_ulps", probe.max_division_error_ulps}};
}

nlohmann::json report_json(const DeviceReport& report) {
  const DeviceDescription& device = report.device;
  return {{"index", device.index},
          {"name", device.name},
          {"kind", device.kind},
          {"driver", device.driver},
          {"api_version", device.api_version},
          {"usable", device.usable},
          {"unusable_reason", device.unusable_reason},
          {"is_cpu", device.is_cpu},
          {"is_llvmpipe", device.is_llvmpipe},
          {"ray_query", device.ray_query},
          {"float64", device.float64},
          {"device_memory_bytes", device.device_memory_bytes},
          {"max_allocation_bytes", device.max_allocation_bytes},
          {"max_storage_buffer_range_bytes", device.max_storage_buffer_range_bytes},
          {"max_texel_buffer_elements", device.max_texel_buffer_elements},
          {"max_storage_buffers", device.max_storage_buffers},
          {"max_workgroup_invocations", device.max_workgroup_invocations},
          {"subgroup_size", device.subgroup_size},
          {"timestamps", device.timestamp_bits > 0},
          {"timestamp_period_ns", device.timestamp_period_ns},
          {"probe", report.probe ? probe_json(*report.probe) : nlohmann::json(nullptr)},
          {"probe_failure", report.probe_failure}};
}

}  // namespace

std::vector<DeviceReport> report_devices(const VulkanInstance& instance) {
  std::vector<DeviceReport> out;
  for (const DeviceDescription& description : list_devices(instance)) {
    DeviceReport report{description, std::nullopt, ""};
    try {
      if (description.usable) report.probe = probe_device(Device(instance, description));
    } catch (const Error& error) {
      report.probe_failure = error.what();
    }
    out.push_back(std::move(report));
  }
  return out;
}

std::string describe_devices(std::span<const DeviceReport> reports) {
  if (reports.empty()) return "There is no Vulkan device.\n";
  std::ostringstream out;
  for (const DeviceReport& report : reports) {
    const DeviceDescription& device = report.device;
    out << device.index << "   " << device.name << "\n";
    line(out, "kind", device.kind);
    line(out, "driver", device.driver);
    line(out, "Vulkan", device.api_version);
    line(out, "usable", device.usable ? "yes" : "no: " + device.unusable_reason);
    describe_limits(out, device);
    if (report.probe) describe_probe(out, *report.probe);
    if (!report.probe_failure.empty()) line(out, "the probe failed", report.probe_failure);
  }
  return out.str();
}

nlohmann::json devices_json(std::span<const DeviceReport> reports) {
  nlohmann::json devices = nlohmann::json::array();
  for (const DeviceReport& report : reports) devices.push_back(report_json(report));
  return {{"schema", 1}, {"devices", devices}};
}

}  // namespace vernier
