#pragma once

#include <vector>

#include "morph/contour_blend.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Edge lengths and turning angles of the control polygons, interpolated (Sederberg, Gao, Wang and Mu,
/// SIGGRAPH 1993). Smooth joints stay smooth, since three control points in line stay in line.
///
/// The edges of closed paths have to close: their lengths are corrected by factors exp(-k (lambda cos + mu
/// sin)), which are positive whatever happens; k is larger where a length changes. The centroid of the edges'
/// middles moves in a straight line. Loops that grow from a point grow evenly; where two loops do not wind
/// alike, the sharpest turn goes the other way round.
class IntrinsicBlend final : public ContourBlend {
 public:
  IntrinsicBlend(const CubicPath& a, const CubicPath& b);
  void at(double s, std::span<double> points) const override;

 private:
  struct Edge {
    double length_a;
    double length_b;
    double heading;  ///< degrees, in a
    double turn;     ///< degrees, from a to b
    double give;     ///< how willingly the length changes, as a length
    [[nodiscard]] double length_at(double s) const;
  };
  /// Makes the lengths close the polygon of edges of these directions. gives: shares of the lengths at s.
  void close(double s, std::span<const double> directions, std::span<double> lengths,
             std::span<const double> gives) const;

  std::vector<Edge> edges_;
  bool closed_;
  double center_a_[2];
  double center_b_[2];
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
