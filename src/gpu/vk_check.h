#pragma once

#include <string>
#include <utility>
#include <vulkan/vulkan_raii.hpp>

#include "error.h"

namespace vernier {

/// Runs `call` and turns a Vulkan failure into an Error that says `what` was being done: device loss becomes
/// Error(device_lost), out of memory and all else Error(failed).
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
