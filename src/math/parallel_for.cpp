#include "math/parallel_for.h"

#include <algorithm>
#include <thread>

#include "math/thread_team.h"

namespace vernier {

unsigned resolve_thread_count(unsigned thread_count) {
  return std::max(1u, thread_count == 0 ? std::thread::hardware_concurrency() : thread_count);
}

void parallel_for(unsigned thread_count, std::size_t count, const std::function<void(std::size_t)>& work) {
  ThreadTeam(thread_count).run(count, work);
}

}  // namespace vernier
