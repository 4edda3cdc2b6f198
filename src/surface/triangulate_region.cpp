#include "surface/triangulate_region.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

double turn(Vec2 a, Vec2 b, Vec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The loop in the sense in which its area is positive, in the plane itself or in its mirror image.
class Plane {
 public:
  Plane(std::span<const Vec2> points, bool mirrored) : points_(points), mirrored_(mirrored) {}
  [[nodiscard]] Vec2 operator[](std::uint32_t i) const {
    return mirrored_ ? Vec2{points_[i].x, -points_[i].y} : points_[i];
  }

 private:
  std::span<const Vec2> points_;
  bool mirrored_;
};

bool same(Vec2 a, Vec2 b) {
  return a.x == b.x && a.y == b.y;
}

/// In the closed triangle (counter-clockwise), but not at one of its corners.
bool blocks(Vec2 p, Vec2 a, Vec2 b, Vec2 c) {
  if (same(p, a) || same(p, b) || same(p, c)) return false;
  return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
}

/// Place in `loop` of the vertex that a bridge from `from` can lead to: the ray to the right meets an edge,
/// and of the reflex vertices between it and that edge's farther end the one at the least angle is seen.
std::size_t bridge_to(const Loop& loop, const Plane& plane, Vec2 from) {
  double nearest = std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::size_t next = (i + 1) % loop.size();
    const Vec2 a = plane[loop[i]];
    const Vec2 b = plane[loop[next]];
    // Upward edges have the inside of the region to their left.
    if (!(a.y <= from.y && from.y <= b.y && a.y < b.y)) continue;
    const double x = a.x + (from.y - a.y) / (b.y - a.y) * (b.x - a.x);
    if (x >= from.x && x < nearest) {
      nearest = x;
      best = a.x > b.x ? i : next;
    }
  }
  if (nearest == std::numeric_limits<double>::infinity()) return 0;  // the hole is not inside
  const Vec2 hit{nearest, from.y};
  const Vec2 end = plane[loop[best]];
  const Vec2 low = end.y < from.y ? end : hit;
  const Vec2 high = end.y < from.y ? hit : end;
  double least_tangent = std::numeric_limits<double>::infinity();
  double least_distance = std::numeric_limits<double>::infinity();
  std::size_t seen = best;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 p = plane[loop[i]];
    const bool inside = turn(from, low, p) >= 0.0 && turn(low, high, p) >= 0.0 && turn(high, from, p) >= 0.0;
    if (!(p.x > from.x) || (!inside && i != best)) continue;
    // Only a vertex whose own corner of the region opens towards `from` is seen from there: vertices that
    // earlier bridges doubled stand at one place with different corners.
    const Vec2 before = plane[loop[(i + loop.size() - 1) % loop.size()]];
    const Vec2 after = plane[loop[(i + 1) % loop.size()]];
    const bool convex = turn(before, p, after) >= 0.0;
    const bool left_of_in = turn(before, p, from) >= 0.0;
    const bool left_of_out = turn(p, after, from) >= 0.0;
    if (convex ? !(left_of_in && left_of_out) : !(left_of_in || left_of_out)) continue;
    const double tangent = std::abs(p.y - from.y) / (p.x - from.x);
    const double distance = p.x - from.x;
    if (tangent < least_tangent || (tangent == least_tangent && distance < least_distance)) {
      least_tangent = tangent;
      least_distance = distance;
      seen = i;
    }
  }
  return seen;
}

Loop with_bridge(const Loop& loop, std::size_t at, const Loop& hole, std::size_t from) {
  Loop joined(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(at) + 1);
  for (std::size_t i = 0; i <= hole.size(); ++i) joined.push_back(hole[(from + i) % hole.size()]);
  joined.insert(joined.end(), loop.begin() + static_cast<std::ptrdiff_t>(at), loop.end());
  return joined;
}

std::size_t rightmost(const Loop& loop, const Plane& plane) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    if (plane[loop[i]].x > plane[loop[best]].x) best = i;
  }
  return best;
}

/// Cuts ears off a loop, linked both ways.
class EarClipping {
 public:
  EarClipping(const Loop& loop, const Plane& plane) : loop_(loop), plane_(plane) {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
      next_.push_back((i + 1) % n);
      previous_.push_back((i + n - 1) % n);
    }
  }

  std::vector<std::array<std::uint32_t, 3>> run() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::size_t at = 0;
    std::size_t looked = 0;
    for (std::size_t left = loop_.size(); left >= 3;) {
      // After a whole round without an ear the loop is no simple one: any vertex goes.
      if (looked < left && !is_ear(at)) {
        at = next_[at];
        ++looked;
        continue;
      }
      triangles.push_back({loop_[previous_[at]], loop_[at], loop_[next_[at]]});
      next_[previous_[at]] = next_[at];
      previous_[next_[at]] = previous_[at];
      // Two on: ears off the same vertex again and again would make a fan.
      at = next_[next_[at]];
      looked = 0;
      --left;
    }
    return triangles;
  }

 private:
  [[nodiscard]] bool is_ear(std::size_t at) const {
    const Vec2 a = plane_[loop_[previous_[at]]];
    const Vec2 b = plane_[loop_[at]];
    const Vec2 c = plane_[loop_[next_[at]]];
    if (!(turn(a, b, c) > 0.0)) return false;
    for (std::size_t i = next_[next_[at]]; i != previous_[at]; i = next_[i]) {
      if (blocks(plane_[loop_[i]], a, b, c)) return false;
    }
    return true;
  }

  const Loop& loop_;
  const Plane& plane_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> previous_;
};

}  // namespace

double twice_area(const Loop& loop, std::span<const Vec2> points) {
  double sum = 0.0;
  const Vec2 origin = points[loop.front()];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    sum += turn(origin, points[loop[i]], points[loop[(i + 1) % loop.size()]]);
  }
  return sum;
}

bool is_inside(const Loop& loop, std::span<const Vec2> points, Vec2 p) {
  int winding = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 a = points[loop[i]];
    const Vec2 b = points[loop[(i + 1) % loop.size()]];
    if (a.y <= p.y && b.y > p.y && turn(a, b, p) > 0.0) ++winding;
    if (a.y > p.y && b.y <= p.y && turn(a, b, p) < 0.0) --winding;
  }
  return winding != 0;
}

std::vector<std::array<std::uint32_t, 3>> triangulate_region(const Loop& outer, std::vector<Loop> holes,
                                                             std::span<const Vec2> points) {
  const Plane plane(points, twice_area(outer, points) < 0.0);
  // From right to left: the bridge of a hole may end on one to its right.
  std::sort(holes.begin(), holes.end(), [&](const Loop& a, const Loop& b) {
    return plane[a[rightmost(a, plane)]].x > plane[b[rightmost(b, plane)]].x;
  });
  Loop loop = outer;
  for (const Loop& hole : holes) {
    const std::size_t from = rightmost(hole, plane);
    loop = with_bridge(loop, bridge_to(loop, plane, plane[hole[from]]), hole, from);
  }
  return EarClipping(loop, plane).run();
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
