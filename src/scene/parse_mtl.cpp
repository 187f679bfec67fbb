#include "scene/parse_mtl.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "scene/logical_lines.h"
#include "scene/text_words.h"

namespace vernier {
namespace {

std::optional<double> number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

const std::map<std::string_view, std::optional<glm::dvec3> MtlMaterial::*> kColors = {
    {"Kd", &MtlMaterial::diffuse},  {"Ks", &MtlMaterial::specular},     {"Ka", &MtlMaterial::ambient},
    {"Ke", &MtlMaterial::emission}, {"Tf", &MtlMaterial::transmission}, {"Kt", &MtlMaterial::transmission}};

const std::map<std::string_view, MtlMap> kMaps = {
    {"map_Kd", MtlMap::diffuse},  {"map_Ks", MtlMap::specular}, {"map_Ka", MtlMap::ambient},
    {"map_Ke", MtlMap::emission}, {"map_Ns", MtlMap::exponent}, {"map_d", MtlMap::dissolve},
    {"map_bump", MtlMap::bump},   {"map_Bump", MtlMap::bump},   {"bump", MtlMap::bump},
    {"norm", MtlMap::normal},     {"map_Kn", MtlMap::normal}};

// Options of maps and the most values they take. Those that only steer filtering are dropped without a word.
const std::map<std::string_view, int> kOptionValues = {
    {"-s", 3},    {"-o", 3},      {"-t", 3},      {"-mm", 2},    {"-bm", 1},     {"-clamp", 1}, {"-imfchan", 1},
    {"-type", 1}, {"-blendu", 1}, {"-blendv", 1}, {"-boost", 1}, {"-texres", 1}, {"-cc", 1},    {"-colorspace", 1}};

bool is_numeric_option(std::string_view option) {
  return option == "-s" || option == "-o" || option == "-t" || option == "-mm" || option == "-bm" || option == "-boost";
}

class MtlParser {
 public:
  MtlLibrary parse(std::string_view text) {
    LogicalLines lines(text);
    while (!lines.at_end()) {
      std::string_view rest = lines.next();
      line_ = lines.last_line();
      const std::string_view keyword = take_word(rest);
      if (!keyword.empty() && keyword[0] != '#') statement(keyword, rest);
    }
    return std::move(library_);
  }

 private:
  void statement(std::string_view keyword, std::string_view rest) {
    if (keyword == "newmtl") {
      library_.materials.emplace_back().name = rest;
      has_dissolve_ = false;
      return;
    }
    if (library_.materials.empty()) return;
    MtlMaterial& material = library_.materials.back();
    if (const auto color = kColors.find(keyword); color != kColors.end()) {
      set_color(material.*(color->second), keyword, rest);
    } else if (const auto map = kMaps.find(keyword); map != kMaps.end()) {
      set_map(material.maps[static_cast<std::size_t>(map->second)], keyword, rest);
    } else {
      set_scalar(material, keyword, rest);
    }
  }

  void set_scalar(MtlMaterial& material, std::string_view keyword, std::string_view rest) {
    if (keyword == "Ns") {
      material.exponent = finite(keyword, rest);
    } else if (keyword == "Ni") {
      material.ior = finite(keyword, rest);
    } else if (keyword == "illum") {
      set_illumination(material, rest);
    } else if (keyword == "d") {
      if (rest.starts_with("-halo")) {
        take_word(rest);
        unsupported("d -halo");
      }
      material.opacity = finite(keyword, rest);
      has_dissolve_ = true;
    } else if (keyword == "Tr") {
      // d wins: Tr is not of the MTL text, and some exporters write both with Tr = d.
      const std::optional<double> transparency = finite(keyword, rest);
      if (!has_dissolve_ && transparency) material.opacity = 1.0 - *transparency;
    } else if (keyword != "sharpness" && keyword != "map_aat") {
      unsupported(std::string(keyword));
    }
  }

  void set_illumination(MtlMaterial& material, std::string_view rest) {
    const std::optional<double> model = finite("illum", rest);
    if (!model) return;
    if (*model >= 0.0 && *model < 10.0) {
      material.illumination = static_cast<int>(*model);
    } else {
      unsupported("illum " + std::string(rest));
    }
  }

  void set_color(std::optional<glm::dvec3>& color, std::string_view keyword, std::string_view rest) {
    if (rest.starts_with("spectral") || rest.starts_with("xyz")) {
      unsupported(std::string(keyword) + " " + std::string(take_word(rest)));
      return;
    }
    const std::optional<double> r = finite(keyword, take_word(rest));
    if (!r) return;
    glm::dvec3 value(*r);  // one number is a grey
    for (const int channel : {1, 2}) {
      const std::string_view word = take_word(rest);
      if (word.empty() || word[0] == '#') break;
      const std::optional<double> given = finite(keyword, word);
      if (!given) return;
      for (int c = channel; c < 3; ++c) value[c] = *given;
    }
    color = glm::max(value, glm::dvec3(0.0));
  }

