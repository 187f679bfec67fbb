#pragma once

#include <map>
#include <string>

namespace vernier {

/// All of `metadata` as one text, for formats that hold no attributes of free names: a first line that marks it, then
/// a line `name=value` each, in order of name, with \ as \\ and a line break as \n; in names also = as \e.
/// Empty metadata give an empty text.
std::string text_of_metadata(const std::map<std::string, std::string>& metadata);

/// The metadata that text_of_metadata made `text` of. Empty for a text without the mark; lines without = are ignored.
std::map<std::string, std::string> metadata_of_text(const std::string& text);

}  // namespace vernier
