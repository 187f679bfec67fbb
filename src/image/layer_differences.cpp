#include "image/layer_differences.h"

#include <algorithm>
#include <cstring>
#include <sstream>

namespace vernier {
namespace {

std::string title_of(const Layer& layer) {
  return layer.name.empty() ? "colour" : "layer `" + layer.name + "`";
}

/// The line about two arrays of `count` channels a pixel; empty where all bits are the same.
template <typename Value>
std::string difference_of(const Layer& layer, const std::vector<Value>& original, const std::vector<Value>& values,
                          const ImageFile& image) {
  const std::size_t count = layer.channels.size();
  std::size_t differing = 0, first = 0;
  for (std::size_t pixel = 0; pixel < values.size(); pixel += count) {
    if (std::memcmp(&original[pixel], &values[pixel], count * sizeof(Value)) == 0) continue;
    if (differing++ == 0) first = pixel;
  }
  if (differing == 0) return "";
  std::size_t channel = 0;
  while (std::memcmp(&original[first + channel], &values[first + channel], sizeof(Value)) == 0) ++channel;
  const std::size_t pixel = first / count, width = static_cast<std::size_t>(image.width);
  std::ostringstream line;
  line.precision(9);  // digits that tell any two floats apart
  line << title_of(layer) << ": " << differing << " of " << values.size() / count << " pixels differ, the first: pixel "
       << image.x + static_cast<int>(pixel % width) << "," << image.y + static_cast<int>(pixel / width) << ", "
       << layer.channels[channel] << " " << values[first + channel] << " instead of " << original[first + channel];
  return line.str();
}

std::string difference_of(const Layer& original, const Layer* layer, const ImageFile& image) {
  if (layer == nullptr) return title_of(original) + ": is not there";
  if (layer->channels != original.channels || layer->values.index() != original.values.index()) {
    return title_of(original) + ": has other channels";
  }
  return std::visit(
      [&](const auto& values) {
        return difference_of(original, values, std::get<std::decay_t<decltype(values)>>(layer->values), image);
      },
      original.values);
}

std::string window_of(const ImageFile& image) {
  std::ostringstream text;
  text << image.width << "x" << image.height << " pixels at " << image.x << "," << image.y << " of " << image.full_width
       << "x" << image.full_height;
  return text.str();
}

}  // namespace

std::vector<std::string> layer_differences(const ImageFile& original, const ImageFile& image) {
  if (window_of(original) != window_of(image)) return {window_of(image) + " instead of " + window_of(original)};
  std::vector<std::string> lines;
  for (const Layer& layer : original.layers) {
    const std::string line = difference_of(layer, find_layer(image, layer.name), image);
    if (!line.empty()) lines.push_back(line);
  }
  for (const Layer& layer : image.layers) {
    if (find_layer(original, layer.name) == nullptr) lines.push_back(title_of(layer) + ": is new");
  }
  return lines;
}

}  // namespace vernier
