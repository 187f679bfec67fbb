#pragma once

#include <string>
#include <string_view>

namespace vernier {

/// Blank inside a line of OBJ and MTL.
inline constexpr std::string_view kBlanks = " \t\r\v\f";

/// `text` without blanks at both ends.
std::string_view trimmed(std::string_view text);

/// Cuts the first blank-separated word off `text` and returns it; both empty at the end. `text` loses blanks at its
/// start.
std::string_view take_word(std::string_view& text);

/// `text` without a comment at its end: a # behind a blank. Names may have that, too (`Material #25`).
std::string_view without_comment(std::string_view text);

/// `text` in quotes for a message: what cannot be printed becomes '?', and what is beyond 40 characters is left out.
std::string printable(std::string_view text);

}  // namespace vernier
