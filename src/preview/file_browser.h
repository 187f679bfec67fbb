#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "preview/widgets.h"

namespace vernier {

/// Chooses a scene file: recent ones, and folders to walk through.
class FileBrowser {
 public:
  /// Shows itself from the next frame on, at the folder it was closed at.
  void open();
  /// Scenes opened before, the last one first.
  void set_recent(std::vector<std::string> files) { recent_ = std::move(files); }
  /// Begins at the folder of `file`.
  void start_at(const std::string& file);
  /// Draws it, if it is open, and returns the file that was chosen.
  std::optional<std::string> draw(WidgetPlaces& places);

 private:
  struct Entry {
    std::string name;
    bool is_folder = false;
  };
  void enter(const std::filesystem::path& folder);
  std::optional<std::string> draw_recent() const;
  std::optional<std::string> draw_entries(WidgetPlaces& places);

  bool open_ = false;
  std::filesystem::path folder_;
  std::string typed_;
  std::vector<Entry> entries_;
  std::vector<std::string> recent_;
};

}  // namespace vernier
