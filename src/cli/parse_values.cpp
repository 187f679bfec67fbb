#include "cli/parse_values.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "error.h"
#include "render/setting_limits.h"

namespace vernier {
namespace {

[[noreturn]] void reject(const std::string& option, const std::string& text, const std::string& expected) {
  throw Error(ErrorKind::usage, option + ": `" + text + "` is not " + expected);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == separator) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

std::optional<double> plain_number(std::string_view text) {
  double value = 0.0;
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);  // from_chars takes a minus alone
  const char* end = text.data() + text.size();
  const auto [rest, failure] = std::from_chars(text.data(), end, value);
  const bool whole = failure == std::errc() && rest == end && std::isfinite(value);
  return whole ? std::optional(value) : std::nullopt;
}

// Digits only: from_chars of an unsigned type takes no sign.
std::optional<std::uint32_t> whole_number(std::string_view text) {
  std::uint32_t value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, failure] = std::from_chars(text.data(), end, value);
  return failure == std::errc() && rest == end ? std::optional(value) : std::nullopt;
}

std::string to_text(double value) {
  char digits[32];
  const auto [end, failure] = std::to_chars(digits, digits + sizeof digits, value);
  return failure == std::errc() ? std::string(digits, end) : "?";
}

bool is_side(std::optional<std::uint32_t> value) {
  return value && *value >= 1 && *value <= static_cast<std::uint32_t>(kMaxSide_px);
}

/// Three numbers; `wanted` says of what in the message.
glm::dvec3 three_numbers(const std::string& option, const std::string& text, const char* wanted) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 3) reject(option, text, wanted);
  glm::dvec3 numbers(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<double> value = plain_number(parts[static_cast<std::size_t>(axis)]);
    if (!value) reject(option, text, wanted);
    numbers[axis] = *value;
  }
  return numbers;
}

}  // namespace

double parse_number(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, '/');
  const std::optional<double> value = plain_number(parts[0]);
  const std::optional<double> divisor = parts.size() == 2 ? plain_number(parts[1]) : std::optional(1.0);
  if (parts.size() > 2 || !value || !divisor || !std::isfinite(*value / *divisor)) {
    reject(option, text, "a number");
  }
  return *value / *divisor;
}

double parse_number_in(const std::string& option, const std::string& text, double low, double high) {
  const double value = parse_number(option, text);
  if (value < low || value > high) {
    reject(option, text, "from " + to_text(low) + " to " + to_text(high));
  }
  return value;
}

std::uint32_t parse_count(const std::string& option, const std::string& text, std::uint32_t low, std::uint32_t high) {
  const std::optional<std::uint32_t> value = whole_number(text);
  if (!value || *value < low || *value > high) {
    reject(option, text, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return *value;
}

glm::ivec2 parse_size(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, 'x');
  if (parts.size() != 2 || !is_side(whole_number(parts[0])) || !is_side(whole_number(parts[1]))) {
    reject(option, text, "WxH in pixels, each from 1 to " + std::to_string(kMaxSide_px));
  }
  return {static_cast<int>(*whole_number(parts[0])), static_cast<int>(*whole_number(parts[1]))};
}

PixelRect parse_rect(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  std::vector<int> values;
  for (const std::string& part : parts) {
    const std::optional<std::uint32_t> value = whole_number(part);
    if (value && *value <= static_cast<std::uint32_t>(kMaxSide_px)) {
      values.push_back(static_cast<int>(*value));
    }
  }
  if (parts.size() != 4 || values.size() != 4 || values[2] == 0 || values[3] == 0) {
    reject(option, text, "X,Y,W,H in pixels with W and H of at least 1");
  }
  return {values[0], values[1], values[2], values[3]};
}

glm::dvec3 parse_vec3(const std::string& option, const std::string& text) {
  return three_numbers(option, text, "three numbers x,y,z");
}

glm::vec3 parse_color(const std::string& option, const std::string& text) {
  constexpr const char* kColor = "a colour r,g,b of numbers from 0 to 3.4e38";
  const glm::dvec3 color = three_numbers(option, text, kColor);
  constexpr double kLargest = std::numeric_limits<float>::max();
  for (int channel = 0; channel < 3; ++channel) {
    if (color[channel] < 0.0 || color[channel] > kLargest) {
      reject(option, text, kColor);
    }
  }
  return glm::vec3(color);
}

float parse_exposure(const std::string& text) {
  constexpr double kMostStops = 100.0;
  return static_cast<float>(parse_number_in("--exposure", text, -kMostStops, kMostStops));
}

SampleRange parse_sample_range(const std::string& option, const std::string& text, std::uint32_t spp) {
  const std::vector<std::string> parts = split(text, ':');
  const std::optional<std::uint32_t> begin = whole_number(parts.front());
  const std::optional<std::uint32_t> end = whole_number(parts.back());
  if (parts.size() != 2 || !begin || !end || *begin >= *end || *end > spp) {
    reject(option, text, "a range A:B of samples with A < B <= --spp " + std::to_string(spp));
  }
  return {*begin, *end};
}

}  // namespace vernier
