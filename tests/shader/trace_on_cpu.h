#pragma once

#include <algorithm>
#include <bit>

#include "shader/job_count.h"
#include "shader/shader.h"
#include "shader/tiny_scene.h"

namespace vernier::shader {
namespace {

/// Film words of the whole image: the kernels' text run on the CPU by `invocations` in turn, with at most
/// `search_budget` searches each and `jobs` in all at a time.
inline std::vector<std::uint32_t> film_on_cpu(const PackedScene& packed, const RenderSettings& settings,
                                              std::uint32_t search_budget = 1u << 20, std::uint32_t invocations = 3,
                                              std::uint32_t jobs = 1u << 20) {
  Memory scene = memory_of(packed);
  const auto width = static_cast<std::uint32_t>(settings.width), height = static_cast<std::uint32_t>(settings.height);
  DispatchConstants& dispatch = scene.dispatch;
  dispatch.tile_width = dispatch.band_width = width;
  dispatch.tile_height = height;
  dispatch.sample_begin = settings.sample_begin;
  dispatch.sample_end = settings.sample_end;
  dispatch.search_budget = search_budget;
  dispatch.search_limit = search_budget;
  const BoundMemory bound(scene);
  scene.film.assign(std::size_t{FILM_WORDS} * width * height, 0u);
  scene.paths.assign(std::size_t{PATH_BLOCKS(PATH_STACK_SIZE)} * invocations, uvec4(0u));
  scene.samples.assign(std::size_t{SAMPLE_BLOCKS(COUNT_COST)} * job_count(), uvec4(0u));
  do {
    const std::uint32_t next_job = scene.counters[COUNTER_NEXT_JOB];
    scene.counters.assign(COUNTER_COUNT, 0u);
    scene.counters[COUNTER_NEXT_JOB] = next_job;
    dispatch.job_end = std::min(next_job + jobs, job_count());
    for (std::uint32_t i = 0; i < invocations; ++i) trace_jobs(i);
    scene.counters[COUNTER_NEXT_JOB] = std::min(scene.counters[COUNTER_NEXT_JOB], dispatch.job_end);
    dispatch.resume = 1;
  } while (scene.counters[COUNTER_UNFINISHED] > 0 || scene.counters[COUNTER_NEXT_JOB] < job_count());
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) accumulate_samples(x, y, first_job_of(x, y));
  }
  return scene.film;
}

}  // namespace
}  // namespace vernier::shader
