#pragma once

#include <functional>

namespace vernier::reference {

/// parallel_for over rows of an image, with progress: calls `work(row)` once for each row in [0, row_count) on
/// `thread_count` threads (0: all cores) and returns when all are done. `progress` (may be empty) gets the share done,
/// growing to 1, one call at a time from any thread. Once `cancelled` (may be empty; called from any thread) is true no
/// row is begun. An exception of any ends the work and is passed on.
void for_each_row(int row_count, unsigned thread_count, const std::function<void(int)>& work,
                  const std::function<void(double)>& progress, const std::function<bool()>& cancelled = {});

}  // namespace vernier::reference
