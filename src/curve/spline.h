#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/curve/curve.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The working form of exact editing: a spline over premultiplied coefficients (w x, w y, ..., w), the weight
/// last, or plain coordinates where the curve is polynomial. Not validated: whoever turns it back into a
/// Curve is.
struct Spline {
  int degree = 1;
  int stride = 1;  ///< numbers per coefficient
  bool rational = false;
  double scale = 1.0;  ///< what the coordinates were multiplied with, a power of two; see premultiplied()
  std::vector<double> knots;
  std::vector<double> coefficients;

  [[nodiscard]] std::size_t size() const noexcept {
    return coefficients.size() / static_cast<std::size_t>(stride);
  }
  [[nodiscard]] Interval domain() const noexcept {
    return {knots[static_cast<std::size_t>(degree)], knots[size()]};
  }
  [[nodiscard]] const double* operator[](std::size_t i) const noexcept {
    return coefficients.data() + i * static_cast<std::size_t>(stride);
  }
  [[nodiscard]] double* operator[](std::size_t i) noexcept {
    return coefficients.data() + i * static_cast<std::size_t>(stride);
  }
};

/// As premultiplied coefficients; a polynomial curve gets weights 1 when `rational` is asked for.
///
/// Weights count up to a common factor only and are scaled to at most 1. Coordinates far from 1 (below
/// 1e-100, above 1e100) are scaled, without rounding, to where their products with weights and binomial
/// coefficients fit.
[[nodiscard]] Spline premultiplied(const Curve& curve, bool rational);
[[nodiscard]] inline Spline premultiplied(const Curve& curve) {
  return premultiplied(curve, curve.is_rational());
}

/// Back to Euclidean control points and weights. @throws InvalidArgument as Curve's constructor
[[nodiscard]] Curve euclidean(Spline spline);

/// Values of the blossom of a spline at degree-many arguments: the control point that stands for those
/// arguments as knots. Looks at the spline, which must outlive it. Keeps scratch space and a place: use one
/// per thread, and ask in ascending order for speed.
///
/// The arguments must be consecutive knots of some refinement of the spline's knots inside its domain. Then
/// only convex combinations are formed (knot insertion after Boehm, one new argument after the other).
class Blossom {
 public:
  explicit Blossom(const Spline& spline);

  /// args: degree numbers, non-decreasing; the coefficient goes to out (stride numbers).
  void operator()(const double* args, double* out);

 private:
  const Spline& spline_;
  std::size_t place_ = 0;
  std::vector<double> fresh_;
  std::vector<double> scratch_;
};

/// The same spline over other knots: of the same degree, clamped or not, on its domain or a part of it, where
/// they must refine the spline's own.
[[nodiscard]] Spline over_knots(const Spline& spline, std::vector<double> knots);

/// The knots of the spline strictly between lo and hi, clamped at lo and hi.
[[nodiscard]] std::vector<double> clamped_knots(const Spline& spline, Interval part);

/// The part over `part`, clamped.
[[nodiscard]] Spline part_of(const Spline& spline, Interval part);

/// Both ends have knots of multiplicity degree + 1.
[[nodiscard]] bool is_clamped(const Curve& curve);

/// The whole, clamped; unchanged if it is already.
[[nodiscard]] Spline clamped(Spline spline);

/// Degree raised; clamped.
[[nodiscard]] Spline elevated(Spline spline, int times);

/// Appends `next` (same degree, stride and kind; both clamped) with its knots shifted by `shift`. The joint
/// becomes a knot of full multiplicity; of the two coefficients there, that of `spline` stays, and rational
/// weights are scaled to fit.
void append(Spline& spline, const Spline& next, double shift);

/// A distinct knot of a spline.
struct Break {
  double value = 0.0;
  int multiplicity = 0;
};

/// A spline as Bezier pieces: piece i lies over [breaks[i].value, breaks[i + 1].value] and has degree + 1
/// coefficients of its own. The first and last break are the ends of the domain.
struct Pieces {
  int degree = 1;
  int stride = 1;
  bool rational = false;
  double scale = 1.0;  ///< as in Spline
  std::vector<Break> breaks;
  std::vector<double> coefficients;

  [[nodiscard]] std::size_t size() const noexcept { return breaks.empty() ? 0 : breaks.size() - 1; }
  [[nodiscard]] std::size_t piece_length() const noexcept {
    return static_cast<std::size_t>(degree + 1) * static_cast<std::size_t>(stride);
  }
  [[nodiscard]] const double* operator[](std::size_t i) const noexcept {
    return coefficients.data() + i * piece_length();
  }
  [[nodiscard]] double* operator[](std::size_t i) noexcept {
    return coefficients.data() + i * piece_length();
  }
};

/// Cuts at all knots.
[[nodiscard]] Pieces decompose(const Spline& spline);

/// The clamped spline whose pieces these are, with the multiplicities in `breaks`: the pieces must be as
/// smooth there (degree - multiplicity continuous derivatives) as those claim, to rounding. Multiplicities
/// are raised to half of the degree, so that no control point has to be extrapolated over more than one
/// piece.
[[nodiscard]] Spline assemble(const Pieces& pieces);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
