#include "curve/evaluator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curve/local_spline.h"
#include "curve/scratch.h"
#include "tandem/curve/knots.h"

namespace tandem {
inline namespace v0 {
namespace detail {
Evaluator::Evaluator(const Curve& curve) noexcept
    : knots_(curve.knots().data()),
      points_(curve.control_points().data().data()),
      weights_(curve.is_rational() ? curve.weights().data() : nullptr),
      size_(curve.size()),
      degree_(curve.degree()),
      dim_(curve.dim()),
      domain_(curve.domain()) {}

std::size_t Evaluator::span_at(double t, Side side) const noexcept {
  return span_on_side({knots_, size_ + static_cast<std::size_t>(degree_) + 1}, degree_, t, side);
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
  Scratch<64> raw((static_cast<std::size_t>(order) + 1) * stride);
  for (std::size_t i = 0; i <= degree; ++i) {
    const std::size_t at = k - degree + i;
    const double w = weights_ == nullptr ? 1.0 : weights_[at];
    for (std::size_t c = 0; c < dim; ++c) local[i * stride + c] = w * (points_[at * dim + c] - rows[c]);
    local[i * stride + dim] = w;
  }
  local_derivatives(knots_ + k, degree_, t, order, stride, local.data(), raw.data());

  const auto weight = [&](std::size_t r) { return raw[r * stride + dim]; };
  for (std::size_t r = 1; r <= static_cast<std::size_t>(order); ++r) {
    double* row = rows.data() + r * dim;
    std::copy(raw.data() + r * stride, raw.data() + r * stride + dim, row);
    if (weights_ != nullptr) {
      double binomial = 1.0;
      for (std::size_t j = 1; j < r; ++j) {
        binomial *= static_cast<double>(r - j + 1) / static_cast<double>(j);
        for (std::size_t c = 0; c < dim; ++c) row[c] -= binomial * weight(j) * rows[(r - j) * dim + c];
      }
      for (std::size_t c = 0; c < dim; ++c) row[c] /= weight(0);
    }
    for (std::size_t c = 0; c < dim; ++c) row[c] = saturated(row[c]);
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
