#include "surface/enclosed_surface.h"

#include <algorithm>
#include <span>
#include <utility>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

bool is_clamped_at(const Surface& surface, Along along, bool at_end) {
  const std::vector<double>& knots = surface.knots(along);
  const Interval domain = surface.domain(along);
  return at_end ? *(knots.end() - 2) == domain.hi : knots[1] == domain.lo;
}

// The line of control points with the first or the last index along a parameter.
std::vector<std::span<const double>> edge_points(const Surface& surface, Along fixed, bool at_end) {
  std::vector<std::span<const double>> result;
  const Along moving = fixed == Along::u ? Along::v : Along::u;
  const std::size_t at = at_end ? surface.size(fixed) - 1 : 0;
  for (std::size_t k = 0; k < surface.size(moving); ++k)
    result.push_back(fixed == Along::u ? surface.control_point(at, k) : surface.control_point(k, at));
  return result;
}

bool same(std::span<const double> p, std::span<const double> q) {
  return std::equal(p.begin(), p.end(), q.begin(), q.end());
}

bool is_one_point(const Surface& surface, Along fixed, bool at_end) {
  if (!is_clamped_at(surface, fixed, at_end)) return false;
  const auto points = edge_points(surface, fixed, at_end);
  return std::all_of(points.begin(), points.end(), [&](auto p) { return same(p, points.front()); });
}

bool is_closed_exactly(const Surface& surface) {
  if (!is_clamped_at(surface, Along::u, false) || !is_clamped_at(surface, Along::u, true)) return false;
  // Weights may differ along the seam; the points of its two sides then do.
  if (surface.is_rational()) return false;
  const auto first = edge_points(surface, Along::u, false);
  const auto last = edge_points(surface, Along::u, true);
  return std::equal(first.begin(), first.end(), last.begin(), same);
}

EnclosedSpline lines_along_u(const Surface& surface) {
  const std::array<const Points*, 1> cloud = {&surface.control_points()};
  const std::size_t group = static_cast<std::size_t>(surface.dim()) + (surface.is_rational() ? 1 : 0);
  EnclosedSpline result(
      surface.degree(Along::u), surface.knots(Along::u),
      homogeneous(surface.control_points(), surface.weights(), surface.is_rational(), frame_of(cloud)),
      surface.size(Along::v) * group);
  if (surface.dim() == 2 && surface.is_closed(Along::u) && !is_closed_exactly(surface))
    result.weld(static_cast<std::size_t>(surface.dim()), surface.is_rational(), *(result.breaks().end() - 2));
  return result;
}

// (f x g)_c
BernsteinGrid cross(const std::vector<BernsteinGrid>& f, const std::vector<BernsteinGrid>& g, std::size_t c) {
  const std::size_t x = (c + 1) % 3;
  const std::size_t y = (c + 2) % 3;
  return difference(product(f[x], g[y]), product(f[y], g[x]));
}

}  // namespace

EnclosedSurface::EnclosedSurface(const Surface& surface)
    : dim_(static_cast<std::size_t>(surface.dim())),
      rational_(surface.is_rational()),
      group_(dim_ + (rational_ ? 1 : 0)),
      degree_{surface.degree(Along::u), surface.degree(Along::v)},
      knots_{surface.knots(Along::u), surface.knots(Along::v)},
      along_u_(lines_along_u(surface)) {
  breaks_[0] = along_u_.breaks();
  breaks_[1] = EnclosedSpline(degree_[1], knots_[1], Enclosures(surface.size(Along::v)), 1).breaks();
  for (const bool at_end : {false, true}) {
    poles_[0][at_end ? 1 : 0] = is_one_point(surface, Along::u, at_end);
    poles_[1][at_end ? 1 : 0] = is_one_point(surface, Along::v, at_end);
  }
}

