// Milliseconds that building a BVH takes, Embree's and each kind of ours in turn, in one process and round by round, by
// the clock and of all threads' CPU time (a second measure for a machine with other guests).
// Usage: build_times MESH ROUNDS THREADS
// Prints one JSON object: what was built and, for each builder, its times in the order of the rounds. The round before
// them, in which memory is asked for first, is not told. MESH: two uint32 counts, float32 positions, uint32 corners.
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bvh/build_bvh.h"
#include "embree.h"
#include "raw_mesh.h"

namespace {

using vernier::RawMesh;

struct Time {
  double wall_ms;
  double cpu_ms;  // of all threads
};

Time time_of(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const std::clock_t cpu_start = std::clock();
  work();
  const double cpu_ms = 1000.0 * static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  return {std::chrono::duration<double, std::milli>(Clock::now() - start).count(), cpu_ms};
}

// The buffers are the mesh's own: what is timed is building. Positions end with a float more, as Embree asks.
Time embree_time(RTCDevice device, const RawMesh& mesh, RTCBuildQuality quality) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.positions.data(), 0,
                             sizeof(glm::vec3), mesh.positions.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.corners.data(), 0,
                             sizeof(glm::uvec3), mesh.corners.size());
  const RTCScene scene = rtcNewScene(device);
  rtcSetSceneBuildQuality(scene, quality);
  const Time time = time_of([&] {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcCommitScene(scene);
  });
  rtcReleaseGeometry(geometry);
  rtcReleaseScene(scene);
  return time;
}

Time build_time(const std::vector<vernier::BvhTriangle>& triangles, unsigned thread_count, vernier::BuildMethod method) {
  return time_of([&] { vernier::build_bvh(triangles, {}, thread_count, method); });
}

struct Builder {
  std::string name;
  std::function<Time()> build;
  std::vector<Time> times;
};

void print_list(const std::string& name, const std::vector<Time>& times, double Time::*member) {
  std::printf(", \"%s\": [", name.c_str());
  for (std::size_t i = 0; i < times.size(); ++i) std::printf("%s%.2f", i > 0 ? ", " : "", times[i].*member);
  std::printf("]");
}

void print_times(const std::vector<Builder>& builders, std::size_t triangle_count, unsigned thread_count) {
  std::printf("{\"triangles\": %zu, \"threads\": %u", triangle_count, thread_count);
  for (const Builder& builder : builders) {
    print_list(builder.name + "_ms", builder.times, &Time::wall_ms);
    print_list(builder.name + "_cpu_ms", builder.times, &Time::cpu_ms);
  }
  std::printf("}\n");
}

void measure(const std::string& path, int round_count, unsigned thread_count) {
  RawMesh mesh = vernier::read_mesh(path);
  mesh.positions.reserve(mesh.positions.size() + 1);
  const std::vector<vernier::BvhTriangle> triangles = triangles_of(mesh);
  const RTCDevice device = rtcNewDevice(("threads=" + std::to_string(thread_count)).c_str());
  std::vector<Builder> builders = {
      {"embree", [&] { return embree_time(device, mesh, RTC_BUILD_QUALITY_MEDIUM); }, {}},
      {"fast", [&] { return build_time(triangles, thread_count, vernier::BuildMethod::fast); }, {}},
      {"default", [&] { return build_time(triangles, thread_count, vernier::BuildMethod::standard); }, {}},
      {"quality", [&] { return build_time(triangles, thread_count, vernier::BuildMethod::quality); }, {}}};
  for (int round = 0; round <= round_count; ++round) {
    for (Builder& builder : builders) {
      const Time time = builder.build();
      if (round > 0) builder.times.push_back(time);
    }
  }
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE) throw std::runtime_error("Embree reports an error");
  print_times(builders, triangles.size(), thread_count);
  rtcReleaseDevice(device);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "build_times: takes a mesh, a number of rounds and one of threads\n");
    return 2;
  }
  try {
    measure(argv[1], std::atoi(argv[2]), static_cast<unsigned>(std::atoi(argv[3])));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "build_times: %s\n", error.what());
    return 1;
  }
  return 0;
}
