// Rays per second of Embree with single rays on all threads: primary rays, then shadow rays to a point light.
// Usage: embree_rate MESH WIDTH HEIGHT SECONDS THREADS EYE(3) RIGHT(3) UP(3) FORWARD(3) LIGHT(3) HALF_HEIGHT
// Prints one JSON object. MESH: two uint32 counts, float32 positions, uint32 corners.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "embree.h"
#include "on_all_threads.h"

namespace {

struct Vector {
  float x, y, z;
};

Vector operator+(Vector a, Vector b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vector operator-(Vector a, Vector b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vector operator*(Vector a, float s) {
  return {a.x * s, a.y * s, a.z * s};
}
float dot(Vector a, Vector b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

struct View {
  Vector eye, right, up, forward, light;
  float half_height;
};

constexpr std::size_t kTile = 8;      // pixels a side: neighbours in the picture follow one another

RTCRay ray_of(Vector origin, Vector direction, float far) {
  RTCRay ray{};
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.tfar = far;
  ray.mask = ~0u;
  return ray;
}

RTCScene load_scene(RTCDevice device, const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::uint32_t counts[2] = {};
  file.read(reinterpret_cast<char*>(counts), sizeof counts);
  const RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* positions =
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vector), counts[0]);
  void* corners = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, counts[1]);
  file.read(static_cast<char*>(positions), static_cast<std::streamsize>(sizeof(Vector)) * counts[0]);
  file.read(static_cast<char*>(corners), static_cast<std::streamsize>(12) * counts[1]);
  if (!file) throw std::runtime_error(path + ": is cut off");
  rtcCommitGeometry(mesh);
  const RTCScene scene = rtcNewScene(device);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  rtcAttachGeometry(scene, mesh);
  rtcReleaseGeometry(mesh);
  rtcCommitScene(scene);
  return scene;
}

std::vector<RTCRay> primary_rays(const View& view, std::size_t width, std::size_t height) {
  std::vector<RTCRay> rays;
  rays.reserve(width * height);
  const float half_width = view.half_height * static_cast<float>(width) / static_cast<float>(height);
  for (std::size_t tile_y = 0; tile_y < height; tile_y += kTile) {
    for (std::size_t tile_x = 0; tile_x < width; tile_x += kTile) {
      for (std::size_t i = 0; i < kTile * kTile; ++i) {
        const std::size_t x = tile_x + i % kTile;
        const std::size_t y = tile_y + i / kTile;
        if (x >= width || y >= height) continue;
        const float u = (2.0f * (static_cast<float>(x) + 0.5f) / static_cast<float>(width) - 1.0f) * half_width;
        const float v = (1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / static_cast<float>(height)) * view.half_height;
        const Vector direction = view.forward + view.right * u + view.up * v;
        rays.push_back(ray_of(view.eye, direction * (1.0f / std::sqrt(dot(direction, direction))),
                              std::numeric_limits<float>::infinity()));
      }
    }
  }
  return rays;
}

struct Rate {
  double per_s;      // of the clock on the wall
  double per_cpu_s;  // of the CPU seconds of all threads
};

// Calls trace(i) for all i below `count` on all threads, again and again for `seconds`; returns calls per second.
template <typename Trace>
Rate rate(std::size_t count, unsigned thread_count, double seconds, const Trace& trace) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const std::clock_t cpu_start = std::clock();
  double passed = 0.0;
  std::size_t passes = 0;
  while (passed < seconds) {
    on_all_threads(count, thread_count, trace);
    ++passes;
    passed = std::chrono::duration<double>(Clock::now() - start).count();
  }
  const double cpu_s = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  const auto calls = static_cast<double>(passes * count);
  return {calls / passed, calls / cpu_s};
}

// Shadow rays from where the primary rays hit a side that faces the light.
std::vector<RTCRay> shadow_rays(RTCScene scene, const std::vector<RTCRay>& primary, Vector light) {
  std::vector<RTCRay> shadows;
  for (const RTCRay& ray : primary) {
    RTCRayHit hit{ray, {}};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    find_closest_hit(scene, hit, kAnyRays);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
    const Vector direction{ray.dir_x, ray.dir_y, ray.dir_z};
    const Vector place = Vector{ray.org_x, ray.org_y, ray.org_z} + direction * hit.ray.tfar;
    const Vector normal{hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z};
    const Vector to_light = light - place;
    if (dot(normal, to_light) * dot(normal, direction) >= 0.0f) continue;
    shadows.push_back(ray_of(place, to_light, 1.0f));
    shadows.back().tnear = 1e-4f;  // of the way to the light: off the own triangle
  }
  return shadows;
}

void measure(const std::string& path, std::size_t width, std::size_t height, double seconds, unsigned threads,
             const View& view) {
  const RTCDevice device = rtcNewDevice(nullptr);
  const RTCScene scene = load_scene(device, path);
  const std::vector<RTCRay> primary = primary_rays(view, width, height);
  const std::vector<RTCRay> shadows = shadow_rays(scene, primary, view.light);
  const Rate primary_rate = rate(primary.size(), threads, seconds, [&](std::size_t i) {
    RTCRayHit hit{primary[i], {}};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    find_closest_hit(scene, hit, kCoherentRays);
  });
  const Rate shadow_rate = rate(shadows.size(), threads, seconds, [&](std::size_t i) {
    is_occluded(scene, shadows[i], kCoherentRays);
  });
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw std::runtime_error("Embree reports an error");
  const auto p = static_cast<double>(primary.size());
  const auto s = static_cast<double>(shadows.size());
  const double seconds_once = p / primary_rate.per_s + s / shadow_rate.per_s;
  const double cpu_s_once = p / primary_rate.per_cpu_s + s / shadow_rate.per_cpu_s;
  std::printf("{\"primary\": %zu, \"shadow\": %zu, \"primary_per_s\": %.0f, \"shadow_per_s\": %.0f, ", primary.size(),
              shadows.size(), primary_rate.per_s, shadow_rate.per_s);
  std::printf("\"rays_per_s\": %.0f, \"cpu_s\": %.6f}\n", (p + s) / seconds_once, cpu_s_once);
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int kNumbers = 16;
  if (argc != 6 + kNumbers) {
    std::fprintf(stderr, "embree_rate: takes a mesh, 4 settings and %d numbers of camera and light\n", kNumbers);
    return 2;
  }
  float n[kNumbers];
  for (int i = 0; i < kNumbers; ++i) n[i] = std::strtof(argv[6 + i], nullptr);
  const View view{{n[0], n[1], n[2]},   {n[3], n[4], n[5]},    {n[6], n[7], n[8]},
                  {n[9], n[10], n[11]}, {n[12], n[13], n[14]}, n[15]};
  try {
    measure(argv[1], std::stoul(argv[2]), std::stoul(argv[3]), std::stod(argv[4]),
            static_cast<unsigned>(std::stoul(argv[5])), view);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "embree_rate: %s\n", error.what());
    return 1;
  }
  return 0;
}
