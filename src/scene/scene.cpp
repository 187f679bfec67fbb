#include "scene/scene.h"

#include <algorithm>

namespace vernier {

void note_file(std::vector<std::string>& files, const std::string& path) {
  if (std::ranges::find(files, path) == files.end()) files.push_back(path);
}

}  // namespace vernier
