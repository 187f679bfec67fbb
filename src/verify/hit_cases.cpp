#include "verify/hit_cases.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "verify/ray_suite.h"
#include "verify/wide_oracle.h"

namespace vernier {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// For errors of t: at the exact level in ulp, at most 1 (worked out wider, then rounded); else in ulp times the cosine
/// to the normal, by which the plane's distance is known worse, at most 16.
Tally tally_of_t(const CaseSetup& setup) {
  if (setup.level == Accuracy::exact) return Tally("ulp", 1.0);
  return Tally("ulp/condition", setup.level == Accuracy::robust ? 16.0 : kNoBound);
}

/// Error of the answer's t for tally_of_t.
double error_of_t(const CaseSetup& setup, const RayAnswer& answer, const WideCrossing& crossing) {
  const double ulps = ulps_from(answer.t, crossing.t);
  // Wide arithmetic keeps 2^-44 of a plane's distance: from 2^-18 on the angle takes more than rounding to float does.
  constexpr double kGrazing = 0x1p-18;
  return setup.level == Accuracy::exact ? ulps * std::min(1.0, crossing.cosine / kGrazing) : ulps * crossing.cosine;
}

float in_range(SampleRandom& random, double lo, double hi) {
  return static_cast<float>(random.in(lo, hi));
}

/// How far a weight may be off in float32: corners come into the ray's frame with up to 16 roundings of 2^-24 of their
/// distance, at both ends of an edge, and weights are counted in the triangle's height as the ray sees it. At the exact
/// level too: it decides exactly, for corners that are rounded into that frame.
double weight_band(const RayQuery& query, const BvhTriangle& triangle, const WideCrossing& crossing) {
  const glm::dvec3 origin = query.origin, v0 = triangle.v0, v1 = triangle.v1, v2 = triangle.v2;
  const double distance = std::max({glm::length(v0 - origin), glm::length(v1 - origin), glm::length(v2 - origin)});
  const double longest = std::max({glm::length(v1 - v0), glm::length(v2 - v1), glm::length(v0 - v2)});
  const double seen_area = glm::length(glm::cross(v1 - v0, v2 - v0)) * crossing.cosine;
  return 2.0 * 16.0 * 0x1p-24 * distance * longest / seen_area;
}

/// The nearest crossing with t > 0 among `triangles`, its number in `nearest`; `clear` unless a weight of some crossing
/// lies within its band.
WideCrossing nearest_crossing(const RayQuery& query, const std::vector<BvhTriangle>& triangles, std::uint32_t& nearest,
                              bool& clear) {
  WideCrossing best;
  best.t = kNoBound;
  nearest = NONE;
  clear = true;
  for (const BvhTriangle& triangle : triangles) {
    const WideCrossing crossing = wide_crossing(query, triangle);
    if (!(crossing.t > 0.0)) continue;
    clear = clear && std::abs(crossing.nearest_edge) > weight_band(query, triangle, crossing);
    if (crossing.inside && crossing.t < best.t) {
      best = crossing;
      nearest = triangle.id;
    }
  }
  return best;
}

}  // namespace

