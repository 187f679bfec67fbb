#include "verify/build_cases.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "error.h"
#include "scene/validate_scene.h"
#include "verify/image_scenes.h"
#include "verify/ray_suite.h"

namespace vernier {
namespace {

/// A scene of `mesh` alone.
Scene scene_with(const VerifyMesh& mesh, const glm::dmat4& world_from_object) {
  Scene scene;
  add_object(scene, mesh, Material{}, world_from_object);
  return scene;
}

/// Answers of two scenes to the same rays must have the same bits, but for what counts the work.
void book_same(const RayQuery& query, RayAnswer a, RayAnswer b, Tally& tally) {
  a.nodes = b.nodes = a.tested = b.tested = 0;
  const bool same = a.finished == 1 && std::memcmp(&a, &b, sizeof(a)) == 0;
  tally.book(same, [&] { return ray_inputs(query); });
}

/// Traces `count` rays made by `make` through both scenes and books whether the answers are the same.
void compare_scenes(const CaseSetup& setup, const char* name, RayKernel& kernel, const RayScene& scene,
                    const RayScene& other, std::uint64_t first_sample, std::uint64_t count, const MakeRay& make,
                    Tally& tally) {
  std::vector<RayQuery> queries(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    SampleRandom random(setup.seed, name, first_sample + i);
    queries[i] = make(random, 0);
  }
  const std::vector<RayAnswer> answers = kernel.trace(scene, queries), expected = kernel.trace(other, queries);
  for (std::size_t i = 0; i < queries.size(); ++i) book_same(queries[i], answers[i], expected[i], tally);
}

/// The mesh with its vertices at -x and its triangles wound the other way round.
VerifyMesh mirrored(VerifyMesh mesh) {
  for (glm::vec3& p : mesh.positions) p.x = -p.x;
  for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
  return mesh;
}

}  // namespace

CaseResult run_scale(const CaseSetup& setup) {
  constexpr const char* kName = "scale";
  constexpr int kLowest = -70, kHighest = 66;
  constexpr std::uint64_t kRaysPerScale = 128;
  SampleRandom numbers = mesh_random(setup, kName, 0);
  const Target target{sphere_mesh(16, 16, 0.6, 0.9, numbers), glm::dvec3(0.0), 0.3};
  const RayScene unscaled(*setup.device, pack_scene(scene_with(target.mesh, glm::dmat4(1.0)), 0), setup.traversal);
  RayKernel kernel(setup, VERIFY_RESPAWN);
  Tally tally;
  for (std::uint64_t first = 0; setup.wants(first); first += kRaysPerScale) {
    const int exponent = kLowest + static_cast<int>(first / kRaysPerScale % (kHighest - kLowest + 1));
    const double scale = std::ldexp(1.0, exponent);
    PackedScene packed = pack_scene(scene_with(target.mesh, scaling(glm::dvec3(scale))), 0);
    // What the traced space hides from the rays has to come back exactly.
    const bool exact = packed.space.metres_per_unit == scale;
    const RayScene scaled(*setup.device, std::move(packed), setup.traversal);
    compare_scenes(
        setup, kName, kernel, scaled, unscaled, first, std::min(kRaysPerScale, setup.sample_count - first),
        [&](SampleRandom& random, std::uint32_t) { return aimed_ray(random, target, mixed_aim(random)); }, tally);
    if (!exact) tally.book(false, [&] { return "metres_per_unit at 2^" + std::to_string(exponent); });
  }
  return tally.result();
}

namespace {

constexpr std::uint32_t kGarbageVertices = 300, kGarbageTriangles = 200;

/// Any bits as positions, but below 2 in most places where `mostly_small`; now and then any bits as an index.
VerifyMesh garbage_mesh(SampleRandom& numbers, bool mostly_small) {
  VerifyMesh mesh;
  for (std::uint32_t i = 0; i < 3 * kGarbageVertices; ++i) {
    if (i % 3 == 0) mesh.positions.emplace_back();
    const bool small = mostly_small && numbers.below(64) != 0;
    const std::uint32_t bits = static_cast<std::uint32_t>(numbers.bits() >> 32) & (small ? 0xbfffffffu : 0xffffffffu);
    mesh.positions.back()[static_cast<int>(i % 3)] = std::bit_cast<float>(bits);
  }
  for (std::uint32_t i = 0; i < kGarbageTriangles; ++i) {
    glm::uvec3 t(numbers.below(kGarbageVertices), numbers.below(kGarbageVertices), numbers.below(kGarbageVertices));
    if (numbers.below(32) == 0) t.y = static_cast<std::uint32_t>(numbers.bits() >> 32);
    mesh.triangles.push_back(t);
  }
  return mesh;
}

/// Any rays through `garbage`, from sample `first` on, must end with a triangle of it or none.
void trace_garbage(const CaseSetup& setup, const char* name, RayKernel& kernel, const RayScene& garbage,
                   std::uint64_t first, std::uint64_t count, Tally& tally) {
  std::vector<RayQuery> queries(count);
  for (std::uint64_t i = 0; i < queries.size(); ++i) {
    SampleRandom random(setup.seed, name, first + i);
    queries[i] = ray_query(glm::vec3(random.direction()), glm::vec3(random.direction()));
    queries[i].outgoing = glm::vec3(random.direction());
  }
  const std::vector<RayAnswer> answers = kernel.trace(garbage, queries);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const RayAnswer& a = answers[i];
    const bool sound = a.finished == 1 && (a.triangle == NONE || a.triangle < kGarbageTriangles) && std::isfinite(a.t);
    tally.book(sound, [&] { return ray_inputs(queries[i]); });
  }
}

}  // namespace

