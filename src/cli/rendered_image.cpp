#include "cli/rendered_image.h"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <future>
#include <optional>
#include <utility>

#include "cli/cost_legend.h"
#include "cli/interrupt.h"
#include "cli/match_recipes.h"
#include "cli/progress_bar.h"
#include "cli/recipe.h"
#include "cli/sample_command.h"
#include "cli/scene_setup.h"
#include "cli/warnings.h"
#include "error.h"
#include "image/codec_module.h"
#include "render/film_file.h"
#include "render/form_file.h"
#include "render/memory_need.h"
#include "render/pack_scene.h"
#include "render/pipeline_file.h"
#include "render/render_image.h"
#include "render/trace_pipeline.h"

namespace vernier {
namespace {

using Metadata = std::map<std::string, std::string>;

/// Libraries that are loaded beside the scene.
struct Libraries {
  std::future<VulkanInstance> vulkan;
  std::future<void> codecs;  ///< what is missing shows at get()
};

/// The driver's first, which the tree waits for: the system's loader takes one request at a time.
Libraries load_libraries() {
  std::promise<VulkanInstance> vulkan;
  Libraries libraries{vulkan.get_future(), {}};
  libraries.codecs = std::async(std::launch::async, [promise = std::move(vulkan)]() mutable {
    try {
      promise.set_value(VulkanInstance());
    } catch (...) {
      promise.set_exception(std::current_exception());
    }
    load_codecs();
  });
  return libraries;
}

/// What to go on from. A render that is killed before its first checkpoint begins anew by the same command.
std::optional<SavedFilm> read_resumed(const RenderPlan& plan) {
  if (plan.resume.empty()) return std::nullopt;
  std::error_code failure;
  if (plan.resume == plan.checkpoint && !std::filesystem::exists(plan.resume, failure)) return std::nullopt;
  return read_film_file(plan.resume);
}

MemoryNeed need_of(const Scene& scene, const RenderSettings& settings) {
  const bool driver_traces = settings.traversal == TraversalForm::ray_query;
  return memory_need(scene, driver_traces ? Sharing::never : settings.sharing);
}

void check_room(const Scene& scene, const MemoryNeed& need, const DeviceDescription& device, const MemoryThere& there,
                const RenderSettings& settings) {
  check_memory(scene.source, need, there);
  check_image_memory(need, image_need(settings, device), there);
}

/// Builds the tree while images are decoded. Large scenes take their time: whether there is room for them is known
/// before, but for textures whose size is not known yet.
PackedScene pack_with_progress(LoadingSetup& loading, const RenderPlan& plan, const DeviceDescription& device) {
  constexpr std::uint64_t kLarge = 1'000'000;
  const Scene& scene = loading.setup.scene;
  const MemoryNeed need = need_of(scene, plan.settings);
  MemoryClaim claim;
  const MemoryThere there = claim_memory(claim, need, memory_there(device));
  check_room(scene, need, device, there, plan.settings);
  if (need.triangles >= kLarge && !plan.quiet) {
    const char* textures = loading.images.empty() ? "" : ", textures not counted";
    std::fprintf(stderr, "%s%s\n", memory_text(need, there).c_str(), textures);
  }
  ProgressBar bar(plan.quiet);
  return pack_shape(scene, plan.settings, [&, clock = WorkClock()](double share) {
    loading.images.check_so_far();
    if (interrupted()) throw Error(ErrorKind::failed, no_sample_text(plan, device.name));
    bar.update(clock.at(share, "BVH"));
  });
}

RenderResult render_with_progress(const Device& device, const SceneSetup& setup, PackedScene shape,
                                  const RenderPlan& plan, const std::shared_future<Metadata>& recipe,
                                  const SavedFilm* resumed) {
  ProgressBar bar(plan.quiet);
  RenderCallbacks callbacks;
  callbacks.progress = [&bar](const RenderProgress& progress) {
    bar.update({progress.share, progress.rays_per_s, progress.eta_s, ""});
  };
  callbacks.cancelled = interrupted;
  callbacks.resumed = resumed;
  std::optional<Checkpoint> checkpoint;
  if (!plan.checkpoint.empty()) {
    checkpoint.emplace(plan.checkpoint, recipe.get(), plan.checkpoint_interval_s,
                       [](const std::string& line) { print_warnings({line}); });
    callbacks.checkpoint = &*checkpoint;
  }
  try {
    return render_image(device, setup.scene, std::move(shape), setup.camera, plan.settings, callbacks);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::device_lost) throw;
    const bool saved = checkpoint && (checkpoint->is_saved() || plan.resume == plan.checkpoint);
    const std::string hint =
        saved ? resume_hint(plan, device.description().name) : "; nothing was saved, see --checkpoint";
    throw Error(error.kind(), error.what() + hint);
  }
}

/// Makes the recipe beside what follows: hashing a large scene's files takes longer than tracing a small picture.
/// `plan` and `device` outlive it.
std::shared_future<Metadata> begin_recipe(const RenderPlan& plan, const DeviceDescription& device, const Scene& scene) {
  return std::async(std::launch::async, [&, files = scene.files] {
    const RecipeMaker maker{device.name, device.driver,
                            trace_spirv_hash(choose_scene_loads(device, plan.settings.traversal))};
    return render_recipe(scene_recipe(plan.scene_arguments, files, plan.render_arguments), maker);
  });
}

/// `recipe`, or none and a warning where the scene's files went while it was rendered: the picture is no worse for it.
Metadata recipe_or_none(const std::shared_future<Metadata>& recipe, std::vector<std::string>& warnings) {
  try {
    return recipe.get();
  } catch (const Error& failure) {
    warnings.push_back(std::string(failure.what()) + "; the image has no recipe");
    return {};
  }
}

RenderReport report_of(const RenderPlan& plan, const SceneSetup& setup, const CachedDevice& device,
                       const MemoryNeed& memory, RenderStatistics statistics) {
  RenderReport report{setup.scene.source, device.device().description(), plan.settings,  std::move(statistics),
                      setup.load_ms,      setup.scene.warnings,          device.store(), memory};
  report.warnings.insert(report.warnings.end(), report.statistics.warnings.begin(), report.statistics.warnings.end());
  return report;
}

}  // namespace

