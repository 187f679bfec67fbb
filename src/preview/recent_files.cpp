#include "preview/recent_files.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "error.h"
#include "image/whole_file.h"

namespace vernier {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRecent = 10;

}  // namespace

std::string recent_files_path() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && fs::path(state).is_absolute()) return (fs::path(state) / "vernier/recent").string();
  const char* home = std::getenv("HOME");
  if (home != nullptr && fs::path(home).is_absolute()) return (fs::path(home) / ".local/state/vernier/recent").string();
  return "";
}

std::vector<std::string> read_recent_files(const std::string& file) {
  std::vector<std::string> files;
  std::ifstream lines(file);
  for (std::string line; files.size() < kMostRecent && std::getline(lines, line);) {
    if (!line.empty()) files.push_back(line);
  }
  return files;
}

std::vector<std::string> with_recent(std::vector<std::string> files, const std::string& opened) {
  std::erase(files, opened);
  files.insert(files.begin(), opened);
  if (files.size() > kMostRecent) files.resize(kMostRecent);
  return files;
}

void write_recent_files(const std::string& file, const std::vector<std::string>& files) {
  if (file.empty()) return;
  std::string text;
  for (const std::string& path : files) text += path + "\n";
  std::error_code failure;
  fs::create_directories(fs::path(file).parent_path(), failure);
  try {
    write_text(file, text);
  } catch (const Error&) {
    // See the docstring.
  }
}

}  // namespace vernier
