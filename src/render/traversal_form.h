#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "error.h"
#include "gpu/buffer.h"
#include "gpu/device.h"

namespace vernier {

/// How shaders read the scene's arrays: forms of one SPIR-V source (shaders/buffers.glsl).
enum class SceneLoads {
  texels,   ///< storage texel buffers: 4 times faster on llvmpipe, and not bound by maxStorageBufferRange
  storage,  ///< storage buffers: everywhere else
  queries   ///< the same, and the driver's tree in place of ours (shaders/query_boxes.glsl)
};

/// How rays find what they hit: how records are read, and where the stack of a search lies. No bit hangs on it.
enum class TraversalForm {
  automatic,        ///< as suits the device
  texels_shifted,   ///< texel loads; the stack in variables that all move with each push
  texels_array,     ///< texel loads; an array with an index
  storage_shifted,  ///< storage-buffer loads
  storage_array,
  ray_query  ///< the driver's own tree and traversal, our triangle test
};

/// All of them.
inline constexpr std::array kTraversalForms = {TraversalForm::automatic,     TraversalForm::texels_shifted,
                                               TraversalForm::texels_array,  TraversalForm::storage_shifted,
                                               TraversalForm::storage_array, TraversalForm::ray_query};

/// The form's name on the command line.
constexpr std::string_view to_string(TraversalForm form) {
  constexpr std::array<std::string_view, 6> kNames = {
      "auto", "texels-shifted", "texels-array", "storage-shifted", "storage-array", "ray-query"};
  return kNames[static_cast<std::size_t>(form)];
}

/// `form`, or what suits `device`: on llvmpipe texels-shifted, which measured best (src/README.md), elsewhere
/// storage-array.
constexpr TraversalForm resolve_form(const DeviceDescription& device, TraversalForm form) {
  if (form != TraversalForm::automatic) return form;
  return device.is_llvmpipe ? TraversalForm::texels_shifted : TraversalForm::storage_array;
}

/// How records are read on `device` by `form`.
constexpr SceneLoads choose_scene_loads(const DeviceDescription& device,
                                        TraversalForm form = TraversalForm::automatic) {
  const TraversalForm resolved = resolve_form(device, form);
  if (resolved == TraversalForm::ray_query) return SceneLoads::queries;
  const bool texels = resolved == TraversalForm::texels_shifted || resolved == TraversalForm::texels_array;
  return texels ? SceneLoads::texels : SceneLoads::storage;
}

/// Storage texel buffers that kernels with SceneLoads::texels bind (shaders/buffers.glsl).
constexpr std::uint32_t kTexelBuffers = 9;

/// Throws Error(refused) where `device` lacks what kernels with `loads` take.
inline void require_loads(const DeviceDescription& device, SceneLoads loads) {
  if (loads == SceneLoads::texels && device.max_storage_texel_buffers < kTexelBuffers) {
    throw Error(ErrorKind::refused, "device " + device.name + ": " + std::to_string(device.max_storage_texel_buffers) +
                                        " storage texel buffers for a shader, " + std::to_string(kTexelBuffers) +
                                        " are needed; try --traversal storage-array");
  }
  if (loads == SceneLoads::texels && !device.subgroup_ballot) {
    throw Error(ErrorKind::refused, "device " + device.name + ": no ballots of subgroups, which kernels that read " +
                                        "texels take; try --traversal storage-array");
  }
  if (loads == SceneLoads::queries && !device.ray_query) {
    throw Error(ErrorKind::refused,
                "device " + device.name + ": " + device.no_ray_query_reason + ", which --traversal ray-query takes");
  }
}

/// The use of a buffer that kernels store to and read back by `loads`.
constexpr BufferUse stored_use(SceneLoads loads) {
  return loads == SceneLoads::texels ? BufferUse::storage_and_texels : BufferUse::storage;
}

/// Whether the stack lies in shifted variables on `device` by `form`.
constexpr bool shifts_stack(const DeviceDescription& device, TraversalForm form) {
  const TraversalForm resolved = resolve_form(device, form);
  return resolved == TraversalForm::texels_shifted || resolved == TraversalForm::storage_shifted;
}

}  // namespace vernier
