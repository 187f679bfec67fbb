#include "scene/obj_line_filter.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <utility>

#include "error.h"
#include "scene/text_words.h"

namespace vernier {
namespace {

// Reads as infinity in tinyobjloader, which validate_scene finds.
constexpr std::string_view kInfinity = "1e999";
// Longer indices do not fit an int.
constexpr std::size_t kIndexDigits = 9;
// Statements that only ask for display or tessellation habits and change nothing about polygons.
constexpr std::array<std::string_view, 8> kSilentKeywords = {"bevel", "c_interp",   "d_interp",  "lod",
                                                             "mg",    "shadow_obj", "trace_obj", "ctech"};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// A decimal number in full: sign, digits with or without a point, exponent.
bool is_plain_number(std::string_view word) {
  std::size_t i = 0;
  const auto skip_digits = [&] {
    const std::size_t first = i;
    while (i < word.size() && is_digit(word[i])) ++i;
    return i - first;
  };
  const auto skip_sign = [&] { i += i < word.size() && (word[i] == '-' || word[i] == '+') ? 1 : 0; };
  skip_sign();
  std::size_t digits = skip_digits();
  if (i < word.size() && word[i] == '.') {
    ++i;
    digits += skip_digits();
  }
  if (digits == 0) return false;
  if (i < word.size() && (word[i] == 'e' || word[i] == 'E')) {
    ++i;
    skip_sign();
    if (skip_digits() == 0) return false;
  }
  return i == word.size();
}

// nan, -inf, -nan(ind), 1.#QNAN and the like, which printing to few digits rounds to 1.#QO or 1.#R.
bool is_non_finite(std::string_view word) {
  const std::size_t sign = word[0] == '-' || word[0] == '+' ? 1 : 0;
  std::string head(word.substr(sign, 3));
  std::ranges::transform(head, head.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  constexpr std::string_view kFirstLetters = "IQSJR";
  const bool is_microsofts =
      head == "1.#" && word.size() > sign + 3 && kFirstLetters.find(word[sign + 3]) != std::string_view::npos;
  return head == "nan" || head == "inf" || is_microsofts;
}

// i, i/j, i//k or i/j/k, with empty parts at the end left out; empty where it is none of them.
std::string_view face_corner(std::string_view word) {
  while (!word.empty() && word.back() == '/') word.remove_suffix(1);
  std::size_t digits = 0;
  std::size_t slashes = 0;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const bool starts = i == 0 || word[i - 1] == '/';
    if (is_digit(word[i])) {
      if (++digits > kIndexDigits) return {};
    } else if (word[i] == '/') {
      digits = 0;
      if (++slashes > 2) return {};
    } else if (!(starts && (word[i] == '-' || word[i] == '+'))) {
      return {};
    }
  }
  return !word.empty() && word[0] != '/' && is_digit(word.back()) ? word : std::string_view{};
}

// Of a corner as face_corner has it.
bool has_index_zero(std::string_view corner) {
  bool is_zero = false;
  for (std::size_t i = 0; i < corner.size(); ++i) {
    const bool starts = i == 0 || !is_digit(corner[i - 1]);
    is_zero = corner[i] == '0' && (starts || is_zero);
    if (is_zero && (i + 1 == corner.size() || !is_digit(corner[i + 1]))) return true;
  }
  return false;
}

}  // namespace

ObjLineFilter::ObjLineFilter(std::string file, std::string_view text) : file_(std::move(file)), lines_(text) {}

int ObjLineFilter::underflow() {
  out_.clear();
  while (out_.empty() && !lines_.at_end()) write(lines_.next());
  statements_.lines = line();
  if (out_.empty() && !std::exchange(ended_, true)) out_ = "f 1 1 1\n";
  if (out_.empty()) return traits_type::eof();
  setg(out_.data(), out_.data(), out_.data() + out_.size());
  return traits_type::to_int_type(out_[0]);
}

void ObjLineFilter::write(std::string_view text) {
  std::string_view rest = text;
  const std::string_view keyword = take_word(rest);
  if (keyword.empty() || keyword[0] == '#') return;
  if (keyword == "v" || keyword == "vn" || keyword == "vt") {
    write_vertex(text, keyword, rest);
  } else if (keyword == "f" || keyword == "fo") {
    write_face(rest);
  } else if (keyword == "usemtl") {
    write_material(rest);
  } else if (keyword == "mtllib") {
    keep_libraries(rest);
  } else if (keyword == "g" || keyword == "o" || keyword == "s") {
    std::size_t& first = keyword == "s" ? statements_.first_smoothing_face : statements_.first_group_face;
    first = std::min(first, statements_.face_lines.size());
    // Exporters write `s on` for group 1. A NUL would end the line early.
    const bool is_on = keyword == "s" && without_comment(rest) == "on";
    out_.append(keyword).append(" ").append(is_on ? "1" : rest);
    std::ranges::replace(out_, '\0', '?');
    out_ += '\n';
  } else if (keyword == "l" || keyword == "p") {
    if (statements_.thin_element_count++ == 0) statements_.thin_element_line = line();
  } else if (std::ranges::find(kSilentKeywords, keyword) == kSilentKeywords.end()) {
    keep_unknown(keyword);
  }
}

void ObjLineFilter::write_vertex(std::string_view text, std::string_view keyword, std::string_view rest) {
  const std::size_t least = keyword == "vt" ? 1 : 3;
  out_.append(keyword);
  std::size_t count = 0;
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    bool plain = is_plain_number(word);
    const bool finite = plain || !is_non_finite(word);
    const std::size_t comment = finite && !plain ? word.find('#') : std::string_view::npos;
    if (comment == 0) break;
    if (comment != std::string_view::npos) {
      word = word.substr(0, comment);
      rest = {};
      plain = is_plain_number(word);
    }
    if (finite && !plain) refuse(printable(word) + " is not a number");
    out_.append(" ").append(plain ? word : kInfinity);
    ++count;
  }
  uv_count_ += keyword == "vt" ? 1 : 0;
  normal_count_ += keyword == "vn" ? 1 : 0;
  if (count < least) refuse(printable(text) + " has fewer than " + std::to_string(least) + " numbers");
  out_ += '\n';
}

