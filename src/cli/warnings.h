#pragma once

#include <string>
#include <vector>

namespace vernier {

/// `text` as one line for a terminal: what controls one becomes '?', and the middle of what is longer than 8192
/// bytes is left out. Files may say anything.
std::string terminal_line(std::string text);

/// Prints one line `warning: ...` each on stderr, a hundred at most and then how many more there are.
void print_warnings(const std::vector<std::string>& warnings);

}  // namespace vernier
