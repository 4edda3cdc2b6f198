#include "match/curve_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Knots of the two curves this close, as a share of the domain, are one: composition keeps a breakpoint that
/// lies within 1e-12 of the domain from a knot.
constexpr double kSameKnot = 1e-12;
/// Movement over a span that is nothing but rounding, in units of the last place of the largest coordinate:
/// derivatives are differences of control points, a few roundings each.
constexpr double kStandsStill = 64.0;
/// Distances between the curves, in the same units, at which they meet and the chord has no direction.
constexpr double kMeet = 64.0;

/// Makes v a unit vector and returns its length; without overflow.
double normalise(double* v, std::size_t dim) {
  double largest = 0.0;
  for (std::size_t c = 0; c < dim; ++c) largest = std::max(largest, std::abs(v[c]));
  if (largest == 0.0) return 0.0;
  double sum = 0.0;
  for (std::size_t c = 0; c < dim; ++c) {
    v[c] /= largest;
    sum += v[c] * v[c];
  }
  const double length = std::sqrt(sum);
  for (std::size_t c = 0; c < dim; ++c) v[c] /= length;
  return largest * length;
}

double dot(const double* a, const double* b, std::size_t dim) {
  double sum = 0.0;
  for (std::size_t c = 0; c < dim; ++c) sum += a[c] * b[c];
  return sum;
}

double distance(const double* a, const double* b, std::size_t dim) {
  double sum = 0.0;
  for (std::size_t c = 0; c < dim; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return std::sqrt(sum);
}

double largest_coordinate(const Curve& curve) {
  double largest = 0.0;
  for (const double x : curve.control_points().data()) largest = std::max(largest, std::abs(x));
  return largest;
}

}  // namespace

CurvePair::OneCurve::OneCurve(const Curve& curve)
    : evaluator(curve),
      size(curve.extent() > 0.0 ? curve.extent() : 1.0),
      rounding(std::numeric_limits<double>::epsilon() * largest_coordinate(curve)) {}

CurvePair::CurvePair(const Curve& a, const Curve& b, NormKind norm, std::size_t slots)
    : dim_(static_cast<std::size_t>(a.dim())),
      ruled_(norm == NormKind::ruled),
      a_(a),
      b_(b),
      directions_(slots * 3 * dim_),
      scratch_(2 * dim_) {
  const Interval domain = a.domain();
  const double same = kSameKnot * domain.length();
  const std::vector<double>& knots_a = a.knots();
  const std::vector<double>& knots_b = b.knots();
  breaks_.push_back({domain.lo, b.domain().lo});
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < knots_a.size() || j < knots_b.size()) {
    const double u_a = i < knots_a.size() ? knots_a[i] : std::numeric_limits<double>::infinity();
    const double u_b = j < knots_b.size() ? knots_b[j] : std::numeric_limits<double>::infinity();
    const double u = std::min(u_a, u_b);
    if (u_a - u <= same) ++i;
    if (u_b - u <= same) ++j;
    if (u - breaks_.back().u_a <= same || domain.hi - u <= same) continue;
    breaks_.push_back({u_a - u <= same ? u_a : u, u_b - u <= same ? u_b : u});
  }
  breaks_.push_back({domain.hi, b.domain().hi});
}

void CurvePair::enter_span(std::size_t i) {
  span_ = i;
  a_.length = breaks_[i + 1].u_a - breaks_[i].u_a;
  b_.length = breaks_[i + 1].u_b - breaks_[i].u_b;
}

PairState CurvePair::at_start(std::size_t slot) {
  return look_at(slot, breaks_[span_].u_a, breaks_[span_].u_b, Side::right);
}

PairState CurvePair::at_end(std::size_t slot) {
  return look_at(slot, breaks_[span_ + 1].u_a, breaks_[span_ + 1].u_b, Side::left);
}

PairState CurvePair::inside(std::size_t slot, double u) {
  const PairState right = look_at(slot, u, u, Side::right);
  if (right.speed_a > 0.0 && right.speed_b > 0.0) return right;
  const double value = std::max(right.value[0], right.value[1]);
  const PairState left = look_at(slot, u, u, Side::left);
  return std::max(left.value[0], left.value[1]) <= value ? left : look_at(slot, u, u, Side::right);
}

