#include "render/lay_out_vertices.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "bvh/decode_record.h"
#include "math/parallel_for.h"
#include "shared/bvh_record.h"

namespace vernier {
namespace {

constexpr std::size_t kMaterialWord = 3;  // of a vertex

/// Records that share their vertices.
constexpr std::size_t kChunkRecords = 8192;
constexpr std::size_t kMostChunkVertices = 3 * kChunkRecords;
static_assert(kMostChunkVertices <= std::size_t{1} << 15, "any two are apart by what 15 bits and a sign hold");
static_assert(std::size_t{3} * BVH_MAX_RECORDS <= BVH_VERTEX_LIMIT, "records run out before numbers");

/// What is laid out as one vertex.
struct SourceVertex {
  std::uint32_t baked;
  std::uint32_t material;
  bool operator==(const SourceVertex&) const = default;
};

/// Numbers the vertices of a chunk in the order of their first use, by a table of numbers with open addressing.
class VertexNumbers {
 public:
  std::uint32_t number_of(const SourceVertex& vertex) {
    std::uint16_t* number = &numbers_[slot_of(vertex)];
    while (*number != kFree && vertices_[*number] != vertex) {
      number = number == &numbers_.back() ? &numbers_.front() : number + 1;
    }
    if (*number == kFree) {
      *number = static_cast<std::uint16_t>(vertices_.size());
      vertices_.push_back(vertex);
    }
    return *number;
  }

  /// [number]; the numbers are used up.
  std::vector<SourceVertex> take_vertices() { return std::move(vertices_); }

 private:
  static constexpr int kSlotBits = 16;
  static constexpr std::uint16_t kFree = 0xffffu;
  static_assert(2 * kMostChunkVertices <= std::size_t{1} << kSlotBits, "half of the slots stay free");

  static std::uint32_t slot_of(const SourceVertex& vertex) {
    // Fibonacci hashing (Knuth, The Art of Computer Programming 3, 6.4): neighbours are taken apart.
    constexpr std::uint32_t kGoldenRatio = 0x9e3779b9u;
    return vertex.baked * kGoldenRatio >> (32 - kSlotBits);
  }

  std::vector<std::uint16_t> numbers_ = std::vector<std::uint16_t>(std::size_t{1} << kSlotBits, kFree);
  std::vector<SourceVertex> vertices_;
};

/// Where triangle records name their place in BakedScene::triangles.
std::size_t place_word(const SceneTrees& trees) {
  return trees.instances.empty() ? BVH_WORD_NUMBER : BVH_WORD_PLACE;
}

/// The records of chunk `index`.
std::span<BvhRecord> chunk_of(LargeArray<BvhRecord>& records, std::size_t index) {
  const std::size_t first = index * kChunkRecords;
  return std::span(records).subspan(first, std::min(kChunkRecords, records.size() - first));
}

/// Calls write(record, triangle) for the triangles among `records`, `triangle` being vertices 0, 1, 2 and the material.
template <typename Write>
void for_triangles(std::span<BvhRecord> records, std::size_t place_word, const BakedScene& baked, const Write& write) {
  for (BvhRecord& record : records) {
    if (is_triangle(record)) write(record, &baked.triangles[4 * std::size_t{record[place_word]}]);
  }
}

/// Writes the places of vertices within the chunk into its records; the vertices.
std::vector<SourceVertex> number_vertices(std::span<BvhRecord> chunk, std::size_t place_word, const BakedScene& baked) {
  VertexNumbers numbers;
  for_triangles(chunk, place_word, baked, [&](BvhRecord& record, const std::uint32_t* triangle) {
    const std::uint32_t material = triangle[3];
    const std::uint32_t first = numbers.number_of({triangle[0], material});
    const std::uint32_t second = numbers.number_of({triangle[1], material});
    const std::uint32_t third = numbers.number_of({triangle[2], material});
    record[BVH_WORD_FLAGS] |= BVH_VERTEX_BITS(first);
    record[BVH_WORD_PLACE] = ((second - first) & 0xffffu) | (third - first) << 16;
  });
  return numbers.take_vertices();
}

/// The flags of a triangle whose vertex 0 comes `by` later.
std::uint32_t moved_vertex(std::uint32_t flags, std::uint32_t by) {
  const std::uint32_t number = BVH_VERTEX_NUMBER(flags);
  return (flags & ~BVH_VERTEX_BITS(number)) | BVH_VERTEX_BITS(number + by);
}

void copy_vertices(std::span<const SourceVertex> vertices, const BakedScene& baked, std::uint32_t* out) {
  const std::size_t words = 4 * std::size_t{baked.layout.texels};
  for (const SourceVertex& vertex : vertices) {
    std::copy_n(&baked.vertices[words * vertex.baked], words, out);
    out[kMaterialWord] = vertex.material;
    out += words;
  }
}

/// Where each chunk's vertices begin, and behind the last the number of them all.
std::vector<std::uint32_t> first_vertices(const std::vector<std::vector<SourceVertex>>& chunks) {
  std::vector<std::uint32_t> firsts{0};
  for (const std::vector<SourceVertex>& chunk : chunks) {
    firsts.push_back(firsts.back() + static_cast<std::uint32_t>(chunk.size()));
  }
  return firsts;
}

}  // namespace

LargeArray<std::uint32_t> lay_out_vertices(BakedScene baked, SceneTrees& trees, unsigned thread_count) {
  LargeArray<BvhRecord>& records = trees.bvh.records;
  const unsigned threads = resolve_thread_count(thread_count);
  const std::size_t place = place_word(trees);
  const std::size_t chunk_count = (records.size() + kChunkRecords - 1) / kChunkRecords;
  if (baked.layout.texels == 0) {
    parallel_for(threads, chunk_count, [&](std::size_t i) {
      for_triangles(chunk_of(records, i), place, baked,
                    [](BvhRecord& record, const std::uint32_t* triangle) { record[BVH_WORD_PLACE] = triangle[3]; });
    });
    return {};
  }
  std::vector<std::vector<SourceVertex>> chunks(chunk_count);
  parallel_for(threads, chunk_count,
               [&](std::size_t i) { chunks[i] = number_vertices(chunk_of(records, i), place, baked); });
  baked.triangles = {};
  const std::vector<std::uint32_t> firsts = first_vertices(chunks);
  const std::size_t words = 4 * std::size_t{baked.layout.texels};
  LargeArray<std::uint32_t> vertices(words * firsts.back());
  parallel_for(threads, chunk_count, [&](std::size_t i) {
    copy_vertices(chunks[i], baked, vertices.data() + words * firsts[i]);
    for (BvhRecord& record : chunk_of(records, i)) {
      if (is_triangle(record)) record[BVH_WORD_FLAGS] = moved_vertex(record[BVH_WORD_FLAGS], firsts[i]);
    }
  });
  return vertices;
}

}  // namespace vernier
