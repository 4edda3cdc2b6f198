#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "io/limits.h"
#include "io/path_data_reader.h"
#include "io/scanner.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/shape/measures.h"

namespace tandem {
inline namespace v0 {
namespace {

/// How far apart the ends of a filled outline may lie to count as meeting, as a share of its diagonal.
/// Rounding to two or three decimals in icon files leaves gaps of about 1e-4.
constexpr double kMeetingEnds = 1e-3;
/// What a stroked outline encloses at least, as a share of the square of its diagonal.
constexpr double kLeastArea = 1e-3;

Box box_of(std::span<const double> p, std::span<const double> q) {
  Box box;
  box.include(p);
  box.include(q);
  return box;
}

bool ends_meet(const CubicPath& path) {
  const Points& points = path.control_points();
  const double gap = box_of(points.front(), points.back()).diagonal();
  if (gap == 0.0) return true;
  Box polygon;
  for (std::size_t i = 0; i < points.size(); ++i) polygon.include(points[i]);
  if (gap > kMeetingEnds * polygon.diagonal()) return false;  // the outline's own box is no larger
  return gap <= kMeetingEnds * bounding_box(to_curve(path)).diagonal();
}

CubicPath closed_by_line(const CubicPath& path) {
  Points points = path.control_points();
  const Point from(points.back().begin(), points.back().end());
  const Point to(points.front().begin(), points.front().end());
  if (from == to) return CubicPath(std::move(points), true);
  Point handle1(from.size());
  Point handle2(from.size());
  for (std::size_t k = 0; k < from.size(); ++k) {
    handle1[k] = from[k] + (to[k] - from[k]) / 3.0;
    handle2[k] = to[k] - (to[k] - from[k]) / 3.0;
  }
  points.push_back(handle1);
  points.push_back(handle2);
  points.push_back(to);
  return CubicPath(std::move(points), true);
}

/// Whether there is something inside.
bool goes_around(const CubicPath& path) {
  const double size = bounding_box(to_curve(path)).diagonal();
  return std::fabs(signed_area(path)) > kLeastArea * size * size;
}

/// Closes the open paths whose ends meet, where what comes of it is wanted.
template <typename IsWanted>
std::vector<CubicPath> close_where(std::vector<CubicPath> paths, const IsWanted& is_wanted) {
  for (CubicPath& path : paths) {
    if (path.is_closed() || !ends_meet(path)) continue;
    CubicPath closed = closed_by_line(path);
    if (is_wanted(closed)) path = std::move(closed);
  }
  return paths;
}

bool in_range(double x) {
  return std::fabs(x) <= kLargestCoordinate;
}  // false for NaN

}  // namespace

std::vector<CubicPath> close_meeting_ends(std::vector<CubicPath> paths) {
  return close_where(std::move(paths), [](const CubicPath&) { return true; });
}

std::vector<CubicPath> close_meeting_outlines(std::vector<CubicPath> paths) {
  return close_where(std::move(paths), goes_around);
}

bool is_in_range(const CubicPath& path) {
  const std::span<const double> coordinates = path.control_points().data();
  return std::all_of(coordinates.begin(), coordinates.end(), [](double x) { return in_range(x); });
}

void check_range(Vec2 point, const Transform& transform, std::size_t offset) {
  const Vec2 image = transform(point);
  if (in_range(point.x) && in_range(point.y) && in_range(image.x) && in_range(image.y)) return;
  Scanner::fail(offset, "the point lies beyond the largest coordinate, 1e300");
}

}  // namespace v0
}  // namespace tandem
