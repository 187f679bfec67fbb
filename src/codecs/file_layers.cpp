#include "codecs/file_layers.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>

#include "codecs/pixel_rows.h"
#include "image/srgb_curve.h"

namespace vernier {
namespace {

// Position among the channel names that have a customary order; all others come after them.
std::size_t customary_position(const std::string& channel) {
  constexpr std::array<const char*, 9> kOrder = {"R", "G", "B", "A", "X", "Y", "Z", "U", "V"};
  return std::find(kOrder.begin(), kOrder.end(), channel) - kOrder.begin();
}

bool comes_before(const ChannelSource& a, const ChannelSource& b) {
  const std::size_t position_a = customary_position(a.name);
  const std::size_t position_b = customary_position(b.name);
  return position_a != position_b ? position_a < position_b : a.name < b.name;
}

bool all_uint32(const std::vector<ChannelSource>& channels, const OIIO::ImageSpec& spec) {
  return std::all_of(channels.begin(), channels.end(), [&](const ChannelSource& channel) {
    return spec.channelformat(channel.file_channel) == OIIO::TypeDesc::UINT32;
  });
}

std::vector<std::size_t> channel_offsets(const OIIO::ImageSpec& spec) {
  std::vector<std::size_t> offsets;
  std::size_t offset = 0;
  for (int channel = 0; channel < spec.nchannels; ++channel) {
    offsets.push_back(offset);
    offset += spec.channelformat(channel).size();
  }
  return offsets;
}

// Reads one channel of a layer from a pixel of the file.
struct ChannelReader {
  std::size_t byte_offset;
  OIIO::TypeDesc type;
  bool on_srgb_curve;

  void append(std::vector<float>& values, const std::byte* pixel) const {
    const double value = value_of(pixel, byte_offset, type);
    values.push_back(static_cast<float>(on_srgb_curve ? linear_from_srgb(value) : value));
  }
  void append(std::vector<std::uint32_t>& values, const std::byte* pixel) const {
    std::uint32_t value;
    std::memcpy(&value, pixel + byte_offset, sizeof value);
    values.push_back(value);
  }
};

}  // namespace

std::vector<LayerSource> named_layers(const OIIO::ImageSpec& spec) {
  std::map<std::string, LayerSource> by_name;  // the empty name sorts first
  for (int channel = 0; channel < spec.nchannels; ++channel) {
    const std::string full_name = spec.channelnames[channel];
    const std::size_t dot = full_name.rfind('.');
    const std::string layer_name = dot == std::string::npos ? "" : full_name.substr(0, dot);
    const std::string channel_name = dot == std::string::npos ? full_name : full_name.substr(dot + 1);
    by_name[layer_name].channels.push_back({channel_name, channel, false});
  }
  std::vector<LayerSource> layers;
  for (auto& [name, layer] : by_name) {
    layer.name = name;
    std::stable_sort(layer.channels.begin(), layer.channels.end(), comes_before);
    layer.counts = all_uint32(layer.channels, spec);
    layers.push_back(layer);
  }
  return layers;
}

std::vector<LayerSource> unnamed_layer(const OIIO::ImageSpec& spec) {
  const OIIO::TypeDesc type = spec.format;
  const bool coded = type == OIIO::TypeDesc::UINT8 || type == OIIO::TypeDesc::UINT16;
  LayerSource layer;
  const auto add = [&](const std::string& name, int channel) {
    layer.channels.push_back({name, channel, coded && name != "A"});
  };
  if (spec.nchannels <= 2 && coded) {
    for (const char* name : {"R", "G", "B"}) add(name, 0);
    if (spec.nchannels == 2) add("A", 1);
  } else {
    const std::string letters = spec.nchannels <= 2 ? "YA" : spec.nchannels <= 4 ? "RGBA" : "";
    for (int channel = 0; channel < spec.nchannels; ++channel)
      add(letters.empty() ? std::to_string(channel) : letters.substr(channel, 1), channel);
  }
  layer.counts = all_uint32(layer.channels, spec);
  return {layer};
}

std::vector<Layer> empty_layers(const std::vector<LayerSource>& sources, std::size_t pixel_count) {
  std::vector<Layer> layers;
  for (const LayerSource& source : sources) {
    Layer layer{source.name, {}, {}};
    for (const ChannelSource& channel : source.channels) layer.channels.push_back(channel.name);
    if (source.counts) layer.values = std::vector<std::uint32_t>();
    std::visit([&](auto& values) { values.reserve(pixel_count * source.channels.size()); }, layer.values);
    layers.push_back(std::move(layer));
  }
  return layers;
}

void append_pixels(std::vector<Layer>& layers, const std::vector<LayerSource>& sources, const OIIO::ImageSpec& spec,
                   const std::byte* bytes, std::size_t pixel_count) {
  const std::size_t pixel_bytes = spec.pixel_bytes(true);
  const std::vector<std::size_t> offsets = channel_offsets(spec);
  for (std::size_t index = 0; index < layers.size(); ++index) {
    std::vector<ChannelReader> readers;
    for (const ChannelSource& channel : sources[index].channels)
      readers.push_back(
          {offsets[channel.file_channel], spec.channelformat(channel.file_channel), channel.on_srgb_curve});
    std::visit(
        [&](auto& values) {
          for (std::size_t pixel = 0; pixel < pixel_count; ++pixel)
            for (const ChannelReader& reader : readers) reader.append(values, bytes + pixel * pixel_bytes);
        },
        layers[index].values);
  }
}

}  // namespace vernier
