#include "shape/edge_contact.h"

#include <algorithm>
#include <cmath>
#include <optional>

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
  using Kind = EdgeContact::Kind;
  const Vec2 da = between(a[0], a[1]);
  const Vec2 db = between(b[0], b[1]);
  const double bound_a = epsilon * length(da);
  const double c1 = cross(da, between(a[0], b[0]));
  const double c2 = cross(da, between(a[0], b[1]));
  const int s1 = side(c1, bound_a);
  const int s2 = side(c2, bound_a);
  if (s1 != 0 && s1 == s2) return {};
  const double bound_b = epsilon * length(db);
  const double c3 = cross(db, between(b[0], a[0]));
  const double c4 = cross(db, between(b[0], a[1]));
  const int s3 = side(c3, bound_b);
  const int s4 = side(c4, bound_b);
  if (s3 != 0 && s3 == s4) return {};
  const bool clearly = s1 * s2 != 0 && s3 * s4 != 0;
  if (clearly || (c1 * c2 < 0.0 && c3 * c4 < 0.0)) {
    return {clearly ? Kind::crossing : Kind::undecided, c3 / (c3 - c4), c1 / (c1 - c2)};
  }
  const auto foot_within = [&](const FlatVertex& vertex, const FlatVertex* edge, Vec2 d) {
    const double share = std::clamp(dot(d, between(edge[0], vertex)) / dot(d, d), 0.0, 1.0);
    const Vec2 foot = plus(position(edge[0]), times(share, d));
    return distance(foot, position(vertex)) <= epsilon ? std::optional(share) : std::nullopt;
  };
  if (const auto share = foot_within(a[0], b, db)) return {Kind::undecided, 0.0, *share};
  if (const auto share = foot_within(b[0], a, da)) return {Kind::undecided, *share, 0.0};
  return {};
}

bool passes_through(const Flattening& flat, const FlatPlace& a, const FlatPlace& b, double epsilon) {
  const auto point = [&](const FlatPlace& place) {
    const FlatVertex* e = &flat.vertices()[place.edge];
    return plus(position(e[0]), times(place.share, between(e[0], e[1])));
  };
  const Vec2 center = point(a);
  for (const double r : {8.0 * epsilon, 32.0 * epsilon, 128.0 * epsilon}) {
    const auto end = [&](const FlatPlace& place, bool forward) {
      return follow(flat, place.path, point(place), forward ? place.edge + 1 : place.edge, forward, center,
                    r);
    };
    const auto a0 = end(a, false);
    const auto a1 = end(a, true);
    const auto b0 = end(b, false);
    const auto b1 = end(b, true);
    if (!a0 || !a1 || !b0 || !b1) return false;
    const double gap =
        std::min({distance(*a0, *b0), distance(*a0, *b1), distance(*a1, *b0), distance(*a1, *b1)});
    if (gap <= 2.0 * epsilon) continue;
    const double from = pseudo_angle(minus(*a0, center));
    const double to = pseudo_angle(minus(*a1, center));
    return lies_between(pseudo_angle(minus(*b0, center)), from, to) !=
           lies_between(pseudo_angle(minus(*b1, center)), from, to);
  }
  return false;
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
