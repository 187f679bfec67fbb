#include "cli/match_recipes.h"

#include <array>

#include "cli/json_text.h"
#include "cli/parse_values.h"
#include "cli/read_recipe.h"
#include "error.h"
#include "gpu/vector_width.h"

namespace vernier {
namespace {

using Metadata = std::map<std::string, std::string>;

struct Field {
  const char* name;
  const char* meaning;
  const char* hint;
};

constexpr std::array kFields = {
    Field{"vernier:version", "version", ""},
    Field{"vernier:scene_sha1", "SHA-1 of the scene's files", ""},
    Field{"vernier:device", "device", "; another device may give other bits"},
    Field{"vernier:driver", "driver", "; another driver may give other bits"},
    Field{"vernier:spirv_hash", "hash of the shaders", ""},
    Field{"vernier:exposure", "--exposure", ""},
};

// A device's name is taken without the width of its vectors: no bit hangs on that.
std::string value_of(const Metadata& metadata, const char* name) {
  const auto entry = metadata.find(name);
  return entry == metadata.end() ? "" : without_vector_width(entry->second);
}

std::string text_of(const nlohmann::ordered_json& options, const std::string& name) {
  const auto option = options.find(name);
  if (option == options.end()) return "";
  return option->is_string() ? option->get<std::string>() : json_line(*option);
}

/// The same text, or the same number in other words.
bool is_same(const std::string& text_a, const std::string& text_b) {
  if (text_a == text_b) return true;
  try {
    return parse_number("", text_a) == parse_number("", text_b);
  } catch (const Error&) {
    return false;
  }
}

std::string quoted(const std::string& text) {
  return text.empty() ? "not set" : "`" + text + "`";
}

[[noreturn]] void refuse(const std::string& name_a, const std::string& name_b, const std::string& what,
                         const std::string& text_a, const std::string& text_b, const std::string& hint) {
  throw Error(ErrorKind::refused, name_b + ": does not belong to " + name_a + ": " + what + " is " + quoted(text_b) +
                                      ", there " + quoted(text_a) + hint);
}

}  // namespace

void match_recipes(const std::string& name_a, const Metadata& a, const std::string& name_b, const Metadata& b,
                   const std::set<std::string>& free_options) {
  for (const Field& field : kFields) {
    const std::string text_a = value_of(a, field.name), text_b = value_of(b, field.name);
    if (!is_same(text_a, text_b)) refuse(name_a, name_b, field.meaning, text_a, text_b, field.hint);
  }
  const nlohmann::ordered_json options_a = read_options(name_a, a), options_b = read_options(name_b, b);
  nlohmann::ordered_json all = options_a;
  all.update(options_b);
  for (const auto& [name, unused] : all.items()) {
    if (free_options.contains(name)) continue;
    const std::string text_a = text_of(options_a, name), text_b = text_of(options_b, name);
    if (!is_same(text_a, text_b)) refuse(name_a, name_b, "--" + name, text_a, text_b, "");
  }
}

}  // namespace vernier
