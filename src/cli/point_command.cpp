#include "cli/point_command.h"

namespace vernier {

std::string point_command(const SceneArguments& scene, const RenderArguments& render, const RenderSettings& settings,
                          const CostPoint& point) {
  RenderArguments changed = render;
  changed.size = std::to_string(settings.width) + "x" + std::to_string(settings.height);
  changed.spp.clear();
  for (const auto& [name, value] : point.options) {
    if (name == "spp") changed.spp = value;
    if (name == "error-target") changed.error_target = value;
    if (name == "accuracy") changed.accuracy = value;
    if (name == "max-bounces") changed.max_bounces = value;
    if (name == "cutoff") changed.cutoff = value;
    if (name == "effects") changed.effects = value;
    if (name == "filter") changed.filter = value;
    if (name == "texture-filter") changed.texture_filter = value;
  }
  return short_render_command(scene, changed, "render.exr");
}

}  // namespace vernier
