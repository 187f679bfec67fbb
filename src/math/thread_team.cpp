#include "math/thread_team.h"

#include <algorithm>
#include <utility>

namespace vernier {

ThreadTeam::~ThreadTeam() {
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
  }
  has_changed_.notify_all();
}

void ThreadTeam::run(std::size_t count, const std::function<void(std::size_t)>& work) {
  {
    const std::scoped_lock lock(mutex_);
    work_ = &work;
    next_ = 0;
    count_ = count;
  }
  if (count > 1) has_changed_.notify_all();
  start_helpers(std::min<std::size_t>(count, thread_count_));
  take_part();
  std::unique_lock lock(mutex_);
  is_idle_.wait(lock, [this] { return helpers_at_work_ == 0; });
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

// As far as there are fewer than `count` threads with the caller's.
void ThreadTeam::start_helpers(std::size_t count) {
  try {
    while (helpers_.size() + 1 < count) {
      helpers_.emplace_back([this] { help(); });
    }
  } catch (const std::exception&) {
    // No more threads, or no memory for them: those that run, and the caller's, share the work.
  }
}

void ThreadTeam::help() {
  std::unique_lock lock(mutex_);
  while (true) {
    has_changed_.wait(lock, [this] { return ends_ || has_work(); });
    if (ends_) return;
    ++helpers_at_work_;
    lock.unlock();
    take_part();
    lock.lock();
    if (--helpers_at_work_ == 0) is_idle_.notify_one();
  }
}

void ThreadTeam::take_part() {
  try {
    for (std::size_t i = next_++; i < count_; i = next_++) {
      (*work_)(i);
    }
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    next_ = count_;
    failure_ = failure_ ? failure_ : std::current_exception();
  }
}

}  // namespace vernier
