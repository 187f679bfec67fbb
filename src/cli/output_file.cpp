#include "cli/output_file.h"

#include <unistd.h>

#include <filesystem>

#include "error.h"
#include "image/file_format.h"

namespace vernier {

std::string default_image_path(const std::string& scene) {
  return scene.empty() ? "vernier.png" : std::filesystem::path(scene).stem().string() + ".png";
}

void check_text_output(const std::string& path) {
  if (path.empty()) {
    return;
  }
  std::error_code failure;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const std::string place = folder.empty() ? "." : folder.string();
  if (!std::filesystem::is_directory(place, failure)) {
    throw Error(ErrorKind::failed, path + ": there is no folder " + place);
  }
  if (std::filesystem::is_directory(path, failure)) {
    throw Error(ErrorKind::failed, path + ": is a folder");
  }
  if (access(place.c_str(), W_OK) != 0 && !std::filesystem::exists(path, failure)) {
    throw Error(ErrorKind::failed, path + ": the folder " + place + " may not be written");
  }
}

void check_image_output(const std::string& path) {
  file_format(path, ErrorKind::usage);
  check_text_output(path);
}

}  // namespace vernier
