#include "tandem/curve/compose.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "curve/bernstein.h"
#include "curve/compose_plan.h"
#include "curve/spline.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

std::vector<Break> breaks_of(const Spline& clamped) {
  const Interval domain = clamped.domain();
  std::vector<Break> breaks{{domain.lo, clamped.degree + 1}};
  for (const double knot : clamped.knots) {
    if (knot <= domain.lo || knot >= domain.hi) continue;
    if (knot != breaks.back().value) breaks.push_back({knot, 0});
    ++breaks.back().multiplicity;
  }
  breaks.push_back({domain.hi, clamped.degree + 1});
  return breaks;
}

double local_parameter(const Pieces& inner, const Cut& cut, std::size_t piece) {
  const double start = inner.breaks[piece].value;
  return (cut.u - start) / (inner.breaks[piece + 1].value - start);
}

// Inner pieces are linear, or quotients of linear functions. Then every control point of the result is a
// blossom of `outer` at the inner values of its knots, times the inner weights there: knot insertion is all
// that is needed.
Spline compose_linear(const Spline& outer, const Pieces& inner, const std::vector<Cut>& cuts) {
  const auto p = static_cast<std::size_t>(outer.degree);
  const auto stride = static_cast<std::size_t>(outer.stride);
  const std::size_t last = cuts.size() - 1;
  std::vector<double> values;     // of the inner function at the knots of the result
  std::vector<double> weights;    // of the inner function, there
  std::vector<std::size_t> gaps;  // where p windows would reach across a jump over outer knots
  Spline result;
  result.degree = outer.degree;
  result.stride = outer.stride;
  result.rational = outer.rational;
  result.scale = outer.scale;
  result.knots.reserve(cuts.size() * p + 2);
  values.reserve(cuts.size() * p + 2);
  for (std::size_t i = 0; i <= last; ++i) {
    const Cut& cut = cuts[i];
    const bool end = i == 0 || i == last;
    const std::size_t copies = end ? p + 1 : p - static_cast<std::size_t>(cut.smoothness);
    double weight = 1.0;
    if (inner.rational) {
      const double* b = inner[i == last ? cut.inner - 1 : cut.inner];
      const double x = i == last ? 1.0 : local_parameter(inner, cut, cut.inner);
      weight = (1.0 - x) * b[1] + x * b[3];
    }
    result.knots.insert(result.knots.end(), copies, cut.u);
    values.insert(values.end(), copies, i == 0 ? cut.after : cut.before);
    if (inner.rational) weights.insert(weights.end(), copies, weight);
    if (!end && cut.before != cut.after) {
      gaps.push_back(values.size() - p);
      values.insert(values.end(), p, cut.after);
      if (inner.rational) weights.insert(weights.end(), p, weight);
    }
  }

  const std::size_t windows = values.size() - p - 1;
  result.coefficients.resize((result.knots.size() - p - 1) * stride);
  Blossom blossom(outer);
  double* out = result.coefficients.data();
  auto gap = gaps.begin();
  for (std::size_t i = 0; i < windows; ++i) {
    if (gap != gaps.end() && i == *gap) {
      i += p - 1;
      ++gap;
      continue;
    }
    blossom(values.data() + i + 1, out);
    if (inner.rational) {
      double product = 1.0;
      for (std::size_t k = 1; k <= p; ++k) product *= weights[i + k];
      for (std::size_t c = 0; c < stride; ++c) out[c] *= product;
    }
    out += stride;
  }
  return result;
}

