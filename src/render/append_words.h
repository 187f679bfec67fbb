#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace vernier {

/// Appends a struct of shaders/shared as the words that shaders read.
template <typename Struct>
void append_words(std::vector<std::uint32_t>& words, const Struct& value) {
  static_assert(sizeof(Struct) % sizeof(std::uint32_t) == 0);
  const std::size_t first = words.size();
  words.resize(first + sizeof(Struct) / sizeof(std::uint32_t));
  std::memcpy(words.data() + first, &value, sizeof(Struct));
}

}  // namespace vernier
