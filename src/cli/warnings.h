#pragma once

#include <string>
#include <vector>

namespace vernier {

/// Prints one line `warning: ...` each on stderr.
void print_warnings(const std::vector<std::string>& warnings);

}  // namespace vernier
