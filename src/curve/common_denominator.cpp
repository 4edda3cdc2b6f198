#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "curve/bernstein.h"
#include "curve/common_knots.h"
#include "curve/spline.h"
#include "tandem/curve/compatible.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Weights that agree this well differ by rounding of knot insertion and degree elevation.
constexpr double kSameWeight = 1e-13;
constexpr std::size_t kPolynomial = std::numeric_limits<std::size_t>::max();

// Weights up to a common factor: those of the first control point are 1.
double relative_weight(const Curve& curve, std::size_t i) {
  return curve.is_rational() ? curve.weights()[i] / curve.weights()[0] : 1.0;
}

bool same_weights(const Curve& a, const Curve& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double wa = relative_weight(a, i);
    if (std::abs(wa - relative_weight(b, i)) > kSameWeight * wa) return false;
  }
  return true;
}

bool constant_weights(const Curve& curve) {
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (std::abs(relative_weight(curve, i) - 1.0) > kSameWeight) return false;
  }
  return true;
}

// For each curve the first one that has the same weight function, or kPolynomial.
std::vector<std::size_t> denominators(std::span<const Curve> compatible) {
  std::vector<std::size_t> of(compatible.size(), kPolynomial);
  for (std::size_t i = 0; i < compatible.size(); ++i) {
    if (constant_weights(compatible[i])) continue;
    of[i] = i;
    for (std::size_t j = 0; j < i; ++j) {
      if (of[j] == j && same_weights(compatible[i], compatible[j])) of[i] = j;
    }
  }
  return of;
}

// The same splines with every break of any of them a knot of each, and how smooth all of them are there.
std::vector<Break> unite_breaks(std::vector<Spline>& splines) {
  snap_knots(splines);
  const Interval domain = splines.front().domain();
  std::vector<double> values;
  for (const Spline& spline : splines) {
    for (const double knot : spline.knots) {
      if (domain.lo < knot && knot < domain.hi) values.push_back(knot);
    }
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::vector<Break> smoothness;
  for (const double value : values) {
    int least = std::numeric_limits<int>::max();
    for (const Spline& spline : splines) {
      const auto [first, last] = std::equal_range(spline.knots.begin(), spline.knots.end(), value);
      if (first != last) least = std::min(least, spline.degree - static_cast<int>(last - first));
    }
    smoothness.push_back({value, least});
  }
  for (Spline& spline : splines) {
    std::vector<double> knots;
    std::set_union(spline.knots.begin(), spline.knots.end(), values.begin(), values.end(),
                   std::back_inserter(knots));
    spline = over_knots(spline, std::move(knots));
  }
  return smoothness;
}

// A scalar or vector polynomial with its binomial coefficients multiplied in: products are convolutions.
struct Scaled {
  std::size_t stride = 1;
  std::vector<double> numbers;
};

Scaled operator*(const Scaled& a, const Scaled& scalar) {
  const std::size_t n = scalar.numbers.size();
  Scaled product{a.stride, std::vector<double>(a.numbers.size() + (n - 1) * a.stride, 0.0)};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < a.numbers.size(); ++k) {
      product.numbers[i * a.stride + k] += scalar.numbers[i] * a.numbers[k];
    }
  }
  return product;
}

Scaled raised(const Scaled& a, int degree) {
  const int has = static_cast<int>(a.numbers.size() / a.stride) - 1;
  return degree == has ? a : a * Scaled{1, binomials(degree - has)};
}

// The curve's coordinates (premultiplied), or its weight, over one piece.
Scaled coordinates(const Pieces& pieces, std::size_t piece, double factor) {
  const auto stride = static_cast<std::size_t>(pieces.stride);
  const std::size_t dim = stride - (pieces.rational ? 1 : 0);
  const std::vector<double> binomial = binomials(pieces.degree);
  Scaled result{dim, {}};
  for (std::size_t i = 0; i < binomial.size(); ++i) {
    for (std::size_t c = 0; c < dim; ++c) {
      result.numbers.push_back(factor * binomial[i] * pieces[piece][i * stride + c]);
    }
  }
  return result;
}

Scaled weight(const Pieces& pieces, std::size_t piece) {
  const auto stride = static_cast<std::size_t>(pieces.stride);
  Scaled result{1, binomials(pieces.degree)};
  for (std::size_t i = 0; i < result.numbers.size(); ++i)
    result.numbers[i] *= pieces[piece][(i + 1) * stride - 1];
  return result;
}

