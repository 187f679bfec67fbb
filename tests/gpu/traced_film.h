#pragma once

#include "effects/detect_effects.h"
#include "render/trace_film.h"
#include "shader/tiny_scene.h"

namespace vernier {

/// Film words of `packed` on `device`, through the renderer's own loop, with kernels for `workflows` instead of those
/// of its materials, and with the stack of `form`.
inline std::vector<std::uint32_t> traced_film(const Device& device, const PackedScene& packed,
                                              const RenderSettings& settings, SceneLoads loads, std::uint32_t effects,
                                              std::optional<std::uint32_t> workflows = {},
                                              TraversalForm form = TraversalForm::automatic) {
  GpuScene scene(device, packed, loads);
  scene.set_constants(device, packed.constants, packed.steering);
  SceneShape shape = shape_of(packed);
  shape.workflows = workflows.value_or(shape.workflows);
  const TraceSpecialization specialization =
      specialize(effects, shape, settings.max_bounces, false, device.description(), form);
  Film film(device, settings.crop.value_or(PixelRect{0, 0, settings.width, settings.height}), false);
  FilmTracer(device, scene, loads, specialization, settings, film).trace({});
  return film.read_sums(device);
}

}  // namespace vernier
