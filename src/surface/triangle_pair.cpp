#include "surface/triangle_pair.h"

#include <algorithm>
#include <cstddef>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// A plane in which points are looked at by two of their coordinates.
struct View {
  std::size_t x;
  std::size_t y;

  [[nodiscard]] int turn(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) const noexcept {
    return orientation(a, b, c, x, y);
  }
  /// p, in line with a and b, lies between them.
  [[nodiscard]] bool is_between(const SpacePoint& a, const SpacePoint& b,
                                const SpacePoint& p) const noexcept {
    return std::min(a[x], b[x]) <= p[x] && p[x] <= std::max(a[x], b[x]) && std::min(a[y], b[y]) <= p[y] &&
           p[y] <= std::max(a[y], b[y]);
  }
  [[nodiscard]] bool segments_meet(const SpacePoint& a, const SpacePoint& b, const SpacePoint& p,
                                   const SpacePoint& q) const noexcept {
    const int of_p = turn(a, b, p);
    const int of_q = turn(a, b, q);
    const int of_a = turn(p, q, a);
    const int of_b = turn(p, q, b);
    if (of_p * of_q < 0 && of_a * of_b < 0) return true;
    return (of_p == 0 && is_between(a, b, p)) || (of_q == 0 && is_between(a, b, q)) ||
           (of_a == 0 && is_between(p, q, a)) || (of_b == 0 && is_between(p, q, b));
  }
};

// In which the triangle keeps its area. Any that does keeps apart what is apart in its plane.
View view_of(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) noexcept {
  for (const View view : {View{0, 1}, View{1, 2}}) {
    if (view.turn(a, b, c) != 0) return view;
  }
  return {2, 0};
}

struct Corners {
  const SpacePoint& a;
  const SpacePoint& b;
  const SpacePoint& c;

  [[nodiscard]] bool holds_in_plane(const View& view, const SpacePoint& p) const noexcept {
    const std::array<int, 3> turns = {view.turn(a, b, p), view.turn(b, c, p), view.turn(c, a, p)};
    const auto [least, most] = std::minmax_element(turns.begin(), turns.end());
    return *least >= 0 || *most <= 0;
  }

  /// The other triangle, but for its first corner if that is shared, lies strictly on one side of the plane.
  [[nodiscard]] bool has_beside(const Corners& other, std::size_t shared) const noexcept {
    const int side = orientation(a, b, c, other.c);
    return side != 0 && orientation(a, b, c, other.b) == side &&
           (shared == 1 || orientation(a, b, c, other.a) == side);
  }

  /// The segment pq meets the triangle.
  [[nodiscard]] bool meets(const SpacePoint& p, const SpacePoint& q) const noexcept {
    const int of_p = orientation(a, b, c, p);
    const int of_q = orientation(a, b, c, q);
    if (of_p * of_q > 0) return false;
    if (of_p == 0 && of_q == 0) {
      const View view = view_of(a, b, c);
      return holds_in_plane(view, p) || view.segments_meet(a, b, p, q) || view.segments_meet(b, c, p, q) ||
             view.segments_meet(c, a, p, q);
    }
    // The line pq goes through the plane, and does so within the triangle if it passes all edges on one side.
    const std::array<int, 3> sides = {orientation(p, q, a, b), orientation(p, q, b, c),
                                      orientation(p, q, c, a)};
    const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
    return *least >= 0 || *most <= 0;
  }
};

// The corners of s, those shared with t first; and how many these are.
std::size_t shared_first(Triangle& s, const Triangle& t) noexcept {
  const auto end = std::partition(
      s.begin(), s.end(), [&](std::uint32_t i) { return std::find(t.begin(), t.end(), i) != t.end(); });
  return static_cast<std::size_t>(end - s.begin());
}

}  // namespace

bool is_flat(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) noexcept {
  return View{0, 1}.turn(a, b, c) == 0 && View{1, 2}.turn(a, b, c) == 0 && View{2, 0}.turn(a, b, c) == 0;
}

bool do_meet(std::span<const SpacePoint> points, const Triangle& s, const Triangle& t) noexcept {
  Triangle f = s;
  Triangle g = t;
  const std::size_t shared = shared_first(f, t);
  shared_first(g, s);
  const auto p = [&](std::size_t i) -> const SpacePoint& { return points[f[i]]; };
  const auto q = [&](std::size_t i) -> const SpacePoint& { return points[g[i]]; };
  const Corners of_s{p(0), p(1), p(2)};
  const Corners of_t{q(0), q(1), q(2)};
  if (shared < 2 && (of_s.has_beside(of_t, shared) || of_t.has_beside(of_s, shared))) return false;
  switch (shared) {
    case 0:  // An edge of one meets the other, or they are apart.
      for (std::size_t i = 0; i < 3; ++i) {
        if (of_t.meets(p(i), p((i + 1) % 3)) || of_s.meets(q(i), q((i + 1) % 3))) return true;
      }
      return false;
    case 1:  // Seen from the common corner, what they share ends at an edge that faces it.
      return of_t.meets(p(1), p(2)) || of_s.meets(q(1), q(2));
    case 2: {  // Different planes meet in the edge alone; in one plane they must lie on different sides of
               // it.
      if (orientation(p(0), p(1), p(2), q(2)) != 0) return false;
      const View view = view_of(p(0), p(1), p(2));
      return view.turn(p(0), p(1), p(2)) == view.turn(p(0), p(1), q(2));
    }
    default:
      return true;  // the same triangle twice
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
