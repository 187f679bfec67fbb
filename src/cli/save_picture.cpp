#include "cli/save_picture.h"

#include "cli/camera_arguments.h"
#include "cli/output_file.h"
#include "cli/parse_values.h"
#include "cli/recipe.h"
#include "cli/rendered_image.h"
#include "image/write_image.h"
#include "preview/camera_words.h"
#include "render/trace_pipeline.h"

namespace vernier {

RenderCommandArguments render_arguments(const RenderCommandArguments& arguments, const SavedPicture& picture) {
  RenderCommandArguments changed = arguments;
  changed.output = picture.path;
  changed.scene = with_camera(arguments.scene, picture.words);
  changed.scene.scene = picture.viewed.source;
  RenderArguments& render = changed.render;
  const RenderSettings& settings = picture.settings;
  render.size = std::to_string(settings.width) + "x" + std::to_string(settings.height);
  render.spp = std::to_string(settings.spp);
  render.max_bounces = std::to_string(settings.max_bounces);
  render.accuracy = to_string(settings.accuracy);
  render.effects = settings.effects;
  if (parse_exposure(arguments.exposure) != picture.exposure_ev) changed.exposure = shortest_text(picture.exposure_ev);
  return changed;
}

void save_picture(const RenderCommandArguments& arguments, const SavedPicture& picture) {
  const RenderPlan plan = plan_render(render_arguments(arguments, picture));
  check_not_read(output_files(plan), picture.viewed.scene.files);
  const RecipeMaker maker{picture.device.name, picture.device.driver,
                          trace_spirv_hash(choose_scene_loads(picture.device))};
  ImageFile image = picture.image;
  const auto shown = scene_recipe(plan.scene_arguments, picture.viewed.scene.files, plan.render_arguments);
  image.metadata = describe_image(plan, image, picture.statistics, render_recipe(shown, maker));
  write_image(plan.output, image, plan.display);
}

}  // namespace vernier