CaseResult run_mixed_scales(const CaseSetup& setup) {
  constexpr const char* kName = "mixed_scales";
  // In the traced space the ground is 1 and the triangles 2^-40, as 1e6 and 1e-6 metres come to lie.
  constexpr double kSize = 0x1p-40, kReach = 0x1p-20;
  SampleRandom numbers = mesh_random(setup, kName, 0);
  VerifyMesh mesh;
  for (int i = 0; i < 32; ++i) {
    const VerifyMesh one = triangle_soup(1, 0.5, numbers);
    append(mesh, placed(one, kSize, {numbers.in(-kReach, kReach), 4 * kSize, numbers.in(-kReach, kReach)}));
  }
  // Moved aside, so that the ground's diagonal is far from the triangles.
  append(mesh, placed(grid_mesh(1, 1, 0.0f), 0.75, {0.25, 0.0, 0.0}));
  const std::vector<BvhTriangle> triangles = triangles_of(mesh);
  Tally tally = tally_of_t(setup);
  std::uint64_t judged = 0;
  CaseSetup few = setup;
  few.sample_count = std::min<std::uint64_t>(setup.sample_count, 1u << 13);  // the oracle tests every triangle
  trace_samples(
      few, kName, VERIFY_RESPAWN, scenes_of(setup, std::vector{mesh}), tally,
      [&](SampleRandom& random, std::uint32_t) {
        const BvhTriangle& triangle = triangles[random.below(32)];
        const double b = random.in(0.2, 0.4), c = random.in(0.2, 0.4);
        const glm::dvec3 v0 = triangle.v0;
        const glm::dvec3 place = v0 + (glm::dvec3(triangle.v1) - v0) * b + (glm::dvec3(triangle.v2) - v0) * c;
        const glm::dvec3 up = random.direction();
        const glm::vec3 origin(place +
                               glm::dvec3(up.x, std::abs(up.y) + 0.1, up.z) * random.power_of_ten(-5.0, -1.0) * kReach);
        return ray_query(origin, glm::vec3(place - glm::dvec3(origin)));
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        std::uint32_t nearest = NONE;
        bool clear = false;
        const WideCrossing crossing = nearest_crossing(query, triangles, nearest, clear);
        const auto inputs = [&] {
          return ray_inputs(query) + " hit=" + std::to_string(answer.triangle) + " expected=" + std::to_string(nearest);
        };
        judged += clear ? 1 : 0;
        if (!clear || answer.triangle != nearest) {
          tally.book(!clear, inputs);
        } else {
          tally.book_error(error_of_t(setup, answer, crossing), inputs);
        }
      });
  return if_judged(tally.result(), judged);
}

CaseResult run_degenerate(const CaseSetup& setup) {
  constexpr const char* kName = "degenerate";
  constexpr std::uint32_t kSound = 64, kFlat = 64;
  SampleRandom numbers = mesh_random(setup, kName, 0);
  VerifyMesh mesh = triangle_soup(kSound, 0.3, numbers);
  for (std::uint32_t i = 0; i < kFlat; ++i) {
    // Small whole numbers over 64: a + s d lies exactly on the line.
    const auto grid = [&] { return glm::vec3(numbers.below(33), numbers.below(33), numbers.below(33)) / 64.0f; };
    const glm::vec3 a = grid(), d = grid() - 0.25f;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, a + d * 0.5f, a + d});
    const glm::uvec3 kinds[] = {{0, 1, 2}, {0, 2, 1}, {0, 0, 1}, {2, 2, 2}};
    mesh.triangles.push_back(kinds[i % 4] + first);
  }
  Tally tally;
  trace_samples(
      setup, kName, VERIFY_CLOSEST, scenes_of(setup, std::vector{mesh}), tally,
      [&](SampleRandom& random, std::uint32_t) {
        const glm::uvec3& t = mesh.triangles[kSound + random.below(kFlat)];
        const glm::vec3 aim = glm::mix(mesh.positions[t.x], mesh.positions[t.y], in_range(random, 0.0, 1.0));
        const glm::vec3 origin(random.direction());
        return ray_query(origin, aim - origin);
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        const bool sound = answer.triangle == NONE || (answer.triangle < kSound && std::isfinite(answer.t));
        tally.book(sound, [&] { return ray_inputs(query); });
      });
  return tally.result();
}

