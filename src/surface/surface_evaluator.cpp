#include "surface/surface_evaluator.h"

#include <algorithm>

#include "curve/local_spline.h"
#include "curve/scratch.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Of the scratch arrays: bicubic surfaces in R^3, rational, with second derivatives, need no more.
constexpr std::size_t kStackNumbers = 256;

// Row of the derivative k times by u and l times by v.
constexpr std::size_t row_of(std::size_t k, std::size_t l) {
  return (k + l) * (k + l + 1) / 2 + l;
}

double binomial(std::size_t n, std::size_t k) {
  double value = 1.0;
  for (std::size_t i = 1; i <= k; ++i)
    value = value * static_cast<double>(n - k + i) / static_cast<double>(i);
  return value;
}

/// Where a parameter lies among the knots.
struct Place {
  const double* knot;  ///< that starts the span
  std::size_t first;   ///< control point of the span
  int degree;
  double t;

  Place(const Surface& surface, Along along, double at, Side side)
      : degree(surface.degree(along)), t(surface.domain(along).clamp(at)) {
    const std::vector<double>& knots = surface.knots(along);
    const std::size_t k = span_on_side(knots, degree, t, side);
    knot = knots.data() + k;
    first = k - static_cast<std::size_t>(degree);
  }
  [[nodiscard]] std::size_t count() const noexcept { return static_cast<std::size_t>(degree) + 1; }
};

}  // namespace

void SurfaceEvaluator::point(double u, double v, std::span<double> p) const {
  const Place in_u(surface_, Along::u, u, Side::right);
  const Place in_v(surface_, Along::v, v, Side::right);
  Scratch<kStackDegree + 1> along_u(in_u.count());
  Scratch<kStackDegree + 1> along_v(in_v.count());
  basis(in_u.knot, in_u.degree, in_u.t, along_u.data(), nullptr);
  basis(in_v.knot, in_v.degree, in_v.t, along_v.data(), nullptr);
  const std::size_t columns = surface_.size(Along::v);
  const std::vector<double>& weights = surface_.weights();
  const auto share = [&](std::size_t i, std::size_t j, std::size_t at) {
    return along_u[i] * along_v[j] * (weights.empty() ? 1.0 : weights[at]);
  };
  double sum = 0.0;
  std::fill(p.begin(), p.end(), 0.0);
  for (const bool weighing : {true, false}) {
    if (weighing && weights.empty()) {
      sum = 1.0;
      continue;
    }
    for (std::size_t i = 0; i < in_u.count(); ++i) {
      for (std::size_t j = 0; j < in_v.count(); ++j) {
        const std::size_t at = (in_u.first + i) * columns + in_v.first + j;
        if (weighing) {
          sum += share(i, j, at);
          continue;
        }
        // Shares are divided, not sums: a convex combination stays in the hull.
        const double of_all = share(i, j, at) / sum;
        const auto from = surface_.control_points()[at];
        for (std::size_t c = 0; c < p.size(); ++c) p[c] += of_all * from[c];
      }
    }
  }
}

void SurfaceEvaluator::derivatives(double u, double v, int order, SurfaceSides sides,
                                   std::span<double> rows) const {
  const auto dim = static_cast<std::size_t>(surface_.dim());
  const std::span<double> origin = rows.first(dim);
  point(u, v, origin);
  if (order < 1) return;

  const Place in_u(surface_, Along::u, u, sides.u);
  const Place in_v(surface_, Along::v, v, sides.v);
  const std::size_t columns = surface_.size(Along::v);
  const std::size_t stride = dim + 1;
  const std::size_t line = in_v.count() * stride;
  const std::size_t orders = static_cast<std::size_t>(order) + 1;
  // Premultiplied and with the origin at the point, weight last: the quotient rule then loses its largest
  // term, and with it the cancellation.
  Scratch<kStackNumbers> local(in_u.count() * line);
  for (std::size_t i = 0; i < in_u.count(); ++i) {
    for (std::size_t j = 0; j < in_v.count(); ++j) {
      const std::size_t at = (in_u.first + i) * columns + in_v.first + j;
      const double w = surface_.is_rational() ? surface_.weights()[at] : 1.0;
      double* out = local.data() + i * line + j * stride;
      for (std::size_t c = 0; c < dim; ++c) out[c] = w * (surface_.control_points()[at][c] - origin[c]);
      out[dim] = w;
    }
  }
  Scratch<kStackNumbers> by_u(orders * line);
  local_derivatives(in_u.knot, in_u.degree, in_u.t, order, line, local.data(), by_u.data());
  // raw[k][l]: of the premultiplied surface.
  Scratch<kStackNumbers> raw(orders * orders * stride);
  for (std::size_t k = 0; k < orders; ++k) {
    local_derivatives(in_v.knot, in_v.degree, in_v.t, order - static_cast<int>(k), stride,
                      by_u.data() + k * line, raw.data() + k * orders * stride);
  }
  const auto at = [&](std::size_t k, std::size_t l) { return raw.data() + (k * orders + l) * stride; };
  // The NURBS Book, A4.4, but for the terms of S itself, which is the origin here.
  for (std::size_t n = 1; n < orders; ++n) {
    for (std::size_t l = 0; l <= n; ++l) {
      const std::size_t k = n - l;
      double* row = rows.data() + row_of(k, l) * dim;
      std::copy(at(k, l), at(k, l) + dim, row);
      if (!surface_.is_rational()) continue;
      for (std::size_t i = 0; i <= k; ++i) {
        for (std::size_t j = 0; j <= l; ++j) {
          if (i + j == 0 || i + j == n) continue;
          const double factor = binomial(k, i) * binomial(l, j) * at(i, j)[dim];
          const double* lower = rows.data() + row_of(k - i, l - j) * dim;
          for (std::size_t c = 0; c < dim; ++c) row[c] -= factor * lower[c];
        }
      }
      for (std::size_t c = 0; c < dim; ++c) row[c] /= at(0, 0)[dim];
    }
  }
  for (double& x : rows.subspan(dim)) x = saturated(x);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
