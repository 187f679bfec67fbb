#include "reference/parallel_rows.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace vernier::reference {

namespace {

class RowQueue {
 public:
  RowQueue(int row_count, const std::function<void(int)>& work, const std::function<void(double)>& progress,
           const std::function<bool()>& cancelled)
      : row_count_(row_count), work_(work), progress_(progress), cancelled_(cancelled) {}

  void run() noexcept {
    try {
      for (int row = take(); row < row_count_ && !is_cancelled(); row = take()) {
        work_(row);
        report();
      }
    } catch (...) {
      fail();
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  bool is_cancelled() const { return cancelled_ && cancelled_(); }

  int take() {
    const std::lock_guard lock(mutex_);
    return failure_ ? row_count_ : std::min(next_++, row_count_);
  }

  void report() {
    const std::lock_guard lock(mutex_);
    ++done_;
    if (progress_ && !failure_) progress_(static_cast<double>(done_) / row_count_);
  }

  void fail() {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
  }

  const int row_count_;
  const std::function<void(int)>& work_;
  const std::function<void(double)>& progress_;
  const std::function<bool()>& cancelled_;
  std::mutex mutex_;
  int next_ = 0;
  int done_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

void for_each_row(int row_count, unsigned thread_count, const std::function<void(int)>& work,
                  const std::function<void(double)>& progress, const std::function<bool()>& cancelled) {
  if (thread_count == 0) thread_count = std::max(1u, std::thread::hardware_concurrency());
  RowQueue queue(row_count, work, progress, cancelled);
  {
    std::vector<std::jthread> others;
    for (unsigned i = 1; i < std::min(thread_count, static_cast<unsigned>(row_count)); ++i)
      others.emplace_back([&queue] { queue.run(); });
    queue.run();
  }
  queue.rethrow();
}

}  // namespace vernier::reference
