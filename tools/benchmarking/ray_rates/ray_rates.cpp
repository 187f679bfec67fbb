// Seconds that searches of the same rays take: by Vernier's traversal on the first usable device, by Embree's single
// rays, and by ray queries where the device's driver has them. Nothing is shaded. All take turns, pass by pass.
//
//     ray_rates MESH ROUNDS PASSES THREADS EYE(3) RIGHT(3) UP(3) FORWARD(3) LIGHT(3) HALF_HEIGHT
//
// Prints one JSON object: the device, the tree, what rays cost in records and how many of them hit, rays of each tracer
// whose answer is not that of Embree, and for each round and tracer the seconds of its passes. The round before them is
// not told.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "bvh/bvh_statistics.h"
#include "gpu/vector_width.h"
#include "ray_query_tracer.h"

namespace vernier {
namespace {

struct Tracer {
  std::string name;
  std::function<PassTime(RayKind)> trace;
  std::function<std::vector<std::uint32_t>(RayKind)> answers;
};

constexpr std::array kKinds = {kPrimary, kMirror, kDiffuse, kShadow};

nlohmann::json tree_json(const Bvh& bvh) {
  const BvhStatistics tree = bvh_statistics(bvh);
  return {{"triangles", tree.triangle_count},
          {"nodes", tree.node_count},
          {"depth", tree.depth},
          {"sah_cost", tree.sah_cost},
          {"bytes", tree.bytes}};
}

nlohmann::json records_json(VernierTracer& vernier) {
  nlohmann::json out;
  for (const RayKind kind : kKinds) {
    const RecordCounts counts = vernier.count_records(kind);
    out[kRayKinds[kind]] = {{"records_per_ray", counts.records_per_ray},
                            {"rounds_per_subgroup", counts.rounds_per_subgroup}};
  }
  return out;
}

/// The part of each kind's rays that meet anything.
nlohmann::json hits_json(const Tracer& tracer) {
  nlohmann::json out;
  for (const RayKind kind : kKinds) {
    std::size_t hits = 0;
    for (const std::uint32_t answer : tracer.answers(kind)) hits += answer != RATED_NOTHING ? 1 : 0;
    out[kRayKinds[kind]] = static_cast<double>(hits) / kRayCount;
  }
  return out;
}

/// Of each tracer but the first and of each kind: rays that it answers otherwise than the first.
nlohmann::json differing_json(const std::vector<Tracer>& tracers) {
  nlohmann::json out;
  for (const RayKind kind : kKinds) {
    const std::vector<std::uint32_t> expected = tracers.front().answers(kind);
    for (std::size_t number = 1; number < tracers.size(); ++number) {
      const std::vector<std::uint32_t> found = tracers[number].answers(kind);
      std::size_t differing = 0;
      for (std::size_t i = 0; i < found.size(); ++i) differing += found[i] != expected[i] ? 1 : 0;
      out[tracers[number].name][kRayKinds[kind]] = differing;
    }
  }
  return out;
}

/// Seconds of `passes` passes of each tracer, which take turns.
nlohmann::json round_json(const std::vector<Tracer>& tracers, int passes) {
  nlohmann::json out;
  for (const RayKind kind : kKinds) {
    std::vector<PassTime> sums(tracers.size(), {0.0, 0.0});
    for (int pass = 0; pass < passes; ++pass) {
      for (std::size_t number = 0; number < tracers.size(); ++number) {
        const PassTime time = tracers[number].trace(kind);
        sums[number].seconds += time.seconds;
        sums[number].cpu_s += time.cpu_s;
      }
    }
    for (std::size_t number = 0; number < tracers.size(); ++number) {
      out[tracers[number].name][kRayKinds[kind]] = {{"seconds", sums[number].seconds}, {"cpu_s", sums[number].cpu_s}};
    }
  }
  return out;
}

struct Arguments {
  std::string mesh;
  int rounds;
  int passes;
  unsigned threads;
  RayView view;
};

/// Halves or doubles the scene until it just lies in [-1, 1], as the renderer's do (pack_scene). No answer changes by
/// that.
void scale_into_traced_space(RawMesh& mesh, RayView& view) {
  float largest = 0.0f;
  for (const glm::vec3& p : mesh.positions) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  const float scale = std::ldexp(1.0f, -exponent);
  for (glm::vec3& p : mesh.positions) p *= scale;
  view.eye *= scale;
  view.light *= scale;
}

nlohmann::json measure(Arguments arguments) {
  choose_vector_width();
  const VulkanInstance instance;
  const Device device(instance, choose_device(list_devices(instance), ""));
  RawMesh mesh = read_mesh(arguments.mesh);
  scale_into_traced_space(mesh, arguments.view);
  const EmbreeTracer embree(mesh, RTC_BUILD_QUALITY_HIGH, arguments.threads);
  const EmbreeTracer medium(mesh, RTC_BUILD_QUALITY_MEDIUM, arguments.threads);
  const RaySets rays = make_rays(arguments.view, [&](const RatedRay& ray) { return embree.closest_hit(ray); });
  VernierTracer vernier(device, mesh, rays);
  std::optional<RayQueryTracer> queries;
  if (device.description().ray_query) queries.emplace(device, mesh, rays);
  const auto of_embree = [&rays](const std::string& name, const EmbreeTracer& tracer) -> Tracer {
    return {name, [&](RayKind kind) { return tracer.trace(rays[kind]); },
            [&](RayKind kind) { return tracer.answers(rays[kind]); }};
  };
  std::vector<Tracer> tracers = {of_embree("Embree", embree), of_embree("Embree medium", medium)};
  tracers.push_back({"Vernier", [&](RayKind kind) { return vernier.trace(kind); },
                     [&](RayKind kind) { return comparable(vernier.answers(kind), rays[kind]); }});
  if (queries) {
    tracers.push_back({"ray query", [&](RayKind kind) { return queries->trace(kind); },
                       [&](RayKind kind) { return comparable(queries->answers(kind), rays[kind]); }});
  }
  nlohmann::json out = {{"device", device.description().name}, {"driver", device.description().driver},
                        {"threads", arguments.threads},        {"rays", kRayCount},
                        {"passes", arguments.passes},          {"tree", tree_json(vernier.bvh())},
                        {"records", records_json(vernier)},    {"hits", hits_json(tracers.front())},
                        {"differing", differing_json(tracers)}};
  for (int round = 0; round <= arguments.rounds; ++round) {
    nlohmann::json turn = round_json(tracers, arguments.passes);
    if (round > 0) out["rounds"].push_back(std::move(turn));
  }
  return out;
}

}  // namespace
}  // namespace vernier

int main(int argc, char** argv) {
  constexpr int kNumbers = 16;
  if (argc != 5 + kNumbers) {
    std::fprintf(stderr, "ray_rates: takes a mesh, 3 settings and %d numbers of camera and light\n", kNumbers);
    return 2;
  }
  float n[kNumbers];
  for (int i = 0; i < kNumbers; ++i) n[i] = std::strtof(argv[5 + i], nullptr);
  const vernier::RayView view{{n[0], n[1], n[2]},   {n[3], n[4], n[5]},    {n[6], n[7], n[8]},
                              {n[9], n[10], n[11]}, {n[12], n[13], n[14]}, n[15]};
  try {
    const vernier::Arguments arguments{argv[1], std::atoi(argv[2]), std::atoi(argv[3]),
                                       static_cast<unsigned>(std::atoi(argv[4])), view};
    std::printf("%s\n", vernier::measure(arguments).dump().c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ray_rates: %s\n", error.what());
    return 1;
  }
  return 0;
}
