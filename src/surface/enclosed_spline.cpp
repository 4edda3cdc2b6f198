#include "surface/enclosed_spline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// (1 - alpha) left + alpha right where alpha = (t - from) / (to - from) and from <= t <= to.
struct Mix {
  Enclosure of_left;
  Enclosure of_right;

  Mix(double from, double t, double to) {
    // At the ends the one or the other as it is: splines whose knots have full multiplicity stay exact.
    if (t == from) {
      of_left = 1.0;
    } else if (t == to) {
      of_right = 1.0;
    } else {
      const Enclosure whole = Enclosure(to) - from;
      of_left = (Enclosure(to) - t) / whole;
      of_right = (Enclosure(t) - from) / whole;
    }
  }
  // left and right: stride numbers; the result replaces `right`.
  void apply(const Enclosure* left, Enclosure* right, std::size_t stride) const {
    if (of_left.is_zero()) return;
    if (of_right.is_zero()) {
      std::copy(left, left + stride, right);
      return;
    }
    for (std::size_t c = 0; c < stride; ++c) right[c] = of_left * left[c] + of_right * right[c];
  }
};

// Bezier coefficients over `part` from the degree + 1 coefficients d of a span that starts at *knot, in
// place. First `part.lo` is inserted until it has full multiplicity, then `part.hi`: blossoms f(lo.., hi..).
void to_bezier(const double* knot, int degree, Interval part, std::size_t stride, Enclosures& d) {
  const auto at = [&](int i) { return d.data() + static_cast<std::size_t>(i) * stride; };
  // After stage r, d_i = f(lo^r, knots i - p + r + 1 .. i); those right of what the last stage needs are
  // f(lo^(p - m), knots 1 .. m) in the end.
  Enclosures kept(d.size());
  for (int r = 0; r <= degree; ++r) {
    std::copy(at(degree), at(degree) + stride, kept.data() + static_cast<std::size_t>(degree - r) * stride);
    for (int i = degree; i > r; --i)
      Mix(knot[i - degree], part.lo, knot[i - r]).apply(at(i - 1), at(i), stride);
  }
  d.swap(kept);
  for (int r = 1; r <= degree; ++r) {
    for (int m = degree; m >= r; --m) Mix(part.lo, part.hi, knot[m - r + 1]).apply(at(m - 1), at(m), stride);
  }
}

}  // namespace

Frame frame_of(std::span<const Points* const> clouds) {
  const auto first = clouds.front()->front();
  Frame frame;
  double largest = 0.0;
  for (std::size_t c = 0; c < first.size(); ++c) {
    double reach = 0.0;
    double size = 0.0;
    for (const Points* cloud : clouds) {
      for (std::size_t i = 0; i < cloud->size(); ++i) {
        reach = std::max(reach, std::abs((*cloud)[i][c] - first[c]));
        size = std::max(size, std::abs((*cloud)[i][c]));
      }
    }
    // All then lie between half and twice the origin, and differences are exact (Sterbenz).
    const bool far = std::abs(first[c]) > 2.0 * reach;
    frame.origin.push_back(far ? first[c] : 0.0);
    largest = std::max(largest, far ? reach : size);
  }
  if (largest > 0.0) frame.exponent = -std::ilogb(largest);
  return frame;
}

Enclosures homogeneous(const Points& points, const std::vector<double>& weights, bool rational,
                       const Frame& frame) {
  const auto dim = static_cast<std::size_t>(points.dim());
  const std::size_t stride = dim + (rational ? 1 : 0);
  const int weight_exponent =
      weights.empty() ? 0 : -std::ilogb(*std::max_element(weights.begin(), weights.end()));
  Enclosures result(points.size() * stride);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Enclosure* out = result.data() + i * stride;
    const Enclosure weight = weights.empty() ? Enclosure(1.0) : scaled(weights[i], weight_exponent);
    for (std::size_t c = 0; c < dim; ++c) {
      out[c] = scaled(Enclosure(points[i][c]) - frame.origin[c], frame.exponent);
      if (!weights.empty()) out[c] = out[c] * weight;
    }
    if (rational) out[dim] = weight;
  }
  return result;
}

Enclosures component(const Enclosures& coefficients, std::size_t stride, std::size_t c) {
  Enclosures result(coefficients.size() / stride);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = coefficients[i * stride + c];
  return result;
}

EnclosedSpline::EnclosedSpline(int degree, std::vector<double> knots, Enclosures coefficients,
                               std::size_t stride)
    : degree_(degree), stride_(stride), knots_(std::move(knots)), coefficients_(std::move(coefficients)) {}

