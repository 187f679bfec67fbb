#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "gpu/probe_device.h"

namespace vernier {

/// A device and what the probe found on it; without probe where the device is not usable or the probe failed.
struct DeviceReport {
  DeviceDescription device;
  std::optional<ProbeResult> probe;
  std::string probe_failure;  ///< why there is no probe of a usable device; else empty
};

/// Lists all devices of `instance` in the loader's order and probes the usable ones. A probe that fails is reported in
/// its place and stops nothing. Throws Error(no_device) when the devices cannot be listed.
std::vector<DeviceReport> report_devices(const VulkanInstance& instance);

/// A paragraph per device for people: names, driver, limits, findings. No devices give one line that says so.
std::string describe_devices(std::span<const DeviceReport> reports);

/// {"schema": 1, "devices": [...]} with the fields of DeviceDescription, and of ProbeResult under "probe" (null
/// without).
nlohmann::json devices_json(std::span<const DeviceReport> reports);

}  // namespace vernier