std::vector<BernsteinGrid> EnclosedSurface::patch(const Cell& cell, bool by_u, bool by_v) const {
  const Enclosures lines = by_u ? along_u_.hodograph(cell[0]) : along_u_.bezier(cell[0]);
  const std::size_t rows = lines.size() / along_u_.stride();
  const std::size_t size = along_u_.stride() / group_;
  // As splines along v, whose coefficients are the columns.
  Enclosures columns(lines.size());
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t c = 0; c < group_; ++c)
        columns[(j * rows + i) * group_ + c] = lines[(i * size + j) * group_ + c];
    }
  }
  const EnclosedSpline along_v(degree_[1], knots_[1], std::move(columns), rows * group_);
  const Enclosures all = by_v ? along_v.hodograph(cell[1]) : along_v.bezier(cell[1]);
  const std::size_t count = all.size() / (rows * group_);
  std::vector<BernsteinGrid> result(group_, BernsteinGrid{rows, count, Enclosures(rows * count)});
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t c = 0; c < group_; ++c) result[c].at(i, j) = all[(j * rows + i) * group_ + c];
    }
  }
  return result;
}

// Polynomial: S_u x S_v. Rational, S = X / W: W X_u x X_v + W_v X x X_u - W_u X x X_v, which is W^3 times
// that (the terms with X x X drop out); in the plane its third coordinate, the determinant |X X_u X_v| of the
// homogeneous points.
std::vector<BernsteinGrid> EnclosedSurface::normal(const Cell& cell) const {
  const std::vector<BernsteinGrid> by_u = patch(cell, true, false);
  const std::vector<BernsteinGrid> by_v = patch(cell, false, true);
  std::vector<BernsteinGrid> result;
  const std::vector<BernsteinGrid> x = rational_ ? patch(cell, false, false) : std::vector<BernsteinGrid>{};
  for (std::size_t c = dim_ == 2 ? 2 : 0; c < 3; ++c) {
    BernsteinGrid n = cross(by_u, by_v, c);
    if (rational_) {
      n = product(x[dim_], n);
      n = sum(std::move(n), product(by_v[dim_], cross(x, by_u, c)));
      n = difference(std::move(n), product(by_u[dim_], cross(x, by_v, c)));
    }
    result.push_back(std::move(n));
  }
  for (const std::size_t along : {0U, 1U}) {
    for (const bool at_end : {false, true}) {
      const bool there =
          at_end ? cell[along].hi == breaks_[along].back() : cell[along].lo == breaks_[along][0];
      if (!is_pole(along, at_end) || !there) continue;
      for (BernsteinGrid& n : result) n = without_zero_at_edge(n, along, at_end);
    }
  }
  return result;
}

// Rational, S = X / W: W X_u - W_u X, which is W^2 times S_u.
std::vector<BernsteinGrid> EnclosedSurface::tangent(std::size_t along, const Cell& cell) const {
  std::vector<BernsteinGrid> by = patch(cell, along == 0, along == 1);
  if (!rational_) return by;
  const std::vector<BernsteinGrid> x = patch(cell, false, false);
  std::vector<BernsteinGrid> result;
  for (std::size_t c = 0; c < dim_; ++c)
    result.push_back(difference(product(x[dim_], by[c]), product(by[dim_], x[c])));
  return result;
}

EnclosedSpline EnclosedSurface::edge(std::size_t along, bool at_end) const {
  const auto outermost = [at_end](const std::vector<double>& breaks) {
    return at_end ? Interval{breaks[breaks.size() - 2], breaks.back()} : Interval{breaks[0], breaks[1]};
  };
  if (along == 1) {
    const Enclosures lines = along_u_.bezier(outermost(breaks_[0]));
    const auto stride = static_cast<std::ptrdiff_t>(along_u_.stride());
    return EnclosedSpline(degree_[1], knots_[1],
                          at_end ? Enclosures(lines.end() - stride, lines.end())
                                 : Enclosures(lines.begin(), lines.begin() + stride),
                          group_);
  }
  return along_u_.mapped([&](const Enclosures& line) {
    const Enclosures points =
        EnclosedSpline(degree_[1], knots_[1], line, group_).bezier(outermost(breaks_[1]));
    const auto group = static_cast<std::ptrdiff_t>(group_);
    return at_end ? Enclosures(points.end() - group, points.end())
                  : Enclosures(points.begin(), points.begin() + group);
  });
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
