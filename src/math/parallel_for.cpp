#include "math/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace vernier {

unsigned resolve_thread_count(unsigned thread_count) {
  return std::max(1u, thread_count == 0 ? std::thread::hardware_concurrency() : thread_count);
}

void parallel_for(unsigned thread_count, std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto run = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        work(i);
      }
    } catch (...) {
      const std::scoped_lock lock(failure_mutex);
      next = count;
      failure = failure ? failure : std::current_exception();
    }
  };
  std::vector<std::jthread> threads;
  try {
    const std::size_t wanted = std::min<std::size_t>(thread_count, count);
    for (std::size_t i = 1; i < wanted; ++i) {
      threads.emplace_back(run);
    }
  } catch (const std::system_error&) {
    // No more threads to be had: those that run, and this one, share the work.
  }
  run();
  threads.clear();
  if (failure) {
    std::rethrow_exception(failure);
  }
}

}  // namespace vernier