std::vector<double> EnclosedSpline::breaks() const {
  const auto first = knots_.begin() + degree_;
  std::vector<double> result(first, knots_.begin() + static_cast<std::ptrdiff_t>(size()) + 1);
  if (!gap_.empty()) result.insert(std::lower_bound(result.begin(), result.end(), gap_from_), gap_from_);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::size_t EnclosedSpline::span_of(Interval part) const {
  // The last knot at or before part.lo starts a non-empty span, since part.hi lies behind it.
  const auto end = knots_.begin() + static_cast<std::ptrdiff_t>(size());
  return static_cast<std::size_t>(std::upper_bound(knots_.begin() + degree_, end, part.lo) - knots_.begin()) -
         1;
}

Enclosures EnclosedSpline::bezier(Interval part) const {
  const std::size_t span = span_of(part);
  const auto first = coefficients_.begin() +
                     static_cast<std::ptrdiff_t>((span - static_cast<std::size_t>(degree_)) * stride_);
  Enclosures d(first, first + static_cast<std::ptrdiff_t>((static_cast<std::size_t>(degree_) + 1) * stride_));
  to_bezier(knots_.data() + span, degree_, part, stride_, d);
  if (!gap_.empty()) add_gap(gap_shares(part), d);
  return d;
}

Enclosures EnclosedSpline::hodograph(Interval part) const {
  const std::size_t span = span_of(part);
  const double* knot = knots_.data() + span;
  const Enclosure* from = coefficients_.data() + (span - static_cast<std::size_t>(degree_)) * stride_;
  Enclosures d(static_cast<std::size_t>(degree_) * stride_);
  for (int i = 0; i < degree_; ++i) {
    // The coefficients i and i + 1 differ over the knots i - p + 1 .. i + 1, counted from the span's first.
    const double lo = knot[i - degree_ + 1];
    const double hi = knot[i + 1];
    const Enclosure share = lo == part.lo && hi == part.hi
                                ? Enclosure(1.0)
                                : (Enclosure(part.hi) - part.lo) / (Enclosure(hi) - lo);
    for (std::size_t c = 0; c < stride_; ++c) {
      const std::size_t at = static_cast<std::size_t>(i) * stride_ + c;
      d[at] = (from[at + stride_] - from[at]) * share;
    }
  }
  if (degree_ > 1) to_bezier(knot, degree_ - 1, part, stride_, d);
  if (!gap_.empty()) {
    const Enclosures shares = gap_shares(part);
    Enclosures steps(shares.size() - 1);
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = shares[i + 1] - shares[i];
    add_gap(steps, d);
  }
  return d;
}

void EnclosedSpline::weld(std::size_t dim, bool rational, double from) {
  const std::vector<double> knots = breaks();
  const Enclosures first = bezier({knots[0], knots[1]});
  const Enclosures last = bezier({knots[knots.size() - 2], knots.back()});
  const Enclosure* start = first.data();
  const Enclosure* end = last.data() + last.size() - stride_;
  Enclosures gap(stride_);
  const std::size_t group = dim + (rational ? 1 : 0);
  for (std::size_t i = 0; i < stride_; ++i) {
    const std::size_t weight = i - i % group + dim;
    if (rational && i == weight) continue;
    const Enclosure there = rational ? end[weight] * start[i] / start[weight] : start[i];
    gap[i] = hull(0.0, there - end[i]);
  }
  gap_ = std::move(gap);
  gap_from_ = from;
}

// Of x^degree over the part: the blossom of x, lo (degree - i) times and hi i times.
Enclosures EnclosedSpline::gap_shares(Interval part) const {
  Enclosures shares(static_cast<std::size_t>(degree_) + 1);
  if (part.hi <= gap_from_) return shares;
  const auto x = [&](double t) {
    if (t == gap_from_ || t == domain().hi) return Enclosure(t == gap_from_ ? 0.0 : 1.0);
    return (Enclosure(t) - gap_from_) / (Enclosure(domain().hi) - gap_from_);
  };
  const Enclosure lo = x(part.lo);
  const Enclosure hi = x(part.hi);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    shares[i] = 1.0;
    for (std::size_t k = 0; k + 1 < shares.size(); ++k) shares[i] = shares[i] * (k < i ? hi : lo);
  }
  return shares;
}

void EnclosedSpline::add_gap(const Enclosures& shares, Enclosures& coefficients) const {
  for (std::size_t i = 0; i < shares.size(); ++i) {
    for (std::size_t c = 0; c < stride_; ++c) coefficients[i * stride_ + c] += shares[i] * gap_[c];
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
