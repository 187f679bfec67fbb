#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace vernier {

/// Pixels of one layer: [height][width][channel_count] float32, row 0 on top, linear Rec.709 where they are colour.
struct Image {
  int width = 0;
  int height = 0;
  int channel_count = 4;
  std::vector<float> values;
};

/// A named layer of an image file. The colour layer has an empty name and channels R G B A; an AOV has its name
/// (`depth`) and its channels without it (`Z`): the file calls the channel `depth.Z`.
/// `values` is [height][width][channels.size()], float32 or uint32 for all channels of the layer.
struct Layer {
  std::string name;
  std::vector<std::string> channels;
  std::variant<std::vector<float>, std::vector<std::uint32_t>> values;
};

/// All that an image file holds. `width` x `height` pixels that start at (`x`, `y`) of a full image of
/// `full_width` x `full_height`; without a crop both are the same and the start is (0, 0).
/// `metadata` are text attributes by name; Vernier's own start with `vernier:`.
struct ImageFile {
  int width = 0;
  int height = 0;
  int x = 0;
  int y = 0;
  int full_width = 0;
  int full_height = 0;
  std::vector<Layer> layers;
  std::map<std::string, std::string> metadata;
};

/// The layer of that name; null where there is none.
inline const Layer* find_layer(const ImageFile& file, std::string_view name) {
  const auto found = std::ranges::find(file.layers, name, &Layer::name);
  return found == file.layers.end() ? nullptr : &*found;
}

}  // namespace vernier
