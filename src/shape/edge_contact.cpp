#include "shape/edge_contact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "shape/plane.h"

namespace tandem {
inline namespace v0 {
namespace {

Vec2 position(const FlatVertex& v) {
  return {v.x, v.y};
}
Vec2 between(const FlatVertex& from, const FlatVertex& to) {
  return {to.x - from.x, to.y - from.y};
}

int side(double offset, double epsilon) {
  return offset > epsilon ? 1 : offset < -epsilon ? -1 : 0;
}

// Where the edge from `inside` to `outside` leaves the circle of radius r about the centre.
Vec2 leave(Vec2 inside, Vec2 outside, Vec2 center, double r) {
  const Vec2 d = minus(outside, inside);
  const Vec2 f = minus(inside, center);
  const double a = dot(d, d);
  const double b = dot(f, d);
  const double root = std::sqrt(std::max(0.0, b * b - a * (dot(f, f) - r * r)));
  return plus(inside, times((root - b) / a, d));
}

// Where the polyline, followed from `from` over the vertices starting with `vertex`, leaves the circle;
// nothing when an open one ends inside, or a closed one has come round.
std::optional<Vec2> follow(const Flattening& flat, const FlatPath& path, Vec2 from, std::size_t vertex,
                           bool forward, Vec2 center, double r) {
  for (std::size_t steps = 0; steps <= path.edge_count(); ++steps) {
    const Vec2 p = position(flat.vertices()[vertex]);
    if (distance(p, center) > r) return leave(from, p, center, r);
    from = p;
    if (vertex == (forward ? path.last : path.first)) {
      if (!path.closed) return std::nullopt;
      vertex = forward ? path.first : path.last;
    }
    forward ? ++vertex : --vertex;
  }
  return std::nullopt;
}

// Grows with the angle of (x, y) from 0 to 4, without trigonometry.
double pseudo_angle(Vec2 d) {
  const double p = d.y / (std::abs(d.x) + std::abs(d.y));
  return d.x < 0.0 ? 2.0 - p : p < 0.0 ? 4.0 + p : p;
}

bool lies_between(double angle, double from, double to) {
  return from <= to ? from < angle && angle < to : angle > from || angle < to;
}

}  // namespace

EdgeContact find_contact(const FlatVertex* a, const FlatVertex* b, double epsilon) {
  const Vec2 da = between(a[0], a[1]);
  const Vec2 db = between(b[0], b[1]);
  const double bound_a = epsilon * std::sqrt(dot(da, da));
  const double c1 = cross(da, between(a[0], b[0]));
  const double c2 = cross(da, between(a[0], b[1]));
  const int s1 = side(c1, bound_a);
  const int s2 = side(c2, bound_a);
  if (s1 != 0 && s1 == s2) return {};
  const double bound_b = epsilon * std::sqrt(dot(db, db));
  const double c3 = cross(db, between(b[0], a[0]));
  const double c4 = cross(db, between(b[0], a[1]));
  const int s3 = side(c3, bound_b);
  const int s4 = side(c4, bound_b);
  if (s3 != 0 && s3 == s4) return {};
  if (s1 * s2 == 0 || s3 * s4 == 0) return {EdgeContact::Kind::undecided};
  return {EdgeContact::Kind::crossing, c3 / (c3 - c4), c1 / (c1 - c2)};
}

std::optional<double> passes_through(const Flattening& flat, const FlatPath& path, std::size_t vertex,
                                     const FlatPath& other, std::size_t edge, double epsilon) {
  const FlatVertex& v = flat.vertices()[vertex];
  const FlatVertex& e0 = flat.vertices()[edge];
  const Vec2 center = position(v);
  const Vec2 d = between(e0, flat.vertices()[edge + 1]);
  const double share = std::clamp(dot(d, between(e0, v)) / dot(d, d), 0.0, 1.0);
  const Vec2 foot = plus(position(e0), times(share, d));
  if (distance(center, foot) > epsilon) return std::nullopt;
  if (!path.closed && (vertex == path.first || vertex == path.last)) return std::nullopt;
  const std::size_t before = vertex == path.first ? path.last - 1 : vertex - 1;
  const std::size_t after = vertex == path.last ? path.first + 1 : vertex + 1;
  for (const double r : {8.0 * epsilon, 32.0 * epsilon, 128.0 * epsilon}) {
    const std::array<std::optional<Vec2>, 4> ends{follow(flat, path, center, before, false, center, r),
                                                  follow(flat, path, center, after, true, center, r),
                                                  follow(flat, other, foot, edge, false, center, r),
                                                  follow(flat, other, foot, edge + 1, true, center, r)};
    if (!std::all_of(ends.begin(), ends.end(), [](const auto& end) { return end.has_value(); })) break;
    std::array<double, 4> angles{};
    bool apart = true;
    for (std::size_t i = 0; i < 4; ++i) {
      angles[i] = pseudo_angle(minus(*ends[i], center));
      if (i >= 2) {
        apart = apart && distance(*ends[i], *ends[0]) > 2.0 * epsilon &&
                distance(*ends[i], *ends[1]) > 2.0 * epsilon;
      }
    }
    if (!apart) continue;
    if (lies_between(angles[2], angles[0], angles[1]) == lies_between(angles[3], angles[0], angles[1])) {
      return std::nullopt;
    }
    return share;
  }
  return std::nullopt;
}

bool turns_back(const Flattening& flat, const FlatPath& path, std::size_t vertex, double epsilon) {
  if (vertex == path.first || vertex == path.last) return false;  // joints
  const FlatVertex* v = &flat.vertices()[vertex];
  if (dot(between(v[-1], v[0]), between(v[0], v[1])) >= 0.0 || v->u == std::floor(v->u)) return false;
  const Vec2 center = position(*v);
  const auto back = follow(flat, path, center, vertex - 1, false, center, 10.0 * epsilon);
  const auto on = follow(flat, path, center, vertex + 1, true, center, 10.0 * epsilon);
  return back && on && distance(*back, *on) <= 2.0 * epsilon;
}

}  // namespace v0
}  // namespace tandem
