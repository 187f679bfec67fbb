#include "reference/parallel_rows.h"

#include <mutex>

#include "math/parallel_for.h"

namespace vernier::reference {

void for_each_row(int row_count, unsigned thread_count, const std::function<void(int)>& work,
                  const std::function<void(double)>& progress, const std::function<bool()>& cancelled) {
  std::mutex reporting;
  int done = 0;
  parallel_for(resolve_thread_count(thread_count), static_cast<std::size_t>(row_count), [&](std::size_t row) {
    if (cancelled && cancelled()) return;
    work(static_cast<int>(row));
    const std::lock_guard lock(reporting);
    ++done;
    if (progress) progress(static_cast<double>(done) / row_count);
  });
}

}  // namespace vernier::reference
