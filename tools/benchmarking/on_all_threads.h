#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

/// Calls trace(i) once for all i below `count`, on `thread_count` threads, each of which takes 4096 at once; returns when all
/// are done. Embree's rays are traced so.
template <typename Trace>
void on_all_threads(std::size_t count, unsigned thread_count, const Trace& trace) {
  constexpr std::size_t kChunk = 4096;
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t first; (first = next.fetch_add(kChunk)) < count;) {
      for (std::size_t i = first; i < std::min(first + kChunk, count); ++i) trace(i);
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 1; i < thread_count; ++i) threads.emplace_back(work);
  work();
}
