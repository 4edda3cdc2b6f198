#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "curve/bernstein.h"
#include "curve/spline.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Differences of control points over the lengths of the knot intervals (The NURBS Book, eq. (3.8)).
Spline polynomial_derivative(const Spline& spline) {
  const auto p = static_cast<std::size_t>(spline.degree);
  const auto stride = static_cast<std::size_t>(spline.stride);
  Spline result;
  result.degree = spline.degree - 1;
  result.stride = spline.stride;
  result.scale = spline.scale;
  result.knots.assign(spline.knots.begin() + 1, spline.knots.end() - 1);
  result.coefficients.resize((spline.size() - 1) * stride);
  for (std::size_t i = 0; i + 1 < spline.size(); ++i) {
    const double length = spline.knots[i + p + 1] - spline.knots[i + 1];
    for (std::size_t c = 0; c < stride; ++c) {
      result[i][c] = spline.degree * ((spline[i + 1][c] - spline[i][c]) / length);
    }
  }
  return result;
}

// A derivative of degree 0, raised to degree 1.
Spline constant_derivative(const Spline& line) {
  const Interval domain = line.domain();
  Spline result = part_of(line, domain);
  const auto stride = static_cast<std::size_t>(line.stride);
  for (std::size_t c = 0; c < stride; ++c) {
    result[0][c] = (result[1][c] - result[0][c]) / domain.length();
    result[1][c] = result[0][c];
  }
  return result;
}

// (A' w - A w') / w^2 piece by piece. With the curve as (1 - x) L + x R, the halves of the last step of de
// Casteljau, the numerator is degree * (R_A L_w - L_A R_w), of degree 2 p - 2, and made of differences of
// control points.
Spline rational_derivative(const Spline& spline) {
  const auto p = static_cast<std::size_t>(spline.degree);
  const auto stride = static_cast<std::size_t>(spline.stride);
  const std::size_t dim = stride - 1;
  const Pieces pieces = decompose(spline);
  Pieces result;
  result.degree = 2 * pieces.degree;
  result.stride = pieces.stride;
  result.rational = true;
  result.scale = pieces.scale;
  result.breaks = pieces.breaks;
  for (std::size_t i = 1; i < pieces.size(); ++i) result.breaks[i].multiplicity += pieces.degree + 1;
  result.coefficients.assign(result.size() * result.piece_length(), 0.0);

  const std::vector<double> own = binomials(pieces.degree);
  const std::vector<double> lower = binomials(pieces.degree - 1);
  const std::vector<double> upper = binomials(result.degree);
  const double raise[3] = {1.0, 2.0, 1.0};  // 1 as a polynomial of degree 2
  for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
    const double* b = pieces[piece];
    double* out = result[piece];
    const double factor = pieces.degree / (pieces.breaks[piece + 1].value - pieces.breaks[piece].value);
    for (std::size_t i = 0; i <= p; ++i) {
      for (std::size_t j = 0; j <= p; ++j) {
        const double share = own[i] / upper[i + j] * own[j];
        out[(i + j) * stride + dim] += share * b[i * stride + dim] * b[j * stride + dim];
      }
    }
    for (std::size_t i = 0; i < p; ++i) {
      for (std::size_t j = 0; j < p; ++j) {
        const double v = b[i * stride + dim];
        const double w = b[(j + 1) * stride + dim];
        for (std::size_t k = 0; k < 3; ++k) {
          const double share = lower[i] / upper[i + j + k] * lower[j] * raise[k] * v * w;
          for (std::size_t c = 0; c < dim; ++c) {
            const double difference = b[(j + 1) * stride + c] / w - b[i * stride + c] / v;
            out[(i + j + k) * stride + c] += share * (factor * difference);
          }
        }
      }
    }
  }
  return assemble(result);
}

}  // namespace
}  // namespace detail

Curve derivative_curve(const Curve& curve) {
  const Interval domain = curve.domain();
  for (std::size_t i = 0; i + static_cast<std::size_t>(curve.degree()) <= curve.size() + 1; ++i) {
    const double knot = curve.knots()[i];
    if (domain.lo < knot && knot < domain.hi &&
        curve.knots()[i + static_cast<std::size_t>(curve.degree()) - 1] == knot) {
      throw InvalidArgument(fmt::format(
          "the derivative may jump at knot {}, which has full multiplicity ({})", knot, curve.degree()));
    }
  }
  const detail::Spline spline = detail::premultiplied(curve);
  if (curve.is_rational()) {
    if (2 * curve.degree() > detail::kLargestProductDegree) {
      throw InvalidArgument(fmt::format("the derivative would have degree {}, expected at most {}",
                                        2 * curve.degree(), detail::kLargestProductDegree));
    }
    return detail::euclidean(detail::rational_derivative(spline));
  }
  if (curve.degree() == 1) return detail::euclidean(detail::constant_derivative(spline));
  return detail::euclidean(detail::polynomial_derivative(spline));
}

}  // namespace v0
}  // namespace tandem
