#include "surface/planar_ruled.h"

#include <utility>
#include <vector>

#include "surface/ruled_jacobian.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// The end ruling at the start or the end of the rails, as a curve over v.
BoundaryEdge ruling(const Rails& rails, bool at_end) {
  const auto end_point = [&](const EnclosedSpline& rail) {
    const std::vector<double> knots = rail.breaks();
    const std::size_t last = knots.size() - 1;
    const Interval span = at_end ? Interval{knots[last - 1], knots[last]} : Interval{knots[0], knots[1]};
    const std::vector<PlanePoint> polygon = plane_points(rail.bezier(span), rails.rational);
    return at_end ? polygon.back() : polygon.front();
  };
  const PlanePoint p = end_point(rails.a);
  const PlanePoint q = end_point(rails.b);
  const Interval domain = rails.a.domain();
  return {EnclosedSpline(1, {0, 0, 1, 1}, {p[0], p[1], q[0], q[1]}, 2), false, !at_end, Along::v,
          at_end ? domain.hi : domain.lo};
}

std::vector<BoundaryLoop> boundary_of(const Rails& rails) {
  BoundaryEdge a{rails.a, rails.rational, false, Along::u, 0.0};
  BoundaryEdge b{rails.b, rails.rational, !rails.closed, Along::u, 1.0};
  if (rails.closed) return {{std::move(a)}, {std::move(b)}};
  BoundaryLoop loop = {std::move(a)};
  if (!rails.pole[1]) loop.push_back(ruling(rails, true));
  loop.push_back(std::move(b));
  if (!rails.pole[0]) loop.push_back(ruling(rails, false));
  return {std::move(loop)};
}

Parameters parameters(const RailPlace& place) {
  return {place.u, static_cast<double>(place.rail)};
}

}  // namespace

Findings examine_planar_ruled(const Curve& a, const Curve& b) {
  const Rails rails = make_rails(a, b);
  const JacobianSign jacobian = ruled_jacobian_sign(rails);
  Findings result;
  result.regular = jacobian.verdict;
  if (jacobian.positive && jacobian.negative) {
    const bool few_positive = jacobian.rarer > 0;
    result.sign_change(parameters(few_positive ? *jacobian.positive : *jacobian.negative), jacobian.rarer,
                       parameters(few_positive ? *jacobian.negative : *jacobian.positive));
    return result;
  }
  if (jacobian.zero) result.zero(parameters(*jacobian.zero));
  const std::vector<BoundaryLoop> loops = boundary_of(rails);
  result.boundary(find_simple(loops), jacobian.sign != 0);
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