double CurvePair::look(const OneCurve& curve, double u, Side side, double* position, double* direction) {
  curve.evaluator.point_and_derivative(u, side, {position, dim_}, {direction, dim_});
  const double speed = normalise(direction, dim_);
  if (speed * curve.length > kStandsStill * curve.rounding) return speed / curve.size;
  return limit(curve, u, side, direction);
}

/// The direction where the speed is zero; returns 0.
double CurvePair::limit(const OneCurve& curve, double u, Side side, double* direction) {
  // A rational curve may have derivatives beyond its degree; the direction never takes more than twice as
  // many.
  const int highest = 2 * curve.evaluator.degree();
  derivatives_.resize(static_cast<std::size_t>(highest + 1) * dim_);
  curve.evaluator.derivatives(u, highest, side, derivatives_);
  double scale = curve.length;
  double sign = side == Side::left ? -1.0 : 1.0;
  for (std::size_t order = 2; order <= static_cast<std::size_t>(highest); ++order) {
    scale *= curve.length / static_cast<double>(order);
    double* derivative = derivatives_.data() + order * dim_;
    if (normalise(derivative, dim_) * scale > kStandsStill * curve.rounding) {
      for (std::size_t c = 0; c < dim_; ++c) direction[c] = sign * derivative[c];
      return 0.0;
    }
    // Before the point the terms of even order (in the speed: odd) run the other way.
    if (side == Side::left) sign = -sign;
  }
  std::fill(direction, direction + dim_, 0.0);
  return 0.0;
}

PairState CurvePair::look_at(std::size_t slot, double u_a, double u_b, Side side) {
  double* tangent_a = directions_.data() + slot * 3 * dim_;
  double* tangent_b = tangent_a + dim_;
  double* chord = tangent_b + dim_;
  double* point_a = scratch_.data();
  double* point_b = point_a + dim_;
  PairState state;
  state.u = u_a;
  state.speed_a = look(a_, u_a, side, point_a, tangent_a);
  state.speed_b = look(b_, u_b, side, point_b, tangent_b);
  state.tangent_a = tangent_a;
  state.tangent_b = tangent_b;
  if (ruled_) {
    // Halved, the difference of two huge coordinates is finite.
    for (std::size_t c = 0; c < dim_; ++c) chord[c] = 0.5 * point_b[c] - 0.5 * point_a[c];
    if (normalise(chord, dim_) <= kMeet * std::max(a_.rounding, b_.rounding))
      std::fill(chord, chord + dim_, 0.0);
    state.chord = chord;
  }
  judge(state);
  return state;
}

void CurvePair::judge(PairState& state) const {
  const double* a = state.tangent_a;
  const double* b = state.tangent_b;
  // A curve that stands still has no tangent and contradicts none (spec C18).
  if (dot(a, a, dim_) == 0.0 || dot(b, b, dim_) == 0.0) return;
  const double product = std::clamp(dot(a, b, dim_), -1.0, 1.0);
  if (!ruled_ || dot(state.chord, state.chord, dim_) == 0.0) {
    // Both unit vectors: the value is positive while they are nearer to each other than the root of two.
    const double margin = std::sqrt(2.0) - std::sqrt(2.0 - 2.0 * product);
    for (const int sigma : {0, 1}) {
      state.value[sigma] = product;
      state.margin[sigma] = margin;
    }
  } else if (is_signed()) {
    const double* d = state.chord;
    const double first = d[0] * a[1] - d[1] * a[0];
    const double second = d[0] * b[1] - d[1] * b[0];
    const double size = std::abs(first * second);
    state.margin[0] = std::min(first, second);
    state.margin[1] = std::min(-first, -second);
    for (const int sigma : {0, 1}) state.value[sigma] = state.margin[sigma] > 0.0 ? size : -size;
  } else {
    const double value = product - dot(a, state.chord, dim_) * dot(b, state.chord, dim_);
    for (const int sigma : {0, 1}) state.value[sigma] = state.margin[sigma] = value;
  }
}

double CurvePair::turning(const PairState& from, const PairState& to) const {
  double sum = distance(from.tangent_a, to.tangent_a, dim_) + distance(from.tangent_b, to.tangent_b, dim_);
  // In R^n both tangents are compared with the chord.
  if (ruled_) sum += 2.0 * distance(from.chord, to.chord, dim_);
  return sum;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
