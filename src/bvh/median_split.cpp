#include "bvh/median_split.h"

#include <algorithm>

namespace vernier {

Split split_by_median(std::span<TriangleReference> references, const ReferenceBounds& bounds) {
  const Lanes spread = bounds.centres.hi - bounds.centres.lo;
  int axis = spread[1] > spread[0] ? 1 : 0;
  axis = spread[2] > spread[axis] ? 2 : axis;
  const auto comes_first = [axis](const TriangleReference& a, const TriangleReference& b) {
    const float centre_a = doubled_centre(a)[axis];
    const float centre_b = doubled_centre(b)[axis];
    return centre_a != centre_b ? centre_a < centre_b : triangle_index(a) < triangle_index(b);
  };
  Split split;
  split.middle = (references.size() + 1) / 2;
  std::nth_element(references.begin(), references.begin() + static_cast<std::ptrdiff_t>(split.middle), references.end(),
                   comes_first);
  split.left = bounds_of(references.first(split.middle));
  split.right = bounds_of(references.subspan(split.middle));
  return split;
}

}  // namespace vernier
