#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/render_reference.h"
#include "verify/image_cases.h"
#include "verify/picture.h"
#include "verify/ray_suite.h"

namespace vernier {
namespace {

constexpr int kSide = 64;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// From Embree's watertight tests; floats are 1/64 apart there.
constexpr glm::dvec3 kFarPlace(148376.0, 1234.0, -223423.0);

/// A closed bumpy ball seen from its inside, in a world that would outshine it a million times.
ImageScene dark_ball(SampleRandom& random) {
  ImageScene made;
  add_object(made.scene, placed(sphere_mesh(16, 16, 6.0, 8.0, random), 1.0, kFarPlace), unlit(glm::vec3(1.0f)));
  surround(made.scene, glm::vec3(1e6f));
  const glm::dvec3 eye = kFarPlace + random.direction() * 2.0;
  made.camera = looking(eye, eye + random.direction(), 2.0);
  return made;
}

/// A convex body of long triangles under two lights.
ImageScene lit_body(SampleRandom& random) {
  ImageScene made;
  add_object(made.scene, placed(double_cone(12, 0.0, random), 8.0, kFarPlace), matte(glm::vec3(0.5f)));
  for (int i = 0; i < 2; ++i) {
    Light light;
    light.kind = i == 0 ? LightKind::directional : LightKind::point;
    light.direction = random.direction();
    light.position = kFarPlace + random.direction() * 20.0;
    light.intensity = glm::vec3(i == 0 ? 1.0f : 400.0f);
    made.scene.lights.push_back(light);
  }
  made.camera = looking(kFarPlace + random.direction() * 30.0, kFarPlace, 0.6);
  return made;
}

constexpr std::uint32_t kLayers = 100;
constexpr float kLayerAlpha = 1.0f / 64.0f;

/// `kLayers` see-through triangles across z from `z` upwards, one step of float apart, `size` wide.
VerifyMesh layers_at(float z, float size) {
  VerifyMesh mesh;
  // Around 0 the steps are those of the corners.
  const double gap = std::ldexp(1.0, std::ilogb(std::max(z, size)) - 23);
  for (std::uint32_t i = 0; i < kLayers; ++i) {
    const float height = static_cast<float>(z + i * gap);
    mesh.positions.insert(
        mesh.positions.end(),
        {{-2 * size, -2 * size, height}, {6 * size, -2 * size, height}, {-2 * size, 6 * size, height}});
    mesh.triangles.push_back(glm::uvec3(0, 1, 2) + 3 * i);
  }
  return mesh;
}

/// Layers of a white shimmer, looked at from below; or between a light and a white ground, looked at from between.
ImageScene layered(float z, float size, bool as_shadow, SampleRandom& random) {
  ImageScene made;
  Material shimmer = unlit(glm::vec3(1.0f));
  shimmer.base_color.w = kLayerAlpha;
  shimmer.alpha_mode = AlphaMode::blend;
  add_object(made.scene, layers_at(z, size), shimmer);
  // Keeps 0 within the scene: it is not moved before it is traced.
  add_object(made.scene, {{glm::vec3(0.0f), {0, -1e-3f, 0}, {1e-3f, -1e-3f, 0}}, {{0u, 1u, 2u}}},
             matte(glm::vec3(0.0f)));
  const glm::dvec3 below(random.in(-0.2, 0.2) * size, random.in(-0.2, 0.2) * size, z - 2.0 * size);
  made.camera = looking(below, below + glm::dvec3(0.0, 0.0, as_shadow ? -1.0 : 1.0), 0.5);
  if (!as_shadow) return made;
  const float ground = z - 3.0f * size;
  add_rectangle(made.scene, {-4 * size, -4 * size, ground}, {8 * size, 0, 0}, {0, 8 * size, 0}, matte(glm::vec3(1.0f)));
  Light light;
  light.kind = LightKind::directional;
  light.intensity = glm::vec3(std::numbers::pi_v<float>);
  made.scene.lights.push_back(light);
  return made;
}

/// How far uv may be off where a pixel's ray meets a ground of `half` metres to each side, `distance` away: the
/// direction's three roundings, stretched by the slant; then at robust the weights, to which corners come with up to 16
/// roundings at both ends of an edge, counted in the triangle's height as the ray sees it, else four roundings of 1.
double uv_bound(const CaseSetup& setup, double half, double distance, double cosine) {
  const double direction = distance * 4.0 * 0x1p-24 / cosine / (2.0 * half);
  const double longest = 2.0 * std::numbers::sqrt2 * half, farthest = longest;
  const double seen_area = 4.0 * half * half * cosine;
  const double weights =
      setup.level == Accuracy::exact ? 4.0 * 0x1p-24 : 2.0 * 16.0 * 0x1p-24 * farthest * longest / seen_area;
  return direction + weights + 4.0 * 0x1p-24;
}

/// Colours of the reference renderer for the same picture.
std::vector<float> reference_colors(const ImageScene& made, const RenderSettings& settings) {
  ReferenceSettings same;
  same.width = settings.width;
  same.height = settings.height;
  same.spp = settings.spp;
  same.max_bounces = settings.max_bounces;
  same.cutoff = static_cast<double>(settings.cutoff);
  ImageFile image = render_reference(made.scene, made.camera, same, {});
  return std::get<std::vector<float>>(std::move(image.layers.front().values));
}

/// Largest difference of a pixel's colours, relative to `b` but for values below 2^-10, a step of a cutoff.
double relative_difference(const glm::vec3& a, const float* b) {
  double largest = 0.0;
  for (int c = 0; c < 3; ++c) {
    largest = std::max(largest, std::abs(double{a[c]} - b[c]) / std::max(std::abs(double{b[c]}), 0x1p-10));
  }
  return largest;
}

}  // namespace

CaseResult run_far_scene(const CaseSetup& setup) {
  constexpr const char* kName = "far_scene";
  Tally tally;
  for_each_picture(setup, kName, kSide, 16, [&](SampleRandom& random, std::uint64_t number) {
    RenderSettings settings = picture_settings(setup, kSide);
    if (number % 2 == 0) {
      Picture picture = render_picture(setup, dark_ball(random), settings);
      picture.number = number;
      book_pixels(tally, picture, [&](std::size_t pixel) { return picture.color(pixel) == glm::vec3(1.0f); });
    } else {
      const ImageScene made = lit_body(random);
      Picture picture = render_picture(setup, made, settings);
      picture.number = number;
      settings.effects = "auto,-shadows";
      const Picture unshadowed = render_picture(setup, made, settings);
      book_pixels(tally, picture, [&](std::size_t pixel) { return same_bits(picture, unshadowed, pixel); });
    }
  });
  return tally.result();
}

CaseResult run_image_layers(const CaseSetup& setup) {
  constexpr const char* kName = "image_layers";
  // Three roundings per layer, of the share, its complement and the sum, and ten for the light on the ground.
  Tally tally("absolute", (3.0 * kLayers + 10.0) * 0x1p-24);
  const double through = std::pow(1.0 - double{kLayerAlpha}, kLayers);
  for_each_picture(setup, kName, kSide, 6, [&](SampleRandom& random, std::uint64_t number) {
    const bool as_shadow = number % 2 == 1;
    const float z = number / 2 == 0 ? 0.0f : number / 2 == 1 ? 1e3f : 1e6f, size = z == 1e6f ? 64.0f : 1.0f;
    Picture picture = render_picture(setup, layered(z, size, as_shadow, random), picture_settings(setup, kSide));
    picture.number = number;
    const double expected = as_shadow ? through : 1.0 - through;
    book_pixel_errors(tally, picture, [&](std::size_t pixel) { return std::abs(picture.color(pixel).x - expected); });
  });
  return tally.result();
}

CaseResult run_perspective_uv(const CaseSetup& setup) {
  constexpr const char* kName = "perspective_uv";
  constexpr double kHalf = 128.0;
  Tally tally("bounds", 1.0);
  std::uint64_t judged = 0;
  for_each_picture(setup, kName, kSide, 8, [&](SampleRandom& random, std::uint64_t number) {
    ImageScene made;
    constexpr auto kSize = static_cast<float>(kHalf);
    add_rectangle(made.scene, {-kSize, -1.0f, kSize}, {2 * kSize, 0, 0}, {0, 0, -2 * kSize}, matte(glm::vec3(1.0f)));
    const glm::dvec3 eye(random.in(-2.0, 2.0), 0.0, random.in(-2.0, 2.0));
    made.camera = looking(eye, eye + glm::dvec3(random.in(-1.0, 1.0), random.in(-0.5, 0.0), random.in(-1.0, 1.0)), 1.5);
    RenderSettings settings = picture_settings(setup, kSide);
    settings.aovs = {"uv", "depth"};
    Picture picture = render_picture(setup, made, settings);
    picture.number = number;
    const auto& uv = std::get<std::vector<float>>(picture.layers[1].values);
    const auto& depth = std::get<std::vector<float>>(picture.layers[2].values);
    book_pixel_errors(tally, picture, [&](std::size_t pixel) {
      const PixelRay ray = pixel_ray(made.camera, picture, pixel);
      const double t = -1.0 / ray.direction.y;
      const glm::dvec3 place = ray.origin + t * ray.direction;
      // Beyond the horizon, or near the ground's rim where rounding decides.
      if (!(t > 0.0) || std::max(std::abs(place.x), std::abs(place.z)) > 0.999 * kHalf) return 0.0;
      ++judged;
      if (!std::isfinite(depth[pixel])) return kNan;
      const double u = (place.x + kHalf) / (2.0 * kHalf), v = (kHalf - place.z) / (2.0 * kHalf);
      return std::max(std::abs(uv[2 * pixel] - u), std::abs(uv[2 * pixel + 1] - v)) /
             uv_bound(setup, kHalf, t, 1.0 / t);
    });
  });
  // The sky is a good half of some pictures.
  return if_judged(tally.result(), 2 * judged);
}

CaseResult run_reference_scene(const CaseSetup& setup) {
  constexpr const char* kName = "reference_scene";
  // The eye is moved by 2^-18 of its distance, about what five bounces of eight half ulps each do to a path. Where that
  // changes the picture by less than 2^-10 of itself, rounding does too; Fresnel terms and sums add less than 2^-14.
  constexpr double kShift = 0x1p-18, kChange = 0x1p-10;
  Tally tally("relative", kChange + 0x1p-14);
  std::uint64_t judged = 0;
  for_each_picture(setup, kName, kSide, 4, [&](SampleRandom& random, std::uint64_t number) {
    const ImageScene made = mixed_scene(random);
    RenderSettings settings = picture_settings(setup, kSide);
    settings.max_bounces = 4;
    Picture picture = render_picture(setup, made, settings);
    picture.number = number;
    const std::vector<float> reference = reference_colors(made, settings);
    std::vector<double> change(picture.pixel_count(), 0.0);
    for (int way = 0; way < 4; ++way) {
      ImageScene moved = made;
      glm::dmat4& frame = moved.camera.world_from_camera;
      frame[3] += frame[way / 2] * ((way % 2 == 0 ? kShift : -kShift) * glm::length(glm::dvec3(frame[3])));
      const std::vector<float> other = reference_colors(moved, settings);
      for (std::size_t pixel = 0; pixel < change.size(); ++pixel) {
        const float* value = other.data() + 4 * pixel;
        const glm::vec3 color(value[0], value[1], value[2]);
        change[pixel] = std::max(change[pixel], relative_difference(color, reference.data() + 4 * pixel));
      }
    }
    book_pixel_errors(tally, picture, [&](std::size_t pixel) {
      if (change[pixel] > kChange) return 0.0;
      ++judged;
      return relative_difference(picture.color(pixel), reference.data() + 4 * pixel);
    });
  });
  return if_judged(tally.result(), judged);
}

CaseResult run_driver_difference(const CaseSetup& setup) {
  constexpr const char* kName = "driver_difference";
  CaseResult not_run;
  if (setup.level != Accuracy::exact) {
    not_run.not_run = "only exact promises the same hits on two devices";
    return not_run;
  }
  const VulkanInstance instance;
  const std::string& name = setup.device->description().name;
  const std::vector<DeviceDescription> devices = list_devices(instance);
  const auto other = std::ranges::find_if(
      devices, [&](const DeviceDescription& device) { return device.usable && device.name != name; });
  if (other == devices.end()) {
    not_run.not_run = "there is no second device beside " + name;
    return not_run;
  }
  const Device second(instance, *other);
  CaseSetup setup_of_second = setup;
  setup_of_second.device = &second;
  Tally tally;
  for_each_picture(setup, kName, kSide, 4, [&](SampleRandom& random, std::uint64_t number) {
    const ImageScene made = mixed_scene(random);
    RenderSettings settings = picture_settings(setup, kSide);
    settings.aovs = {"object_id", "primitive_id"};
    Picture picture = render_picture(setup, made, settings);
    picture.number = number;
    const Picture there = render_picture(setup_of_second, made, settings);
    const auto same_id = [&](std::size_t layer, std::size_t pixel) {
      const auto id = [&](const Picture& one) {
        return std::get<std::vector<std::uint32_t>>(one.layers[layer].values)[pixel];
      };
      return id(picture) == id(there);
    };
    book_pixels(tally, picture, [&](std::size_t pixel) {
      const glm::vec3 a = picture.color(pixel), b = there.color(pixel);
      bool same = same_id(1, pixel) && same_id(2, pixel);
      // One step of an 8-bit picture; above 1 of the value, which is beyond white there.
      for (int c = 0; c < 3; ++c) same = same && std::abs(a[c] - b[c]) <= std::max(1.0f, a[c]) / 255.0f;
      return same;
    });
  });
  return tally.result();
}

}  // namespace vernier
