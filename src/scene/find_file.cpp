#include "scene/find_file.h"

#include <algorithm>
#include <filesystem>

namespace vernier {
namespace {

namespace fs = std::filesystem;

char lower(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

}  // namespace

std::string find_file(const std::string& path, bool any_case) {
  std::error_code failure;
  if (fs::is_regular_file(path, failure)) return path;
  if (!any_case) return "";
  const std::string wanted = fs::path(path).filename().string();
  const std::string folder = path.substr(0, path.size() - wanted.size());
  std::string found;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    if (!std::ranges::equal(name, wanted, {}, lower, lower) || (!found.empty() && found < name)) continue;
    if (fs::is_regular_file(entry->path(), failure)) found = name;
  }
  return found.empty() ? "" : folder + found;
}

}  // namespace vernier