CaseResult run_near_degenerate(const CaseSetup& setup) {
  constexpr const char* kName = "near_degenerate";
  VerifyMesh mesh;
  SampleRandom numbers = mesh_random(setup, kName, 0);
  for (int k = 2; k <= 60; ++k) {
    // Height 2^-k over an edge of 1; below 2^-22 such a height exists near 0 alone.
    const double height = std::ldexp(1.0, -k);
    const glm::dvec3 along = k <= 22 ? numbers.direction() * 0.5 : glm::dvec3(0.5, 0.0, numbers.in(-0.5, 0.5));
    const glm::dvec3 up = k <= 22 ? glm::normalize(glm::cross(along, numbers.direction())) : glm::dvec3(0.0, 1.0, 0.0);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::dvec3& corner : {-along, along, along * numbers.in(-0.5, 0.5) + up * height}) {
      mesh.positions.push_back(glm::vec3(corner));
    }
    mesh.triangles.push_back(glm::uvec3(0, 1, 2) + first);
  }
  const std::vector<BvhTriangle> triangles = triangles_of(mesh);
  // Each edge is rounded once, each product and difference of the cross product too: 2^-24 |e1| |e2| / |e1 x e2| each,
  // and four of them for each of the three components make less than 8 as a length.
  Tally tally("edge roundings", setup.level == Accuracy::fast ? kNoBound : 8.0);
  std::uint64_t judged = 0;
  trace_samples(
      setup, kName, VERIFY_RESPAWN, scenes_of(setup, std::vector{mesh}), tally,
      [&](SampleRandom& random, std::uint32_t) {
        const BvhTriangle& triangle = triangles[random.below(static_cast<std::uint32_t>(triangles.size()))];
        const glm::dvec3 v0 = triangle.v0, v1 = triangle.v1, v2 = triangle.v2;
        const glm::dvec3 place = v0 * 0.25 + v1 * 0.25 + v2 * 0.5;
        const glm::vec3 origin(place + wide_normal(triangle) * random.in(0.25, 1.0) + random.direction() * 0.1);
        return ray_query(origin, glm::vec3(place - glm::dvec3(origin)));
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        const auto inputs = [&] { return ray_inputs(query); };
        if (answer.triangle == NONE) return tally.book(true, inputs);
        const BvhTriangle& hit = triangles[answer.triangle];
        const glm::dvec3 normal = wide_normal(hit), e1 = glm::dvec3(hit.v1) - glm::dvec3(hit.v0),
                         e2 = glm::dvec3(hit.v2) - glm::dvec3(hit.v0);
        const double angle = glm::length(glm::cross(normal, glm::dvec3(answer.normal)));
        const double step = 0x1p-24 * glm::length(e1) * glm::length(e2) / glm::length(glm::cross(e1, e2));
        ++judged;
        tally.book_error(angle / step, inputs);
      });
  return if_judged(tally.result(), judged);
}

CaseResult run_coplanar_duplicates(const CaseSetup& setup) {
  constexpr const char* kName = "coplanar_duplicates";
  // Copies of 16 triangles each; every number of copies is a scene.
  std::vector<Target> targets;
  std::vector<std::vector<std::uint32_t>> lowest;
  for (const std::uint32_t copies : {2u, 16u, 100u}) {
    SampleRandom numbers = mesh_random(setup, kName, copies);
    const VerifyMesh one = triangle_soup(16, 0.3, numbers);
    VerifyMesh mesh;
    mesh.positions = one.positions;
    std::vector<std::uint32_t> first(16, NONE);
    for (std::uint32_t i = 0; i < 16 * copies; ++i) mesh.triangles.push_back(one.triangles[i % 16]);
    for (std::size_t i = mesh.triangles.size(); i > 1; --i) {
      std::swap(mesh.triangles[i - 1], mesh.triangles[numbers.below(static_cast<std::uint32_t>(i))]);
    }
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      std::uint32_t& number = first[mesh.triangles[i].x / 3];
      number = std::min(number, i);
    }
    targets.push_back({mesh, glm::dvec3(0.0), 1.0});
    lowest.push_back(first);
  }
  Tally tally;
  trace_samples(
      setup, kName, VERIFY_CLOSEST, scenes_of(setup, targets), tally,
      [&](SampleRandom& random, std::uint32_t target) {
        if (random.below(2) == 0) return grazing_ray(random, targets[target]);
        return aimed_ray(random, targets[target], mixed_aim(random));
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t target) {
        const bool first = answer.triangle == NONE ||
                           answer.triangle == lowest[target][targets[target].mesh.triangles[answer.triangle].x / 3];
        tally.book(first, [&] { return ray_inputs(query); });
      });
  return tally.result();
}

