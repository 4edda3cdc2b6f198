#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "curve/norm.h"
#include "curve/spline.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

struct Removal {
  Spline spline;
  double deviation = std::numeric_limits<double>::infinity();
};

// One removal of an interior knot. With Q over the fewer knots, inserting the knot again would give
// P_i = a_i Q_i + (1 - a_i) Q_(i-1) for i in [first, last]: one equation more than there are unknown Q. They
// are solved from both sides, and the equation that is left over where the two meet is the one that fails
// least.
class KnotRemover {
 public:
  KnotRemover(const Spline& spline, double t) : spline_(spline), t_(t) {
    const auto p = static_cast<std::size_t>(spline.degree);
    const auto at = std::upper_bound(spline.knots.begin(), spline.knots.end(), t);
    const auto index = static_cast<std::size_t>(at - spline.knots.begin()) - 1;
    const auto copies = static_cast<std::size_t>(multiplicity(spline.knots, t));
    knots_ = spline.knots;
    knots_.erase(knots_.begin() + static_cast<std::ptrdiff_t>(index));
    // index - 1 is the span of t among the fewer knots, copies - 1 its multiplicity there.
    first_ = index - p;
    last_ = index - copies;
  }

  [[nodiscard]] Removal remove() const {
    const auto stride = static_cast<std::size_t>(spline_.stride);
    const std::size_t unknown = last_ - first_;  // Q_first .. Q_(last - 1)
    std::vector<double> from_left((unknown + 1) * stride);
    std::vector<double> from_right((unknown + 1) * stride);
    // Row 0 of from_left is Q_(first - 1), the last row of from_right is Q_last: those are given.
    std::copy_n(spline_[first_ - 1], stride, from_left.begin());
    std::copy_n(spline_[last_ + 1], stride, from_right.end() - static_cast<std::ptrdiff_t>(stride));
    for (std::size_t k = 0; k < unknown; ++k) {
      const double a = share(first_ + k);
      for (std::size_t c = 0; c < stride; ++c) {
        from_left[(k + 1) * stride + c] =
            (spline_[first_ + k][c] - (1.0 - a) * from_left[k * stride + c]) / a;
      }
    }
    for (std::size_t k = unknown; k > 0; --k) {
      const double a = share(first_ + k);
      for (std::size_t c = 0; c < stride; ++c) {
        from_right[(k - 1) * stride + c] =
            (spline_[first_ + k][c] - a * from_right[k * stride + c]) / (1.0 - a);
      }
    }
    Removal best;
    for (std::size_t k = 0; k <= unknown; ++k) {
      Removal removal = joined(from_left, from_right, k);
      if (removal.deviation < best.deviation) best = std::move(removal);
    }
    return best;
  }

 private:
  // a_i of the insertion of t into the fewer knots.
  [[nodiscard]] double share(std::size_t i) const {
    const double lo = knots_[i];
    return (t_ - lo) / (knots_[i + static_cast<std::size_t>(spline_.degree)] - lo);
  }

  // Q from the left up to Q_(first + k - 1), from the right after it; equation first + k is left over.
  [[nodiscard]] Removal joined(const std::vector<double>& from_left, const std::vector<double>& from_right,
                               std::size_t k) const {
    const auto stride = static_cast<std::size_t>(spline_.stride);
    const std::size_t unknown = last_ - first_;
    Removal removal;
    Spline& q = removal.spline;
    q.degree = spline_.degree;
    q.stride = spline_.stride;
    q.rational = spline_.rational;
    q.scale = spline_.scale;
    const auto offset = [&](std::size_t i) {
      return spline_.coefficients.begin() + static_cast<std::ptrdiff_t>(i * stride);
    };
    q.coefficients.assign(offset(0), offset(first_));
    q.coefficients.insert(q.coefficients.end(), from_left.begin() + static_cast<std::ptrdiff_t>(stride),
                          from_left.begin() + static_cast<std::ptrdiff_t>((k + 1) * stride));
    q.coefficients.insert(q.coefficients.end(), from_right.begin() + static_cast<std::ptrdiff_t>(k * stride),
                          from_right.begin() + static_cast<std::ptrdiff_t>(unknown * stride));
    q.coefficients.insert(q.coefficients.end(), offset(last_ + 1), spline_.coefficients.end());
    removal.deviation =
        residual(from_left.data() + k * stride, from_right.data() + k * stride, first_ + k, q);
    q.knots = knots_;
    return removal;
  }

  // How far the curve moves: with the knot inserted again, only coefficient i differs.
  [[nodiscard]] double residual(const double* before, const double* after, std::size_t i,
                                const Spline& q) const {
    const auto stride = static_cast<std::size_t>(spline_.stride);
    const std::size_t dim = stride - (spline_.rational ? 1 : 0);
    const double a = share(i);
    std::vector<double> gap(stride);
    for (std::size_t c = 0; c < stride; ++c) gap[c] = spline_[i][c] - (a * after[c] + (1.0 - a) * before[c]);
    if (!spline_.rational) return scaled_norm(gap);
    // |C - C~| = N_i |dA - C~ dw| / w <= (|dA - P_i dw| + |C~ - P_i| |dw|) / w_i, with C~ in the hull of the
    // new local points.
    const double weight = spline_[i][dim];
    double reach = 0.0;
    std::vector<double> difference(dim);
    const std::size_t from = first_ - 1;
    const std::size_t to = std::min(last_ + 1, q.size());
    for (std::size_t j = from; j < to; ++j) {
      if (!(q[j][dim] > 0.0)) return std::numeric_limits<double>::infinity();
      for (std::size_t c = 0; c < dim; ++c) difference[c] = q[j][c] / q[j][dim] - spline_[i][c] / weight;
      reach = std::max(reach, scaled_norm(difference));
    }
    for (std::size_t c = 0; c < dim; ++c) difference[c] = gap[c] - spline_[i][c] / weight * gap[dim];
    return (scaled_norm(difference) + reach * std::abs(gap[dim])) / weight;
  }

  const Spline& spline_;
  double t_;
  std::vector<double> knots_;  ///< without the knot
  std::size_t first_ = 0;
  std::size_t last_ = 0;
};

}  // namespace
}  // namespace detail

KnotRemoval remove_knot(const Curve& curve, double t, int times, double tolerance) {
  if (times < 0)
    throw InvalidArgument(fmt::format("knot {} removed {} times, expected at least 0", t, times));
  if (!(tolerance >= 0.0)) {
    throw InvalidArgument(fmt::format("the tolerance is {}, expected a number of at least 0", tolerance));
  }
  const Interval domain = curve.domain();
  const int copies = domain.lo < t && t < domain.hi ? multiplicity(curve.knots(), t) : 0;
  KnotRemoval result{curve, 0, 0.0};
  detail::Spline spline = detail::premultiplied(curve);
  for (; result.removed < std::min(times, copies); ++result.removed) {
    detail::Removal removal = detail::KnotRemover(spline, t).remove();
    removal.deviation /= spline.scale;
    if (!(result.deviation + removal.deviation <= tolerance)) break;
    result.deviation += removal.deviation;
    spline = std::move(removal.spline);
  }
  if (result.removed > 0) result.curve = detail::euclidean(std::move(spline));
  return result;
}

}  // namespace v0
}  // namespace tandem
