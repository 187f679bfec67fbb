#include "scene/logical_lines.h"

#include <algorithm>

#include "scene/text_words.h"

namespace vernier {

LogicalLines::LogicalLines(std::string_view text) : text_(text) {
  if (text_.starts_with("\xEF\xBB\xBF")) position_ = 3;
}

std::string_view LogicalLines::next() {
  joined_.clear();
  while (!at_end()) {
    const std::size_t start = position_;
    const std::size_t end = std::min(text_.find_first_of("\n\r", start), text_.size());
    const bool crlf = text_.compare(end, 2, "\r\n") == 0;
    position_ = std::min(end + (crlf ? 2 : 1), text_.size());
    ++line_;
    std::string_view part = trimmed(text_.substr(start, end - start));
    const bool goes_on = part.ends_with('\\') && !(joined_.empty() && part.starts_with('#'));
    if (!goes_on && joined_.empty()) return part;
    if (goes_on) part.remove_suffix(1);
    joined_ += part;
    if (!goes_on) break;
    joined_ += ' ';
  }
  return trimmed(joined_);
}

}  // namespace vernier
