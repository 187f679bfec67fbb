#include "scene/polygon_triangles.h"

#include <algorithm>
#include <cmath>

namespace vernier {
namespace {

// A polygon that needs more point tests than this per corner is not simple or is made to stall: the rest is cut
// unchecked.
constexpr std::size_t kTestsPerCorner = 8192;
// And never more than this, a second or a few.
constexpr std::size_t kMostTests = std::size_t{1} << 28;

// Normal of a polygon whose length is twice its area (Newell's method), about the first corner to keep far ones exact.
glm::dvec3 newell_normal(std::span<const glm::dvec3> corners) {
  glm::dvec3 normal(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return normal;
}

// The polygon seen along the largest component of its normal, counter-clockwise.
std::vector<glm::dvec2> project(std::span<const glm::dvec3> corners) {
  const glm::dvec3 normal = newell_normal(corners);
  const glm::dvec3 size = glm::abs(normal);
  const int drop = size.x > size.y && size.x > size.z ? 0 : (size.y > size.z ? 1 : 2);
  const int u = (drop + 1) % 3;
  const int v = (drop + 2) % 3;
  const double sign = normal[drop] < 0.0 ? -1.0 : 1.0;
  std::vector<glm::dvec2> flat;
  flat.reserve(corners.size());
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 local = corner - corners[0];
    flat.emplace_back(sign * local[u], local[v]);
  }
  return flat;
}

// Twice the signed area: positive for a left turn.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class EarClipper {
 public:
  explicit EarClipper(std::span<const glm::dvec3> corners)
      : flat_(project(corners)),
        previous_(flat_.size()),
        next_(flat_.size()),
        bends_in_(flat_.size()),
        remaining_(flat_.size()) {
    const auto count = static_cast<std::uint32_t>(flat_.size());
    for (std::uint32_t i = 0; i < count; ++i) {
      previous_[i] = (i + count - 1) % count;
      next_[i] = (i + 1) % count;
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      bends_in_[i] = may_bend_in(i);
      if (bends_in_[i]) reflex_.push_back(i);
      if (is_spike(i)) spikes_.push_back(i);
    }
    reflex_count_ = reflex_.size();
    // A bend that is no number is neither an ear nor none.
    if (!std::ranges::all_of(flat_, [](const glm::dvec2& p) { return std::isfinite(p.x + p.y); })) budget_ = 0;
  }

  bool convex() const { return reflex_.empty(); }

  void clip(std::vector<PolygonTriangle>& triangles) {
    std::uint32_t corner = 0;
    std::size_t refused = 0;
    while (remaining_ >= 3) {
      if (!spikes_.empty()) {
        const std::uint32_t spike = spikes_.back();
        spikes_.pop_back();
        // One may have been cut off, or filled, since it was met.
        if (!is_there(spike) || !is_spike(spike)) continue;
        corner = cut(spike, triangles);
        refused = 0;
        continue;
      }
      // A round without an ear: straight corners may go too. Another one: the polygon is not simple, cut anywhere.
      const bool give_up = refused >= 2 * remaining_ || budget_ == 0;
      if (!give_up && !is_ear(corner, refused >= remaining_)) {
        corner = next_[corner];
        ++refused;
        continue;
      }
      corner = cut(corner, triangles);
      refused = 0;
    }
  }

 private:
  double corner_turn(std::uint32_t i) const { return turn(flat_[previous_[i]], flat_[i], flat_[next_[i]]); }

  // Out and back again, or the same place twice: without area, and cut off before it is taken for a side of something.
  bool is_spike(std::uint32_t i) const {
    const glm::dvec2 before = flat_[previous_[i]] - flat_[i], after = flat_[next_[i]] - flat_[i];
    const bool stays = before == glm::dvec2(0.0) || after == glm::dvec2(0.0);
    return corner_turn(i) == 0.0 && (stays || glm::dot(before, after) > 0.0);
  }

  // A spike inwards bends in as far as can be.
  bool may_bend_in(std::uint32_t i) const { return corner_turn(i) < 0.0 || is_spike(i); }

  bool is_there(std::uint32_t i) const { return next_[previous_[i]] == i; }

  // Cuts the corner off and returns the one to look at next: two further on keeps triangles from becoming a fan of
  // slivers.
  std::uint32_t cut(std::uint32_t corner, std::vector<PolygonTriangle>& triangles) {
    triangles.push_back({previous_[corner], corner, next_[corner]});
    return next_[remove(corner)];
  }

