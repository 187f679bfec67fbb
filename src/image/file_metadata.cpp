#include "image/file_metadata.h"

#include <sstream>

namespace vernier {
namespace {

constexpr const char* kMark = "vernier metadata";

// `equals` stands for every = of the text.
std::string escape(const std::string& text, const char* equals) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '\\')
      escaped += "\\\\";
    else if (letter == '\n')
      escaped += "\\n";
    else if (letter == '=')
      escaped += equals;
    else
      escaped += letter;
  }
  return escaped;
}

std::string unescape(const std::string& escaped) {
  std::string text;
  for (std::size_t i = 0; i < escaped.size(); ++i) {
    if (escaped[i] != '\\' || i + 1 == escaped.size()) {
      text += escaped[i];
      continue;
    }
    const char letter = escaped[++i];
    text += letter == 'n' ? '\n' : letter == 'e' ? '=' : letter;
  }
  return text;
}

}  // namespace

std::string text_of_metadata(const std::map<std::string, std::string>& metadata) {
  if (metadata.empty()) return "";
  std::string text = kMark;
  for (const auto& [name, value] : metadata) text += "\n" + escape(name, "\\e") + "=" + escape(value, "=");
  return text;
}

std::map<std::string, std::string> metadata_of_text(const std::string& text) {
  std::map<std::string, std::string> metadata;
  std::istringstream lines(text);
  std::string line;
  if (!std::getline(lines, line) || line != kMark) return metadata;
  while (std::getline(lines, line)) {
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos) metadata[unescape(line.substr(0, equals))] = unescape(line.substr(equals + 1));
  }
  return metadata;
}

}  // namespace vernier
