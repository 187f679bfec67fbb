#pragma once

#include <cstddef>
#include <functional>

namespace vernier {

/// Threads to use for a wish of `thread_count`: 0 is one per core; never less than 1.
unsigned resolve_thread_count(unsigned thread_count);

/// Calls work(i) for every i in [0, count), on up to `thread_count` threads (at least 1) in no fixed order, and waits.
/// The first exception is thrown again after all threads have stopped; indices not begun by then are left out.
/// Runs on fewer threads when the system refuses more. count = 0 does nothing.
void parallel_for(unsigned thread_count, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace vernier
