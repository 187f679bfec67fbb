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

constexpr std::size_t kPlaceWord = 7;
constexpr std::size_t kChildBaseWord = 10;
constexpr std::size_t kNumberWord = 11;
constexpr std::uint32_t kLowestByte = 0xffu;

/// A triangle whose box is `box`: what the builder takes for the instance.
BvhTriangle stand_in(const Box& box, std::uint32_t id) {
  return {box.lo, box.hi, glm::vec3(box.hi.x, box.lo.y, box.lo.z), id};
}

BvhRecord instance_record(const TreeInstance& instance, float scene_extent, std::uint32_t root) {
  const Box box = pad_box(instance.box, scene_extent);
  BvhRecord record = quantize_node(std::span(&box, 1), box, root);
  record[3] |= BVH_INSTANCE;
  record[kPlaceWord] = (record[kPlaceWord] & kLowestByte) | instance.number << BVH_INSTANCE_SHIFT;
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
      record[kPlaceWord] = object.first_place + record[kNumberWord];
    } else {
      record[kChildBaseWord] += base;
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

}  // namespace

Bvh build_instance_tree(std::vector<BvhTriangle> triangles, std::span<const std::uint32_t> numbers,
                        std::span<const TreeInstance> instances, std::vector<ObjectTree>& objects,
                        const std::function<bool(std::uint32_t)>& not_opaque, unsigned thread_count, BuildMethod method,
                        const std::function<void(double share)>& progress) {
  // Ids of stand-ins follow those of triangles.
  const auto first_stand_in = static_cast<std::uint32_t>(numbers.size());
  for (std::uint32_t i = 0; i < instances.size(); ++i) {
    if (!objects[instances[i].object].bvh.records.empty()) {
      triangles.push_back(stand_in(instances[i].box, first_stand_in + i));
    }
  }
  const auto may_pass = [&](std::uint32_t id) { return id < first_stand_in && not_opaque && not_opaque(id); };
  Bvh bvh = build_bvh(triangles, may_pass, thread_count, method, progress);
  triangles = {};
  const std::size_t own_records = bvh.records.size();
  const std::vector<bool> used = used_objects(instances, objects.size());
  std::uint64_t record_count = own_records;
  for (std::size_t i = 0; i < objects.size(); ++i) record_count += used[i] ? objects[i].bvh.records.size() : 0;
  refuse_too_many(record_count);
  bvh.records.reserve(record_count);
  std::vector<std::uint32_t> roots(objects.size());
  std::uint32_t deepest = 0;
  std::vector<double> costs(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    roots[i] = static_cast<std::uint32_t>(bvh.records.size());
    costs[i] = objects[i].bvh.sah_cost;
    if (!used[i]) continue;
    append(objects[i], bvh);
    bvh.coarse = bvh.coarse && (objects[i].bvh.records.empty() || objects[i].bvh.coarse);
    deepest = std::max(deepest, objects[i].bvh.depth);
    objects[i].bvh = {};
  }
  const float extent = longest_side(bvh.bounds);
  const double root_area = half_area(bvh.bounds);
  for (std::size_t i = 0; i < own_records; ++i) {
    BvhRecord& record = bvh.records[i];
    if (!is_triangle(record)) continue;
    const std::uint32_t id = record[kNumberWord];
    if (id < first_stand_in) {
      record[kPlaceWord] = id;
      record[kNumberWord] = numbers[id];
      continue;
    }
    const TreeInstance& instance = instances[id - first_stand_in];
    record = instance_record(instance, extent, roots[instance.object]);
    bvh.sah_cost += half_area(instance.box) / root_area * costs[instance.object];
    ++bvh.instance_count;
    ++bvh.node_count;
    --bvh.triangle_count;
  }
  if (bvh.instance_count > 0) bvh.depth += 1 + deepest;
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