CaseResult run_grazing(const CaseSetup& setup) {
  constexpr const char* kName = "grazing";
  VerifyMesh mesh = grid_mesh(1, 2, 0.0f);
  const glm::dvec3 u(0.36, 0.48, -0.8), v(-0.8, 0.6, 0.0), n(0.48, 0.64, 0.6);
  for (glm::vec3& p : mesh.positions) p = glm::vec3((u * double{p.x} + v * double{p.y}) * 0.7);
  const std::vector<BvhTriangle> triangles = triangles_of(mesh);
  Tally tally = tally_of_t(setup);
  std::uint64_t judged = 0;
  trace_samples(
      setup, kName, VERIFY_RESPAWN, scenes_of(setup, std::vector{mesh}), tally,
      [&](SampleRandom& random, std::uint32_t) {
        const glm::dvec3 place = (u * random.in(-0.6, 0.6) + v * random.in(-0.6, 0.6)) * 0.7;
        const double elevation = std::ldexp(1.0, -1 - static_cast<int>(random.below(22)));
        const double turn = random.in(0.0, 6.28), distance = random.in(0.1, 1.0);
        const glm::dvec3 back = u * std::cos(turn) + v * std::sin(turn) + n * elevation;
        const glm::vec3 origin(place + back * distance);
        return ray_query(origin, glm::vec3(place - glm::dvec3(origin)));
      },
      [&](const RayQuery& query, const RayAnswer& answer, std::uint32_t) {
        const auto inputs = [&] { return ray_inputs(query); };
        // Rounded coordinates may let the flattest rays miss or meet the other triangle's edge.
        const WideCrossing crossing =
            answer.triangle == NONE ? WideCrossing{} : wide_crossing(query, triangles[answer.triangle]);
        if (!crossing.inside) return tally.book(true, inputs);
        ++judged;
        tally.book_error(error_of_t(setup, answer, crossing), inputs);
      });
  return if_judged(tally.result(), judged);
}

CaseResult run_t_limits(const CaseSetup& setup) {
  constexpr const char* kName = "t_limits";
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  SampleRandom numbers = mesh_random(setup, kName, 0);
  const Target target{triangle_soup(128, 0.4, numbers), glm::dvec3(0.0), 1.0};
  const RayScene scene(*setup.device, triangles_of(target.mesh), setup.traversal);
  RayKernel kernel(setup, VERIFY_CLOSEST);
  std::vector<RayQuery> open(setup.sample_count);
  for (std::uint64_t i = 0; i < open.size(); ++i) {
    SampleRandom random(setup.seed, kName, i);
    open[i] = aimed_ray(random, target, mixed_aim(random));
  }
  const std::vector<RayAnswer> hits = kernel.trace(scene, open);
  // The same rays within limits at the hit: up to it, up to a step before it, from a step before it, from it on, and
  // from it on but for lower numbers.
  enum Limit { up_to, before, from_before, behind, next_in_order, limit_count };
  std::vector<RayQuery> limited;
  for (std::size_t i = 0; i < open.size(); ++i) {
    std::vector<RayQuery> five(limit_count, open[i]);
    five[up_to].t_max = hits[i].t;
    five[before].t_max = std::nextafter(hits[i].t, 0.0f);
    five[from_before].t_min = std::nextafter(hits[i].t, 0.0f);
    five[behind].t_min = five[next_in_order].t_min = hits[i].t;
    five[next_in_order].after_triangle = hits[i].triangle;
    if (hits[i].triangle == NONE) five.assign(limit_count, open[i]);
    limited.insert(limited.end(), five.begin(), five.end());
  }
  const std::vector<RayAnswer> answers = kernel.trace(scene, limited);
  Tally tally;
  for (std::size_t i = 0; i < open.size(); ++i) {
    const RayAnswer* five = &answers[limit_count * i];
    const RayAnswer& hit = hits[i];
    const auto same = [&](const RayAnswer& a) { return a.triangle == hit.triangle && a.t == hit.t; };
    const RayAnswer& next = five[next_in_order];
    const bool in_order = next.triangle == NONE || next.t > hit.t || (next.t == hit.t && next.triangle > hit.triangle);
    const bool held = hit.triangle == NONE ||
                      (same(five[up_to]) && five[before].triangle == NONE && same(five[from_before]) &&
                       (five[behind].triangle == NONE || five[behind].t > hit.t) && in_order && hit.t < kInfinity);
    tally.book(held, [&] { return ray_inputs(open[i]); });
  }
  return tally.result();
}

}  // namespace vernier
