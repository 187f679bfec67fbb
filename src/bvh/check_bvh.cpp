#include "bvh/check_bvh.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "bvh/box.h"
#include "bvh/check_triangles.h"
#include "bvh/coarse.h"
#include "bvh/decode_record.h"
#include "bvh/quantize_node.h"

namespace vernier {
namespace {

// The box areas of a level of N records may sum up to this many times (twice the root's + all triangles' boxes + the
// root's times the cube root of N). Trees of surfaces stay below the first term, 1.4 times the root being usual;
// triangles that lie in one another make all boxes as large as theirs, hence the second; N cubes fill a cube with
// areas of N^(1/3) times its own, hence the third. A tree split beside the point doubles with every level.
constexpr double kLevelAreaFactor = 1.5;
// Rounding of sums of up to 2^24 areas in double, generously.
constexpr double kSumTolerance = 1e-6;

class TreeCheck {
 public:
  TreeCheck(const Bvh& bvh, std::span<const BvhTriangle> triangles)
      : bvh_(bvh),
        tally_(triangles),
        level_(bvh.records.size(), 0),
        boxes_(bvh.records.size()),
        scene_extent_(longest_side(bvh.bounds)) {}

  std::string first_fault() {
    std::string fault = walk_down();
    fault = fault.empty() ? tally_.first_left_over() : fault;
    fault = fault.empty() ? check_counts() : fault;
    fault = fault.empty() ? check_boxes() : fault;
    return fault.empty() ? check_cost() : fault;
  }

 private:
  // Visits every record that can be reached, parents first, and notes its level (the root's is 1).
  std::string walk_down() {
    if (bvh_.records.empty()) {
      return "";
    }
    if (is_triangle(bvh_.records[0])) {
      return "record 0: the root is a triangle";
    }
    order_ = {0};
    level_[0] = 1;
    for (std::size_t next = 0; next < order_.size(); ++next) {
      const std::uint32_t index = order_[next];
      const BvhRecord& record = bvh_.records[index];
      std::string fault = is_triangle(record) ? tally_.tick(record, index) : visit_node(record, index);
      if (!fault.empty()) {
        return fault;
      }
    }
    return order_.size() == bvh_.records.size() ? "" : "a record is not reached from the root";
  }

  /// What is wrong with a node by itself.
  std::string node_fault(const BvhRecord& record, const DecodedNode& node, const std::string& place) const {
    if (node.child_count < 1 || node.child_count > 4) {
      return place + "has " + std::to_string(node.child_count) + " children";
    }
    if (node.child_base >= bvh_.records.size() || node.child_count > bvh_.records.size() - node.child_base) {
      return place + "has children beyond the last record";
    }
    for (std::uint32_t i = node.child_count; i < 4; ++i) {
      if (!node.slot_is_empty[i]) {
        return place + "has a box in an empty slot";
      }
    }
    for (const std::size_t word : {4, 5, 6, 8, 9, 10}) {
      if (record[word] >> 24 == 0) {
        return place + "has a byte of 0 at the top of a word that may be read as a coordinate";
      }
    }
    const double least_cell = std::ldexp(1.0, static_cast<int>(kLeastExponent) - 127);
    for (int axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(node.boxes[0].lo[axis]) || !(node.cell[axis] >= least_cell) || std::isinf(node.cell[axis])) {
        return place + "has a broken grid";
      }
    }
    return "";
  }

  std::string visit_node(const BvhRecord& record, std::uint32_t index) {
    const DecodedNode node = decode_node(record);
    std::string fault = node_fault(record, node, "record " + std::to_string(index) + ": ");
    if (!fault.empty()) return fault;
    for (std::uint32_t child = node.child_base; child < node.child_base + node.child_count; ++child) {
      if (level_[child] != 0) {
        return "record " + std::to_string(child) + ": has two parents";
      }
      level_[child] = level_[index] + 1;
      order_.push_back(child);
    }
    return "";
  }

  std::string check_counts() const {
    std::uint32_t node_count = 0;
    std::uint32_t depth = 0;
    for (std::size_t i = 0; i < bvh_.records.size(); ++i) {
      if (!is_triangle(bvh_.records[i])) {
        ++node_count;
        depth = std::max(depth, level_[i]);
      }
    }
    if (bvh_.node_count != node_count || bvh_.triangle_count != bvh_.records.size() - node_count) {
      return "node_count or triangle_count is wrong";
    }
    if (bvh_.coarse && !is_in_coarse_reach(bvh_.bounds)) return "rays count on other bounds";
    return bvh_.depth == depth ? "" : "depth is " + std::to_string(bvh_.depth) + ", not " + std::to_string(depth);
  }

