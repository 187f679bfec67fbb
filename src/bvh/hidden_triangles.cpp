#include "bvh/hidden_triangles.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstring>
#include <span>

#include "bvh/large_array.h"
#include "bvh/zero_area.h"
#include "math/parallel_for.h"

namespace vernier {
namespace {

constexpr std::size_t kCornerBytes = 9 * sizeof(float);
// Triangles, or entries, per piece of work.
constexpr std::size_t kPiece = 16384;
constexpr std::uint32_t kBatch = 32;

bool same_corners(const BvhTriangle& a, const BvhTriangle& b) {
  return std::memcmp(&a, &b, kCornerBytes) == 0;
}

// Mixes the bits of all corners (the multiplier is that of Knuth's 64-bit linear congruential generator, MMIX).
std::uint64_t hash_of(const BvhTriangle& triangle) {
  std::uint32_t words[9];
  std::memcpy(words, &triangle, kCornerBytes);
  std::uint64_t hash = 0;
  for (const std::uint32_t word : words) hash = (std::rotl(hash, 29) ^ word) * 6364136223846793005u;
  return hash ^ (hash >> 32);
}

// The first of each kind of triangles with the same corners, found by several threads at once. Open addressing, at most
// half full: an entry holds the index of a triangle and the upper half of its hash. Once an entry is of a kind it stays
// so, and its index only falls: whatever the order of the threads, the least of each kind is left.
class FirstTriangles {
 public:
  FirstTriangles(std::span<const BvhTriangle> triangles, unsigned thread_count)
      : triangles_(triangles), entries_(std::bit_ceil(2 * triangles.size() + 1)) {
    parallel_for(thread_count, (entries_.size() + kPiece - 1) / kPiece, [this](std::size_t piece) {
      const std::span entries = std::span(entries_).subspan(piece * kPiece);
      std::ranges::fill(entries.first(std::min(kPiece, entries.size())), kEmpty);
    });
  }

  // Adds those of [begin, end) that are opaque; was one of the same kind there, or one not opaque?
  bool add(std::uint32_t begin, std::uint32_t end, const auto& is_opaque) {
    bool may_hide = false;
    // Where they go is asked for before each is waited for in turn: the entries lie all over memory.
    std::array<std::uint64_t, kBatch> hashes;
    for (; begin < end; begin += kBatch) {
      const std::uint32_t count = std::min<std::uint32_t>(kBatch, end - begin);
      for (std::uint32_t i = 0; i < count; ++i) {
        hashes[i] = hash_of(triangles_[begin + i]);
        __builtin_prefetch(&entries_[first_slot(hashes[i])], 1);
      }
      for (std::uint32_t i = 0; i < count; ++i) {
        may_hide |= !is_opaque(begin + i) || add(begin + i, hashes[i]);
      }
    }
    return may_hide;
  }

  // Was one of its kind with a lower index added? Not to be called while others add.
  bool has_before(std::uint32_t index) const {
    const std::uint64_t hash = hash_of(triangles_[index]);
    const std::uint64_t own = entry_of(hash, index);
    for (std::size_t slot = first_slot(hash); entries_[slot] != kEmpty; slot = next_slot(slot)) {
      if (is_same(entries_[slot], own)) return entries_[slot] < own;
    }
    return false;
  }

 private:
  static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};  // no triangle has the index 2^32 - 1

  bool add(std::uint32_t index, std::uint64_t hash) {
    const std::uint64_t own = entry_of(hash, index);
    for (std::size_t slot = first_slot(hash);; slot = next_slot(slot)) {
      const std::atomic_ref<std::uint64_t> entry(entries_[slot]);
      std::uint64_t there = kEmpty;
      if (entry.compare_exchange_strong(there, own, std::memory_order_relaxed)) return false;
      if (!is_same(there, own)) continue;
      while (own < there && !entry.compare_exchange_weak(there, own, std::memory_order_relaxed)) {
      }
      return true;
    }
  }

  static std::uint64_t entry_of(std::uint64_t hash, std::uint32_t index) { return hash >> 32 << 32 | index; }
  std::size_t first_slot(std::uint64_t hash) const { return hash & (entries_.size() - 1); }
  std::size_t next_slot(std::size_t slot) const { return (slot + 1) & (entries_.size() - 1); }

  bool is_same(std::uint64_t a, std::uint64_t b) const {
    return a >> 32 == b >> 32 &&
           same_corners(triangles_[static_cast<std::uint32_t>(a)], triangles_[static_cast<std::uint32_t>(b)]);
  }

  std::span<const BvhTriangle> triangles_;
  LargeArray<std::uint64_t> entries_;
};

}  // namespace

std::size_t remove_hidden(std::vector<BvhTriangle>& triangles, const std::function<bool(std::uint32_t)>& not_opaque,
                          unsigned thread_count) {
  const auto for_pieces = [&](const auto& work) {
    parallel_for(resolve_thread_count(thread_count), (triangles.size() + kPiece - 1) / kPiece, [&](std::size_t piece) {
      const std::size_t end = std::min((piece + 1) * kPiece, triangles.size());
      work(static_cast<std::uint32_t>(piece * kPiece), static_cast<std::uint32_t>(end));
    });
  };
  const auto is_opaque = [&](std::uint32_t i) { return !not_opaque || !not_opaque(triangles[i].id); };
  FirstTriangles opaque(triangles, resolve_thread_count(thread_count));
  std::atomic<bool> may_hide = false;
  for_pieces([&](std::uint32_t begin, std::uint32_t end) {
    if (opaque.add(begin, end, is_opaque)) may_hide = true;
  });
  if (!may_hide) return 0;
  std::vector<char> hidden(triangles.size());
  for_pieces([&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      const BvhTriangle& triangle = triangles[i];
      hidden[i] = opaque.has_before(i) && !has_zero_area(triangle.v0, triangle.v1, triangle.v2);
    }
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < hidden.size(); ++i) {
    if (!hidden[i]) triangles[kept++] = triangles[i];
  }
  triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(kept), triangles.end());
  return hidden.size() - kept;
}

}  // namespace vernier