CaseResult run_garbage_mesh(const CaseSetup& setup) {
  constexpr const char* kName = "garbage_mesh";
  constexpr std::uint64_t kRaysPerMesh = 512;
  const std::uint64_t count = std::min<std::uint64_t>(setup.sample_count, 1u << 14);  // 32 scenes
  RayKernel kernel(setup, VERIFY_RESPAWN);
  Tally tally;
  std::uint64_t refused = 0;
  for (std::uint64_t first = 0; first < count; first += kRaysPerMesh) {
    SampleRandom numbers = mesh_random(setup, kName, static_cast<std::uint32_t>(first / kRaysPerMesh));
    // Three of four meshes are mostly small, or all would be refused for their size.
    Scene scene = scene_with(garbage_mesh(numbers, first / kRaysPerMesh % 4 != 0), glm::dmat4(1.0));
    const std::uint64_t rays = std::min(kRaysPerMesh, count - first);
    try {
      validate_scene(scene);
    } catch (const Error&) {
      // Refused with a message, as it may be.
      refused += rays;
      for (std::uint64_t i = 0; i < rays; ++i) tally.book(true, [] { return std::string(); });
      continue;
    }
    const RayScene garbage(*setup.device, pack_scene(scene, 0), setup.traversal);
    trace_garbage(setup, kName, kernel, garbage, first, rays, tally);
  }
  // With fewer than two meshes there is nothing but a refused one.
  const CaseResult result = tally.result();
  return count < 2 * kRaysPerMesh ? result : if_judged(result, result.samples - refused);
}

CaseResult run_identical_centroids(const CaseSetup& setup) {
  constexpr const char* kName = "identical_centroids";
  constexpr std::uint32_t kTriangles = 1000;
  std::vector<VerifyMesh> meshes(2);
  for (std::uint32_t i = 0; i < kTriangles; ++i) {
    for (const bool same_size : {false, true}) {
      const double size = same_size ? 1.0 : (i + 1.0) / kTriangles, turn = same_size ? 0.0 : 0.01 * i;
      VerifyMesh& mesh = meshes[same_size ? 1 : 0];
      for (const double angle : {0.0, 2.0943951, 4.1887902}) {
        mesh.positions.push_back(glm::vec3(size * std::cos(angle + turn), size * std::sin(angle + turn), 0.0));
      }
      mesh.triangles.push_back(glm::uvec3(0, 1, 2) + 3 * i);
    }
  }
  CaseSetup few = setup;
  few.sample_count = std::min<std::uint64_t>(setup.sample_count, 1u << 12);  // each goes through a thousand triangles
  CaseResult result = against_every_triangle(few, kName, meshes, [](SampleRandom& random, std::uint32_t) {
    const glm::vec3 aim(random.in(-0.5, 0.5), random.in(-0.5, 0.5), 0.0);
    const glm::vec3 origin(random.in(-1, 1), random.in(-1, 1), random.in(0.1, 1.0));
    return ray_query(origin, aim - origin);
  });
  for (const VerifyMesh& mesh : meshes) {
    // 48 + ceil(log2 n), as build_bvh promises.
    const double allowed = 48 + std::ceil(std::log2(kTriangles));
    const std::uint32_t depth = RayScene(*setup.device, triangles_of(mesh)).bvh().depth;
    if (depth <= allowed) continue;
    ++result.failures;
    result.worst_inputs = "depth " + std::to_string(depth);
  }
  return result;
}