// The outer curve is a polyline: between two of its corners the result is an affine image of the inner
// function.
Spline compose_polyline(const Pieces& outer, const Spline& inner, const std::vector<Cut>& cuts) {
  const auto q = static_cast<std::size_t>(inner.degree);
  const auto stride = static_cast<std::size_t>(outer.stride);
  const std::size_t last = cuts.size() - 1;
  Spline result;
  result.degree = inner.degree;
  result.stride = outer.stride;
  result.rational = outer.rational;
  result.scale = outer.scale;
  std::vector<std::size_t> owner;  // the cut that a knot belongs to
  for (std::size_t i = 0; i <= last; ++i) {
    const std::size_t copies = i == 0 || i == last ? q + 1 : q - static_cast<std::size_t>(cuts[i].smoothness);
    result.knots.insert(result.knots.end(), copies, cuts[i].u);
    owner.insert(owner.end(), copies, i);
  }
  result.coefficients.resize((result.knots.size() - q - 1) * stride);
  Blossom blossom(inner);
  double value[2] = {0.0, 1.0};  // premultiplied, and its weight
  for (std::size_t i = 0; i < result.size(); ++i) {
    blossom(result.knots.data() + i + 1, value);
    value[0] /= value[1];
    std::size_t from = owner[i + 1];
    if (owner[i + q] == from) {
      // The point of a corner, or an end.
      value[0] = from == 0 ? cuts[from].after : cuts[from].before;
      if (from > 0) --from;
    }
    const std::size_t piece = cuts[from].outer;
    const double* b = outer[piece];
    const double lo = outer.breaks[piece].value;
    const double share = (value[0] - lo) / (outer.breaks[piece + 1].value - lo);
    for (std::size_t c = 0; c < stride; ++c) {
      result[i][c] = value[1] * ((1.0 - share) * b[c] + share * b[stride + c]);
    }
  }
  return result;
}

// Composes Bezier pieces: blossoming with Bernstein products. Polynomials are kept with their binomial
// coefficients multiplied in, so that a product is a plain convolution.
class PieceComposer {
 public:
  PieceComposer(const Pieces& outer, const Pieces& inner)
      : outer_(outer),
        inner_(inner),
        p_(static_cast<std::size_t>(outer.degree)),
        q_(static_cast<std::size_t>(inner.degree)),
        stride_(static_cast<std::size_t>(outer.stride)),
        inner_binomials_(binomials(inner.degree)),
        result_binomials_(binomials(outer.degree * inner.degree)),
        values_(q_ + 1),
        weights_(q_ + 1, 1.0),
        to_lo_(q_ + 1),
        to_hi_(q_ + 1),
        now_((p_ + 1) * stride_) {
    // Level k holds p - k + 1 polynomials of degree k q.
    std::size_t most = 0;
    for (std::size_t k = 0; k <= p_; ++k) most = std::max(most, (p_ - k + 1) * (k * q_ + 1) * stride_);
    now_.resize(most);
    next_.resize(most);
  }

  /// The segment between two cuts, p q + 1 coefficients.
  void operator()(const Cut& from, const Cut& to, double* out) {
    restrict_inner(from, to);
    const double* b = outer_[from.outer];
    const double lo = outer_.breaks[from.outer].value;
    const double length = outer_.breaks[from.outer + 1].value - lo;
    const double hi = outer_.breaks[from.outer + 1].value;
    for (std::size_t i = 0; i <= q_; ++i) {
      const double scaled = inner_binomials_[i] * weights_[i];
      to_lo_[i] = scaled * ((hi - values_[i]) / length);
      to_hi_[i] = scaled * ((values_[i] - lo) / length);
    }
    std::copy(b, b + (p_ + 1) * stride_, now_.begin());
    for (std::size_t k = 1; k <= p_; ++k) {
      const std::size_t length_before = ((k - 1) * q_ + 1) * stride_;
      const std::size_t length_after = (k * q_ + 1) * stride_;
      for (std::size_t j = 0; j + k <= p_; ++j) {
        double* product = next_.data() + j * length_after;
        std::fill(product, product + length_after, 0.0);
        const double* left = now_.data() + j * length_before;
        const double* right = left + length_before;
        for (std::size_t i = 0; i <= q_; ++i) {
          double* shifted = product + i * stride_;
          const double a = to_lo_[i];
          const double c = to_hi_[i];
          for (std::size_t m = 0; m < length_before; ++m) shifted[m] += a * left[m] + c * right[m];
        }
      }
      now_.swap(next_);
    }
    for (std::size_t i = 0; i <= p_ * q_; ++i) {
      for (std::size_t c = 0; c < stride_; ++c)
        out[i * stride_ + c] = now_[i * stride_ + c] / result_binomials_[i];
    }
  }