  void set_map(MtlTexture& map, std::string_view keyword, std::string_view rest) {
    map = MtlTexture{};
    while (rest.starts_with('-') && option(map, keyword, rest)) {
    }
    rest = options_after_name(map, keyword, trimmed(rest));
    map.file = std::string(rest);
    if (rest.empty()) fault(std::string(keyword) + " names no file");
  }

  // Applies the option at the start of `rest` and cuts it off; false, `rest` untouched, where there is none.
  bool option(MtlTexture& map, std::string_view keyword, std::string_view& rest) {
    std::string_view after = rest;
    const std::string_view name = take_word(after);
    const auto known = kOptionValues.find(name);
    if (known == kOptionValues.end()) return false;
    std::vector<std::string_view> words;
    while (words.size() < static_cast<std::size_t>(known->second) && !after.empty()) {
      std::string_view next = after;
      const std::string_view word = take_word(next);
      // The second and third number are optional, and the file name may stand in their place.
      if (is_numeric_option(name) && !number(word)) break;
      words.push_back(word);
      after = next;
    }
    rest = after;
    apply(map, keyword, name, words);
    return true;
  }

  void apply(MtlTexture& map, std::string_view keyword, std::string_view name,
             const std::vector<std::string_view>& words) {
    const auto value = [&](std::size_t i, double absent) {
      const double given = i < words.size() ? number(words[i]).value_or(absent) : absent;
      return std::isfinite(given) ? given : absent;
    };
    if (name == "-s") {
      map.scale = glm::dvec2(value(0, 1.0), value(1, 1.0));
    } else if (name == "-o") {
      map.offset = glm::dvec2(value(0, 0.0), value(1, 0.0));
    } else if (name == "-bm") {
      map.bump_multiplier = value(0, 1.0);
    } else if (name == "-clamp") {
      map.clamp = words.empty() || words[0] == "on";
    } else if (name == "-imfchan") {
      map.channel = words.empty() ? '\0' : words[0][0];
    } else if (name == "-t" || name == "-mm" || name == "-cc" || name == "-type") {
      bool neutral = name == "-t" && value(0, 0.0) == 0.0 && value(1, 0.0) == 0.0;
      if (name == "-mm") neutral = value(0, 0.0) == 0.0 && value(1, 1.0) == 1.0;
      if (name == "-cc") neutral = !words.empty() && words[0] == "off";
      if (!neutral) unsupported(std::string(keyword) + " " + std::string(name));
    }
  }

  // Some exporters write options behind the name: `bump stone.png -bm 2`. Returns the name alone.
  std::string_view options_after_name(MtlTexture& map, std::string_view keyword, std::string_view text) {
    for (std::size_t dash = text.find(" -"); dash != std::string_view::npos; dash = text.find(" -", dash + 1)) {
      std::string_view rest = trimmed(text.substr(dash));
      if (!option(map, keyword, rest)) continue;
      while (!rest.empty() && option(map, keyword, rest)) {
      }
      return trimmed(text.substr(0, dash));
    }
    return text;
  }

  std::optional<double> finite(std::string_view keyword, std::string_view rest) {
    const std::optional<double> value = number(take_word(rest));
    if (value && std::isfinite(*value)) return value;
    fault(std::string(keyword) + " is not a finite number");
    return std::nullopt;
  }

  void unsupported(const std::string& what) {
    if (told_.insert(what).second) note(library_.unsupported, what + " is not supported");
  }

  void fault(const std::string& what) {
    if (told_.insert(what).second) note(library_.faults, what + " and is left out");
  }

  // Text of the file ends up in these lines: only what can be printed, and of a garbage file not all.
  void note(std::vector<std::string>& lines, std::string what) const {
    constexpr std::size_t kMostLines = 16;
    constexpr std::size_t kLongestLine = 80;
    if (lines.size() == kMostLines) return;
    what.resize(std::min(what.size(), kLongestLine));
    for (char& c : what) c = c >= ' ' && c <= '~' ? c : '?';
    lines.push_back("line " + std::to_string(line_) + ": " + what);
  }

  MtlLibrary library_;
  std::set<std::string> told_;
  std::size_t line_ = 0;
  bool has_dissolve_ = false;
};

}  // namespace

MtlLibrary parse_mtl(std::string_view text) {
  return MtlParser().parse(text);
}

}  // namespace vernier
