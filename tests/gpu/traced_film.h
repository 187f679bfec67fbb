#pragma once

#include "effects/detect_effects.h"
#include "render/trace_film.h"
#include "shader/tiny_scene.h"

namespace vernier {

/// Film words of `packed` on `device`, through the renderer's own loop.
inline std::vector<std::uint32_t> traced_film(const Device& device, const PackedScene& packed,
                                              const RenderSettings& settings, SceneLoads loads, std::uint32_t effects) {
  GpuScene scene(device, packed, loads);
  scene.set_constants(device, packed.constants, packed.steering);
  const TraceSpecialization specialization =
      specialize(effects, shape_of(packed.bvh), settings.max_bounces, false, device.description());
  Film film(device, settings.crop.value_or(PixelRect{0, 0, settings.width, settings.height}), false);
  FilmTracer(device, scene, loads, specialization, settings, film).trace({});
  return film.read_sums(device);
}

}  // namespace vernier