CaseResult run_deep_tree(const CaseSetup& setup) {
  constexpr const char* kName = "deep_tree";
  VerifyMesh mesh;
  for (int i = 0; i <= 120; ++i) {
    const double x = std::ldexp(1.0, -i);
    append(mesh, placed(grid_mesh(1, 0, 0.0f), 0.5 * x, {0.75 * x, 0.0, 0.0}));
    append(mesh, placed({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0u, 1u, 2u}}}, x, {0.0, 0.1 * x, 0.3 * x}));
  }
  for (int i = 0; i < 64; ++i) {  // sticks across everything
    const float at = static_cast<float>(i) / 64.0f;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{-1.0f, at, -1.0f}, {1.0f, at, 1.0f}, {1.0f, at + 0x1p-12f, 1.0f}});
    mesh.triangles.push_back(glm::uvec3(0, 1, 2) + first);
  }
  return against_every_triangle(setup, kName, {mesh}, [&](SampleRandom& random, std::uint32_t) {
    // Along the series, across it, and anywhere.
    const glm::vec3 aim(std::exp2(random.in(-40.0, 0.0)), 0.0, 0.0);
    const glm::vec3 origin = random.below(3) == 0 ? glm::vec3(2.0f, random.in(-1e-3, 1e-3), random.in(-1e-3, 1e-3))
                                                  : glm::vec3(random.direction());
    return random.below(3) == 0 ? aimed_ray(random, {mesh, glm::dvec3(0.0), 1.0}, mixed_aim(random))
                                : ray_query(origin, aim - origin);
  });
}

CaseResult run_build_order(const CaseSetup& setup) {
  constexpr const char* kName = "build_order";
  SampleRandom numbers = mesh_random(setup, kName, 0);
  Target target{sphere_mesh(16, 16, 0.5, 1.0, numbers), glm::dvec3(0.0), 0.4};
  append(target.mesh, target.mesh);  // every hit is a tie
  std::vector<BvhTriangle> triangles = triangles_of(target.mesh);
  const RayScene in_order(*setup.device, triangles, setup.traversal);
  RayKernel kernel(setup, VERIFY_RESPAWN);
  Tally tally;
  for (std::uint64_t first = 0; setup.wants(first); first += kSamplesPerTarget) {
    SampleRandom shuffle = mesh_random(setup, kName, 1 + static_cast<std::uint32_t>(first / kSamplesPerTarget));
    for (std::size_t i = triangles.size(); i > 1; --i) {
      std::swap(triangles[i - 1], triangles[shuffle.below(static_cast<std::uint32_t>(i))]);
    }
    const RayScene shuffled(*setup.device, triangles, setup.traversal);
    compare_scenes(
        setup, kName, kernel, shuffled, in_order, first, std::min(kSamplesPerTarget, setup.sample_count - first),
        [&](SampleRandom& random, std::uint32_t) { return aimed_ray(random, target, mixed_aim(random)); }, tally);
  }
  return tally.result();
}

CaseResult run_mirror(const CaseSetup& setup) {
  constexpr const char* kName = "mirror";
  SampleRandom numbers = mesh_random(setup, kName, 0);
  const VerifyMesh mesh = sphere_mesh(16, 16, 0.6, 0.9, numbers);
  const Target target{mirrored(mesh), glm::dvec3(0.0), 0.3};
  const RayScene by_transform(*setup.device, pack_scene(scene_with(mesh, scaling({-1.0, 1.0, 1.0})), 0),
                              setup.traversal);
  const RayScene by_mesh(*setup.device, pack_scene(scene_with(target.mesh, glm::dmat4(1.0)), 0), setup.traversal);
  RayKernel kernel(setup, VERIFY_RESPAWN);
  Tally tally;
  compare_scenes(
      setup, kName, kernel, by_transform, by_mesh, 0, setup.sample_count,
      [&](SampleRandom& random, std::uint32_t) {
        RayQuery query = aimed_ray(random, target, mixed_aim(random));
        query.outgoing = glm::vec3(random.direction());
        return query;
      },
      tally);
  return tally.result();
}

}  // namespace vernier
