#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace vernier {

/// Threads that share one piece of work after another: for many short ones in a row, where starting threads for each,
/// as parallel_for does, would take as long as the work. A thread that the system has not woken yet is not waited for.
class ThreadTeam {
 public:
  /// `thread_count` (at least 1) of them, with the caller's; they start when there is work for them, and are fewer when
  /// the system refuses more.
  explicit ThreadTeam(unsigned thread_count) : thread_count_(thread_count) {}
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;
  ~ThreadTeam();

  /// How many there are meant to be.
  unsigned thread_count() const { return thread_count_; }

  /// Calls work(i) for every i in [0, count) in no fixed order, and waits. The first exception is thrown again after
  /// all threads have stopped; indices not begun by then are left out. To be called by one thread, not from `work`.
  void run(std::size_t count, const std::function<void(std::size_t)>& work);

 private:
  void start_helpers(std::size_t count);
  void help();
  void take_part();
  bool has_work() const { return next_ < count_; }

  unsigned thread_count_;
  std::mutex mutex_;
  std::condition_variable has_changed_;  // for helpers: there is work, or the end
  std::condition_variable is_idle_;      // for the caller: no helper is at work
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::atomic<std::size_t> next_ = 0;
  std::size_t count_ = 0;
  std::size_t helpers_at_work_ = 0;
  std::exception_ptr failure_;
  bool ends_ = false;
  std::vector<std::jthread> helpers_;
};

}  // namespace vernier
