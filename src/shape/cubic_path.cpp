#include "tandem/shape/cubic_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "shape/cubic_fit.h"
#include "shape/third.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

CubicPath::CubicPath(Points control_points, bool closed)
    : control_points_(std::move(control_points)), closed_(closed) {
  const std::size_t n = control_points_.size();
  if (n < 4 || n % 3 != 1) {
    throw InvalidArgument(fmt::format("cubic path: {} control points, expected 3k + 1 with k >= 1", n));
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (double x : control_points_[i]) {
      if (!std::isfinite(x)) {
        throw InvalidArgument(fmt::format("cubic path: control point {} is not finite ({})", i, x));
      }
    }
  }
  const auto front = std::as_const(control_points_).front();
  const auto back = std::as_const(control_points_).back();
  if (closed_ && !std::equal(front.begin(), front.end(), back.begin())) {
    throw InvalidArgument("cubic path: closed, but its last control point is not its first one");
  }
}

std::array<std::span<const double>, 4> CubicPath::segment(std::size_t i) const noexcept {
  return {control_points_[3 * i], control_points_[3 * i + 1], control_points_[3 * i + 2],
          control_points_[3 * i + 3]};
}

bool CubicPath::is_line(std::size_t i, double tolerance) const {
  const auto [p0, p1, p2, p3] = segment(i);
  for (std::size_t k = 0; k < p0.size(); ++k) {
    if (!(std::fabs(p1[k] - third(p0[k], p3[k])) <= tolerance)) return false;
    if (!(std::fabs(p2[k] - third(p3[k], p0[k])) <= tolerance)) return false;
  }
  return true;
}

Curve to_curve(const CubicPath& path) {
  const std::size_t k = path.segment_count();
  std::vector<double> knots;
  knots.reserve(3 * k + 5);
  knots.push_back(0.0);
  for (std::size_t i = 0; i <= k; ++i) knots.insert(knots.end(), 3, static_cast<double>(i));
  knots.push_back(static_cast<double>(k));
  return Curve(3, std::move(knots), path.control_points());
}

CubicPath to_cubic_path(const Curve& curve, double tolerance) {
  if (!(tolerance > 0.0)) {
    throw InvalidArgument(fmt::format("to_cubic_path: tolerance is {}, expected > 0", tolerance));
  }
  Points points = std::move(cubic_control_points({&curve, 1}, tolerance).front());
  const bool closed = curve.is_closed();
  if (closed) {  // its ends meet up to rounding only
    const auto front = std::as_const(points).front();
    std::copy(front.begin(), front.end(), points[points.size() - 1].begin());
  }
  return CubicPath(std::move(points), closed);
}

}  // namespace v0
}  // namespace tandem
