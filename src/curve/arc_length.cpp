#include "tandem/curve/arc_length.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "curve/bernstein.h"
#include "curve/scratch.h"
#include "curve/spline.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

// Gauss-Legendre with 8 nodes on [-1, 1], the positive half (Abramowitz and Stegun, table 25.4).
constexpr std::array<double, 4> kNodes{0.18343464249564980494, 0.52553240991632898582, 0.79666647741362673959,
                                       0.96028985649753623168};
constexpr std::array<double, 4> kWeights{0.36268378337836198297, 0.31370664587788728734,
                                         0.22238103445337447054, 0.10122853629037625915};
// Per span. A cusp takes some 30 for 1e-10; beyond this the errors are rounding that no halving will cure.
constexpr std::size_t kMostIntervals = 400;
// Rounding of one quadrature, as a share of its value or of the size of the curve (which is scaled to about
// 1).
constexpr double kRounding = 1e-15;

// Brings `extent` into [1, 2) without rounding.
double power_of_two_scale(double extent) {
  if (extent == 0.0) return 1.0;
  return std::ldexp(1.0, -std::clamp(std::ilogb(extent), -1020, 1020));
}

// The curve with its first control point at the origin and its size near 1: rounding is a share of its size
// then, however far off it lies.
detail::Spline centred(const Curve& curve, double scale, bool rational) {
  detail::Spline spline = detail::premultiplied(curve, rational);
  spline.scale = 1.0;
  const auto dim = static_cast<std::size_t>(curve.dim());
  const Points& points = curve.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double weight = rational ? spline[i][dim] : 1.0;
    for (std::size_t c = 0; c < dim; ++c) spline[i][c] = weight * (scale * (points[i][c] - points[0][c]));
  }
  return spline;
}

// Where in [0, 1] the share `y` of an interval's length is reached, by the cubic through (0, 0) and (1, 1)
// with the slopes of the inverse function there; linear where the curve (nearly) stands still at an end.
double first_guess(double y, double slope_lo, double slope_hi) {
  const bool usable = slope_lo < 3.0 && slope_hi < 3.0;  // a monotone cubic (Fritsch and Carlson, 1980)
  if (!usable) return y;
  const double z = 1.0 - y;
  return y * y * (y + 3.0 * z) + y * z * (z * slope_lo - y * slope_hi);
}

}  // namespace

ArcLength::ArcLength(const Curve& curve, double accuracy) {
  if (!(accuracy > 0.0)) {
    throw InvalidArgument(
        fmt::format("the accuracy of a length is {}, expected a positive number", accuracy));
  }
  const bool high = curve.degree() > detail::kLargestProductDegree;  // too high for binomial coefficients
  scale_ = power_of_two_scale(curve.extent());
  detail::Pieces pieces = detail::decompose(centred(curve, scale_, curve.is_rational() || high));
  rational_ = pieces.rational;
  stride_ = pieces.stride;
  const auto stride = static_cast<std::size_t>(stride_);
  const auto order = static_cast<std::size_t>(pieces.degree) + 1;
  for (const detail::Break& at : pieces.breaks) piece_breaks_.push_back(at.value);
  if (rational_) {
    degree_ = pieces.degree;
    coefficients_ = std::move(pieces.coefficients);
  } else {
    degree_ = pieces.degree - 1;
    coefficients_.reserve(pieces.coefficients.size());
    const std::vector<double> binomial = detail::binomials(degree_);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const double* b = pieces[i];
      for (std::size_t k = 0; k < (order - 1) * stride; ++k) {
        coefficients_.push_back(binomial[k / stride] * pieces.degree * (b[k + stride] - b[k]));
      }
    }
  }

  std::vector<double> whole(pieces.size());
  double total = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) total += whole[i] = integrate(i, 0.0, 1.0);
  const double tolerance = accuracy * total / static_cast<double>(pieces.size());
  lengths_.push_back(0.0);
  for (std::size_t i = 0; i < pieces.size(); ++i) divide(i, whole[i], tolerance);
  parameters_.push_back(piece_breaks_.back());
}

// Speed with respect to the local parameter x of a piece, scaled.
double ArcLength::speed(std::size_t piece, double x) const {
  const auto stride = static_cast<std::size_t>(stride_);
  const auto order = static_cast<std::size_t>(degree_) + 1;
  const double* b = coefficients_.data() + piece * order * stride;
  double sum = 0.0;
  if (!rational_) {
    // Horner's scheme; the binomial coefficients are in the coefficients already.
    const double y = 1.0 - x;
    for (std::size_t c = 0; c < stride; ++c) {
      double value = b[c];
      double power = x;
      for (std::size_t i = 1; i < order; ++i, power *= x) value = value * y + power * b[i * stride + c];
      sum += value * value;
    }
    return std::sqrt(sum);
  }
  // The last two points of de Casteljau's scheme, P and Q with weights v and w, give the derivative of a
  // rational curve: degree * v * w / weight^2 * (Q - P) (Floater, Derivatives of rational Bezier curves,
  // 1992).
  detail::Scratch<128> scratch(order * stride);
  std::copy(b, b + order * stride, scratch.data());
  for (std::size_t level = order - 1; level > 1; --level) {
    for (std::size_t i = 0; i < level * stride; ++i)
      scratch[i] = (1.0 - x) * scratch[i] + x * scratch[i + stride];
  }
  const double v = scratch[stride - 1];
  const double w = scratch[2 * stride - 1];
  const double weight = (1.0 - x) * v + x * w;
  for (std::size_t c = 0; c + 1 < stride; ++c) {
    const double d = scratch[stride + c] / w - scratch[c] / v;
    sum += d * d;
  }
  return degree_ * (v / weight) * (w / weight) * std::sqrt(sum);
}