 private:
  // Values and weights of the inner function's coefficients over the segment.
  void restrict_inner(const Cut& from, const Cut& to) {
    const std::size_t piece = from.inner;
    const double* b = inner_[piece];
    const std::size_t step = inner_.rational ? 2 : 1;
    for (std::size_t i = 0; i <= q_; ++i) {
      values_[i] = b[i * step];
      if (inner_.rational) weights_[i] = b[i * step + 1];
    }
    const double a = local_parameter(inner_, from, piece);
    const double c = local_parameter(inner_, to, piece);
    if (c < 1.0) {
      keep_left(values_, c);
      if (inner_.rational) keep_left(weights_, c);
    }
    if (a > 0.0) {
      keep_right(values_, a / c);
      if (inner_.rational) keep_right(weights_, a / c);
    }
    if (inner_.rational) {
      for (std::size_t i = 0; i <= q_; ++i) values_[i] /= weights_[i];
    }
    // At a corner the neighbours meet in the point that belongs to the knot.
    if (from.smoothness == 0) values_.front() = from.after;
    if (to.smoothness == 0) values_.back() = to.before;
  }

  static void keep_left(std::vector<double>& b, double x) {
    for (std::size_t level = 1; level < b.size(); ++level) {
      for (std::size_t i = b.size() - 1; i >= level; --i) b[i] = (1.0 - x) * b[i - 1] + x * b[i];
    }
  }
  static void keep_right(std::vector<double>& b, double x) {
    for (std::size_t level = b.size() - 1; level > 0; --level) {
      for (std::size_t i = 0; i < level; ++i) b[i] = (1.0 - x) * b[i] + x * b[i + 1];
    }
  }

  const Pieces& outer_;
  const Pieces& inner_;
  std::size_t p_;
  std::size_t q_;
  std::size_t stride_;
  std::vector<double> inner_binomials_;
  std::vector<double> result_binomials_;
  std::vector<double> values_;
  std::vector<double> weights_;
  std::vector<double> to_lo_;
  std::vector<double> to_hi_;
  std::vector<double> now_;
  std::vector<double> next_;
};

Spline compose_pieces(const Pieces& outer, const Pieces& inner, const std::vector<Cut>& cuts) {
  Pieces result;
  result.degree = outer.degree * inner.degree;
  result.stride = outer.stride;
  result.rational = outer.rational;
  result.scale = outer.scale;
  for (const Cut& cut : cuts) result.breaks.push_back({cut.u, result.degree - cut.smoothness});
  result.coefficients.resize(result.size() * result.piece_length());
  PieceComposer composer(outer, inner);
  for (std::size_t i = 0; i < result.size(); ++i) composer(cuts[i], cuts[i + 1], result[i]);
  return assemble(result);
}

}  // namespace
}  // namespace detail

Curve compose(const Curve& outer, const Curve& inner) {
  if (inner.dim() != 1) {
    throw InvalidArgument(fmt::format("the inner function has dimension {}, expected 1", inner.dim()));
  }
  const int degree = outer.degree() * inner.degree();
  if (degree > detail::kLargestProductDegree) {
    throw InvalidArgument(fmt::format("the composed curve would have degree {}, expected at most {}", degree,
                                      detail::kLargestProductDegree));
  }
  const bool rational = outer.is_rational() || inner.is_rational();
  const detail::Spline whole = detail::clamped(detail::premultiplied(outer, rational));
  const detail::Spline function = detail::clamped(detail::premultiplied(inner));
  const detail::Pieces pieces = detail::decompose(function);
  const std::vector<detail::Cut> cuts = detail::plan_cuts(whole.degree, detail::breaks_of(whole), pieces);
  detail::Spline result;
  if (function.degree == 1) {
    result = detail::compose_linear(whole, pieces, cuts);
  } else if (whole.degree == 1) {
    result = detail::compose_polyline(detail::decompose(whole), function, cuts);
  } else {
    result = detail::compose_pieces(detail::decompose(whole), pieces, cuts);
  }
  return detail::euclidean(std::move(result));
}

}  // namespace v0
}  // namespace tandem