std::map<std::string, std::string> describe_image(const RenderPlan& plan, const ImageFile& image,
                                                  const RenderStatistics& statistics,
                                                  std::map<std::string, std::string> recipe) {
  if (statistics.error) recipe["vernier:error_estimate"] = error_text(*statistics.error);
  if (statistics.stopped) recipe["vernier:stopped_at"] = std::to_string(statistics.samples_done);
  if (plan.display.exposure_ev != 0.0f) recipe["vernier:exposure"] = plan.exposure;
  const std::string legend = cost_legend(image);
  if (!legend.empty()) recipe["vernier:cost_legend"] = legend;
  return recipe;
}

RenderedImage render_planned(RenderPlan plan) {
  const std::optional<SavedFilm> resumed = read_resumed(plan);
  Libraries libraries = load_libraries();
  const double aspect = aspect_of(plan.settings);
  LoadingSetup loading = open_setup(plan.scene, aspect);
  const VulkanInstance instance = libraries.vulkan.get();
  const DeviceDescription description = choose_device(list_devices(instance), plan.device);
  plan.settings.traversal = calibrated_form(description, loading.setup.scene, plan.settings.traversal);
  check_settings(plan.settings, description);
  std::shared_future<Metadata> recipe;
  if (resumed) {  // that of another render is refused before the tree is built
    loading.images.finish(loading.setup.scene);
    recipe = begin_recipe(plan, description, loading.setup.scene);
    match_recipes("this render", recipe.get(), plan.resume, resumed->recipe, {});
  }
  const CachedDevice device(instance, description, pipeline_file(description.pipeline_key));
  PackedScene shape = pack_with_progress(loading, plan, description);
  libraries.codecs.get();  // before anything is traced that could not be written
  const SceneSetup setup = finish(std::move(loading));
  check_not_read(output_files(plan), setup.scene.files);
  print_warnings(setup.scene.warnings);
  if (!resumed) recipe = begin_recipe(plan, description, setup.scene);
  const MemoryNeed memory = need_of(setup.scene, plan.settings);
  check_room(setup.scene, after_shape(memory), description, memory_there(description), plan.settings);
  RenderResult result =
      render_with_progress(device.device(), setup, std::move(shape), plan, recipe, resumed ? &*resumed : nullptr);
  Metadata words = recipe_or_none(recipe, result.statistics.warnings);
  print_warnings(result.statistics.warnings);

  result.image.metadata.merge(describe_image(plan, result.image, result.statistics, std::move(words)));
  return {std::move(result.image), report_of(plan, setup, device, memory, std::move(result.statistics))};
}

}  // namespace vernier
