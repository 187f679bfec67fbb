#pragma once

#include "ray_query_device.h"
#include "tracers.h"

namespace vernier {

/// The driver's own traversal, VK_KHR_ray_query, by device timestamps.
class RayQueryTracer {
 public:
  /// Has the driver build its tree over `mesh`, and puts `rays` beside it. The driver of `device`, which outlives the
  /// tracer, has ray queries.
  RayQueryTracer(const Device& device, const RawMesh& mesh, const RaySets& rays);

  /// One dispatch of all rays of `kind`.
  PassTime trace(RayKind kind);
  /// What the rays of `kind` meet.
  std::vector<RatedAnswer> answers(RayKind kind);

 private:
  struct Structure {
    AddressedBuffer memory;
    vk::raii::AccelerationStructureKHR built{nullptr};
  };
  Structure build(vk::AccelerationStructureTypeKHR type, const vk::AccelerationStructureGeometryKHR& geometry,
                  std::uint32_t count) const;
  void build_bottom(const RawMesh& mesh);
  void build_top();
  void make_layouts();
  vk::raii::Pipeline make_pipeline(bool any_hit) const;
  void bind(std::size_t kind);

  bool texels_;
  RayQueryDevice device_;
  Structure bottom_, top_;
  AddressedBuffer answers_;
  std::vector<AddressedBuffer> rays_;
  vk::raii::DescriptorSetLayout set_layout_{nullptr};
  vk::raii::PipelineLayout layout_{nullptr};
  vk::raii::Pipeline closest_{nullptr}, any_{nullptr};
  vk::raii::DescriptorPool pool_{nullptr};
  std::vector<vk::DescriptorSet> sets_;  // freed with their pool
};

}  // namespace vernier
