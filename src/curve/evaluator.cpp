#include "curve/evaluator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curve/scratch.h"
#include "tandem/curve/knots.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

constexpr std::size_t kStackDegree = 31;

// The degree + 1 B-splines that live on the span that starts at knot[0], at t in that span; and, if `slopes`
// is given, the `degree` B-splines of one degree less, each divided by the length of its support: what the
// derivative multiplies differences of control points with. (The NURBS Book, A2.2, as convex combinations.)
void basis(const double* knot, int degree, double t, double* value, double* slopes) {
  value[0] = 1.0;
  for (int j = 1; j <= degree; ++j) {
    double saved = 0.0;
    for (int r = 0; r < j; ++r) {
      const double lo = knot[r + 1 - j];
      const double length = knot[r + 1] - lo;
      const double upper = value[r] * ((t - lo) / length);
      if (slopes != nullptr && j == degree) slopes[r] = value[r] / length;
      value[r] = saved + (value[r] - upper);
      saved = upper;
    }
    value[j] = saved;
  }
}

double saturated(double x) {
  constexpr double kMax = std::numeric_limits<double>::max();
  if (std::abs(x) <= kMax) return x;
  if (std::isnan(x)) return 0.0;
  return x > 0.0 ? kMax : -kMax;
}

}  // namespace

Evaluator::Evaluator(const Curve& curve) noexcept
    : knots_(curve.knots().data()),
      points_(curve.control_points().data().data()),
      weights_(curve.is_rational() ? curve.weights().data() : nullptr),
      size_(curve.size()),
      degree_(curve.degree()),
      dim_(curve.dim()),
      domain_(curve.domain()) {}

std::size_t Evaluator::span_at(double t, Side side) const noexcept {
  const std::span<const double> knots(knots_, size_ + static_cast<std::size_t>(degree_) + 1);
  std::size_t k = find_span(knots, degree_, t);
  if (side == Side::left && t == knots_[k] && t > domain_.lo) {
    while (knots_[k] == t) --k;
  }
  return k;
}

void Evaluator::point(double t, std::span<double> p) const {
  t = domain_.clamp(t);
  const std::size_t k = span_at(t, Side::right);
  const auto order = static_cast<std::size_t>(degree_) + 1;
  const auto dim = static_cast<std::size_t>(dim_);
  const std::size_t first = k + 1 - order;
  Scratch<kStackDegree + 1> value(order);
  basis(knots_ + k, degree_, t, value.data(), nullptr);
  if (weights_ != nullptr) {
    double sum = 0.0;
    for (std::size_t i = 0; i < order; ++i) sum += value[i] *= weights_[first + i];
    for (std::size_t i = 0; i < order; ++i) value[i] /= sum;
  }
  for (std::size_t c = 0; c < dim; ++c) p[c] = 0.0;
  const double* at = points_ + first * dim;
  for (std::size_t i = 0; i < order; ++i, at += dim) {
    for (std::size_t c = 0; c < dim; ++c) p[c] += value[i] * at[c];
  }
}

