#include "verify/picture.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace vernier {
namespace {

const std::vector<float>& colors_of(const Picture& picture) {
  return std::get<std::vector<float>>(picture.layers.front().values);
}

bool is_sound(const Picture& picture, std::size_t pixel) {
  const glm::vec3 color = picture.color(pixel);
  return picture.dropped_rays == 0 && std::isfinite(color.x) && std::isfinite(color.y) && std::isfinite(color.z);
}

}  // namespace

glm::vec3 Picture::color(std::size_t pixel) const {
  const float* value = colors_of(*this).data() + 4 * pixel;
  return {value[0], value[1], value[2]};
}

std::string Picture::inputs(std::size_t pixel) const {
  const glm::vec3 value = color(pixel);
  return "picture " + std::to_string(number) + ", pixel " + std::to_string(pixel % static_cast<std::size_t>(width)) +
         "," + std::to_string(pixel / static_cast<std::size_t>(width)) + ": " +
         hex_floats({{"r", value.x}, {"g", value.y}, {"b", value.z}});
}

RenderSettings picture_settings(const CaseSetup& setup, int side) {
  RenderSettings settings;
  settings.width = settings.height = side;
  settings.spp = settings.sample_end = 1;
  settings.cutoff = 0.0f;
  settings.accuracy = setup.level;
  settings.spot_levels = setup.levels;
  settings.mutation = setup.mutation;
  settings.traversal = setup.traversal;
  return settings;
}

Picture render_picture(const CaseSetup& setup, const ImageScene& scene, const RenderSettings& settings) {
  RenderResult result = render_image(*setup.device, scene.scene, scene.camera, settings, {});
  return {.width = result.image.width,
          .height = result.image.height,
          .layers = std::move(result.image.layers),
          .dropped_rays = result.statistics.stack_overflows};
}

PixelRay pixel_ray(const Camera& camera, const Picture& picture, std::size_t pixel) {
  const auto width = static_cast<std::size_t>(picture.width);
  const double nx = 2.0 * (static_cast<double>(pixel % width) + 0.5) / picture.width - 1.0;
  const double ny = 1.0 - 2.0 * (static_cast<double>(pixel / width) + 0.5) / picture.height;
  const double slope = std::tan(camera.vertical_fov / 2.0);
  const glm::dmat3 axes(camera.world_from_camera);
  const double aspect = static_cast<double>(picture.width) / picture.height;
  return {glm::dvec3(camera.world_from_camera[3]),
          glm::normalize(axes[0] * (nx * aspect * slope) + axes[1] * (ny * slope) - axes[2])};
}

std::array<PixelRay, 5> nearby_rays(const PixelRay& ray, double angle) {
  const glm::dvec3& d = ray.direction;
  const glm::dvec3 side =
      glm::normalize(glm::cross(d, std::abs(d.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 up = glm::cross(side, d);
  const auto turned = [&](const glm::dvec3& way) { return PixelRay{ray.origin, glm::normalize(d + angle * way)}; };
  return {ray, turned(side), turned(-side), turned(up), turned(-up)};
}

void for_each_picture(const CaseSetup& setup, const char* name, int side, std::uint64_t most_pictures,
                      const std::function<void(SampleRandom& random, std::uint64_t number)>& take) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(side) * static_cast<std::uint64_t>(side);
  for (std::uint64_t number = 0; number < most_pictures && setup.wants(number * pixels); ++number) {
    SampleRandom random(setup.seed, name, number);
    take(random, number);
  }
}

void book_pixels(Tally& tally, const Picture& picture, const std::function<bool(std::size_t pixel)>& holds) {
  for (std::size_t pixel = 0; pixel < picture.pixel_count(); ++pixel) {
    tally.book(is_sound(picture, pixel) && holds(pixel), [&] { return picture.inputs(pixel); });
  }
}

void book_pixel_errors(Tally& tally, const Picture& picture, const std::function<double(std::size_t pixel)>& error) {
  for (std::size_t pixel = 0; pixel < picture.pixel_count(); ++pixel) {
    const double off = is_sound(picture, pixel) ? error(pixel) : std::numeric_limits<double>::quiet_NaN();
    tally.book_error(off, [&] { return picture.inputs(pixel); });
  }
}

bool same_bits(const Picture& a, const Picture& b, std::size_t pixel) {
  return std::memcmp(colors_of(a).data() + 4 * pixel, colors_of(b).data() + 4 * pixel, 4 * sizeof(float)) == 0;
}

}  // namespace vernier
