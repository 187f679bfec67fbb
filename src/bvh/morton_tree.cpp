#include "bvh/morton_tree.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "bvh/box.h"
#include "bvh/morton_code.h"
#include "bvh/sort_codes.h"

namespace vernier {
namespace {

// References per piece of work while codes are made.
constexpr std::size_t kPiece = 4096;
// Subtrees of up to this many triangles are built by one thread.
constexpr std::size_t kTaskSize = 2048;

// Ranges of up to this many references have all of them prefetched: 16 KiB, which the nearest cache holds.
constexpr std::size_t kPrefetched = 512;

using CodedReferences = std::span<CodedReference>;

// Sorted references [begin, end) that become the subtree with root `node`.
struct Range {
  std::size_t begin, end;
  std::uint32_t node;
  std::uint32_t depth;

  std::size_t size() const { return end - begin; }
};

void make_codes(const TriangleReferences& references, ThreadTeam& team, CodedReferences codes) {
  const MortonGrid grid(references.bounds.centres);
  team.run((references.all.size() + kPiece - 1) / kPiece, [&](std::size_t piece) {
    const std::size_t end = std::min((piece + 1) * kPiece, references.all.size());
    for (std::size_t i = piece * kPiece; i < end; ++i) {
      codes[i] = {grid.code(doubled_centre(references.all[i])), static_cast<std::uint32_t>(i)};
    }
  });
}

class MortonTreeBuilder {
 public:
  MortonTreeBuilder(const TriangleReference* references, const CodedReference* codes, BinaryNode* nodes)
      : references_(references), codes_(codes), nodes_(nodes) {}

  // The uppermost ranges are divided, what is below them is built by threads, then they become nodes.
  void build(std::size_t count, ThreadTeam& team, const CountDone& done) {
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
      for (const Range& half : halves_of(range)) {
        if (half.size() > 1) waiting.push_back(half);
      }
    }
    team.run(tasks.size(), [&](std::size_t i) {
      build_range(tasks[i]);
      if (done) done(tasks[i].size());
    });
    for (std::size_t i = upper.size(); i-- > 0;) {
      const Halves halves = halves_of(upper[i]);
      LaneBox box = box_of(halves[0]);
      box.grow(box_of(halves[1]));
      write_node(upper[i], halves, box);
    }
  }

 private:
  using Halves = std::array<Range, 2>;

  std::size_t middle_of(const Range& range) const {
    const CodedReference* first = codes_ + range.begin;
    const CodedReference* last = codes_ + range.end - 1;
    const std::uint64_t differing = first->code ^ last->code;
    if (differing == 0 || range.depth >= kMedianDepth) return range.begin + (range.size() + 1) / 2;
    const int highest = std::bit_width(differing) - 1;
    // Binary search without branches, which would be foreseen every other time: the last on the left is among `count`
    // from `first` on.
    for (std::size_t count = range.size() - 1; count > 1;) {
      const std::size_t half = count / 2;
      first += half & ((first[half].code >> highest & 1) - 1);
      count -= half;
    }
    return static_cast<std::size_t>(first + 1 - codes_);
  }

  Halves halves_of(const Range& range) const {
    const std::size_t middle = middle_of(range);
    const auto right_node = range.node + static_cast<std::uint32_t>(middle - range.begin);
    return {Range{range.begin, middle, range.node + 1, range.depth + 1},
            Range{middle, range.end, right_node, range.depth + 1}};
  }

  BinaryChild child_of(const Range& range) const {
    return range.size() == 1 ? kLeafBit | triangle_index(reference_at(range.begin)) : range.node;
  }

  void write_node(const Range& range, const Halves& halves, const LaneBox& box) {
    nodes_[range.node] = {box_from(box), child_of(halves[0]), child_of(halves[1])};
  }

  // Of a range that is built.
  LaneBox box_of(const Range& range) const {
    if (range.size() == 1) return {reference_at(range.begin).lo, reference_at(range.begin).hi};
    const Box& box = nodes_[range.node].box;
    return {lanes_from(box.lo), lanes_from(box.hi)};
  }

  // Asks for the references of `range`, which lie all over memory, before each is waited for in turn.
  void prefetch_references(const Range& range) const {
    for (std::size_t place = range.begin; place < range.end; ++place) __builtin_prefetch(&reference_at(place));
  }

  // As deep as the tree: kMedianDepth + 31 calls at most.
  LaneBox build_range(const Range& range) {
    if (range.size() == 1) return {reference_at(range.begin).lo, reference_at(range.begin).hi};
    const Halves halves = halves_of(range);
    LaneBox box;
    for (const Range& half : halves) {
      if (range.size() > kPrefetched && half.size() <= kPrefetched) prefetch_references(half);
      box.grow(build_range(half));
    }
    write_node(range, halves, box);
    return box;
  }

  const TriangleReference& reference_at(std::size_t place) const { return references_[codes_[place].reference]; }

  const TriangleReference* references_;
  const CodedReference* codes_;
  BinaryNode* nodes_;
};

}  // namespace

void fill_nodes_by_code(const TriangleReferences& references, BinaryNode* nodes, ThreadTeam& team, Workspace& workspace,
                        const CountDone& done) {
  const auto unsorted = workspace.take<CodedReference>(references.all.size());
  make_codes(references, team, unsorted);
  const auto codes = sort_by_code(unsorted, workspace.take<CodedReference>(references.all.size()), team);
  MortonTreeBuilder(references.all.data(), codes.data(), nodes).build(references.all.size(), team, done);
}

}  // namespace vernier
