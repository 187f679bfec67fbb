#pragma once

#include <cstddef>

#include "bvh/triangle_reference.h"

namespace vernier {

/// Two halves of a range of references after it was put in order: [0, middle) and [middle, size), none of them empty.
struct Split {
  std::size_t middle = 0;
  ReferenceBounds left, right;
};

}  // namespace vernier
