#include "cli/point_command.h"

#include <algorithm>

#include "cli/recipe.h"

namespace vernier {

std::string point_command(SceneArguments scene, RenderArguments render, const RenderSettings& settings,
                          const CostPoint& point) {
  render.size = std::to_string(settings.width) + "x" + std::to_string(settings.height);
  render.spp.clear();
  const std::vector<OptionText> texts = option_texts(scene, render);
  for (const auto& [name, value] : point.options) *std::ranges::find(texts, name, &OptionText::first)->second = value;
  return short_render_command(scene, render, "render.exr");
}

}  // namespace vernier