void Evaluator::point_and_derivative(double t, Side side, std::span<double> p, std::span<double> d) const {
  t = domain_.clamp(t);
  const std::size_t k = span_at(t, side);
  const auto degree = static_cast<std::size_t>(degree_);
  const auto dim = static_cast<std::size_t>(dim_);
  const std::size_t first = k - degree;
  Scratch<kStackDegree + 1> value(degree + 1);
  Scratch<kStackDegree + 1> slope(degree + 1);
  basis(knots_ + k, degree_, t, value.data(), slope.data());
  for (std::size_t i = 0; i < degree; ++i) slope[i] *= degree_;

  const double* at = points_ + first * dim;
  for (std::size_t c = 0; c < dim; ++c) p[c] = d[c] = 0.0;
  if (weights_ == nullptr) {
    for (std::size_t i = 0; i <= degree; ++i) {
      for (std::size_t c = 0; c < dim; ++c) p[c] += value[i] * at[i * dim + c];
    }
    for (std::size_t i = 0; i < degree; ++i) {
      for (std::size_t c = 0; c < dim; ++c) d[c] += slope[i] * (at[(i + 1) * dim + c] - at[i * dim + c]);
    }
  } else {
    const double* w = weights_ + first;
    double sum = 0.0;
    for (std::size_t i = 0; i <= degree; ++i) sum += value[i] *= w[i];
    for (std::size_t i = 0; i <= degree; ++i) value[i] /= sum;
    for (std::size_t i = 0; i <= degree; ++i) {
      for (std::size_t c = 0; c < dim; ++c) p[c] += value[i] * at[i * dim + c];
    }
    // With the origin at the point itself the quotient rule loses its second term, and with it the
    // cancellation.
    for (std::size_t i = 0; i < degree; ++i) {
      for (std::size_t c = 0; c < dim; ++c) {
        d[c] += slope[i] * (w[i + 1] * (at[(i + 1) * dim + c] - p[c]) - w[i] * (at[i * dim + c] - p[c]));
      }
    }
    for (std::size_t c = 0; c < dim; ++c) d[c] /= sum;
  }
  for (std::size_t c = 0; c < dim; ++c) d[c] = saturated(d[c]);
}

void Evaluator::derivatives(double t, int order, Side side, std::span<double> rows) const {
  const auto degree = static_cast<std::size_t>(degree_);
  const auto dim = static_cast<std::size_t>(dim_);
  std::fill(rows.begin(), rows.end(), 0.0);
  point(t, rows.first(dim));
  if (order < 1) return;

  t = domain_.clamp(t);
  const std::size_t k = span_at(t, side);
  const std::size_t stride = dim + 1;
  // Local coefficients, premultiplied and with the origin at the point (see point_and_derivative), weight
  // last.
  Scratch<(kStackDegree + 1) * 4> local((degree + 1) * stride);
  Scratch<kStackDegree + 1> value(degree + 1);
  Scratch<64> weight(static_cast<std::size_t>(order) + 1);
  for (std::size_t i = 0; i <= degree; ++i) {
    const std::size_t at = k - degree + i;
    const double w = weights_ == nullptr ? 1.0 : weights_[at];
    for (std::size_t c = 0; c < dim; ++c) local[i * stride + c] = w * (points_[at * dim + c] - rows[c]);
    local[i * stride + dim] = w;
  }
  basis(knots_ + k, degree_, t, value.data(), nullptr);
  weight[0] = 0.0;
  for (std::size_t i = 0; i <= degree; ++i) weight[0] += value[i] * local[i * stride + dim];

  for (std::size_t r = 1; r <= static_cast<std::size_t>(order); ++r) {
    double* row = rows.data() + r * dim;
    weight[r] = 0.0;
    if (r <= degree) {
      const std::size_t left = degree - r;  // degree of the r-th derivative
      for (std::size_t i = 0; i <= left; ++i) {
        const double length = knots_[k + 1 + i] - knots_[k - left + i];
        const double factor = static_cast<double>(left + 1);
        for (std::size_t c = 0; c < stride; ++c) {
          local[i * stride + c] = factor * ((local[(i + 1) * stride + c] - local[i * stride + c]) / length);
        }
      }
      basis(knots_ + k, static_cast<int>(left), t, value.data(), nullptr);
      for (std::size_t i = 0; i <= left; ++i) {
        for (std::size_t c = 0; c < dim; ++c) row[c] += value[i] * local[i * stride + c];
        weight[r] += value[i] * local[i * stride + dim];
      }
    }
    if (weights_ != nullptr) {
      double binomial = 1.0;
      for (std::size_t j = 1; j < r; ++j) {
        binomial *= static_cast<double>(r - j + 1) / static_cast<double>(j);
        for (std::size_t c = 0; c < dim; ++c) row[c] -= binomial * weight[j] * rows[(r - j) * dim + c];
      }
      for (std::size_t c = 0; c < dim; ++c) row[c] /= weight[0];
    }
    for (std::size_t c = 0; c < dim; ++c) row[c] = saturated(row[c]);
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
