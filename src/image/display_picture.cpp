#include "image/display_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "image/cost_picture.h"
#include "image/srgb_curve.h"

namespace vernier {
namespace {

using Rgb = std::array<double, 3>;
constexpr Rgb kBlack = {0.0, 0.0, 0.0};
constexpr Rgb kMagenta = {1.0, 0.0, 1.0};
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The channels of a layer that make red, green and blue; fewer than three make grey (one) or leave blue at 0 (two).
struct ShownChannels {
  const Layer& layer;
  std::vector<std::size_t> channels;

  double value(std::size_t pixel, std::size_t shown) const {
    const std::size_t index = pixel * layer.channels.size() + channels[shown];
    return std::visit([index](const auto& values) { return static_cast<double>(values[index]); }, layer.values);
  }
  Rgb rgb(std::size_t pixel) const {
    if (channels.size() == 1) return Rgb{value(pixel, 0), value(pixel, 0), value(pixel, 0)};
    return Rgb{value(pixel, 0), value(pixel, 1), channels.size() > 2 ? value(pixel, 2) : 0.0};
  }
};

struct Range {
  double low = kInfinity;
  double high = -kInfinity;
  // 0 at `low`, 1 at `high`; 0 everywhere in a range of one value.
  double position(double value) const { return high > low ? (value - low) / (high - low) : 0.0; }
};

bool has_channels(const Layer& layer, std::initializer_list<const char*> names) {
  return std::all_of(names.begin(), names.end(), [&](const char* name) {
    return std::find(layer.channels.begin(), layer.channels.end(), name) != layer.channels.end();
  });
}

ShownChannels shown_channels(const Layer& layer, LayerMeaning meaning) {
  const auto indices_of = [&](std::initializer_list<const char*> names) {
    std::vector<std::size_t> indices;
    for (const char* name : names)
      indices.push_back(std::find(layer.channels.begin(), layer.channels.end(), name) - layer.channels.begin());
    return ShownChannels{layer, indices};
  };
  switch (meaning) {
    case LayerMeaning::color:
      return indices_of({"R", "G", "B"});
    case LayerMeaning::direction:
    case LayerMeaning::position:
      return indices_of({"X", "Y", "Z"});
    case LayerMeaning::uv:
      return indices_of({"U", "V"});
    case LayerMeaning::id:
      return indices_of({"ID"});
    case LayerMeaning::depth:
    case LayerMeaning::cost:
    case LayerMeaning::amount:
      break;
  }
  std::vector<std::size_t> first_three;
  for (std::size_t channel = 0; channel < std::min<std::size_t>(layer.channels.size(), 3); ++channel)
    first_three.push_back(channel);
  return ShownChannels{layer, first_three};
}

std::array<Range, 3> finite_ranges(const ShownChannels& shown, std::size_t pixel_count) {
  std::array<Range, 3> ranges;
  for (std::size_t pixel = 0; pixel < pixel_count; ++pixel) {
    const Rgb rgb = shown.rgb(pixel);
    for (std::size_t c = 0; c < 3; ++c) {
      if (!std::isfinite(rgb[c])) continue;
      ranges[c].low = std::min(ranges[c].low, rgb[c]);
      ranges[c].high = std::max(ranges[c].high, rgb[c]);
    }
  }
  return ranges;
}

Rgb color_of_id(double id) {
  if (id == std::numeric_limits<std::uint32_t>::max()) return kBlack;
  // lowbias32 (Wellons 2018, Prospecting for Hash Functions); each channel stays above a quarter, away from black.
  auto hash = static_cast<std::uint32_t>(id) + 1u;
  hash = (hash ^ (hash >> 16)) * 0x7feb352du;
  hash = (hash ^ (hash >> 15)) * 0x846ca68bu;
  hash ^= hash >> 16;
  const auto byte = [hash](int shift) { return 0.25 + 0.75 * ((hash >> shift) & 255u) / 255.0; };
  return Rgb{byte(0), byte(8), byte(16)};
}

Rgb for_each(const Rgb& rgb, const std::function<double(double, std::size_t)>& change) {
  return Rgb{change(rgb[0], 0), change(rgb[1], 1), change(rgb[2], 2)};
}

using Ranges = std::array<Range, 3>;

Rgb code_of(LayerMeaning meaning, const Rgb& rgb, const Ranges& ranges, double gain) {
  switch (meaning) {
    case LayerMeaning::color:
      return for_each(rgb, [&](double v, std::size_t) { return srgb_from_linear(std::clamp(v * gain, 0.0, 1.0)); });
    case LayerMeaning::depth:
      return for_each(rgb, [&](double v, std::size_t c) { return 1.0 - 0.9 * ranges[c].position(v); });
    case LayerMeaning::direction:
      return for_each(rgb, [&](double v, std::size_t) { return 0.5 * v + 0.5; });
    case LayerMeaning::position:
      return for_each(rgb, [&](double v, std::size_t c) { return ranges[c].position(v); });
    case LayerMeaning::uv:
      return for_each(rgb, [&](double v, std::size_t) { return v - std::floor(v); });
    case LayerMeaning::id:
      return color_of_id(rgb[0]);
    case LayerMeaning::cost:  // not by this way: cost_picture
    case LayerMeaning::amount:
      return for_each(rgb, [&](double v, std::size_t c) { return v > 0.0 ? v / ranges[c].high : 0.0; });
  }
  return kMagenta;
}

bool finite(const Rgb& rgb) {
  return std::isfinite(rgb[0]) && std::isfinite(rgb[1]) && std::isfinite(rgb[2]);
}

// `map` turns finite values into the picture's; misses and faults are the same in every picture.
Image picture(const ShownChannels& shown, LayerMeaning meaning, int width, int height,
              const std::function<Rgb(const Rgb&)>& map, double upper_bound) {
  Image image{width, height, 3, {}};
  const std::size_t pixel_count = static_cast<std::size_t>(width) * height;
  image.values.resize(pixel_count * 3);
  for (std::size_t pixel = 0; pixel < pixel_count; ++pixel) {
    const Rgb rgb = shown.rgb(pixel);
    Rgb out = kMagenta;
    if (meaning == LayerMeaning::depth && rgb[0] == kInfinity)
      out = kBlack;
    else if (finite(rgb))
      out = map(rgb);
    for (std::size_t c = 0; c < 3; ++c)
      image.values[pixel * 3 + c] = static_cast<float>(std::clamp(out[c], 0.0, upper_bound));
  }
  return image;
}

}  // namespace

LayerMeaning layer_meaning(const Layer& layer) {
  if (has_channels(layer, {"R", "G", "B"})) return LayerMeaning::color;
  if (has_channels(layer, {"X", "Y", "Z"}))
    return layer.name.ends_with("normal") ? LayerMeaning::direction : LayerMeaning::position;
  if (layer.channels.size() == 1 && layer.channels[0] == "Z") return LayerMeaning::depth;
  if (has_channels(layer, {"U", "V"})) return LayerMeaning::uv;
  if (has_channels(layer, {"ID"})) return LayerMeaning::id;
  if (layer.name == "cost" && has_channels(layer, {"rays", "nodes", "triangles"})) return LayerMeaning::cost;
  return LayerMeaning::amount;
}

Image display_picture(const Layer& layer, int width, int height, const DisplayTransform& display) {
  const LayerMeaning meaning = layer_meaning(layer);
  if (meaning == LayerMeaning::cost) return cost_picture(layer, width, height);
  const ShownChannels shown = shown_channels(layer, meaning);
  const Ranges ranges = finite_ranges(shown, static_cast<std::size_t>(width) * height);
  const double gain = layer.name.empty() ? std::exp2(static_cast<double>(display.exposure_ev)) : 1.0;
  return picture(
      shown, meaning, width, height, [&](const Rgb& rgb) { return code_of(meaning, rgb, ranges, gain); }, 1.0);
}

Image unsigned_picture(const Layer& layer, int width, int height) {
  const LayerMeaning meaning = layer_meaning(layer);
  if (meaning != LayerMeaning::color && meaning != LayerMeaning::depth && meaning != LayerMeaning::cost &&
      meaning != LayerMeaning::amount)
    return display_picture(layer, width, height, DisplayTransform{});
  const double largest = std::numeric_limits<float>::max();
  return picture(
      shown_channels(layer, meaning), meaning, width, height, [](const Rgb& rgb) { return rgb; }, largest);
}

}  // namespace vernier