void ObjLineFilter::write_face(std::string_view rest) {
  out_ += 'f';
  std::uint32_t count = 0;
  bool has_zero = false;
  for (std::string_view word = take_word(rest); !word.empty() && word[0] != '#'; word = take_word(rest)) {
    const std::string_view corner = face_corner(word);
    if (corner.empty()) refuse(printable(word) + " is not a corner of a face");
    out_.append(" ").append(corner);
    if (corner.find('-') != std::string_view::npos) {
      statements_.counts_back = true;
      check_counted_back(corner);
    }
    has_zero |= has_index_zero(corner);
    ++count;
  }
  out_ += '\n';
  if (count < 3) {
    out_.clear();
    if (statements_.short_face_count++ == 0) statements_.short_face_line = line();
    return;
  }
  // Versions of tinyobjloader differ in where they allow it.
  if (has_zero) refuse("index 0 does not exist, indices count from 1 or back from -1");
  statements_.face_lines.push_back(static_cast<std::uint32_t>(line()));
  statements_.face_corner_counts.push_back(count);
}

// tinyobjloader takes what lies one before the first for none.
void ObjLineFilter::check_counted_back(std::string_view corner) const {
  const std::array<std::size_t, 3> counts = {std::numeric_limits<std::size_t>::max(), uv_count_, normal_count_};
  std::size_t slot = 0;
  for (std::size_t i = 0; i < corner.size(); ++i) {
    if (corner[i] == '/') ++slot;
    if (corner[i] != '-') continue;
    std::size_t back = 0;
    std::from_chars(corner.data() + i + 1, corner.data() + corner.size(), back);
    if (back > counts[slot]) refuse(printable(corner) + " counts back before the first of the file");
  }
}

void ObjLineFilter::write_material(std::string_view name) {
  statements_.first_material_face = std::min(statements_.first_material_face, statements_.face_lines.size());
  auto known = material_ids_.find(name);
  if (known == material_ids_.end()) {
    known = material_ids_.emplace(std::string(name), statements_.material_names.size()).first;
    statements_.material_names.emplace_back(name);
    // The loader's material reader turns this number into a name that usemtl can find.
    out_.append("mtllib ").append(std::to_string(known->second)).append("\n");
  }
  out_.append("usemtl ").append(std::to_string(known->second)).append("\n");
}

void ObjLineFilter::keep_libraries(std::string_view rest) {
  if (rest.empty()) return;
  std::vector<std::string>& libraries = statements_.material_libraries;
  const auto keep = [&](std::string_view name) {
    if (std::ranges::find(libraries, name) != libraries.end()) return;
    if (libraries.size() == kMaxLibraries) refuse("more than " + std::to_string(kMaxLibraries) + " material libraries");
    libraries.emplace_back(name);
  };
  // Several libraries, or one name with spaces: what ends in .mtl ends a name.
  std::size_t start = 0;
  for (std::size_t i = 0; i <= rest.size(); ++i) {
    if (i < rest.size() && kBlanks.find(rest[i]) == std::string_view::npos) continue;
    const std::string_view name = trimmed(rest.substr(start, i - start));
    if (i < rest.size() && !name.ends_with(".mtl") && !name.ends_with(".MTL")) continue;
    if (name.starts_with('#')) return;
    if (!name.empty()) keep(name);
    start = i;
  }
}

void ObjLineFilter::keep_unknown(std::string_view keyword) {
  if (statements_.unknown_keywords.size() >= kUnknownKeywordCount) return;
  statements_.unknown_keywords.emplace(printable(keyword), line());
}

void ObjLineFilter::refuse(const std::string& what) const {
  throw Error(ErrorKind::refused, file_ + ": line " + std::to_string(line()) + ": " + what);
}

}  // namespace vernier
