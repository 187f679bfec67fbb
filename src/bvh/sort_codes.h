#pragma once

#include <cstdint>

#include "bvh/large_array.h"

namespace vernier {

/// Where a triangle's centre lies (MortonGrid) and the number of its reference.
struct CodedReference {
  std::uint64_t code;
  std::uint32_t reference;
};

/// Puts `references` in order of their codes on `thread_count` (at least 1) threads; equal codes keep their
/// order. 11 bits a pass from the lowest up (radix sort); what all codes share costs no pass. 16 bytes per reference
/// beside the input.
void sort_by_code(LargeArray<CodedReference>& references, unsigned thread_count);

}  // namespace vernier
