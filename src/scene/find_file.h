#pragma once

#include <string>

namespace vernier {

/// The regular file at `path`, or with `any_case` one whose name, but not its folder's, differs from it in the case of
/// ASCII letters alone, of several the first by name: models come from machines where that is the same. Empty where
/// there is none.
std::string find_file(const std::string& path, bool any_case);

}  // namespace vernier
