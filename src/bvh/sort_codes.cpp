#include "bvh/sort_codes.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace vernier {
namespace {

// Three passes. More would scatter to more places at once than the second cache keeps open.
constexpr int kDigitBits = 13;
constexpr int kCodeBits = 63;
// Codes seldom agree in the bits above these without being equal: a cell is 2^-13 of the scene. Runs that do are put in
// order one by one, which spares two passes over all.
constexpr int kLowBits = 24;
constexpr std::size_t kDigitCount = std::size_t{1} << kDigitBits;
// References per piece at least: threads cost more than a smaller one saves.
constexpr std::size_t kLeastPiece = 16384;

// For each digit how many references of a piece have it, then where the first of them goes.
using DigitPlaces = std::array<std::uint32_t, kDigitCount>;

std::size_t digit_of(const CodedReference& reference, int shift) {
  return reference.code >> shift & (kDigitCount - 1);
}

class RadixSort {
 public:
  RadixSort(std::span<const CodedReference> from, ThreadTeam& team)
      : from_(from),
        team_(team),
        piece_(std::max(from.size() / team.thread_count() + 1, kLeastPiece)),
        places_((from.size() + piece_ - 1) / piece_) {}

  // Moves all from the one array to `to`, in order of the digit at `shift`; false, and nothing, where all have the
  // same.
  bool pass(CodedReference* to, int shift) {
    team_.run(places_.size(), [&](std::size_t i) {
      places_[i].fill(0);
      for (const CodedReference& reference : piece(i)) ++places_[i][digit_of(reference, shift)];
    });
    if (!turn_counts_to_places(digit_of(from_.front(), shift))) return false;
    team_.run(places_.size(), [&](std::size_t i) {
      for (const CodedReference& reference : piece(i)) to[places_[i][digit_of(reference, shift)]++] = reference;
    });
    from_ = {to, from_.size()};
    return true;
  }

 private:
  std::span<const CodedReference> piece(std::size_t index) const {
    return from_.subspan(index * piece_, std::min(piece_, from_.size() - index * piece_));
  }

  // By digit, then by piece: equal digits keep their order, whatever the number of pieces.
  bool turn_counts_to_places(std::size_t digit_of_first) {
    std::uint32_t place = 0;
    for (std::size_t digit = 0; digit < kDigitCount; ++digit) {
      const std::uint32_t begin = place;
      for (DigitPlaces& places : places_) {
        const std::uint32_t here = places[digit];
        places[digit] = place;
        place += here;
      }
      if (digit == digit_of_first && place - begin == from_.size()) return false;
    }
    return true;
  }

  std::span<const CodedReference> from_;
  ThreadTeam& team_;
  std::size_t piece_;
  std::vector<DigitPlaces> places_;
};

bool comes_first(const CodedReference& a, const CodedReference& b) {
  return a.code != b.code ? a.code < b.code : a.reference < b.reference;
}

// Puts the runs of equal high bits that begin in [begin, end) in order, the last one to its end.
void sort_runs(std::span<CodedReference> references, std::size_t begin, std::size_t end) {
  const auto high_bits = [&](std::size_t place) { return references[place].code >> kLowBits; };
  while (begin > 0 && begin < end && high_bits(begin) == high_bits(begin - 1)) ++begin;
  while (begin < end) {
    std::size_t run_end = begin + 1;
    while (run_end < references.size() && high_bits(run_end) == high_bits(begin)) ++run_end;
    if (run_end - begin > 1) std::ranges::sort(references.subspan(begin, run_end - begin), comes_first);
    begin = run_end;
  }
}

}  // namespace

std::span<const CodedReference> sort_by_code(std::span<CodedReference> references, std::span<CodedReference> other,
                                             ThreadTeam& team) {
  if (references.size() < 2) return references;
  RadixSort sort(references, team);
  for (int shift = kLowBits; shift < kCodeBits; shift += kDigitBits) {
    if (sort.pass(other.data(), shift)) std::swap(references, other);
  }
  team.run((references.size() + kLeastPiece - 1) / kLeastPiece, [&](std::size_t i) {
    sort_runs(references, i * kLeastPiece, std::min((i + 1) * kLeastPiece, references.size()));
  });
  return references;
}

}  // namespace vernier
