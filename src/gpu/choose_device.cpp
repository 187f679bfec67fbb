#include <algorithm>
#include <cctype>
#include <charconv>
#include <tuple>

#include "error.h"
#include "gpu/device.h"
#include "gpu/vector_width.h"

namespace vernier {
namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// Smaller is better.
std::tuple<int, int, int> preference(const DeviceDescription& device) {
  const std::vector<std::string> order{"discrete GPU", "integrated GPU", "virtual GPU", "CPU"};
  const auto place = static_cast<int>(std::find(order.begin(), order.end(), device.kind) - order.begin());
  return {place, device.is_cpu && !device.is_llvmpipe ? 1 : 0, device.index};
}

std::string listing(const std::vector<DeviceDescription>& devices) {
  if (devices.empty()) return "there is no Vulkan device";
  std::string out = "there is ";
  for (const DeviceDescription& device : devices) {
    if (&device != &devices.front()) out += ", ";
    out += std::to_string(device.index) + ": " + device.name;
    if (!device.usable) out += " (not usable: " + device.unusable_reason + ")";
  }
  return out;
}

const DeviceDescription* best_usable(const std::vector<DeviceDescription>& devices, const std::string& selector) {
  const std::string name_part = lower_case(without_vector_width(selector));
  // A whole name first: recipes hold it, and it may be a part of another's.
  const auto rank = [&](const DeviceDescription& device) {
    return std::tuple(lower_case(device.name) != name_part, preference(device));
  };
  const DeviceDescription* best = nullptr;
  for (const DeviceDescription& device : devices) {
    if (!device.usable || lower_case(device.name).find(name_part) == std::string::npos) continue;
    if (best == nullptr || rank(device) < rank(*best)) best = &device;
  }
  return best;
}

}  // namespace

DeviceDescription choose_device(const std::vector<DeviceDescription>& devices, const std::string& selector) {
  const DeviceDescription* chosen = nullptr;
  int index = 0;
  const char* end = selector.data() + selector.size();
  const auto [stop, fault] = std::from_chars(selector.data(), end, index);
  if (!selector.empty() && fault == std::errc() && stop == end) {
    const auto found = std::find_if(devices.begin(), devices.end(),
                                    [&](const DeviceDescription& device) { return device.index == index; });
    if (found != devices.end() && found->usable) chosen = &*found;
  } else {
    chosen = best_usable(devices, selector);
  }
  if (chosen != nullptr) return *chosen;
  const std::string asked = selector.empty() ? "no usable device" : "device \"" + selector + "\": none such is usable";
  throw Error(ErrorKind::no_device, asked + "; " + listing(devices));
}

}  // namespace vernier
