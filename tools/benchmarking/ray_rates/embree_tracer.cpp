#include <chrono>
#include <ctime>
#include <stdexcept>
#include <string>

#include "../on_all_threads.h"
#include "tracers.h"

namespace vernier {
namespace {

RTCRay embree_ray(const RatedRay& ray) {
  RTCRay out{};
  out.org_x = ray.origin.x;
  out.org_y = ray.origin.y;
  out.org_z = ray.origin.z;
  out.dir_x = ray.direction.x;
  out.dir_y = ray.direction.y;
  out.dir_z = ray.direction.z;
  out.tfar = ray.t_max;
  out.mask = ~0u;
  return out;
}

RTCRayHit intersect(RTCScene scene, const RatedRay& ray) {
  RTCRayHit hit{embree_ray(ray), {}};
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.primID = RATED_NOTHING;
  find_closest_hit(scene, hit, kAnyRays);
  return hit;
}

void add_mesh(RTCDevice device, RTCScene scene, const RawMesh& mesh) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                            mesh.positions.size());
  void* corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3),
                                          mesh.corners.size());
  std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<glm::vec3*>(positions));
  std::copy(mesh.corners.begin(), mesh.corners.end(), static_cast<glm::uvec3*>(corners));
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

}  // namespace

EmbreeTracer::EmbreeTracer(const RawMesh& mesh, RTCBuildQuality quality, unsigned thread_count)
    : device_(rtcNewDevice(nullptr)), thread_count_(thread_count) {
  scene_ = rtcNewScene(device_);
  rtcSetSceneBuildQuality(scene_, quality);
  add_mesh(device_, scene_, mesh);
  rtcCommitScene(scene_);
  if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::runtime_error("Embree cannot build its tree");
}

EmbreeTracer::~EmbreeTracer() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

SurfaceHit EmbreeTracer::closest_hit(const RatedRay& ray) const {
  const RTCRayHit hit = intersect(scene_, ray);
  return {hit.hit.geomID != RTC_INVALID_GEOMETRY_ID, hit.ray.tfar, {hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z}};
}

std::uint32_t EmbreeTracer::search(const RatedRay& ray) const {
  if (ray.any_hit == 0) return intersect(scene_, ray).hit.primID;
  return is_occluded(scene_, embree_ray(ray), kAnyRays) ? 0 : RATED_NOTHING;
}

PassTime EmbreeTracer::trace(const std::vector<RatedRay>& rays) const {
  using Clock = std::chrono::steady_clock;
  // Answers are kept, as the device keeps them.
  std::vector<std::uint32_t> found(rays.size());
  const auto start = Clock::now();
  const std::clock_t cpu_start = std::clock();
  on_all_threads(rays.size(), thread_count_, [&](std::size_t i) { found[i] = search(rays[i]); });
  const double cpu_s = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  return {std::chrono::duration<double>(Clock::now() - start).count(), cpu_s};
}

std::vector<std::uint32_t> EmbreeTracer::answers(const std::vector<RatedRay>& rays) const {
  std::vector<std::uint32_t> found(rays.size());
  on_all_threads(rays.size(), thread_count_, [&](std::size_t i) { found[i] = search(rays[i]); });
  return found;
}

}  // namespace vernier
