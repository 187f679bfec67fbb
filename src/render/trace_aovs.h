#pragma once

#include "render/film.h"
#include "render/gpu_scene.h"
#include "render/render_statistics.h"
#include "render/trace_pipeline.h"

namespace vernier {

/// Writes the AOVs of every pixel of `film`, which has room for them. Returns what compiling its pipeline took.
/// Throws Error(device_lost).
PipelineTime trace_aovs(const Device& device, const GpuScene& scene, SceneLoads loads,
                        const TraceSpecialization& specialization, Film& film);

}  // namespace vernier
