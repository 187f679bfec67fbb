#include "preview/script.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include "error.h"

namespace vernier {
namespace {

/// The words of an event: n a number, w a word, k a key, b a button, r the rest of the line.
struct Verb {
  const char* name;
  const char* words;
};

constexpr std::array<Verb, 17> kVerbs = {{{"wait", "n"},
                                          {"settle", ""},
                                          {"move", "nn"},
                                          {"press", "b"},
                                          {"release", "b"},
                                          {"wheel", "n"},
                                          {"hold", "k"},
                                          {"let", "k"},
                                          {"key", "k"},
                                          {"click", "r"},
                                          {"size", "nn"},
                                          {"drop", "r"},
                                          {"open", "r"},
                                          {"set", "wr"},
                                          {"shot", "w"},
                                          {"close", ""},
                                          {"lose-device", ""}}};

[[noreturn]] void refuse(const std::string& name, int line, const std::string& what) {
  throw Error(ErrorKind::usage, name + ": line " + std::to_string(line) + ": " + what);
}

double number_of(const std::string& name, int line, const std::string& word) {
  double value = 0.0;
  const char* end = word.data() + word.size();
  const auto [rest, failure] = std::from_chars(word.data(), end, value);
  if (failure != std::errc() || rest != end || !std::isfinite(value)) refuse(name, line, "`" + word + "` is no number");
  return value;
}

bool is_button(const std::string& word) {
  return word == "left" || word == "right" || word == "middle";
}

void read_word(const std::string& name, char kind, std::istringstream& words, ScriptEvent& event) {
  std::string word;
  if (kind == 'r') {
    std::getline(words >> std::ws, word);
  } else {
    words >> word;
  }
  if (word.empty()) refuse(name, event.line, "`" + event.verb + "` needs more words");
  if (kind == 'n') event.numbers.push_back(number_of(name, event.line, word));
  if (kind == 'k' && key_code(word) < 0) refuse(name, event.line, "there is no key `" + word + "`");
  if (kind == 'b' && !is_button(word)) refuse(name, event.line, "`" + word + "` is not left, middle or right");
  event.words.push_back(word);
}

bool is_window_size(const ScriptEvent& event) {
  constexpr double kMostSide = 16384.0;  // beyond any screen; window systems count in 16 bits
  return std::ranges::all_of(event.numbers, [](double side) { return side >= 1.0 && side <= kMostSide; });
}

ScriptEvent parse_line(const std::string& name, int line, const std::string& text) {
  std::istringstream words(text);
  ScriptEvent event;
  event.line = line;
  words >> event.verb;
  for (const Verb& verb : kVerbs) {
    if (event.verb != verb.name) continue;
    for (const char* kind = verb.words; *kind != '\0'; ++kind) read_word(name, *kind, words, event);
    std::string rest;
    if (words >> rest) refuse(name, line, "`" + rest + "` is too much");
    if (event.verb == "size" && !is_window_size(event)) refuse(name, line, "no window has that size");
    return event;
  }
  refuse(name, line, "there is no event `" + event.verb + "`");
}

}  // namespace

std::vector<ScriptEvent> parse_script(const std::string& name, std::string_view text) {
  std::vector<ScriptEvent> events;
  std::istringstream lines{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    events.push_back(parse_line(name, number, line));
  }
  return events;
}

int key_code(const std::string& name) {
  if (name.size() == 1 && name[0] >= 'a' && name[0] <= 'z') return GLFW_KEY_A + (name[0] - 'a');
  if (name.size() == 1 && name[0] >= '0' && name[0] <= '9') return GLFW_KEY_0 + (name[0] - '0');
  if (name == "escape") return GLFW_KEY_ESCAPE;
  return name == "enter" ? GLFW_KEY_ENTER : -1;
}

}  // namespace vernier
