#include "tandem/curve/arc_length.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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
// An interval of 2^-45 of a span cannot be told from its ends in the length.
constexpr int kDeepest = 45;
// Rounding of one quadrature, as a share of its value.
constexpr double kRounding = 1e-15;

// Brings `extent` into [1, 2) without rounding.
double power_of_two_scale(double extent) {
  if (extent == 0.0) return 1.0;
  return std::ldexp(1.0, -std::clamp(std::ilogb(extent), -1020, 1020));
}

}  // namespace

ArcLength::ArcLength(const Curve& curve, double accuracy) {
  if (!(accuracy > 0.0)) {
    throw InvalidArgument(
        fmt::format("the accuracy of a length is {}, expected a positive number", accuracy));
  }
  detail::Pieces pieces = detail::decompose(detail::premultiplied(curve));
  scale_ = power_of_two_scale(curve.extent());
  rational_ = pieces.rational;
  stride_ = pieces.stride;
  const auto stride = static_cast<std::size_t>(stride_);
  const auto dim = static_cast<std::size_t>(curve.dim());
  const auto order = static_cast<std::size_t>(pieces.degree) + 1;
  for (const detail::Break& at : pieces.breaks) piece_breaks_.push_back(at.value);
  if (rational_) {
    degree_ = pieces.degree;
    for (std::size_t i = 0; i < pieces.coefficients.size(); ++i) {
      if (i % stride < dim) pieces.coefficients[i] *= scale_;
    }
    coefficients_ = std::move(pieces.coefficients);
  } else {
    degree_ = pieces.degree - 1;
    coefficients_.reserve(pieces.coefficients.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const double* b = pieces[i];
      for (std::size_t k = 0; k < (order - 1) * stride; ++k) {
        coefficients_.push_back(pieces.degree * (scale_ * b[k + stride] - scale_ * b[k]));
      }
    }
  }

  for (const double x : curve.control_points().data()) {
    noise_ = std::max(noise_, kRounding * pieces.degree * std::abs(scale_ * x));
  }
  std::vector<double> whole(pieces.size());
  double total = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) total += whole[i] = integrate(i, 0.0, 1.0);
  const double tolerance = accuracy * total / static_cast<double>(pieces.size());
  lengths_.push_back(0.0);
  for (std::size_t i = 0; i < pieces.size(); ++i) divide(i, 0.0, 1.0, whole[i], tolerance, 0);
  parameters_.push_back(piece_breaks_.back());
}

// Speed with respect to the local parameter x of a piece, scaled.
double ArcLength::speed(std::size_t piece, double x) const {
  const auto stride = static_cast<std::size_t>(stride_);
  const auto order = static_cast<std::size_t>(degree_) + 1;
  const double* b = coefficients_.data() + piece * order * stride;
  double sum = 0.0;
  if (!rational_) {
    detail::Scratch<32> basis(order);
    double factor = 1.0;
    for (std::size_t i = 0; i < order; ++i) {
      basis[i] = factor;
      factor *= x * (static_cast<double>(order - 1 - i) / static_cast<double>(i + 1));
    }
    factor = 1.0;
    for (std::size_t i = order; i-- > 0;) {
      basis[i] *= factor;
      factor *= 1.0 - x;
    }
    for (std::size_t c = 0; c < stride; ++c) {
      double value = 0.0;
      for (std::size_t i = 0; i < order; ++i) value += basis[i] * b[i * stride + c];
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

void ArcLength::divide(std::size_t piece, double from, double to, double whole, double tolerance, int depth) {
  const double middle = 0.5 * (from + to);
  const double left = integrate(piece, from, middle);
  const double right = integrate(piece, middle, to);
  if (std::abs(left + right - whole) > tolerance + kRounding * whole + noise_ * (to - from) &&
      depth < kDeepest) {
    divide(piece, from, middle, left, tolerance, depth + 1);
    divide(piece, middle, to, right, tolerance, depth + 1);
    return;
  }
  const double start = piece_breaks_[piece];
  const double span = piece_breaks_[piece + 1] - start;
  for (const auto& [local, length] : {std::pair{from, left}, std::pair{middle, right}}) {
    pieces_.push_back(piece);
    locals_.push_back(local);
    parameters_.push_back(start + local * span);
    lengths_.push_back(lengths_.back() + length);
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
  const double enough = 2.0 * std::numeric_limits<double>::epsilon() * lengths_[i + 1];
  double x = lo + (hi - lo) * (rest / whole);
  // Newton on the length within the interval; where it leaves the bracket (zero speed, cusps), bisection. 100
  // steps are never needed: 60 halvings exhaust a double.
  for (int step = 0; step < 100; ++step) {
    const double error = integrate(piece, from, x) - rest;
    if (std::abs(error) <= enough) break;
    (error > 0.0 ? hi : lo) = x;
    double next = x - error / speed(piece, x);
    if (!(lo < next && next < hi)) next = 0.5 * (lo + hi);
    if (next == lo || next == hi) break;
    x = next;
  }
  const double start = piece_breaks_[piece];
  return std::min(start + x * (piece_breaks_[piece + 1] - start), parameters_[i + 1]);
}

double arc_length(const Curve& curve, double accuracy) {
  return ArcLength(curve, accuracy).length();
}

}  // namespace v0
}  // namespace tandem
