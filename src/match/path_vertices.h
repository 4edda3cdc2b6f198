#pragma once

#include <cstddef>
#include <vector>

#include "match/limit_slopes.h"
#include "tandem/curve/interval.h"
#include "tandem/match/reparametrization.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The unit square that the path fills: there the mean slope is 1, whatever the units of u and v are.
class Frame {
 public:
  explicit Frame(const std::vector<ParameterPair>& points)
      : u_{points.front().u, points.back().u}, v_{points.front().v, points.back().v} {}

  [[nodiscard]] const Interval& u() const { return u_; }
  [[nodiscard]] const Interval& v() const { return v_; }
  [[nodiscard]] double x(double u) const { return (u - u_.lo) / u_.length(); }
  [[nodiscard]] double y(double v) const { return (v - v_.lo) / v_.length(); }
  [[nodiscard]] double u(double x) const { return at(u_, x); }
  [[nodiscard]] double v(double y) const { return at(v_, y); }

 private:
  [[nodiscard]] static double at(const Interval& interval, double share) {
    if (share >= 1.0) return interval.hi;
    return share <= 0.0 ? interval.lo : interval.clamp(interval.lo + share * interval.length());
  }

  Interval u_;
  Interval v_;
};

/// The path's points with the steps at one u drawn together, in the unit square.
struct Vertices {
  std::vector<double> x;           ///< increasing
  std::vector<double> y;           ///< half-way up the step; at the ends the path's own ends
  std::vector<double> low;         ///< foot of the step
  std::vector<double> high;        ///< and its head
  std::vector<ParameterPair> own;  ///< (x, y) as parameters, without the rounding of the unit square
  std::vector<std::size_t> fixed;  ///< first, corners, last

  [[nodiscard]] std::size_t size() const { return x.size(); }
};

/// The path must be sound: see fit().
[[nodiscard]] Vertices make_vertices(const FitPath& path, const Frame& frame);

/// Heights of the vertices, moved as little as may be so that no slope leaves the range: corners first.
[[nodiscard]] std::vector<double> admissible_heights(const Vertices& vertices, const SlopeRange& range);

/// Vertex i as parameters, at height y.
[[nodiscard]] ParameterPair parameters(const Vertices& vertices, std::size_t i, double y, const Frame& frame);

/// Leaves out points that do not rise above the one before by more than `ulps` units of the domains' last
/// place, in u and in v: what is left of a step when the domain lies far from 0. Both ends stay.
[[nodiscard]] std::vector<ParameterPair> without_drowned(const std::vector<ParameterPair>& points,
                                                         double ulps);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
