#pragma once

#include <span>
#include <string>
#include <vector>

namespace vernier {

/// The image file of a render of `scene` for which -o was not given: NAME.png in the current folder for
/// FOLDER/NAME.EXT, vernier.png for the built-in scene (empty).
std::string default_image_path(const std::string& scene);

/// Finds out before the work whether `path` can be written at its end: an image extension (Error(usage) otherwise),
/// and a folder that exists and may be written (Error(failed) otherwise). An existing file is fine.
void check_image_output(const std::string& path);

/// Throws Error(usage) where an image of `width` x `height` pixels cannot be written in the format of `path`.
void check_image_size(const std::string& path, int width, int height);

/// A file that a command line names.
struct NamedFile {
  const char* option;
  std::string path;      ///< empty: none
  bool is_read = false;  ///< else written
};

/// Throws Error(usage) where two of `files` are the same, links followed, and not both read: one would be lost.
void check_distinct(std::span<const NamedFile> files);

/// The same for what is written, `outputs`, and the files that a scene was read from.
void check_not_read(std::span<const NamedFile> outputs, const std::vector<std::string>& scene_files);

/// What is told on standard output, `text`: left out where `json_file`, which --json names, is `-` and has it.
void print_result(const std::string& json_file, const std::string& text);

/// Writes `json` to the file that --json names: `-` is standard output, and none is asked for where it is empty.
void write_json(const std::string& json_file, const std::string& json);

/// The same as check_text_output for the file that --json names.
void check_json_output(const std::string& json_file);

/// The same as check_image_output for a file of any extension; an empty path (not asked for) is fine.
void check_text_output(const std::string& path);

}  // namespace vernier
