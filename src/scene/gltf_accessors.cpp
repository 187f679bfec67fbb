#include "scene/gltf_accessors.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace vernier {
namespace {

/// An accessor without bufferView costs the file nothing: it may ask for less than real bytes may.
constexpr std::uint64_t kMaxZeroBytes = std::uint64_t{1} << 26;
constexpr std::uint64_t kMaxZeroBytesOfFile = std::uint64_t{1} << 28;

const tinygltf::Accessor& accessor_at(const GltfDocument& document, int accessor) {
  return document.model.accessors[static_cast<std::size_t>(accessor)];
}

std::string accessor_place(const std::string& place, int accessor) {
  return place + ": accessor " + std::to_string(accessor);
}

std::uint64_t element_bytes(const tinygltf::Accessor& accessor) {
  return gltf_component_bytes(accessor.componentType) * gltf_component_count(accessor.type);
}

// All in 64 bits: count < 2^31 and stride, element < 2^16 cannot overflow, offsets are compared by subtraction.
void check_extent(const GltfDocument& document, const std::string& place, std::uint64_t view_bytes,
                  std::uint64_t offset, std::uint64_t count, std::uint64_t stride, std::uint64_t element) {
  if (count == 0) return;
  const std::uint64_t needed = (count - 1) * stride + element;
  if (offset > view_bytes || needed > view_bytes - offset) {
    refuse_gltf(document, place,
                std::to_string(count) + " elements need " + std::to_string(needed) + " bytes from byte " +
                    std::to_string(offset) + " on, the bufferView has " + std::to_string(view_bytes));
  }
}

void copy_view(const GltfDocument& document, const tinygltf::Accessor& accessor, const std::string& place,
               std::vector<std::byte>& elements) {
  const std::span<const std::byte> bytes = gltf_view_bytes(document, accessor.bufferView, place);
  const std::uint64_t element = element_bytes(accessor);
  const std::uint64_t view_stride =
      document.model.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
  const std::uint64_t stride = view_stride == 0 ? element : view_stride;
  if (stride < element)
    refuse_gltf(document, place, "byteStride " + std::to_string(stride) + " is less than an element");
  check_extent(document, place, bytes.size(), accessor.byteOffset, accessor.count, stride, element);
  if (accessor.count == 0) return;
  elements.resize(accessor.count * element);
  const std::byte* first = bytes.data() + accessor.byteOffset;
  if (stride == element) {
    std::memcpy(elements.data(), first, elements.size());
    return;
  }
  for (std::size_t i = 0; i < accessor.count; ++i) {
    std::memcpy(elements.data() + i * element, first + i * stride, element);
  }
}

std::uint32_t unsigned_at(const std::byte* bytes, std::size_t component_bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < component_bytes; ++i) value |= std::uint32_t(bytes[i]) << (8 * i);
  return value;
}

bool is_unsigned(int component_type) {
  return component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

void apply_sparse(const GltfDocument& document, const tinygltf::Accessor& accessor, const std::string& place,
                  std::vector<std::byte>& elements) {
  const auto& sparse = accessor.sparse;
  // tinygltf's versions differ in whether these numbers have a sign.
  if (static_cast<std::int64_t>(sparse.count) < 0 || static_cast<std::size_t>(sparse.count) > accessor.count ||
      static_cast<std::int64_t>(sparse.indices.byteOffset) < 0 ||
      static_cast<std::int64_t>(sparse.values.byteOffset) < 0) {
    refuse_gltf(document, place, "its sparse count or offset is out of range");
  }
  if (!is_unsigned(sparse.indices.componentType))
    refuse_gltf(document, place, "sparse indices must be unsigned integers");
  const auto count = static_cast<std::size_t>(sparse.count);
  const auto indices_offset = static_cast<std::size_t>(sparse.indices.byteOffset);
  const auto values_offset = static_cast<std::size_t>(sparse.values.byteOffset);
  const std::size_t index_bytes = gltf_component_bytes(sparse.indices.componentType);
  const std::size_t element = element_bytes(accessor);
  const auto indices = gltf_view_bytes(document, sparse.indices.bufferView, place);
  const auto values = gltf_view_bytes(document, sparse.values.bufferView, place);
  check_extent(document, place + ", sparse indices", indices.size(), indices_offset, count, index_bytes, index_bytes);
  check_extent(document, place + ", sparse values", values.size(), values_offset, count, element, element);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t target = unsigned_at(indices.data() + indices_offset + i * index_bytes, index_bytes);
    if (target >= accessor.count) {
      refuse_gltf(
          document, place,
          "sparse index " + std::to_string(target) + " is beyond " + std::to_string(accessor.count) + " elements");
    }
    std::memcpy(elements.data() + target * element, values.data() + values_offset + i * element, element);
  }
}

