#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vernier {

/// One line of a script of events: what to do, and with what.
struct ScriptEvent {
  int line = 0;  ///< counted from 1
  std::string verb;
  std::vector<std::string> words;
  std::vector<double> numbers;  ///< of the words that are numbers by the verb's rule
};

/// The events of `text`: one a line, words between spaces, the last word of some with spaces in it; empty lines and
/// those that begin with # are none. Throws Error(usage) with `name` and the line for an unknown event, too few words
/// and what is no number. Pure.
std::vector<ScriptEvent> parse_script(const std::string& name, std::string_view text);

/// The key that scripts call `name` (a letter, a digit, escape, enter), as the window system counts it; -1: there is
/// none.
int key_code(const std::string& name);

}  // namespace vernier
