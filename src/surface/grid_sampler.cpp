#include "surface/grid_sampler.h"

#include <algorithm>

#include "curve/local_spline.h"
#include "curve/scratch.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// The span that t lies in; its first control point.
std::size_t first_of_span(const Surface& surface, Along along, double t) {
  const int degree = surface.degree(along);
  return span_on_side(surface.knots(along), degree, t, Side::right) - static_cast<std::size_t>(degree);
}

void basis_at(const Surface& surface, Along along, std::size_t first, double t, double* values) {
  const int degree = surface.degree(along);
  basis(surface.knots(along).data() + first + static_cast<std::size_t>(degree), degree, t, values, nullptr);
}

}  // namespace

GridSampler::GridSampler(const ScaledSurface& surface)
    : surface_(surface.surface()), stride_(surface_.is_rational() ? 4 : 3) {
  const std::vector<double>& weights = surface_.weights();
  const double heaviest = weights.empty() ? 1.0 : *std::max_element(weights.begin(), weights.end());
  const std::size_t count = surface_.control_points().size();
  control_.resize(count * stride_);
  for (std::size_t k = 0; k < count; ++k) {
    const double weight = weights.empty() ? 1.0 : weights[k] / heaviest;
    const Vector3 point = surface.scaled(surface_.control_points()[k]);
    for (std::size_t c = 0; c < 3; ++c) control_[k * stride_ + c] = weight * point[c];
    if (stride_ == 4) control_[k * stride_ + 3] = weight;
  }
}

void GridSampler::set_rows(std::span<const double> u) {
  const std::size_t line = surface_.size(Along::v) * stride_;
  const auto order = static_cast<std::size_t>(surface_.degree(Along::u)) + 1;
  Scratch<kStackDegree + 1> values(order);
  lines_.assign(u.size() * line, 0.0);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double t = surface_.domain(Along::u).clamp(u[i]);
    const std::size_t first = first_of_span(surface_, Along::u, t);
    basis_at(surface_, Along::u, first, t, values.data());
    double* to = lines_.data() + i * line;
    for (std::size_t k = 0; k < order; ++k) {
      const double* from = control_.data() + (first + k) * line;
      for (std::size_t c = 0; c < line; ++c) to[c] += values[k] * from[c];
    }
  }
}

void GridSampler::set_columns(std::span<const double> v) {
  const auto order = static_cast<std::size_t>(surface_.degree(Along::v)) + 1;
  first_.resize(v.size());
  basis_.resize(v.size() * order);
  for (std::size_t j = 0; j < v.size(); ++j) {
    const double t = surface_.domain(Along::v).clamp(v[j]);
    first_[j] = first_of_span(surface_, Along::v, t);
    basis_at(surface_, Along::v, first_[j], t, basis_.data() + j * order);
  }
}

Vector3 GridSampler::at(std::size_t i, std::size_t j) const {
  const auto order = static_cast<std::size_t>(surface_.degree(Along::v)) + 1;
  const double* values = basis_.data() + j * order;
  const double* from = lines_.data() + (i * surface_.size(Along::v) + first_[j]) * stride_;
  Vector3 point{};
  double weight = 0.0;
  for (std::size_t k = 0; k < order; ++k, from += stride_) {
    for (std::size_t c = 0; c < 3; ++c) point[c] += values[k] * from[c];
    if (stride_ == 4) weight += values[k] * from[3];
  }
  return stride_ == 4 ? 1.0 / weight * point : point;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
