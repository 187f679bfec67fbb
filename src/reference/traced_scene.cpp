#include "reference/traced_scene.h"

#include "reference/vertex_values.h"

namespace vernier::reference {

TracedScene prepare_scene(const Scene& scene) {
  TracedScene traced;
  traced.scene = &scene;
  traced.baked = bake_triangles(scene);
  traced.tree = build_box_tree(traced.baked);
  traced.environment = prepare_environment(scene);
  return traced;
}

std::optional<Hit> closest_hit(const TracedScene& scene, const Ray& ray, std::uint32_t source) {
  const ShearedRay sheared(ray, source, scene.baked.largest_coordinate);
  const double tie = sheared.tie_width();
  const double infinity = std::numeric_limits<double>::infinity();
  std::optional<Hit> best;
  visit_triangles(scene.tree, ray, infinity, [&](std::uint32_t id) {
    const Triangle& triangle = scene.baked.triangles[id];
    const std::optional<Crossing> crossing = sheared.hit(triangle, id);
    const bool nearer =
        crossing && (!best || crossing->t < best->t - tie || (crossing->t <= best->t + tie && id < best->triangle));
    if (nearer) {
      const double alpha = coverage(*scene.scene, triangle, crossing->weights);
      if (alpha > 0.0) best = Hit{id, crossing->t, crossing->weights, alpha};
    }
    return best ? best->t + tie : infinity;
  });
  return best;
}

}  // namespace vernier::reference
