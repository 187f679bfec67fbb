#include "scene/gltf_meshopt.h"

#include <meshoptimizer.h>

#include <algorithm>

#include "scene/gltf_extensions.h"
#include "scene/gltf_references.h"
#include "scene/gltf_values.h"

namespace vernier {
namespace {

/// A group of 16 bytes can shrink to 2 bits (vertex codec, v0: two header bits and no data), hence 64 : 1, and the
/// baseline of a block comes on top: more than this is a lie, found before memory is allocated for it.
constexpr std::uint64_t kMaxRatio = 80;

struct CompressedView {
  std::string place;
  std::span<const std::byte> bytes;
  std::uint64_t count = 0;
  std::uint64_t stride = 0;
  std::string mode;
  std::string filter;
};

std::string text_member(const tinygltf::Value& object, const char* name, const char* otherwise) {
  return object.Has(name) && object.Get(name).IsString() ? object.Get(name).Get<std::string>() : otherwise;
}

CompressedView describe(const GltfDocument& document, std::size_t view, const char* name,
                        const tinygltf::Value& extension) {
  CompressedView compressed;
  compressed.place = "bufferView " + std::to_string(view) + ", " + name;
  const int buffer_index = gltf_index(extension, "buffer", -1);
  check_gltf_index(document, compressed.place, "buffer", buffer_index, document.buffers.size());
  const GltfBuffer& buffer = *document.buffers[static_cast<std::size_t>(buffer_index)];
  const int offset = gltf_index(extension, "byteOffset", 0);
  const int length = gltf_index(extension, "byteLength", -1);
  const int count = gltf_index(extension, "count", -1);
  const int stride = gltf_index(extension, "byteStride", -1);
  if (buffer.is_fallback || offset < 0 || length <= 0 || static_cast<std::size_t>(offset) > buffer.bytes.size() ||
      static_cast<std::size_t>(length) > buffer.bytes.size() - static_cast<std::size_t>(offset)) {
    refuse_gltf(document, compressed.place, "its bytes go beyond buffer " + std::to_string(buffer_index));
  }
  compressed.bytes =
      std::span(buffer.bytes).subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
  if (count < 0 || stride <= 0 || stride > 256)
    refuse_gltf(document, compressed.place, "count or byteStride is out of range");
  compressed.count = static_cast<std::uint64_t>(count);
  compressed.stride = static_cast<std::uint64_t>(stride);
  compressed.mode = text_member(extension, "mode", "");
  compressed.filter = text_member(extension, "filter", "NONE");
  const std::uint64_t size = compressed.count * compressed.stride;
  if (size > kMaxGltfBytes || size > (compressed.bytes.size() + 256) * kMaxRatio) {
    refuse_gltf(document, compressed.place,
                std::to_string(compressed.bytes.size()) + " bytes cannot decode to " + std::to_string(size));
  }
  return compressed;
}

// Each codec has its own rule for stride and count; the decoders assert them, so they are checked here.
bool parameters_fit(const CompressedView& view) {
  if (view.mode == "ATTRIBUTES") return view.stride % 4 == 0;
  if (view.mode == "TRIANGLES") return view.count % 3 == 0 && (view.stride == 2 || view.stride == 4);
  return view.mode == "INDICES" && (view.stride == 2 || view.stride == 4);
}

bool filter_fits(const CompressedView& view) {
  if (view.filter == "NONE") return true;
  if (view.mode != "ATTRIBUTES") return false;
  if (view.filter == "OCTAHEDRAL") return view.stride == 4 || view.stride == 8;
  if (view.filter == "QUATERNION") return view.stride == 8;
  return view.filter == "EXPONENTIAL" && view.stride % 4 == 0;
}

int decode(const CompressedView& view, std::vector<std::byte>& decoded) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(view.bytes.data());
  if (view.mode == "ATTRIBUTES") {
    return meshopt_decodeVertexBuffer(decoded.data(), view.count, view.stride, bytes, view.bytes.size());
  }
  if (view.mode == "TRIANGLES") {
    return meshopt_decodeIndexBuffer(decoded.data(), view.count, view.stride, bytes, view.bytes.size());
  }
  return meshopt_decodeIndexSequence(decoded.data(), view.count, view.stride, bytes, view.bytes.size());
}

void apply_filter(const CompressedView& view, std::vector<std::byte>& decoded) {
  if (view.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(decoded.data(), view.count, view.stride);
  if (view.filter == "QUATERNION") meshopt_decodeFilterQuat(decoded.data(), view.count, view.stride);
  if (view.filter == "EXPONENTIAL") meshopt_decodeFilterExp(decoded.data(), view.count, view.stride);
}

}  // namespace

void expand_gltf_meshopt(GltfDocument& document) {
  for (std::size_t i = 0; i < document.model.bufferViews.size(); ++i) {
    tinygltf::BufferView& view = document.model.bufferViews[i];
    const auto name = std::ranges::find_if(
        kMeshoptExtensions, [&](const char* one) { return find_gltf_extension(view.extensions, one) != nullptr; });
    if (name == kMeshoptExtensions.end()) continue;
    const CompressedView compressed = describe(document, i, *name, *find_gltf_extension(view.extensions, *name));
    if (!parameters_fit(compressed) || !filter_fits(compressed)) {
      refuse_gltf(document, compressed.place,
                  "mode " + compressed.mode + ", filter " + compressed.filter + " do not go with count and byteStride");
    }
    GltfBuffer decoded;
    decoded.bytes.resize(compressed.count * compressed.stride);
    if (compressed.count > 0 && decode(compressed, decoded.bytes) != 0) {
      refuse_gltf(document, compressed.place, "the data cannot be decoded");
    }
    apply_filter(compressed, decoded.bytes);
    view.buffer = static_cast<int>(document.buffers.size());
    view.byteOffset = 0;
    view.byteLength = decoded.bytes.size();
    document.buffers.push_back(std::make_shared<const GltfBuffer>(std::move(decoded)));
  }
}

}  // namespace vernier
