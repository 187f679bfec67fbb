#include "render/trace_aovs.h"

#include <algorithm>

#include "render/tile_dispatch.h"
#include "render/tile_schedule.h"
#include "shared/bindings.h"

namespace vernier {

AovTracer::AovTracer(const Device& device, const GpuScene& scene, SceneLoads loads,
                     const TraceSpecialization& specialization, Film& film)
    : scene_(scene),
      film_(film),
      submitter_(device),
      tile_side_(tile_side(device.description().is_cpu)),
      dispatch_values_(dispatch_buffer(device)) {
  for (Film::Band& band : film.bands()) {
    std::vector<Binding> bindings = scene.bindings();
    bindings.insert(bindings.end(), {{BINDING_AOVS, &band.aovs}, {BINDING_DISPATCH, &dispatch_values_}});
    if (bindings_.empty()) {
      pipeline_ = make_trace_pipeline(device, Kernel::primary, loads, specialization, bindings);
    }
    bindings_.emplace_back(device, pipeline_, bindings);
  }
}

void AovTracer::trace(const PixelRect& area) {
  for (std::size_t index = 0; index < bindings_.size(); ++index) {
    const Film::Band& band = film_.bands()[index];
    const int row_count = std::min(band.row_count, area.height - band.first_row);
    if (row_count <= 0) return;
    const PixelRect rows{area.x, area.y + band.first_row, area.width, row_count};
    for (const PixelRect& tile : schedule_tiles(rows, glm::ivec2(tile_side_), rows.height)) {
      const DispatchConstants constants = tile_constants(scene_, tile, film_.area(), band);
      const Dispatch dispatch = tile_dispatch(pipeline_, bindings_[index], tile);
      submitter_.run(std::span(&dispatch, 1), {{upload_of(dispatch_values_, constants)}, {}});
    }
  }
}

PipelineTime trace_aovs(const Device& device, const GpuScene& scene, SceneLoads loads,
                        const TraceSpecialization& specialization, Film& film) {
  AovTracer tracer(device, scene, loads, specialization, film);
  tracer.trace(film.area());
  return {"primary", tracer.compile_ms()};
}

}  // namespace vernier