template <typename Integer>
float component_value(Integer value, bool normalised) {
  const auto number = static_cast<float>(value);
  if (!normalised) return number;
  return std::max(number / static_cast<float>(std::numeric_limits<Integer>::max()), -1.0f);
}

template <typename Component>
void convert(const std::vector<std::byte>& elements, bool normalised, std::vector<float>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    Component component;
    std::memcpy(&component, elements.data() + i * sizeof component, sizeof component);
    values[i] = component_value(component, normalised);
  }
}

std::vector<float> read_floats(const GltfDocument& document, int index, std::size_t component_count,
                               const std::string& place) {
  const tinygltf::Accessor& accessor = accessor_at(document, index);
  if (gltf_component_count(accessor.type) != component_count || accessor.type == TINYGLTF_TYPE_MAT2) {
    refuse_gltf(document, accessor_place(place, index),
                "its elements must have " + std::to_string(component_count) + " components");
  }
  const std::vector<std::byte> elements = read_gltf_elements(document, index, place);
  std::vector<float> values(accessor.count * component_count);
  switch (accessor.componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      convert<std::int8_t>(elements, accessor.normalized, values);
      break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      convert<std::uint8_t>(elements, accessor.normalized, values);
      break;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      convert<std::int16_t>(elements, accessor.normalized, values);
      break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      convert<std::uint16_t>(elements, accessor.normalized, values);
      break;
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      convert<float>(elements, false, values);
      break;
    default:
      refuse_gltf(document, accessor_place(place, index), "32-bit integers cannot be used here");
  }
  return values;
}

}  // namespace

std::size_t gltf_component_bytes(int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

std::size_t gltf_component_count(int type) {
  const int count = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type));
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

void count_gltf_zeros(const GltfDocument& document, const std::string& place, std::uint64_t bytes) {
  document.zero_bytes += bytes;
  if (document.zero_bytes > kMaxZeroBytesOfFile) {
    refuse_gltf(
        document, place,
        "accessors without bufferView ask for more than " + std::to_string(kMaxZeroBytesOfFile) + " bytes in all");
  }
}

void check_element_count(const GltfDocument& document, const std::string& place, std::size_t count,
                         std::size_t vertex_count) {
  if (count == vertex_count) return;
  refuse_gltf(document, place,
              std::to_string(count) + " elements do not go with " + std::to_string(vertex_count) + " vertices");
}

std::vector<std::byte> read_gltf_elements(const GltfDocument& document, int index, const std::string& asker) {
  const tinygltf::Accessor& accessor = accessor_at(document, index);
  const std::string place = accessor_place(asker, index);
  const std::uint64_t element = element_bytes(accessor);
  if (element == 0) {
    refuse_gltf(document, place, "component type " + std::to_string(accessor.componentType) + " does not exist");
  }
  const std::uint64_t limit = accessor.bufferView >= 0 ? kMaxGltfBytes : kMaxZeroBytes;
  if (accessor.count > limit / element) {
    refuse_gltf(document, place,
                std::to_string(accessor.count) + " elements are more than " + std::to_string(limit) + " bytes");
  }
  std::vector<std::byte> elements;
  if (accessor.bufferView >= 0) {
    copy_view(document, accessor, place, elements);
  } else {
    count_gltf_zeros(document, place, accessor.count * element);
    elements.resize(accessor.count * element);
  }
  if (accessor.sparse.isSparse) apply_sparse(document, accessor, place, elements);
  return elements;
}

