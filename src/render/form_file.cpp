#include "render/form_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "image/whole_file.h"
#include "render/pipeline_file.h"
#include "render/plan_instances.h"

namespace vernier {

std::string form_file(const std::string& pipeline_key) {
  return cache_file(pipeline_key + ".traversal");
}

std::optional<TraversalForm> read_form(const std::string& file) {
  std::ifstream stream(file);
  std::string name;
  if (!std::getline(stream, name)) return std::nullopt;
  const auto found = std::ranges::find_if(kTraversalForms, [&](TraversalForm form) { return to_string(form) == name; });
  if (found == kTraversalForms.end()) return std::nullopt;
  return *found;
}

void write_form(const std::string& file, TraversalForm form) {
  std::error_code failure;
  std::filesystem::create_directories(std::filesystem::path(file).parent_path(), failure);  // shows again below
  write_text(file, std::string(to_string(form)) + "\n");
}

TraversalForm calibrated_form(const DeviceDescription& device, const Scene& scene, TraversalForm form) {
  if (form != TraversalForm::automatic) return form;
  const std::optional<TraversalForm> found = read_form(form_file(device.pipeline_key));
  if (!found) return form;
  if (*found == TraversalForm::ray_query) {
    const bool shares = !plan_instances(scene, Sharing::automatic).meshes.empty();
    return device.ray_query && !shares ? *found : form;
  }
  return choose_scene_loads(device, *found) == SceneLoads::texels && !device.subgroup_ballot ? form : *found;
}

}  // namespace vernier
