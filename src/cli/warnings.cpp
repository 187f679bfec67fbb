#include "cli/warnings.h"

#include <algorithm>
#include <cstdio>

namespace vernier {

std::string terminal_line(std::string text) {
  // The end tells what is wrong, the beginning where. Commands to go on by have room.
  constexpr std::size_t kLongest = 8192, kKeptAtTheEnd = 1000;
  if (text.size() > kLongest) {
    text = text.substr(0, kLongest - kKeptAtTheEnd) + " ... " + text.substr(text.size() - kKeptAtTheEnd);
  }
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < ' ' || c == 0x7f; }, '?');
  return text;
}

void print_warnings(const std::vector<std::string>& warnings) {
  constexpr std::size_t kMost = 100;
  for (std::size_t i = 0; i < std::min(warnings.size(), kMost); ++i) {
    std::fprintf(stderr, "warning: %s\n", terminal_line(warnings[i]).c_str());
  }
  if (warnings.size() > kMost) std::fprintf(stderr, "warning: %zu more are left out\n", warnings.size() - kMost);
}

}  // namespace vernier
