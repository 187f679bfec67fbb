#include "render/trace_aovs.h"

#include <optional>

#include "render/tile_dispatch.h"
#include "render/tile_schedule.h"
#include "shared/bindings.h"

namespace vernier {

PipelineTime trace_aovs(const Device& device, const GpuScene& scene, SceneLoads loads,
                        const TraceSpecialization& specialization, Film& film) {
  Submitter submitter(device);
  const Buffer unused(device, 0, BufferUse::storage);
  Buffer dispatch_values = dispatch_buffer(device);
  std::optional<ComputePipeline> pipeline;
  for (Film::Band& band : film.bands()) {
    std::vector<Binding> bindings = scene.bindings();
    bindings.insert(bindings.end(), {{BINDING_FILM, &unused},
                                     {BINDING_COUNTERS, &unused},
                                     {BINDING_PATHS, &unused},
                                     {BINDING_AOVS, &band.aovs},
                                     {BINDING_DISPATCH, &dispatch_values}});
    if (!pipeline) pipeline = make_trace_pipeline(device, Kernel::primary, loads, specialization, bindings);
    const BindingSet set(device, *pipeline, bindings);
    const PixelRect rows{film.area().x, film.area().y + band.first_row, film.area().width, band.row_count};
    for (const PixelRect& tile : schedule_tiles(rows, glm::ivec2(kTile), rows.height)) {
      set_dispatch(dispatch_values, tile_constants(scene, tile, film.area(), band));
      const Dispatch dispatch = tile_dispatch(*pipeline, set, tile);
      submitter.run(std::span(&dispatch, 1));
    }
  }
  return {"primary", pipeline ? pipeline->compile_ms() : 0.0};
}

}  // namespace vernier