// Curve i over the product of all denominators: its coordinates times every denominator but its own.
class Denominators {
 public:
  Denominators(std::vector<Pieces> curves, std::vector<std::size_t> of)
      : curves_(std::move(curves)), of_(std::move(of)) {
    int all = 0;
    for (std::size_t j = 0; j < curves_.size(); ++j) {
      if (of_[j] == j) all += curves_[j].degree;
    }
    degree_ = all;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      const int own = of_[i] == kPolynomial ? 0 : curves_[of_[i]].degree;
      degree_ = std::max(degree_, curves_[i].degree + all - own);
    }
  }

  [[nodiscard]] int degree() const noexcept { return degree_; }

  [[nodiscard]] Pieces over_product(std::size_t curve, const std::vector<Break>& breaks) const {
    const Pieces& from = curves_[curve];
    const std::size_t dim = static_cast<std::size_t>(from.stride) - (from.rational ? 1 : 0);
    const std::vector<double> binomial = binomials(degree_);
    Pieces result;
    result.degree = degree_;
    result.stride = static_cast<int>(dim) + 1;
    result.rational = true;
    result.scale = from.scale;
    result.breaks = breaks;
    result.coefficients.resize(result.size() * result.piece_length());
    for (std::size_t piece = 0; piece < result.size(); ++piece) {
      Scaled numerator = coordinates(from, piece, 1.0 / own_factor(curve));
      Scaled denominator{1, {1.0}};
      for (std::size_t j = 0; j < curves_.size(); ++j) {
        if (of_[j] != j) continue;
        const Scaled w = weight(curves_[j], piece);
        denominator = denominator * w;
        if (of_[curve] != j) numerator = numerator * w;
      }
      numerator = raised(numerator, degree_);
      denominator = raised(denominator, degree_);
      double* out = result[piece];
      for (std::size_t i = 0; i < binomial.size(); ++i) {
        for (std::size_t c = 0; c < dim; ++c)
          out[i * (dim + 1) + c] = numerator.numbers[i * dim + c] / binomial[i];
        out[i * (dim + 1) + dim] = denominator.numbers[i] / binomial[i];
      }
    }
    return result;
  }

 private:
  // The weights of a curve are this multiple of those that stand for them.
  [[nodiscard]] double own_factor(std::size_t curve) const {
    const auto first_weight = [](const Pieces& pieces) {
      return pieces.rational ? pieces.coefficients[static_cast<std::size_t>(pieces.stride) - 1] : 1.0;
    };
    const double reference = of_[curve] == kPolynomial ? 1.0 : first_weight(curves_[of_[curve]]);
    return first_weight(curves_[curve]) / reference;
  }

  std::vector<Pieces> curves_;
  std::vector<std::size_t> of_;
  int degree_ = 0;
};

// The curves with the weights of the first, which theirs equal but for rounding; without any if those are
// constant.
std::vector<Curve> with_equal_weights(const std::vector<Curve>& curves) {
  std::vector<Curve> result;
  result.reserve(curves.size());
  const bool constant = constant_weights(curves.front());
  for (const Curve& curve : curves) {
    result.emplace_back(curve.degree(), curve.knots(), curve.control_points(),
                        constant ? std::vector<double>{} : curves.front().weights());
  }
  return result;
}

}  // namespace
}  // namespace detail

std::vector<Curve> with_common_denominator(std::span<const Curve> curves) {
  std::vector<Curve> compatible = make_compatible(curves);
  if (!compatible.front().is_rational()) return compatible;
  const bool agree = std::all_of(compatible.begin(), compatible.end(),
                                 [&](const Curve& c) { return detail::same_weights(c, compatible.front()); });
  if (agree) return detail::with_equal_weights(compatible);

  std::vector<detail::Spline> splines = detail::over_one_domain(curves, false);
  const std::vector<detail::Break> smoothness = detail::unite_breaks(splines);
  std::vector<detail::Pieces> pieces;
  pieces.reserve(splines.size());
  for (const detail::Spline& spline : splines) pieces.push_back(detail::decompose(spline));
  std::vector<detail::Break> breaks = pieces.front().breaks;
  const detail::Denominators denominators(std::move(pieces), detail::denominators(compatible));
  if (denominators.degree() > detail::kLargestProductDegree) {
    throw InvalidArgument(fmt::format("the common denominator would have degree {}, expected at most {}",
                                      denominators.degree(), detail::kLargestProductDegree));
  }
  for (std::size_t b = 1; b + 1 < breaks.size(); ++b) {
    breaks[b].multiplicity = denominators.degree() - smoothness[b - 1].multiplicity;
  }
  std::vector<Curve> result;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    result.push_back(detail::euclidean(detail::assemble(denominators.over_product(i, breaks))));
  }
  return result;
}

}  // namespace v0
}  // namespace tandem
