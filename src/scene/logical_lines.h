#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace vernier {

/// The lines of an OBJ or MTL text: ends of all systems, a byte order mark left out, a line that ends in a backslash
/// joined with the next by a blank. A comment ends with its line.
class LogicalLines {
 public:
  /// `text` has to outlive this.
  explicit LogicalLines(std::string_view text);

  /// Whether all were handed out.
  bool at_end() const { return position_ >= text_.size(); }
  /// The next one, without blanks at its ends; valid until the next call. Empty at the end.
  std::string_view next();
  /// Number, from 1, of the last line of the text that the last one handed out holds.
  std::size_t last_line() const { return line_; }

 private:
  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
  std::string joined_;
};

}  // namespace vernier
