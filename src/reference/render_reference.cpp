#include "reference/render_reference.h"

#include <iterator>
#include <optional>
#include <utility>

#include "reference/first_hit_layers.h"
#include "reference/parallel_rows.h"
#include "reference/pixel_samples.h"
#include "reference/radiance.h"

namespace vernier {

namespace {

using namespace reference;

// Nothing where the caller cancels before the last sample.
std::optional<glm::dvec4> pixel_color(const TracedScene& scene, const Camera& camera, const ReferenceSettings& settings,
                                      const std::function<bool()>& cancelled, int x, int y) {
  const PathLimits limits{settings.max_bounces, settings.cutoff};
  glm::dvec4 sum(0.0);
  for (std::uint32_t sample = 0; sample < settings.spp; ++sample) {
    if (cancelled && cancelled()) return std::nullopt;
    const Arrival arrival = radiance(scene, limits, sample_ray(camera, settings, x, y, sample));
    sum += glm::dvec4(arrival.radiance, arrival.hit ? 1.0 : 0.0);
  }
  return sum / static_cast<double>(settings.spp);
}

}  // namespace

ImageFile render_reference(const Scene& scene, const Camera& camera, const ReferenceSettings& settings,
                           const ReferenceCallbacks& callbacks) {
  check_settings(settings);
  const TracedScene traced = prepare_scene(scene);
  std::vector<Layer> layers = missed_layers(settings.width, settings.height);
  std::vector<float> colors(static_cast<std::size_t>(settings.width) * settings.height * 4);
  const auto render_row = [&](int y) {
    for (int x = 0; x < settings.width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * settings.width + x;
      const auto color = pixel_color(traced, camera, settings, callbacks.cancelled, x, y);
      if (!color) return;
      for (int channel = 0; channel < 4; ++channel) colors[4 * pixel + channel] = static_cast<float>((*color)[channel]);
      fill_layers(traced, camera_ray(camera, settings.width, settings.height, {x + 0.5, y + 0.5}), pixel, layers);
    }
  };
  for_each_row(settings.height, settings.thread_count, render_row, callbacks.progress, callbacks.cancelled);

  ImageFile file{settings.width, settings.height, 0, 0, settings.width, settings.height, {}, {}};
  file.layers.push_back({"", {"R", "G", "B", "A"}, std::move(colors)});
  file.layers.insert(file.layers.end(), std::make_move_iterator(layers.begin()), std::make_move_iterator(layers.end()));
  return file;
}

}  // namespace vernier