double ArcLength::integrate(std::size_t piece, double from, double to) const {
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  double sum = 0.0;
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    sum += kWeights[i] * (speed(piece, middle - half * kNodes[i]) + speed(piece, middle + half * kNodes[i]));
  }
  return sum * half;
}

void ArcLength::divide(std::size_t piece, double whole, double tolerance) {
  // Halves the interval with the largest error until the sum of errors is small (as QUADPACK's QAG does). The
  // error of an interval is how much its halves together differ from it; the halves are what is kept.
  struct Part {
    double from, to, left, right, error;
  };
  const auto less = [](const Part& a, const Part& b) { return a.error < b.error; };
  std::vector<Part> intervals;
  double sum = 0.0;
  const auto add = [&](double from, double to, double estimate) {
    const double middle = 0.5 * (from + to);
    const double left = integrate(piece, from, middle);
    const double right = integrate(piece, middle, to);
    const double error = std::abs(left + right - estimate);
    sum += error;
    intervals.push_back({from, to, left, right, error});
    std::push_heap(intervals.begin(), intervals.end(), less);
  };
  add(0.0, 1.0, whole);
  while (sum > tolerance + kRounding * (whole + 1.0) && intervals.size() < kMostIntervals) {
    std::pop_heap(intervals.begin(), intervals.end(), less);
    const Part worst = intervals.back();
    intervals.pop_back();
    sum -= worst.error;
    const double middle = 0.5 * (worst.from + worst.to);
    add(worst.from, middle, worst.left);
    add(middle, worst.to, worst.right);
  }

  std::sort(intervals.begin(), intervals.end(), [](const Part& a, const Part& b) { return a.from < b.from; });
  const double start = piece_breaks_[piece];
  const double span = piece_breaks_[piece + 1] - start;
  for (const Part& interval : intervals) {
    const double middle = 0.5 * (interval.from + interval.to);
    for (const auto& [local, length] :
         {std::pair{interval.from, interval.left}, std::pair{middle, interval.right}}) {
      pieces_.push_back(piece);
      locals_.push_back(local);
      parameters_.push_back(start + local * span);
      lengths_.push_back(lengths_.back() + length);
    }
  }
}

double ArcLength::length_to(double t) const {
  if (!(t > parameters_.front())) return 0.0;
  if (t >= parameters_.back()) return length();
  const auto after = std::upper_bound(parameters_.begin(), parameters_.end(), t);
  const auto i = static_cast<std::size_t>(after - parameters_.begin()) - 1;
  const std::size_t piece = pieces_[i];
  const double start = piece_breaks_[piece];
  const double x = (t - start) / (piece_breaks_[piece + 1] - start);
  const double within = integrate(piece, locals_[i], std::max(x, locals_[i]));
  return std::min(lengths_[i] + within, lengths_[i + 1]) / scale_;
}

double ArcLength::parameter_at(double length) const {
  const double wanted = length * scale_;
  if (!(wanted > 0.0) || lengths_.back() == 0.0) return parameters_.front();
  // The first interval at whose end the length is reached: the smallest parameter where the curve stands
  // still.
  const auto reached =
      std::lower_bound(lengths_.begin() + 1, lengths_.end(), std::min(wanted, lengths_.back()));
  const auto i = static_cast<std::size_t>(reached - lengths_.begin()) - 1;
  const double rest = wanted - lengths_[i];
  const double whole = lengths_[i + 1] - lengths_[i];
  if (rest >= whole) return parameters_[i + 1];

  const std::size_t piece = pieces_[i];
  double lo = locals_[i];
  double hi = i + 1 < locals_.size() && pieces_[i + 1] == piece ? locals_[i + 1] : 1.0;
  const double from = lo;
  const double width = hi - lo;
  const double enough = 2.0 * std::numeric_limits<double>::epsilon() * lengths_[i + 1];
  double x = from + width * first_guess(rest / whole, whole / (speed(piece, lo) * width),
                                        whole / (speed(piece, hi) * width));
  // Newton on the length within the interval; where it leaves the bracket (zero speed, cusps), bisection. 100
  // steps are never needed: 60 halvings exhaust a double.
  for (int step = 0; step < 100; ++step) {
    const double error = integrate(piece, from, x) - rest;
    if (std::abs(error) <= enough) break;
    (error > 0.0 ? hi : lo) = x;
    const double slope = speed(piece, x);
    double next = x - error / slope;
    const bool inside = lo < next && next < hi;
    if (!inside) next = 0.5 * (lo + hi);
    if (next == lo || next == hi) break;
    x = next;
    // Newton squares the relative error, as long as the speed is much the same all over the interval.
    const double ratio = slope * width / whole;
    if (inside && std::abs(error) <= 1e-9 * whole && 0.25 < ratio && ratio < 4.0) break;
  }
  const double start = piece_breaks_[piece];
  return std::min(start + x * (piece_breaks_[piece + 1] - start), parameters_[i + 1]);
}

double arc_length(const Curve& curve, double accuracy) {
  return ArcLength(curve, accuracy).length();
}

}  // namespace v0
}  // namespace tandem
