#include "match/span_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "match/vector.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Movement over a piece that is nothing but rounding, in units of the last place of the largest coordinate:
/// derivatives are differences of control points, a few roundings each.
constexpr double kStandsStill = 64.0;

/// A rational curve's derivative is a difference over the weight: small weights magnify what cancels among
/// large ones.
double weight_ratio(const Curve& curve) {
  if (!curve.is_rational()) return 1.0;
  const auto [least, greatest] = std::minmax_element(curve.weights().begin(), curve.weights().end());
  return *greatest / *least;
}

/// The degree + 1 Bernstein polynomials at s.
void bernstein(double* value, std::size_t degree, double s) {
  value[0] = 1.0;
  for (std::size_t j = 1; j <= degree; ++j) {
    double saved = 0.0;
    for (std::size_t r = 0; r < j; ++r) {
      const double upper = s * value[r];
      value[r] = saved + (1.0 - s) * value[r];
      saved = upper;
    }
    value[j] = saved;
  }
}

/// De Casteljau at s, which keeps the Bezier points of [s, 1] in place.
void keep_right(std::vector<double>& points, std::size_t degree, std::size_t stride, double s) {
  for (std::size_t left = degree; left > 0; --left) {
    for (std::size_t k = 0; k < left * stride; ++k)
      points[k] = (1.0 - s) * points[k] + s * points[k + stride];
  }
}

/// The same for [0, s].
void keep_left(std::vector<double>& points, std::size_t degree, std::size_t stride, double s) {
  for (std::size_t first = 1; first <= degree; ++first) {
    for (std::size_t k = (degree + 1) * stride; k-- > first * stride;) {
      points[k] = (1.0 - s) * points[k - stride] + s * points[k];
    }
  }
}

/// Bezier points over `whole`, to those over `part` of it.
void restrict_to(const Interval& part, const Interval& whole, std::vector<double>& points, std::size_t degree,
                 std::size_t stride) {
  const double hi = std::min(part.hi, whole.hi);
  if (hi < whole.hi) keep_left(points, degree, stride, (hi - whole.lo) / whole.length());
  if (part.lo > whole.lo) keep_right(points, degree, stride, (part.lo - whole.lo) / (hi - whole.lo));
}

}  // namespace

SpanCurve::SpanCurve(const Curve& curve, std::size_t chords)
    : evaluator_(curve),
      pieces_(decompose(premultiplied(curve))),
      dim_(static_cast<std::size_t>(curve.dim())),
      degree_(static_cast<std::size_t>(curve.degree())),
      stride_(static_cast<std::size_t>(pieces_.stride)),
      chords_(chords),
      size_(curve.extent() > 0.0 ? curve.extent() : 1.0),
      rounding_(std::numeric_limits<double>::epsilon() * largest(curve.control_points().data()) *
                weight_ratio(curve)),
      coefficients_(pieces_.piece_length()),
      differences_(degree_ * stride_),
      lower_((chords + 2) * degree_),
      upper_((chords + 2) * (degree_ + 1)),
      part_(coefficients_.size()),
      edges_(degree_ * dim_),
      workspace_((2 * degree_ + 1) * dim_) {
  // Both curves in their own units: the chord between them is asked for.
  if (pieces_.scale != 1.0) {
    for (std::size_t k = 0; k < pieces_.coefficients.size(); ++k) {
      if (k % stride_ < dim_) pieces_.coefficients[k] /= pieces_.scale;
    }
  }
  for (std::size_t k = 0; k <= chords; ++k) {
    const double s = static_cast<double>(k) / static_cast<double>(chords);
    bernstein(lower_.data() + k * degree_, degree_ - 1, s);
    bernstein(upper_.data() + k * (degree_ + 1), degree_, s);
  }
}

void SpanCurve::enter(std::size_t i, const Interval& span) {
  span_ = span;
  const Interval whole{pieces_.breaks[i].value, pieces_.breaks[i + 1].value};
  std::copy(pieces_[i], pieces_[i] + coefficients_.size(), coefficients_.begin());
  restrict_to(span, whole, coefficients_, degree_, stride_);
  for (std::size_t k = 0; k < differences_.size(); ++k) {
    differences_[k] = static_cast<double>(degree_) * (coefficients_[k + stride_] - coefficients_[k]);
  }
}

