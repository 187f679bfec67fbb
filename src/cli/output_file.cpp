#include "cli/output_file.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "error.h"
#include "image/file_format.h"
#include "image/whole_file.h"

namespace vernier {

namespace fs = std::filesystem;

namespace {

constexpr const char* kStandardOutput = "-";  // of --json, as scripts write it

}  // namespace

std::string default_image_path(const std::string& scene) {
  return scene.empty() ? "vernier.png" : fs::path(scene).stem().string() + ".png";
}

void check_text_output(const std::string& path) {
  if (path.empty() || path == "/dev/stdout") return;  // printed, see write_text
  const fs::path target = written_file(path);
  std::error_code failure;
  const std::string place = target.has_parent_path() ? target.parent_path().string() : ".";
  if (!fs::is_directory(place, failure)) {
    throw Error(ErrorKind::failed, path + ": there is no folder " + place);
  }
  if (fs::is_directory(target, failure)) {
    throw Error(ErrorKind::failed, path + ": is a folder");
  }
  const bool is_there = fs::exists(target, failure);
  // A new file is written beside it and then renamed.
  if ((!is_there || fs::is_regular_file(target, failure)) && access(place.c_str(), W_OK) != 0) {
    throw Error(ErrorKind::failed, path + ": the folder " + place + " may not be written");
  }
  if (is_there && access(target.c_str(), W_OK) != 0) throw Error(ErrorKind::failed, path + ": may not be written");
}

void check_image_size(const std::string& path, int width, int height) {
  const bool is_jpeg = file_format(path, ErrorKind::usage) == FileFormat::jpeg;
  if (is_jpeg && std::max(width, height) > kMostJpegSide_px) {
    throw Error(ErrorKind::usage,
                path + ": a side of a JPEG has at most " + std::to_string(kMostJpegSide_px) + " pixels");
  }
}

void check_distinct(std::span<const NamedFile> files) {
  std::map<fs::path, const NamedFile*> seen;
  for (const NamedFile& file : files) {
    if (file.path.empty()) continue;
    std::error_code failure;
    const fs::path place = fs::weakly_canonical(fs::absolute(file.path, failure), failure);
    // What is written to a device or a pipe replaces nothing.
    if (failure || (fs::exists(place, failure) && !fs::is_regular_file(place, failure))) continue;
    const auto [entry, is_new] = seen.try_emplace(place, &file);
    if (is_new || (entry->second->is_read && file.is_read)) continue;
    throw Error(ErrorKind::usage,
                std::string(file.option) + ": it names the same file as " + entry->second->option + ", " + file.path);
  }
}

void check_not_read(std::span<const NamedFile> outputs, const std::vector<std::string>& scene_files) {
  std::vector<NamedFile> files;
  for (const std::string& file : scene_files) files.push_back({"a file of the scene", file, true});
  files.insert(files.end(), outputs.begin(), outputs.end());
  check_distinct(files);
}

void print_result(const std::string& json_file, const std::string& text) {
  if (json_file == kStandardOutput) return;
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

void write_json(const std::string& json_file, const std::string& json) {
  if (json_file == kStandardOutput) {
    std::fputs(json.c_str(), stdout);
    std::fflush(stdout);
  } else if (!json_file.empty()) {
    write_text(json_file, json);
  }
}

void check_json_output(const std::string& json_file) {
  if (json_file != kStandardOutput) check_text_output(json_file);
}

void check_image_output(const std::string& path) {
  file_format(path, ErrorKind::usage);
  check_text_output(path);
}

}  // namespace vernier
