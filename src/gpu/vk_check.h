#pragma once

#include <string>
#include <utility>
#include <vulkan/vulkan_raii.hpp>

#include "error.h"
#include "gpu/device.h"

namespace vernier {

/// See gpu/device.h.
template <typename Call>
decltype(auto) vk_check(const char* what, Call&& call) {
  try {
    return std::forward<Call>(call)();
  } catch (const vk::DeviceLostError&) {
    throw Error(ErrorKind::device_lost, std::string(what) + ": the device was lost");
  } catch (const vk::OutOfDeviceMemoryError&) {
    throw Error(ErrorKind::failed, std::string(what) + ": out of device memory");
  } catch (const vk::OutOfHostMemoryError&) {
    throw Error(ErrorKind::failed, std::string(what) + ": out of host memory");
  } catch (const vk::SystemError& error) {
    throw Error(ErrorKind::failed, std::string(what) + ": " + error.what());
  }
}

}  // namespace vernier
