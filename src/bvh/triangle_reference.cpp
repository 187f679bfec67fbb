#include "bvh/triangle_reference.h"

#include <algorithm>
#include <vector>

#include "bvh/box.h"
#include "bvh/coarse.h"
#include "bvh/zero_area.h"

namespace vernier {
namespace {

// Triangles per piece of work: fixed, so that sums do not depend on the number of threads.
constexpr std::size_t kChunk = 4096;

struct Chunk {
  std::size_t count = 0;
  ReferenceBounds bounds;
  double half_area_sum = 0.0;
  std::size_t fine_count = 0;
};

TriangleReference make_reference(const BvhTriangle& triangle, std::uint32_t index) {
  const Box box = triangle_bounds(triangle);
  return {Lanes{box.lo.x, box.lo.y, box.lo.z, std::bit_cast<float>(index)}, lanes_from(box.hi)};
}

// Fills `references` from its start with those of triangles[first, last).
Chunk fill_chunk(std::span<const BvhTriangle> triangles, std::size_t first, std::size_t last,
                 TriangleReference* references) {
  Chunk chunk;
  for (std::size_t i = first; i < last; ++i) {
    const BvhTriangle& triangle = triangles[i];
    if (has_zero_area(triangle.v0, triangle.v1, triangle.v2)) {
      continue;
    }
    const TriangleReference reference = make_reference(triangle, static_cast<std::uint32_t>(i));
    chunk.bounds.grow(reference);
    const Box box = triangle_bounds(triangle);
    chunk.half_area_sum += half_area(box);
    chunk.fine_count += is_fine(box) ? 1 : 0;
    references[chunk.count++] = reference;
  }
  return chunk;
}

}  // namespace

ReferenceBounds bounds_of(std::span<const TriangleReference> references) {
  ReferenceBounds bounds;
  for (const TriangleReference& reference : references) {
    bounds.grow(reference);
  }
  return bounds;
}

TriangleReferences make_references(std::span<const BvhTriangle> triangles, ThreadTeam& team, Workspace& workspace) {
  TriangleReferences references;
  references.all = workspace.take<TriangleReference>(triangles.size());
  std::vector<Chunk> chunks((triangles.size() + kChunk - 1) / kChunk);
  team.run(chunks.size(), [&](std::size_t i) {
    const std::size_t first = i * kChunk;
    chunks[i] = fill_chunk(triangles, first, std::min(first + kChunk, triangles.size()), references.all.data() + first);
  });
  std::size_t count = 0;
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    TriangleReference* from = references.all.data() + i * kChunk;
    TriangleReference* to = references.all.data() + count;
    if (from != to) {
      std::copy(from, from + chunks[i].count, to);
    }
    count += chunks[i].count;
    references.bounds.box.grow(chunks[i].bounds.box);
    references.bounds.centres.grow(chunks[i].bounds.centres);
    references.half_area_sum += chunks[i].half_area_sum;
    references.fine_count += chunks[i].fine_count;
  }
  references.all = references.all.first(count);
  return references;
}

}  // namespace vernier
