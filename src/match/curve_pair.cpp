#include "match/curve_pair.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "match/vector.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Knots of the two curves this close, as a share of the domain, are one: composition keeps a breakpoint that
/// lies within 1e-12 of the domain from a knot.
constexpr double kSameKnot = 1e-12;
/// Distances between the curves, in the same units, at which they meet and the chord has no direction.
constexpr double kMeet = 64.0;

double dot(const double* a, const double* b, std::size_t dim) {
  return detail::dot(std::span(a, dim), std::span(b, dim));
}

/// Between unit vectors, where nothing overflows.
double unit_distance(const double* a, const double* b, std::size_t dim) {
  double sum = 0.0;
  for (std::size_t c = 0; c < dim; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return std::sqrt(sum);
}

}  // namespace

CurvePair::CurvePair(const Curve& a, const Curve& b, NormKind norm, std::size_t chords, std::size_t slots)
    : dim_(static_cast<std::size_t>(a.dim())),
      ruled_(norm == NormKind::ruled),
      chords_(chords),
      a_(a, chords),
      b_(b, chords),
      directions_(slots * 3 * dim_),
      points_(2 * dim_) {
  const std::vector<Break>& knots_a = a_.breaks();
  const std::vector<Break>& knots_b = b_.breaks();
  const double same = kSameKnot * a.domain().length();
  double lo = a.domain().lo;
  for (std::size_t i = 0, j = 0; i + 1 < knots_a.size() && j + 1 < knots_b.size();) {
    const double end_a = knots_a[i + 1].value;
    const double end_b = knots_b[j + 1].value;
    const double hi = std::min(end_a, end_b);
    if (hi - lo > same) {
      spans_.push_back({{lo, hi}, i, j});
      lo = hi;
    }
    if (end_a - hi <= same) ++i;
    if (end_b - hi <= same) ++j;
  }
  // A domain that is all rounding has one span at least.
  if (spans_.empty()) spans_.push_back({a.domain(), 0, 0});
}

void CurvePair::enter_span(std::size_t i) {
  span_ = spans_[i];
  a_.enter(span_.piece_a, span_.u);
  b_.enter(span_.piece_b, span_.u);
}

PairState CurvePair::at_node(std::size_t slot, std::size_t k) {
  const double share = static_cast<double>(k) / static_cast<double>(chords_);
  const SpanPlace place{k == chords_ ? span_.u.hi : span_.u.lo + share * span_.u.length(), k};
  if (k == 0) return look(slot, place, Side::right);
  if (k == chords_) return look(slot, place, Side::left);
  return look_from_both_sides(slot, place);
}

PairState CurvePair::look_from_both_sides(std::size_t slot, const SpanPlace& place) {
  const PairState right = look(slot, place, Side::right);
  if (right.speed_a > 0.0 && right.speed_b > 0.0) return right;
  const double value = std::max(right.value[0], right.value[1]);
  const PairState left = look(slot, place, Side::left);
  return std::max(left.value[0], left.value[1]) <= value ? left : look(slot, place, Side::right);
}

PairState CurvePair::look(std::size_t slot, const SpanPlace& place, Side side) {
  double* tangent_a = directions_.data() + slot * 3 * dim_;
  double* tangent_b = tangent_a + dim_;
  double* chord = tangent_b + dim_;
  double* point_a = ruled_ ? points_.data() : nullptr;
  double* point_b = ruled_ ? point_a + dim_ : nullptr;
  PairState state;
  state.u = place.u;
  state.speed_a = a_.look(place, side, tangent_a, point_a);
  state.speed_b = b_.look(place, side, tangent_b, point_b);
  state.tangent_a = tangent_a;
  state.tangent_b = tangent_b;
  if (ruled_) {
    // Halved, the difference of two huge coordinates is finite.
    for (std::size_t c = 0; c < dim_; ++c) chord[c] = 0.5 * point_b[c] - 0.5 * point_a[c];
    const double half = normalize({chord, dim_});
    if (half <= kMeet * std::max(a_.rounding(), b_.rounding())) std::fill(chord, chord + dim_, 0.0);
    state.chord = chord;
    const double unit = std::max(a_.size(), b_.size());
    state.gap = 2.0 * (half / unit);
    const double speed_a = state.speed_a * (a_.size() / unit);
    const double speed_b = state.speed_b * (b_.size() / unit);
    double square = 0.0;
    for (std::size_t c = 0; c < dim_; ++c) {
      const double change = speed_b * tangent_b[c] - speed_a * tangent_a[c];
      square += change * change;
    }
    state.gap_speed = std::sqrt(square);
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
    const double margin = ruled_ ? std::sqrt(2.0) - std::sqrt(2.0 - 2.0 * product) : product;
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

bool CurvePair::certainly_positive(const Interval& part) {
  if (ruled_) return false;
  const std::vector<double>& edges_a = a_.edges(part);
  const std::vector<double>& edges_b = b_.edges(part);
  // A zero edge gives no direction to any tangent.
  const auto is_zero = [this](const double* edge) {
    return std::all_of(edge, edge + dim_, [](double x) { return x == 0.0; });
  };
  for (std::size_t i = 0; i < edges_a.size(); i += dim_) {
    const double* edge_a = edges_a.data() + i;
    for (std::size_t j = 0; j < edges_b.size(); j += dim_) {
      const double* edge_b = edges_b.data() + j;
      if (!(dot(edge_a, edge_b, dim_) > 0.0) && !is_zero(edge_a) && !is_zero(edge_b)) return false;
    }
  }
  return true;
}

double CurvePair::turning(const PairState& from, const PairState& to) const {
  double sum =
      unit_distance(from.tangent_a, to.tangent_a, dim_) + unit_distance(from.tangent_b, to.tangent_b, dim_);
  // In R^n both tangents are compared with the chord.
  if (ruled_) sum += 2.0 * unit_distance(from.chord, to.chord, dim_);
  return sum;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
