#include "surface/contour_band.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// The polyline with vertex i at parameter i.
Curve to_polyline(const Loop& loop, std::span<const Vec2> places) {
  std::vector<double> knots{0.0};
  Points points(2, loop.size() + 1);
  for (std::size_t i = 0; i <= loop.size(); ++i) {
    const Vec2 p = places[loop[i % loop.size()]];
    points[i][0] = p.x;
    points[i][1] = p.y;
    knots.push_back(static_cast<double>(i));
  }
  knots.push_back(knots.back());
  return Curve(1, std::move(knots), std::move(points));
}

}  // namespace

ContourBand make_band(const Loop& below, const Loop& above, std::span<const Vec2> places,
                      const MatchOptions& given) {
  MatchOptions options = given;
  options.closed = ClosedMode::yes;
  options.direction = Direction::forward;
  const Match found = match(to_polyline(below, places), to_polyline(above, places), options);
  const std::size_t n = below.size();
  const std::size_t m = above.size();
  std::vector<double> v;
  for (std::size_t i = 0; i <= n; ++i) v.push_back(found.correspondence.v_at(static_cast<double>(i)));

  ContourBand band{{}, found.report.validity.valid_share};
  // Once round both, each time along that loop whose next edge lies first, by its middle.
  const double start = std::ceil(v[0] - 0.5);
  const auto vertex_above = [&](std::size_t j) {
    const double turned = std::fmod(start + static_cast<double>(j), static_cast<double>(m));
    return above[static_cast<std::size_t>(turned < 0.0 ? turned + static_cast<double>(m) : turned)];
  };
  for (std::size_t i = 0, j = 0; i < n || j < m;) {
    const bool along_below =
        j == m || (i < n && 0.5 * (v[i] + v[i + 1]) <= start + static_cast<double>(j) + 0.5);
    if (along_below) {
      band.triangles.push_back({below[i], below[(i + 1) % n], vertex_above(j)});
      ++i;
    } else {
      band.triangles.push_back({below[i % n], vertex_above(j + 1), vertex_above(j)});
      ++j;
    }
  }
  return band;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
