#include "tandem/shape/path_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "shape/elliptical_arc.h"
#include "shape/third.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

// Ends of a closed subpath that are apart by no more than this share of its extent are meant to meet: the
// same bound by which a Curve counts as closed.
constexpr double kClosingGap = 1e-9;

Vec2 to_vec(std::span<const double> p) {
  return {p[0], p[1]};
}

// from + share (to - from), on one axis; the difference of two huge numbers must not overflow.
double along(double from, double to, double share) {
  const double d = to - from;
  return std::isfinite(d) ? from + d * share : from + (to * share - from * share);
}

Vec2 along(Vec2 from, Vec2 to, double share) {
  return {along(from.x, to.x, share), along(from.y, to.y, share)};
}

Vec2 third_point(Vec2 from, Vec2 to) {
  return {third(from.x, to.x), third(from.y, to.y)};
}

// Largest coordinate difference: no squares, so nothing over- or underflows.
double distance(Vec2 a, Vec2 b) {
  return std::max(std::fabs(a.x - b.x), std::fabs(a.y - b.y));
}

double extent(const Points& points) {
  Vec2 lo = to_vec(points.front());
  Vec2 hi = lo;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 p = to_vec(points[i]);
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
  }
  return distance(lo, hi);
}

void push(Points& points, Vec2 p) {
  const std::array<double, 2> row{p.x, p.y};
  points.push_back(row);
}

void set(Points& points, std::size_t i, Vec2 p) {
  points[i][0] = p.x;
  points[i][1] = p.y;
}

void push_line(Points& points, Vec2 to) {
  const Vec2 from = to_vec(std::as_const(points).back());
  push(points, third_point(from, to));
  push(points, third_point(to, from));
  push(points, to);
}

// The last point becomes the first one exactly. A last segment that lies in the gap altogether is dropped,
// and a line stays a line.
void snap_end(Points& points, double gap) {
  const Vec2 front = to_vec(std::as_const(points).front());
  std::size_t last = points.size() - 1;
  const auto near = [&](std::size_t i) { return distance(to_vec(std::as_const(points)[i]), front) <= gap; };
  if (last > 3 && near(last - 1) && near(last - 2) && near(last - 3)) {
    const auto kept = std::as_const(points).data().first(2 * (last - 2));
    points = Points(2, std::vector<double>(kept.begin(), kept.end()));
    last -= 3;
  }
  const Vec2 from = to_vec(std::as_const(points)[last - 3]);
  const Vec2 end = to_vec(std::as_const(points)[last]);
  const bool line = to_vec(std::as_const(points)[last - 2]) == third_point(from, end) &&
                    to_vec(std::as_const(points)[last - 1]) == third_point(end, from);
  set(points, last, front);
  if (line) {
    set(points, last - 2, third_point(from, front));
    set(points, last - 1, third_point(front, from));
  }
}

}  // namespace

void PathBuilder::set_transform(const Transform& transform) {
  transform_ = transform;
}

void PathBuilder::move_to(Vec2 p) {
  finish(false);
  start_ = p;
  current_ = p;
  has_current_ = true;
}

void PathBuilder::line_to(Vec2 p) {
  start_if_needed();
  // The thirds are taken after the transform, so that a line's handles stand where is_line() expects them.
  const Vec2 from = to_vec(std::as_const(points_).back());
  const Vec2 to = transform_(p);
  if (!(from == to)) push_line(points_, to);
  current_ = p;
}

void PathBuilder::quad_to(Vec2 control, Vec2 p) {
  start_if_needed();
  const Vec2 from = to_vec(std::as_const(points_).back());
  const Vec2 mid = transform_(control);
  const Vec2 to = transform_(p);
  append(along(from, mid, 2.0 / 3.0), along(to, mid, 2.0 / 3.0), to);
  current_ = p;
}

void PathBuilder::cubic_to(Vec2 control1, Vec2 control2, Vec2 p) {
  start_if_needed();
  append(transform_(control1), transform_(control2), transform_(p));
  current_ = p;
}

void PathBuilder::arc_to(Vec2 radii, double x_axis_rotation_degrees, bool large_arc, bool sweep, Vec2 p) {
  start_if_needed();
  if (current_ == p) return;
  const EllipticalArc arc{current_, radii, x_axis_rotation_degrees, large_arc, sweep, p};
  const std::vector<ArcPiece> pieces = arc_pieces(arc);
  if (pieces.empty()) {
    line_to(p);
    return;
  }
  for (const ArcPiece& piece : pieces) {
    append(transform_(piece.control1), transform_(piece.control2), transform_(piece.end));
  }
  current_ = p;
}

void PathBuilder::close() {
  if (!has_current_) return;
  finish(true);
  current_ = start_;
}

std::vector<CubicPath> PathBuilder::take() {
  finish(false);
  has_current_ = false;
  return std::exchange(paths_, {});
}

void PathBuilder::start_if_needed() {
  if (!has_current_)
    throw InvalidArgument("path: a drawing command without a current point, expected move_to first");
  if (points_.empty()) push(points_, transform_(current_));
}

void PathBuilder::append(Vec2 c1, Vec2 c2, Vec2 p) {
  const Vec2 from = to_vec(std::as_const(points_).back());
  if (from == c1 && from == c2 && from == p) return;
  push(points_, c1);
  push(points_, c2);
  push(points_, p);
}

void PathBuilder::finish(bool closed) {
  Points points = std::exchange(points_, {});
  if (points.size() < 4) return;
  if (closed) {
    const Vec2 front = to_vec(std::as_const(points).front());
    const double gap = kClosingGap * extent(points);
    if (distance(to_vec(std::as_const(points).back()), front) > gap) {
      push_line(points, front);
    } else {
      snap_end(points, gap);
    }
  }
  paths_.emplace_back(std::move(points), closed);
}

}  // namespace v0
}  // namespace tandem