  // From the triangles up: the true bounds of what is below each record, and whether the stored boxes hold them.
  std::string check_boxes() {
    for (std::size_t next = order_.size(); next-- > 0;) {
      const std::uint32_t index = order_[next];
      const BvhRecord& record = bvh_.records[index];
      if (is_triangle(record)) {
        boxes_[index] = triangle_bounds(decode_triangle(record));
        continue;
      }
      const DecodedNode node = decode_node(record);
      for (std::uint32_t i = 0; i < node.child_count; ++i) {
        const Box& box = boxes_[node.child_base + i];
        grow(boxes_[index], box);
        const std::string fault = check_box(box, node.boxes[i], node.cell);
        if (!fault.empty()) {
          return "record " + std::to_string(index) + ": box of child " + std::to_string(i) + fault;
        }
      }
    }
    const bool same = bvh_.records.empty() || (boxes_[0].lo == bvh_.bounds.lo && boxes_[0].hi == bvh_.bounds.hi);
    return same ? "" : "bounds are not those of the triangles";
  }

  std::string check_box(const Box& box, const DecodedBox& stored, const glm::dvec3& cell) const {
    const double padding = promised_padding(box, scene_extent_);
    const Box padded = pad_box(box, scene_extent_);
    for (int axis = 0; axis < 3; ++axis) {
      if (!(stored.lo[axis] <= box.lo[axis] - padding && stored.hi[axis] >= box.hi[axis] + padding)) {
        return " does not hold what is below it";
      }
      // One cell for the rounding outwards, one for the rounding of this sum.
      if (stored.lo[axis] < padded.lo[axis] - 2.0 * cell[axis] ||
          stored.hi[axis] > padded.hi[axis] + 2.0 * cell[axis]) {
        return " is too large";
      }
    }
    return "";
  }

  std::string check_cost() const {
    if (bvh_.records.empty()) {
      return bvh_.sah_cost == 0.0 ? "" : "an empty tree has a cost";
    }
    const double root = half_area(boxes_[0]);
    std::vector<double> level_sums(bvh_.depth + 2, 0.0);
    std::vector<std::uint32_t> level_counts(bvh_.depth + 2, 0);
    double triangle_sum = 0.0;
    double node_sum = 0.0;
    for (std::size_t i = 0; i < bvh_.records.size(); ++i) {
      const double area = half_area(boxes_[i]) / root;
      level_sums[level_[i]] += area;
      ++level_counts[level_[i]];
      (is_triangle(bvh_.records[i]) ? triangle_sum : node_sum) += area;
    }
    // The wide nodes are some of the binary nodes, of which there are at most n - 1, and each triangle costs 2 at most.
    // A single triangle has no binary node.
    const double least = (bvh_.triangle_count == 1 ? 0.0 : node_sum) + 2.0 * triangle_sum;
    const double most = 3.0 * bvh_.triangle_count - 1.0;
    if (!(bvh_.sah_cost >= least * (1.0 - kSumTolerance) && bvh_.sah_cost <= most * (1.0 + kSumTolerance))) {
      return "SAH cost " + std::to_string(bvh_.sah_cost) + " is not between " + std::to_string(least) + " and " +
             std::to_string(most);
    }
    return check_levels(level_sums, level_counts, triangle_sum);
  }

  static std::string check_levels(const std::vector<double>& sums, const std::vector<std::uint32_t>& counts,
                                  double triangle_sum) {
    for (std::size_t level = 1; level < sums.size(); ++level) {
      const double most = kLevelAreaFactor * (2.0 + triangle_sum + std::cbrt(counts[level]));
      if (sums[level] > most) {
        return "level " + std::to_string(level) + ": the boxes have " + std::to_string(sums[level]) +
               " times the root's area, more than " + std::to_string(most);
      }
    }
    return "";
  }

  const Bvh& bvh_;
  TriangleTally tally_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> level_;
  std::vector<Box> boxes_;
  float scene_extent_;
};

}  // namespace

std::string check_bvh(const Bvh& bvh, std::span<const BvhTriangle> triangles) {
  return TreeCheck(bvh, triangles).first_fault();
}

}  // namespace vernier
