#include "bvh/morton_tree.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "bvh/box.h"
#include "bvh/morton_code.h"
#include "bvh/sort_codes.h"
#include "math/parallel_for.h"

namespace vernier {
namespace {

// References per piece of work while codes are made.
constexpr std::size_t kPiece = 16384;
// Subtrees of up to this many triangles are built by one thread.
constexpr std::size_t kTaskSize = 8192;

// Ranges of up to this many references have all of them prefetched: 16 KiB, which the nearest cache holds.
constexpr std::size_t kPrefetched = 512;

using CodedReferences = LargeArray<CodedReference>;

// Sorted references [begin, end) that become the subtree with root `node`.
struct Range {
  std::size_t begin, end;
  std::uint32_t node;
  std::uint32_t depth;

  std::size_t size() const { return end - begin; }
};

CodedReferences make_codes(const TriangleReferences& references, unsigned thread_count) {
  CodedReferences codes(references.count);
  const MortonGrid grid(references.bounds.centres);
  parallel_for(thread_count, (references.count + kPiece - 1) / kPiece, [&](std::size_t piece) {
    const std::size_t end = std::min((piece + 1) * kPiece, references.count);
    for (std::size_t i = piece * kPiece; i < end; ++i) {
      codes[i] = {grid.code(doubled_centre(references.all[i])), static_cast<std::uint32_t>(i)};
    }
  });
  return codes;
}

class MortonTreeBuilder {
 public:
  MortonTreeBuilder(const TriangleReference* references, const CodedReference* codes, BinaryNode* nodes)
      : references_(references), codes_(codes), nodes_(nodes) {}

  // The uppermost nodes get their children, the ranges below them are built by threads, then those nodes get boxes.
  void build(std::size_t count, unsigned thread_count, const CountDone& done) {
    std::vector<Range> waiting = {{0, count, 0, 0}};
    std::vector<Range> tasks;
    std::vector<Range> upper;
    while (!waiting.empty()) {
      const Range range = waiting.back();
      waiting.pop_back();
      if (range.size() <= kTaskSize) {
        tasks.push_back(range);
        continue;
      }
      upper.push_back(range);
      for (const Range& half : make_node(range)) {
        if (half.size() > 1) waiting.push_back(half);
      }
    }
    parallel_for(thread_count, tasks.size(), [&](std::size_t i) {
      build_range(tasks[i]);
      if (done) done(tasks[i].size());
    });
    for (std::size_t i = upper.size(); i-- > 0;) {
      BinaryNode& node = nodes_[upper[i].node];
      node.box = box_of(node.left, upper[i].begin);
      grow(node.box, box_of(node.right, upper[i].end - 1));
    }
  }

 private:
  using Halves = std::array<Range, 2>;

  std::size_t middle_of(const Range& range) const {
    const CodedReference* first = codes_ + range.begin;
    const CodedReference* last = codes_ + range.end - 1;
    const std::uint64_t differing = first->code ^ last->code;
    if (differing == 0 || range.depth >= kMedianDepth) return range.begin + (range.size() + 1) / 2;
    const std::uint64_t highest = std::bit_floor(differing);
    const auto is_left = [highest](const CodedReference& coded) { return (coded.code & highest) == 0; };
    return static_cast<std::size_t>(std::partition_point(first, last, is_left) - codes_);
  }

  // The node's children; its box is not known yet.
  Halves make_node(const Range& range) {
    const std::size_t middle = middle_of(range);
    const auto right_node = range.node + static_cast<std::uint32_t>(middle - range.begin);
    const Halves halves = {Range{range.begin, middle, range.node + 1, range.depth + 1},
                           Range{middle, range.end, right_node, range.depth + 1}};
    nodes_[range.node].left = child_of(halves[0]);
    nodes_[range.node].right = child_of(halves[1]);
    return halves;
  }

  BinaryChild child_of(const Range& range) const {
    return range.size() == 1 ? kLeafBit | triangle_index(reference_at(range.begin)) : range.node;
  }

  // Of a child that is built; a leaf is the reference at `place`.
  Box box_of(BinaryChild child, std::size_t place) const {
    return is_leaf(child) ? box_from({reference_at(place).lo, reference_at(place).hi}) : nodes_[child].box;
  }

  // Asks for the references of `range`, which lie all over memory, before each is waited for in turn.
  void prefetch_references(const Range& range) const {
    for (std::size_t place = range.begin; place < range.end; ++place) __builtin_prefetch(&reference_at(place));
  }

  // As deep as the tree: kMedianDepth + 31 calls at most.
  LaneBox build_range(const Range& range) {
    if (range.size() > kPrefetched / 2 && range.size() <= kPrefetched) prefetch_references(range);
    if (range.size() == 1) return {reference_at(range.begin).lo, reference_at(range.begin).hi};
    const Halves halves = make_node(range);
    LaneBox box = build_range(halves[0]);
    box.grow(build_range(halves[1]));
    nodes_[range.node].box = box_from(box);
    return box;
  }

  const TriangleReference& reference_at(std::size_t place) const { return references_[codes_[place].reference]; }

  const TriangleReference* references_;
  const CodedReference* codes_;
  BinaryNode* nodes_;
};

}  // namespace

void fill_nodes_by_code(const TriangleReferences& references, BinaryNode* nodes, unsigned thread_count,
                        const CountDone& done) {
  CodedReferences codes = make_codes(references, thread_count);
  sort_by_code(codes, thread_count);
  MortonTreeBuilder(references.all.data(), codes.data(), nodes).build(references.count, thread_count, done);
}

}  // namespace vernier
