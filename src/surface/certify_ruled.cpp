#include "surface/certify_ruled.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "surface/boundary.h"
#include "surface/ruled_jacobian.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

Curve plane_curve(const Curve& curve, const PlaneAxes& axes) {
  return Curve(curve.degree(), curve.knots(), in_plane(curve.control_points(), axes), curve.weights());
}

/// Places of the ruled surface, from what was proved about its rails.
class RuledPlaces {
 public:
  RuledPlaces(const Curve& a, const Curve& b, const PlaneAxes& axes) : a_(a), b_(b), axes_(axes) {}

  [[nodiscard]] SurfacePlace at(double u, double v) const {
    const Point p = a_.evaluate(u);
    const Point q = b_.evaluate(u);
    SurfacePlace place{u, v, Point(p.size()), 0.0};
    for (std::size_t c = 0; c < p.size(); ++c) place.point[c] = (1.0 - v) * p[c] + v * q[c];
    return place;
  }

  /// sign: what was proved of the Jacobian there.
  [[nodiscard]] SurfacePlace on_rail(const RailPlace& rail, int sign) const {
    SurfacePlace place = at(rail.u, rail.rail == 0 ? 0.0 : 1.0);
    if (sign == 0) return place;
    const Points rows = (rail.rail == 0 ? a_ : b_).derivatives(rail.u, 1);
    const auto tangent = rows[1];
    const Point p = a_.evaluate(rail.u);
    const Point q = b_.evaluate(rail.u);
    const auto [x, y] = axes_;
    const double value = tangent[x] * (q[y] - p[y]) - tangent[y] * (q[x] - p[x]);
    const double least = std::numeric_limits<double>::denorm_min();
    place.jacobian = sign > 0 ? std::max(value, least) : std::min(value, -least);
    return place;
  }

  [[nodiscard]] SurfacePlace on_boundary(const BoundaryPlace& place) const {
    return place.edge->along == Along::u ? at(place.t, place.edge->fixed) : at(place.edge->fixed, place.t);
  }

 private:
  const Curve& a_;
  const Curve& b_;
  const PlaneAxes& axes_;
};

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

}  // namespace

Verdict overall(const Certificate& certificate) noexcept {
  std::vector<Verdict> parts = {certificate.regular};
  if (certificate.one_to_one) parts.push_back(*certificate.one_to_one);
  if (certificate.tessellation_simple) parts.push_back(*certificate.tessellation_simple);
  const auto is = [](Verdict v) { return [v](Verdict part) { return part == v; }; };
  if (std::any_of(parts.begin(), parts.end(), is(Verdict::violated))) return Verdict::violated;
  return std::all_of(parts.begin(), parts.end(), is(Verdict::certified)) ? Verdict::certified
                                                                         : Verdict::undecided;
}

// Why a regular map with a simple boundary is one-to-one. Let the Jacobian be positive inside. Away from the
// image of the boundary, the number of times that a point is met is the winding number of the boundary about
// it (every place counts +1), which is 1 inside a simple closed curve, on the one side that has any, and 0
// outside: no point is met twice, and none outside is met at all. A place inside cannot lie on the curve,
// since its neighbourhood would reach outside. For a closed surface, an annulus, both curves are simple and
// disjoint. They must be nested: two disks beside each other would both be covered, and nothing between
// them. They must run the same way round: otherwise the inner disk would be covered twice, by two disks, and
// the ring once, and the Euler characteristic of the annulus would be 2 rather than 0. What is left is a ring
// that is covered once. Creases do no harm as long as the Jacobian is positive on both sides, nor do zeros on
// the boundary. Conversely a map whose Jacobian takes both signs is not one-to-one (an injective map of the
// plane has one local degree).
Certificate certify_planar_ruled(const Curve& a, const Curve& b, const PlaneAxes& axes) {
  const Rails rails = make_rails(plane_curve(a, axes), plane_curve(b, axes));
  const RuledPlaces places(a, b, axes);
  const JacobianSign jacobian = ruled_jacobian_sign(rails);
  Certificate result;
  result.regular = jacobian.verdict;
  result.one_to_one = Verdict::undecided;
  if (jacobian.positive && jacobian.negative) {
    result.one_to_one = Verdict::violated;
    result.witness = {WitnessKind::sign_change,
                      {places.on_rail(*jacobian.positive, 1), places.on_rail(*jacobian.negative, -1)},
                      {}};
    if (jacobian.rarer < 0) std::swap(result.witness->places[0], result.witness->places[1]);
  } else {
    if (jacobian.zero) result.witness = {WitnessKind::zero, {places.on_rail(*jacobian.zero, 0)}, {}};
    const std::vector<BoundaryLoop> loops = boundary_of(rails);
    const SimpleBoundary boundary = find_simple(loops);
    if (boundary.verdict == Verdict::violated) {
      result.one_to_one = Verdict::violated;
      if (!result.witness) {
        result.witness = {WitnessKind::crossing,
                          {places.on_boundary(boundary.places[0]), places.on_boundary(boundary.places[1])},
                          {}};
      }
    } else if (boundary.verdict == Verdict::certified && jacobian.sign != 0) {
      result.one_to_one = Verdict::certified;
    }
  }
  result.verdict = overall(result);
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
