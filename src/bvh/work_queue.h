#pragma once

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

namespace vernier {

/// Tasks for several threads where a task may add new ones. Oldest first, because those are the largest.
template <typename Task>
class WorkQueue {
 public:
  /// Room for `capacity` tasks over the whole life of the queue, so that push never allocates nor throws.
  explicit WorkQueue(std::size_t capacity) { tasks_.reserve(capacity); }

  /// Adds a task. To be called before the task that makes it is finished.
  void push(const Task& task) {
    {
      const std::scoped_lock lock(mutex_);
      tasks_.push_back(task);
      ++unfinished_;
    }
    changed_.notify_one();
  }

  /// The next task; waits while others may still add some; nothing when all are finished.
  std::optional<Task> take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopped_ || next_ < tasks_.size() || unfinished_ == 0; });
    return !stopped_ && next_ < tasks_.size() ? std::optional<Task>(tasks_[next_++]) : std::nullopt;
  }

  /// Says that a task that was taken is done.
  void finish() {
    const std::scoped_lock lock(mutex_);
    if (--unfinished_ == 0) {
      changed_.notify_all();
    }
  }

  /// Wakes all: take has nothing any more, whatever others still add or finish. For a thread that fails, so that none
  /// waits for its tasks.
  void give_up() {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Task> tasks_;
  std::size_t next_ = 0;
  std::size_t unfinished_ = 0;
  bool stopped_ = false;
};

}  // namespace vernier
