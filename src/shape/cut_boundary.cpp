#include "shape/cut_boundary.h"

#include <algorithm>
#include <cmath>

#include "shape/interior_samples.h"
#include "shape/plane.h"

namespace tandem {
inline namespace v0 {
namespace {

// Share of the scale that curves are flattened to; a chord keeps kClear from all vertices, which is more.
constexpr double kTolerance = 2e-4;
constexpr double kClear = 5e-4;
// ... but for those near its own ends, where the angle to the outline keeps it off.
constexpr double kOwn = 6.0 * kClear;

// Places along the outline. Between neighbours of so many the area of a piece changes by less than 1 % of a
// compact contour.
constexpr int kPlaces = 128;

// Sine of the least angle between a chord and the outline, 10 degrees: thinner wedges look like mistakes.
constexpr double kLeastSine = 0.17;

Vec2 unit(Vec2 v) {
  return times(1.0 / length(v), v);
}

// Whether the segments have a point in common, of which an end of the first does not count.
bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Vec2 chord = minus(b, a);
  const double side_c = cross(chord, minus(c, a));
  const double side_d = cross(chord, minus(d, a));
  if ((side_c > 0.0) == (side_d > 0.0)) return false;
  const Vec2 edge = minus(d, c);
  return (cross(edge, minus(a, c)) > 0.0) != (cross(edge, minus(b, c)) > 0.0);
}

}  // namespace

CutBoundary::CutBoundary(const CubicPath& contour, std::span<const CubicPath> holes, double scale) {
  std::vector<PathView> views = view_paths({&contour, 1});
  const std::vector<PathView> others = view_paths(holes);
  views.insert(views.end(), others.begin(), others.end());
  flat_.assign(views, kTolerance, scale);
  place_vertices(flat_.paths().front(), views.front());
  for (std::size_t i = 0; i + 1 < vertices_.size(); ++i) edges_.push_back({position(i), position(i + 1)});
  for (std::size_t p = 1; p < flat_.paths().size(); ++p) {
    for (std::size_t i = flat_.paths()[p].first; i < flat_.paths()[p].last; ++i) {
      const FlatVertex* v = &flat_.vertices()[i];
      edges_.push_back({{v[0].x, v[0].y}, {v[1].x, v[1].y}});
    }
  }
}

void CutBoundary::place_vertices(const FlatPath& path, const PathView& view) {
  const std::vector<FlatVertex>& flat = flat_.vertices();
  double outline = 0.0;
  for (std::size_t i = path.first; i < path.last; ++i) {
    outline += distance({flat[i].x, flat[i].y}, {flat[i + 1].x, flat[i + 1].y});
  }
  const double spacing = outline / kPlaces;
  for (std::size_t i = path.first; i < path.last; ++i) {
    vertices_.push_back(flat[i]);
    const double step = distance({flat[i].x, flat[i].y}, {flat[i + 1].x, flat[i + 1].y});
    const int parts = spacing > 0.0 ? static_cast<int>(std::ceil(step / spacing)) : 1;
    for (int k = 1; k < parts; ++k) {
      const double u = flat[i].u + k * (flat[i + 1].u - flat[i].u) / parts;
      const Vec2 p = flat_.point(view, u);
      vertices_.push_back({p.x, p.y, u});
    }
  }
  vertices_.push_back(flat[path.last]);
  sums_.push_back({});
  for (std::size_t i = 0; i + 1 < vertices_.size(); ++i) {
    const Moments m = moments(position(i), position(i + 1));
    sums_.push_back({sums_[i].area + m.area, sums_[i].x + m.x, sums_[i].y + m.y});
  }
  choose_places(spacing);
}

void CutBoundary::choose_places(double spacing) {
  double since = spacing;
  for (std::size_t i = 0; i + 1 < vertices_.size(); ++i) {
    if (i > 0) since += distance(position(i - 1), position(i));
    const bool joint = vertices_[i].u == std::floor(vertices_[i].u);
    if (since >= (joint ? 0.25 : 0.75) * spacing) {
      places_.push_back(i);
      since = 0.0;
    }
  }
}

CutBoundary::Moments CutBoundary::moments(Vec2 p, Vec2 q) {
  const double c = cross(p, q);
  return {c, c * (p.x + q.x), c * (p.y + q.y)};
}

Region CutBoundary::region(const Moments& m) {
  if (m.area == 0.0) return {};
  return {0.5 * m.area, {m.x / (3.0 * m.area), m.y / (3.0 * m.area)}};
}

Region CutBoundary::whole() const {
  return region(sums_.back());
}

Region CutBoundary::side(std::size_t a, std::size_t b) const {
  const Moments& from = sums_[places_[a]];
  const Moments& to = sums_[places_[b]];
  const Moments back = moments(point(b), point(a));
  return region({to.area - from.area + back.area, to.x - from.x + back.x, to.y - from.y + back.y});
}

bool CutBoundary::points_inside(std::size_t vertex, Vec2 direction) const {
  const std::size_t last = vertices_.size() - 1;
  const Vec2 on = unit(minus(position(vertex + 1), position(vertex)));
  const Vec2 back = unit(minus(position(vertex == 0 ? last - 1 : vertex - 1), position(vertex)));
  const double turn = sums_.back().area > 0.0 ? 1.0 : -1.0;
  const Vec2 c = unit(direction);
  const bool left_of_on = turn * cross(on, c) > kLeastSine;
  const bool right_of_back = turn * cross(c, back) > kLeastSine;
  if (turn * cross(on, back) >= 0.0) return left_of_on && right_of_back;  // a convex corner, or none
  // At a reflex corner what lies between the edges outside is forbidden, and what is near it; the two tests
  // alone would forbid the way straight on from a thin notch, too.
  const bool outside = turn * cross(back, c) > -kLeastSine && turn * cross(c, on) > -kLeastSine;
  return !outside || (dot(back, on) > 0.9 && dot(back, c) < 0.0);
}

bool CutBoundary::blocks(const Edge& edge, Vec2 a, Vec2 b, double clear) {
  const Vec2 chord = minus(b, a);
  const Vec2 from_a = minus(edge.from, a);
  const double off = cross(chord, from_a);
  const double off_to = cross(chord, minus(edge.to, a));
  if ((off > clear && off_to > clear) || (off < -clear && off_to < -clear)) return false;
  const Vec2 from_b = minus(edge.from, b);
  const double along = dot(from_a, chord);
  if (std::abs(off) <= clear && along >= 0.0 && along <= dot(chord, chord) &&
      dot(from_a, from_a) > kOwn * kOwn && dot(from_b, from_b) > kOwn * kOwn) {
    return true;
  }
  const bool own = edge.from == a || edge.from == b || edge.to == a || edge.to == b;
  return !own && cross_each_other(a, b, edge.from, edge.to);
}

bool CutBoundary::is_clear(Vec2 a, Vec2 b, std::size_t& last_block) const {
  const double clear = kClear * distance(a, b);  // as an area
  if (blocks(edges_[last_block], a, b, clear)) return false;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (blocks(edges_[i], a, b, clear)) {
      last_block = i;
      return false;
    }
  }
  // From a point where a hole touches the outline a chord may run through the hole uncrossed.
  for (std::size_t p = 1; p < flat_.paths().size(); ++p) {
    if (winding_number(flat_, flat_.paths()[p], middle(a, b)) != 0) return false;
  }
  return true;
}

bool CutBoundary::admits(std::size_t a, std::size_t b, std::size_t& last_block) const {
  const Vec2 p = point(a);
  const Vec2 q = point(b);
  const Vec2 chord = minus(q, p);
  if (!(dot(chord, chord) > kOwn * kOwn)) return false;
  return points_inside(places_[a], chord) && points_inside(places_[b], minus(p, q)) &&
         is_clear(p, q, last_block);
}

}  // namespace v0
}  // namespace tandem
