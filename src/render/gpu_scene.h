#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/compute_pipeline.h"
#include "gpu/driver_tree.h"
#include "render/pack_scene.h"
#include "render/traversal_form.h"

namespace vernier {

/// The driver's tree over `records`, which are triangles, for rays whose origins have coordinates up to `reach`. Boxes
/// are wider than the triangles by 2^-19 of what lies between them and the farthest origin.
DriverTree driver_tree(const Device& device, std::span<const BvhRecord> records, float reach);

/// The scene on the device. Owns its buffers.
class GpuScene {
 public:
  /// Uploads `packed`, whose records are triangles alone for SceneLoads::queries (pack_scene). Throws Error(refused)
  /// with numbers when an array passes a limit of the device.
  GpuScene(const Device& device, const PackedScene& packed, SceneLoads loads);

  /// Its buffers with their binding numbers.
  std::vector<Binding> bindings() const;
  /// Memory in all.
  std::uint64_t size_bytes() const;
  /// Replaces the constants (camera, size, samples), and with SceneLoads::queries the driver's tree, when there is none
  /// yet or its boxes are too tight for rays from that camera.
  void set_constants(const Device& device, const RenderConstants& constants, const SteeringConstants& steering);
  /// Replaces the words of the textures, as many as before (their filters).
  void set_textures(const Device& device, const std::vector<std::uint32_t>& words);
  /// Replaces the lights by as many others, in device layout.
  void set_lights(const Device& device, const std::vector<std::uint32_t>& lights);
  /// What every dispatch carries.
  const SteeringConstants& steering() const { return steering_; }

 private:
  void build_tree(const Device& device, float reach);

  SceneLoads loads_;
  SteeringConstants steering_{};
  std::optional<DriverTree> tree_;
  float tree_reach_ = 0.0f;  // of the tree
  Buffer constants_, records_, instances_, vertices_, materials_, lights_, textures_, texels_, first_triangles_;
  Buffer srgb_curve_;  // with texel loads
};

}  // namespace vernier
