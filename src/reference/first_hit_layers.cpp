#include "reference/first_hit_layers.h"

#include <initializer_list>
#include <limits>

#include "reference/shading_frame.h"
#include "reference/surface_terms.h"
#include "reference/vertex_values.h"

namespace vernier::reference {

namespace {

// Indices into the layers, in the order of missed_layers.
enum LayerIndex { kDepth, kPosition, kNormal, kShadingNormal, kUv, kAlbedo, kObjectId, kMaterialId, kPrimitiveId };

Layer float_layer(const char* name, std::vector<std::string> channels, std::size_t pixel_count, float miss) {
  std::vector<float> values(pixel_count * channels.size(), miss);
  return {name, std::move(channels), std::move(values)};
}

Layer id_layer(const char* name, std::size_t pixel_count) {
  return {name, {"ID"}, std::vector<std::uint32_t>(pixel_count, kNoTriangle)};
}

void put(Layer& layer, std::size_t pixel, std::initializer_list<double> values) {
  std::size_t index = pixel * values.size();
  for (const double value : values) std::get<std::vector<float>>(layer.values)[index++] = static_cast<float>(value);
}

void put(Layer& layer, std::size_t pixel, const glm::dvec3& value) {
  put(layer, pixel, {value.x, value.y, value.z});
}

void put_id(Layer& layer, std::size_t pixel, std::uint32_t id) {
  std::get<std::vector<std::uint32_t>>(layer.values)[pixel] = id;
}

}  // namespace

std::vector<Layer> missed_layers(int width, int height) {
  const std::size_t count = static_cast<std::size_t>(width) * height;
  const std::vector<std::string> xyz{"X", "Y", "Z"};
  return {float_layer("depth", {"Z"}, count, std::numeric_limits<float>::infinity()),
          float_layer("position", xyz, count, 0.0f),
          float_layer("normal", xyz, count, 0.0f),
          float_layer("shading_normal", xyz, count, 0.0f),
          float_layer("uv", {"U", "V"}, count, 0.0f),
          float_layer("albedo", {"R", "G", "B"}, count, 0.0f),
          id_layer("object_id", count),
          id_layer("material_id", count),
          id_layer("primitive_id", count)};
}

void fill_layers(const TracedScene& scene, const Ray& ray, std::size_t pixel, std::vector<Layer>& layers) {
  const std::optional<Hit> hit = closest_hit(scene, ray, kNoTriangle);
  if (!hit) return;
  const Triangle& triangle = scene.baked.triangles[hit->triangle];
  const ShadingFrame frame = shading_frame(scene, *hit, ray.direction);
  const glm::dvec2 uv = uv_at(*scene.scene, triangle, hit->weights, 0);
  put(layers[kDepth], pixel, {hit->t});
  put(layers[kPosition], pixel, frame.position);
  put(layers[kNormal], pixel, frame.geometric_normal);
  put(layers[kShadingNormal], pixel, frame.shading_normal);
  put(layers[kUv], pixel, {uv.x, uv.y});
  put(layers[kAlbedo], pixel, surface_terms(*scene.scene, triangle, hit->weights).base);
  put_id(layers[kObjectId], pixel, triangle.instance);
  put_id(layers[kMaterialId], pixel, triangle.material);
  put_id(layers[kPrimitiveId], pixel, triangle.primitive);
}

}  // namespace vernier::reference
