#include "scene/gltf_draco.h"

#include <draco/compression/decode.h>

#include <cstring>
#include <exception>
#include <memory>

#include "scene/gltf_accessors.h"
#include "scene/gltf_references.h"
#include "scene/gltf_values.h"

namespace vernier {
namespace {

std::unique_ptr<draco::Mesh> decode_mesh(const GltfDocument& document, std::span<const std::byte> bytes,
                                         const std::string& place) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::string reason;
  try {
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (decoded.ok()) return std::move(decoded).value();
    reason = decoded.status().error_msg_string();
  } catch (const std::exception& failure) {  // a hostile size ends in bad_alloc or length_error
    reason = failure.what();
  }
  refuse_gltf(document, place, "the data cannot be decoded: " + (reason.empty() ? "no reason given" : reason));
}

/// An accessor like `accessor` that shows `bytes` without gaps; its index.
int add_accessor(GltfDocument& document, tinygltf::Accessor accessor, std::vector<std::byte> bytes, std::size_t count) {
  tinygltf::BufferView view;
  view.buffer = static_cast<int>(document.buffers.size());
  view.byteLength = bytes.size();
  accessor.bufferView = static_cast<int>(document.model.bufferViews.size());
  accessor.byteOffset = 0;
  accessor.count = count;
  accessor.sparse.isSparse = false;
  document.buffers.push_back(std::make_shared<const GltfBuffer>(GltfBuffer{std::move(bytes), false}));
  document.model.bufferViews.push_back(std::move(view));
  document.model.accessors.push_back(std::move(accessor));
  return static_cast<int>(document.model.accessors.size()) - 1;
}

int add_indices(GltfDocument& document, const draco::Mesh& mesh, const std::string& place) {
  std::vector<std::byte> bytes(std::size_t(mesh.num_faces()) * 3 * sizeof(std::uint32_t));
  for (std::uint32_t f = 0; f < mesh.num_faces(); ++f) {
    const draco::Mesh::Face& face = mesh.face(draco::FaceIndex(f));
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t corner = face[c].value();
      if (corner >= mesh.num_points()) {
        refuse_gltf(
            document, place,
            "index " + std::to_string(corner) + " is beyond " + std::to_string(mesh.num_points()) + " vertices");
      }
      std::memcpy(bytes.data() + (std::size_t(f) * 3 + c) * sizeof corner, &corner, sizeof corner);
    }
  }
  tinygltf::Accessor accessor;
  accessor.type = TINYGLTF_TYPE_SCALAR;
  accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  return add_accessor(document, accessor, std::move(bytes), std::size_t(mesh.num_faces()) * 3);
}

template <typename Component>
bool copy_points(const draco::Mesh& mesh, const draco::PointAttribute& attribute, std::vector<std::byte>& bytes) {
  const auto components = static_cast<std::size_t>(attribute.num_components());
  std::vector<Component> element(components);
  bytes.resize(std::size_t(mesh.num_points()) * components * sizeof(Component));
  for (std::uint32_t p = 0; p < mesh.num_points(); ++p) {
    const draco::AttributeValueIndex value = attribute.mapped_index(draco::PointIndex(p));
    if (value.value() >= attribute.size() ||
        !attribute.ConvertValue<Component>(value, static_cast<std::int8_t>(components), element.data())) {
      return false;
    }
    std::memcpy(bytes.data() + p * components * sizeof(Component), element.data(), components * sizeof(Component));
  }
  return true;
}

bool copy_points_as(int component_type, const draco::Mesh& mesh, const draco::PointAttribute& attribute,
                    std::vector<std::byte>& bytes) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return copy_points<std::int8_t>(mesh, attribute, bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return copy_points<std::uint8_t>(mesh, attribute, bytes);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return copy_points<std::int16_t>(mesh, attribute, bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return copy_points<std::uint16_t>(mesh, attribute, bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return copy_points<std::uint32_t>(mesh, attribute, bytes);
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return copy_points<float>(mesh, attribute, bytes);
    default:
      return false;
  }
}

int add_attribute(GltfDocument& document, const draco::Mesh& mesh, int unique_id, int accessor_index,
                  const std::string& place) {
  const tinygltf::Accessor accessor = document.model.accessors[static_cast<std::size_t>(accessor_index)];
  const draco::PointAttribute* attribute =
      unique_id < 0 ? nullptr : mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(unique_id));
  if (attribute == nullptr) refuse_gltf(document, place, "the data has no attribute " + std::to_string(unique_id));
  if (static_cast<std::size_t>(attribute->num_components()) != gltf_component_count(accessor.type)) {
    refuse_gltf(document, place,
                "attribute " + std::to_string(unique_id) + " has " + std::to_string(attribute->num_components()) +
                    " components, unlike its accessor");
  }
  std::vector<std::byte> bytes;
  if (!copy_points_as(accessor.componentType, mesh, *attribute, bytes)) {
    refuse_gltf(document, place, "attribute " + std::to_string(unique_id) + " cannot be read");
  }
  return add_accessor(document, accessor, std::move(bytes), mesh.num_points());
}

void expand_primitive(GltfDocument& document, tinygltf::Primitive& primitive, const tinygltf::Value& extension,
                      const std::string& place) {
  const int view = gltf_index(extension, "bufferView", -1);
  check_gltf_index(document, place, "bufferView", view, document.model.bufferViews.size());
  if (!extension.Has("attributes") || !extension.Get("attributes").IsObject()) {
    refuse_gltf(document, place, "attributes are missing");
  }
  if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP) {
    refuse_gltf(document, place, "mode " + std::to_string(primitive.mode) + " is not one of triangles");
  }
  const tinygltf::Value attributes = extension.Get("attributes");
  const std::unique_ptr<draco::Mesh> mesh = decode_mesh(document, gltf_view_bytes(document, view, place), place);
  for (const std::string& name : attributes.Keys()) {
    const auto original = primitive.attributes.find(name);
    if (original == primitive.attributes.end())
      refuse_gltf(document, place, name + " is not an attribute of the primitive");
    original->second =
        add_attribute(document, *mesh, gltf_index(attributes, name.c_str(), -1), original->second, place + ", " + name);
  }
  primitive.indices = add_indices(document, *mesh, place);
  primitive.mode = TINYGLTF_MODE_TRIANGLES;  // Draco stores strips as triangles too
}

}  // namespace

void expand_gltf_draco(GltfDocument& document) {
  for (std::size_t m = 0; m < document.model.meshes.size(); ++m) {
    for (std::size_t p = 0; p < document.model.meshes[m].primitives.size(); ++p) {
      tinygltf::Primitive& primitive = document.model.meshes[m].primitives[p];
      const tinygltf::Value* extension = find_gltf_extension(primitive.extensions, "KHR_draco_mesh_compression");
      if (extension == nullptr) continue;
      expand_primitive(document, primitive, *extension,
                       "mesh " + std::to_string(m) + ", primitive " + std::to_string(p) + ", Draco");
    }
  }
}

}  // namespace vernier