template <int N>
std::vector<glm::vec<N, float>> read_gltf_vectors(const GltfDocument& document, int accessor,
                                                  const std::string& place) {
  const std::vector<float> values = read_floats(document, accessor, N, place);
  std::vector<glm::vec<N, float>> vectors(values.size() / N);
  for (std::size_t i = 0; i < values.size(); ++i) vectors[i / N][static_cast<glm::length_t>(i % N)] = values[i];
  return vectors;
}

template std::vector<glm::vec2> read_gltf_vectors<2>(const GltfDocument&, int, const std::string&);
template std::vector<glm::vec3> read_gltf_vectors<3>(const GltfDocument&, int, const std::string&);
template std::vector<glm::vec4> read_gltf_vectors<4>(const GltfDocument&, int, const std::string&);

std::vector<glm::vec4> read_gltf_colors(const GltfDocument& document, int accessor, const std::string& place) {
  if (accessor_at(document, accessor).type != TINYGLTF_TYPE_VEC3)
    return read_gltf_vectors<4>(document, accessor, place);
  const std::vector<glm::vec3> opaque = read_gltf_vectors<3>(document, accessor, place);
  std::vector<glm::vec4> colors;
  colors.reserve(opaque.size());
  for (const glm::vec3& color : opaque) colors.emplace_back(color, 1.0f);
  return colors;
}

std::vector<std::uint32_t> read_gltf_indices(const GltfDocument& document, int index, const std::string& place) {
  const tinygltf::Accessor& accessor = accessor_at(document, index);
  if (accessor.type != TINYGLTF_TYPE_SCALAR || !is_unsigned(accessor.componentType)) {
    refuse_gltf(document, accessor_place(place, index), "indices must be unsigned integer scalars");
  }
  const std::vector<std::byte> elements = read_gltf_elements(document, index, place);
  const std::size_t component = gltf_component_bytes(accessor.componentType);
  std::vector<std::uint32_t> indices(accessor.count);
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = unsigned_at(elements.data() + i * component, component);
  return indices;
}

std::vector<glm::uvec4> read_gltf_joints(const GltfDocument& document, int index, const std::string& place) {
  const tinygltf::Accessor& accessor = accessor_at(document, index);
  if (accessor.type != TINYGLTF_TYPE_VEC4 || !is_unsigned(accessor.componentType)) {
    refuse_gltf(document, accessor_place(place, index), "joints must be four unsigned integers an element");
  }
  const std::vector<std::byte> elements = read_gltf_elements(document, index, place);
  const std::size_t component = gltf_component_bytes(accessor.componentType);
  std::vector<glm::uvec4> joints(accessor.count);
  for (std::size_t i = 0; i < joints.size() * 4; ++i) {
    joints[i / 4][static_cast<glm::length_t>(i % 4)] = unsigned_at(elements.data() + i * component, component);
  }
  return joints;
}

std::vector<glm::mat4> read_gltf_matrices(const GltfDocument& document, int index, const std::string& place) {
  const tinygltf::Accessor& accessor = accessor_at(document, index);
  if (accessor.type != TINYGLTF_TYPE_MAT4 || accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
    refuse_gltf(document, accessor_place(place, index), "matrices must be 4x4 floats");
  }
  const std::vector<std::byte> elements = read_gltf_elements(document, index, place);
  std::vector<glm::mat4> matrices(accessor.count);
  static_assert(sizeof(glm::mat4) == 64);
  if (!elements.empty()) std::memcpy(matrices.data(), elements.data(), elements.size());
  return matrices;
}

}  // namespace vernier
