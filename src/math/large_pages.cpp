#include "math/large_pages.h"

#include <memory>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace vernier {

void wish_for_large_pages([[maybe_unused]] std::span<std::byte> memory) {
#ifdef __linux__
  void* first = memory.data();
  std::size_t bytes = memory.size();
  if (std::align(kLargePageBytes, kLargePageBytes, first, bytes) == nullptr) return;
  madvise(first, bytes / kLargePageBytes * kLargePageBytes, MADV_HUGEPAGE);
#endif
}

}  // namespace vernier