const std::vector<double>& SpanCurve::edges(const Interval& part) {
  part_ = coefficients_;
  restrict_to(part, span_, part_, degree_, stride_);
  for (std::size_t k = 0; k < degree_; ++k) {
    const double* from = part_.data() + k * stride_;
    const double* to = from + stride_;
    const double weight_from = pieces_.rational ? from[dim_] : 1.0;
    const double weight_to = pieces_.rational ? to[dim_] : 1.0;
    for (std::size_t c = 0; c < dim_; ++c) {
      edges_[k * dim_ + c] = (to[c] / weight_to - from[c] / weight_from) / size_;
    }
  }
  return edges_;
}

double SpanCurve::look(const SpanPlace& place, Side side, double* tangent, double* point) {
  std::size_t node = place.node;
  if (node == SpanPlace::kNoNode) {
    node = chords_ + 1;
    const double s = std::clamp((place.u - span_.lo) / span_.length(), 0.0, 1.0);
    bernstein(lower_.data() + node * degree_, degree_ - 1, s);
    bernstein(upper_.data() + node * (degree_ + 1), degree_, s);
  }
  const double moved =
      movement(lower_.data() + node * degree_, upper_.data() + node * (degree_ + 1), tangent, point);
  if (moved > kStandsStill * rounding_) return moved / size_ / span_.length();
  return limit(place.u, side, tangent);
}

/// Unit tangent and point from the Bernstein polynomials; returns the speed per span.
double SpanCurve::movement(const double* lower, const double* upper, double* tangent, double* point) {
  const auto sum = [this](const double* basis, std::size_t count, const double* coefficients) {
    double result = 0.0;
    for (std::size_t i = 0; i < count; ++i) result += basis[i] * coefficients[i * stride_];
    return result;
  };
  // In the plane two numbers stay in registers; written first and normalised then, they would be read back as
  // one vector, which waits for both stores: measured, this half of the work then takes three times as long.
  if (dim_ == 2 && !pieces_.rational) {
    if (point != nullptr) {
      point[0] = sum(upper, degree_ + 1, coefficients_.data());
      point[1] = sum(upper, degree_ + 1, coefficients_.data() + 1);
    }
    const double x = sum(lower, degree_, differences_.data());
    const double y = sum(lower, degree_, differences_.data() + 1);
    const double square = x * x + y * y;
    // Neither overflowed nor short of digits.
    if (square > 1e-250 && square < 1e250) {
      const double length = std::sqrt(square);
      tangent[0] = x / length;
      tangent[1] = y / length;
      return length;
    }
  }
  for (std::size_t c = 0; c < dim_; ++c) tangent[c] = sum(lower, degree_, differences_.data() + c);
  if (point != nullptr || pieces_.rational) {
    double* at = point != nullptr ? point : workspace_.data();
    for (std::size_t c = 0; c < dim_; ++c) at[c] = sum(upper, degree_ + 1, coefficients_.data() + c);
    if (pieces_.rational) {
      const double weight = sum(upper, degree_ + 1, coefficients_.data() + dim_);
      const double slope = sum(lower, degree_, differences_.data() + dim_);
      for (std::size_t c = 0; c < dim_; ++c) {
        at[c] /= weight;
        tangent[c] = (tangent[c] - slope * at[c]) / weight;
      }
    }
  }
  return normalize({tangent, dim_});
}

double SpanCurve::limit(double u, Side side, double* tangent) {
  // A rational curve has derivatives beyond its degree, but its direction never takes more than twice as
  // many.
  const int highest = 2 * static_cast<int>(degree_);
  evaluator_.derivatives(u, highest, side, workspace_);
  double scale = span_.length();
  double sign = side == Side::left ? -1.0 : 1.0;
  for (std::size_t order = 2; order <= static_cast<std::size_t>(highest); ++order) {
    scale *= span_.length() / static_cast<double>(order);
    double* derivative = workspace_.data() + order * dim_;
    if (normalize({derivative, dim_}) * scale > kStandsStill * rounding_) {
      for (std::size_t c = 0; c < dim_; ++c) tangent[c] = sign * derivative[c];
      return 0.0;
    }
    // Seen from the left, C'(t - h) = (-h)^(order - 1) C^(order) / (order - 1)!
    if (side == Side::left) sign = -sign;
  }
  std::fill(tangent, tangent + dim_, 0.0);
  return 0.0;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
