#pragma once

#include <bit>

#include "shader/shader.h"
#include "shader/tiny_scene.h"

namespace vernier::shader {
namespace {

/// Film words of the whole image: the trace kernel's text run on the CPU, with at most `ray_budget` rays at a time.
inline std::vector<std::uint32_t> film_on_cpu(const PackedScene& packed, const RenderSettings& settings,
                                              std::uint32_t ray_budget = 1u << 20) {
  Memory scene = memory_of(packed);
  const auto width = static_cast<std::uint32_t>(settings.width), height = static_cast<std::uint32_t>(settings.height);
  scene.film.assign(std::size_t{FILM_WORDS} * width * height, 0u);
  scene.paths.assign(std::size_t{PATH_WORDS(PATH_STACK_SIZE)} * width * height, 0u);
  DispatchConstants& dispatch = scene.dispatch;
  dispatch.tile_width = dispatch.band_width = width;
  dispatch.tile_height = height;
  dispatch.sample_begin = settings.sample_begin;
  dispatch.sample_end = settings.sample_end;
  dispatch.ray_budget = ray_budget;
  const BoundMemory bound(scene);
  do {
    scene.counters.assign(COUNTER_COUNT, 0u);
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) trace_pixel(x, y, y * width + x);
    }
    dispatch.resume = 1;
  } while (scene.counters[COUNTER_UNFINISHED] > 0);
  return scene.film;
}

}  // namespace
}  // namespace vernier::shader
