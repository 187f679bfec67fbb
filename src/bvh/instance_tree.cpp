#include "bvh/instance_tree.h"

#include <algorithm>
#include <string>

#include "bvh/box.h"
#include "bvh/decode_record.h"
#include "bvh/quantize_node.h"
#include "error.h"
#include "shared/bvh_record.h"

namespace vernier {
namespace {

constexpr std::uint32_t kLowestByte = 0xffu;

/// A triangle whose box is `box`: what the builder takes for the instance.
BvhTriangle stand_in(const Box& box, std::uint32_t id) {
  return {box.lo, box.hi, glm::vec3(box.hi.x, box.lo.y, box.lo.z), id};
}

BvhRecord instance_record(const TreeInstance& instance, float scene_extent, std::uint32_t root) {
  const Box box = pad_box(instance.box, scene_extent);
  BvhRecord record = quantize_node(std::span(&box, 1), box, root);
  record[BVH_WORD_FLAGS] |= BVH_INSTANCE;
  record[BVH_WORD_PLACE] = (record[BVH_WORD_PLACE] & kLowestByte) | instance.number << BVH_INSTANCE_SHIFT;
  return record;
}

void refuse_too_many(std::uint64_t records) {
  if (records <= BVH_MAX_RECORDS) return;
  throw Error(ErrorKind::refused, "scene: its different triangles and its instances need " + std::to_string(records) +
                                      " BVH records, more than " + std::to_string(BVH_MAX_RECORDS) +
                                      "; simplify or split the model");
}

/// Puts the records of `object` behind those of `bvh`.
void append(const ObjectTree& object, Bvh& bvh) {
  const auto base = static_cast<std::uint32_t>(bvh.records.size());
  for (BvhRecord record : object.bvh.records) {
    if (is_triangle(record)) {
      record[BVH_WORD_PLACE] = object.first_place + record[BVH_WORD_NUMBER];
    } else {
      record[BVH_WORD_CHILD_BASE] += base;
    }
    bvh.records.push_back(record);
  }
  bvh.node_count += object.bvh.node_count;
  bvh.triangle_count += object.bvh.triangle_count;
}

std::vector<bool> used_objects(std::span<const TreeInstance> instances, std::size_t object_count) {
  std::vector<bool> used(object_count, false);
  for (const TreeInstance& instance : instances) used[instance.object] = true;
  return used;
}

/// Adds a triangle for each instance whose object has any; the first instance's id is `first_id`.
void add_stand_ins(std::span<const TreeInstance> instances, const std::vector<ObjectTree>& objects,
                   std::uint32_t first_id, std::vector<BvhTriangle>& triangles) {
  for (std::uint32_t i = 0; i < instances.size(); ++i) {
    if (objects[instances[i].object].bvh.records.empty()) continue;
    triangles.push_back(stand_in(instances[i].box, first_id + i));
  }
}

/// The objects' trees behind the records of the tree above them.
struct TreesBelow {
  std::vector<std::uint32_t> roots;  ///< by object
  std::vector<double> costs;         ///< their SAH costs
  std::uint32_t depth = 0;           ///< of the deepest
};

/// Puts the trees that `instances` use behind the records of `bvh`, and empties them.
TreesBelow append_used(std::span<const TreeInstance> instances, std::vector<ObjectTree>& objects, Bvh& bvh) {
  const std::vector<bool> used = used_objects(instances, objects.size());
  std::uint64_t record_count = bvh.records.size();
  for (std::size_t i = 0; i < objects.size(); ++i) record_count += used[i] ? objects[i].bvh.records.size() : 0;
  refuse_too_many(record_count);
  bvh.records.reserve(record_count);
  TreesBelow below;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    Bvh& object = objects[i].bvh;
    below.roots.push_back(static_cast<std::uint32_t>(bvh.records.size()));
    below.costs.push_back(object.sah_cost);
    if (!used[i]) continue;
    append(objects[i], bvh);
    bvh.coarse = bvh.coarse && (object.records.empty() || object.coarse);
    below.depth = std::max(below.depth, object.depth);
    object = {};
  }
  return below;
}

/// Gives the triangles among the first `record_count` records their numbers, and puts instances where their stand-ins
/// are, whose ids follow those of triangles.
void place_instances(std::span<const TreeInstance> instances, std::span<const std::uint32_t> numbers,
                     const TreesBelow& below, std::size_t record_count, Bvh& bvh) {
  const float extent = longest_side(bvh.bounds);
  const double root_area = half_area(bvh.bounds);
  for (std::size_t i = 0; i < record_count; ++i) {
    BvhRecord& record = bvh.records[i];
    if (!is_triangle(record)) continue;
    const std::uint32_t id = record[BVH_WORD_NUMBER];
    if (id < numbers.size()) {
      record[BVH_WORD_PLACE] = id;
      record[BVH_WORD_NUMBER] = numbers[id];
      continue;
    }
    const TreeInstance& instance = instances[id - numbers.size()];
    record = instance_record(instance, extent, below.roots[instance.object]);
    bvh.sah_cost += half_area(instance.box) / root_area * below.costs[instance.object];
    ++bvh.instance_count;
    ++bvh.node_count;
    --bvh.triangle_count;
  }
}

}  // namespace

Bvh build_instance_tree(std::vector<BvhTriangle> triangles, std::span<const std::uint32_t> numbers,
                        std::span<const TreeInstance> instances, std::vector<ObjectTree>& objects,
                        const std::function<bool(std::uint32_t)>& not_opaque, unsigned thread_count, BuildMethod method,
                        const std::function<void(double share)>& progress) {
  const auto first_stand_in = static_cast<std::uint32_t>(numbers.size());
  add_stand_ins(instances, objects, first_stand_in, triangles);
  const auto may_pass = [&](std::uint32_t id) { return id < first_stand_in && not_opaque && not_opaque(id); };
  Bvh bvh = build_bvh(triangles, may_pass, thread_count, method, progress);
  triangles = {};
  const std::size_t own_records = bvh.records.size();
  const TreesBelow below = append_used(instances, objects, bvh);
  place_instances(instances, numbers, below, own_records, bvh);
  if (bvh.instance_count > 0) bvh.depth += 1 + below.depth;
  return bvh;
}

std::vector<Box> upper_boxes(const Bvh& bvh) {
  // The root's children, and theirs.
  constexpr int kLevels = 2;
  if (bvh.records.empty()) return {};
  std::vector<std::uint32_t> nodes = {0};
  std::vector<Box> boxes;
  for (int level = 1; level <= kLevels; ++level) {
    std::vector<std::uint32_t> below;
    for (const std::uint32_t index : nodes) {
      const DecodedNode node = decode_node(bvh.records[index]);
      for (std::uint32_t i = 0; i < node.child_count; ++i) {
        const std::uint32_t child = node.child_base + i;
        if (level < kLevels && !is_triangle(bvh.records[child])) {
          below.push_back(child);
        } else {
          // Decoded corners are sums of two floats; rounding them moves less than what they are padded by.
          boxes.push_back({glm::vec3(node.boxes[i].lo), glm::vec3(node.boxes[i].hi)});
        }
      }
    }
    nodes = std::move(below);
  }
  return boxes;
}

}  // namespace vernier
