#pragma once

#include <cstdint>
#include <span>

#include "math/thread_team.h"

namespace vernier {

/// Where a triangle's centre lies (MortonGrid) and the number of its reference.
struct CodedReference {
  std::uint64_t code;
  std::uint32_t reference;
};

/// Puts `references`, whose numbers rise, in order of their codes and then of their numbers on the threads of `team`: a
/// radix sort of the upper 39 bits, 13 a pass from the lowest up (a digit that all share costs no pass), then runs that
/// agree in those. O(n), or O(n log n) where most triangles lie in one 2^-13th of the scene. Returns where they are in
/// order, `references` or `other`, which is as large.
std::span<const CodedReference> sort_by_code(std::span<CodedReference> references, std::span<CodedReference> other,
                                             ThreadTeam& team);

}  // namespace vernier
