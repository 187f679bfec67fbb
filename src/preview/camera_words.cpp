#include "preview/camera_words.h"

#include <array>
#include <charconv>
#include <cmath>

namespace vernier {
namespace {

/// A camera whose right lies so flat is upright but for rounding: 2^-40 is thousands of roundings of a double.
constexpr double kUpright = 0x1p-40;

template <typename Number>
std::string text_of(Number value) {
  std::array<char, 64> text{};
  const auto [end, failure] = std::to_chars(text.data(), text.data() + text.size(), value);
  return failure == std::errc() ? std::string(text.data(), end) : std::string();
}

std::string text_of(const glm::dvec3& point) {
  return text_of(point.x) + "," + text_of(point.y) + "," + text_of(point.z);
}

}  // namespace

std::string shortest_text(double value) {
  return text_of(value);
}

std::string shortest_text(float value) {
  return text_of(value);
}

CameraWords camera_words(const CameraWords& base, const OrbitView& view) {
  const glm::dmat4& frame = view.camera.world_from_camera;
  CameraWords words = base;
  words.eye = text_of(glm::dvec3(frame[3]));
  words.target = text_of(view.target);
  const bool upright = std::fabs(frame[0].y) < kUpright && frame[1].y > 0.0;
  words.up = upright ? std::string() : text_of(glm::dvec3(frame[1]));
  if (view.camera.orthographic) words.view_height = text_of(2.0 * view.camera.half_height);
  return words;
}

}  // namespace vernier
