#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include "math/large_pages.h"

namespace vernier {

/// Memory for arrays that are filled once, by several threads. New elements are not set to zero: that would touch every
/// page on one thread before it is needed. On Linux those of a page and more ask for large pages, since the first touch
/// of 512 small ones costs several times as much as of a large one.
template <typename T>
struct LargeArrayAllocator {
  using value_type = T;

  LargeArrayAllocator() = default;
  template <typename U>
  explicit LargeArrayAllocator(const LargeArrayAllocator<U>&) {}

  /// Throws std::bad_alloc.
  T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / sizeof(T) - kLargePageBytes) throw std::bad_alloc();
    const std::size_t bytes = count * sizeof(T);
    if (bytes < kLargePageBytes) return static_cast<T*>(checked(std::malloc(bytes)));
    const std::size_t whole_pages = (bytes + kLargePageBytes - 1) / kLargePageBytes * kLargePageBytes;
    void* memory = checked(std::aligned_alloc(kLargePageBytes, whole_pages));
    wish_for_large_pages({static_cast<std::byte*>(memory), whole_pages});
    return static_cast<T*>(memory);
  }

  /// Gives back what allocate returned.
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  /// Leaves a new element as the memory is, its defaults too: aggregates begin to live with the memory of malloc.
  template <typename U>
  void construct(U*) {
    static_assert((std::is_aggregate_v<U> || std::is_scalar_v<U>)&&std::is_trivially_copyable_v<U>);
  }
  /// Makes an element of `arguments`.
  template <typename U, typename... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }

  bool operator==(const LargeArrayAllocator&) const { return true; }

 private:
  static_assert(alignof(T) <= alignof(std::max_align_t));

  static void* checked(void* memory) {
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
  }
};

/// A vector whose new elements have no value until one is written.
template <typename T>
using LargeArray = std::vector<T, LargeArrayAllocator<T>>;

}  // namespace vernier
