#pragma once

#include <cstdint>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/compute_pipeline.h"
#include "render/pack_scene.h"
#include "render/traversal_form.h"

namespace vernier {

/// The scene on the device. Owns its buffers.
class GpuScene {
 public:
  /// Uploads `packed`. Throws Error(refused) with numbers when an array passes a limit of the device.
  GpuScene(const Device& device, const PackedScene& packed, SceneLoads loads);

  /// Its buffers with their binding numbers.
  std::vector<Binding> bindings() const;
  /// Memory in all.
  std::uint64_t size_bytes() const;
  /// Replaces the constants (camera, size, samples).
  void set_constants(const Device& device, const RenderConstants& constants, const SteeringConstants& steering);
  /// Replaces the words of the textures, as many as before (their filters).
  void set_textures(const Device& device, const std::vector<std::uint32_t>& words);
  /// Replaces the lights by as many others, in device layout.
  void set_lights(const Device& device, const std::vector<std::uint32_t>& lights);
  /// What every dispatch carries.
  const SteeringConstants& steering() const { return steering_; }

 private:
  SteeringConstants steering_{};
  Buffer constants_, records_, instances_, vertices_, materials_, lights_, textures_, texels_, first_triangles_;
};

}  // namespace vernier
