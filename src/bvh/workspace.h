#pragma once

#include <cassert>
#include <cstddef>
#include <span>

namespace vernier {

/// Memory that is needed for something else later and lent to arrays until then: the first touch of new memory costs
/// more than what a builder does with it.
class Workspace {
 public:
  /// `memory` as malloc aligns it; must outlive the arrays.
  explicit Workspace(std::span<std::byte> memory) : rest_(memory) {}

  /// An array of `count` elements without a value. No more bytes than there are left; elements need no alignment beyond
  /// their own size's.
  template <typename T>
  std::span<T> take(std::size_t count) {
    static_assert(sizeof(T) % alignof(std::max_align_t) == 0, "what comes next would not be aligned");
    assert(count * sizeof(T) <= rest_.size());
    const std::span<T> taken(reinterpret_cast<T*>(rest_.data()), count);
    rest_ = rest_.subspan(count * sizeof(T));
    return taken;
  }

 private:
  std::span<std::byte> rest_;
};

}  // namespace vernier