  bool is_ear(std::uint32_t corner, bool straight_allowed) {
    const double bend = corner_turn(corner);
    const glm::dvec2 a = flat_[previous_[corner]];
    const glm::dvec2 b = flat_[corner];
    const glm::dvec2 c = flat_[next_[corner]];
    if (!(bend > 0.0 || (straight_allowed && bend == 0.0))) {
      budget_ -= std::min<std::size_t>(budget_, 1);
      return false;
    }
    budget_ -= std::min(budget_, reflex_.size());
    // Where any corner lies inside, a reflex one does.
    for (const std::uint32_t i : reflex_) {
      const glm::dvec2 p = flat_[i];
      if (!bends_in_[i]) continue;
      // Corners themselves do not lie inside, but from a twin, where the outline touches itself, it may go on inside.
      if (p == a || p == b || p == c) {
        if (bend > 0.0 && i != previous_[corner] && i != corner && i != next_[corner] && enters(i, a, b, c))
          return false;
        continue;
      }
      if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
    }
    return true;
  }

  // Whether an edge at `i`, which lies on a corner of the triangle, leads into it.
  bool enters(std::uint32_t i, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) const {
    const glm::dvec2 p = flat_[i];
    const glm::dvec2 right = p == a ? b : p == b ? c : a;
    const glm::dvec2 left = p == a ? c : p == b ? a : b;
    const auto leads_in = [&](const glm::dvec2& q) { return turn(p, right, q) > 0.0 && turn(p, q, left) > 0.0; };
    return leads_in(flat_[previous_[i]]) || leads_in(flat_[next_[i]]);
  }

  // Takes the corner out and returns its successor.
  std::uint32_t remove(std::uint32_t corner) {
    const std::uint32_t after = next_[corner];
    next_[previous_[corner]] = after;
    previous_[after] = previous_[corner];
    --remaining_;
    forget_reflex(corner);
    // The angles beside the cut get smaller and may bend in no longer.
    for (const std::uint32_t beside : {previous_[corner], after}) {
      if (!may_bend_in(beside)) forget_reflex(beside);
      if (is_spike(beside)) spikes_.push_back(beside);
    }
    return after;
  }

  void forget_reflex(std::uint32_t corner) {
    if (!bends_in_[corner]) return;
    bends_in_[corner] = false;
    --reflex_count_;
    if (reflex_.size() > 2 * reflex_count_) std::erase_if(reflex_, [&](std::uint32_t i) { return !bends_in_[i]; });
  }

  std::vector<glm::dvec2> flat_;
  std::vector<std::uint32_t> previous_;
  std::vector<std::uint32_t> next_;
  std::vector<bool> bends_in_;
  std::vector<std::uint32_t> reflex_;  // holds all that bend in, and some that no longer do
  std::size_t reflex_count_ = 0;
  std::vector<std::uint32_t> spikes_;  // to be cut off, or to be looked at again
  std::size_t remaining_;
  std::size_t budget_ = std::min(kTestsPerCorner * flat_.size(), kMostTests);
};

bool cut_from_first_corner(std::span<const glm::dvec3> quad) {
  const glm::dvec3 normal = newell_normal(quad);
  const auto bends_in = [&](std::size_t i) {
    const glm::dvec3 before = quad[i] - quad[(i + 3) % 4];
    const glm::dvec3 after = quad[(i + 1) % 4] - quad[i];
    return glm::dot(glm::cross(before, after), normal) < 0.0;
  };
  if (bends_in(0) || bends_in(2)) return true;
  if (bends_in(1) || bends_in(3)) return false;
  const glm::dvec3 first = quad[2] - quad[0];
  const glm::dvec3 second = quad[3] - quad[1];
  return !(glm::dot(second, second) < glm::dot(first, first));
}

}  // namespace

void append_polygon_triangles(std::span<const glm::dvec3> corners, std::vector<PolygonTriangle>& triangles) {
  if (corners.size() < 3) return;
  if (corners.size() == 4) {
    const bool from_first = cut_from_first_corner(corners);
    triangles.push_back(from_first ? PolygonTriangle{0, 1, 2} : PolygonTriangle{0, 1, 3});
    triangles.push_back(from_first ? PolygonTriangle{0, 2, 3} : PolygonTriangle{1, 2, 3});
    return;
  }
  if (corners.size() > 4) {
    EarClipper clipper(corners);
    if (!clipper.convex()) {
      clipper.clip(triangles);
      return;
    }
  }
  for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) triangles.push_back({0, i, i + 1});
}

}  // namespace vernier
