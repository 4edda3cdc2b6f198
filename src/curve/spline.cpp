#include "curve/spline.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

double power_of_two_scale(std::span<const double> coordinates) {
  double largest = 0.0;
  for (const double x : coordinates) largest = std::max(largest, std::abs(x));
  if (largest == 0.0 || (largest > 1e-100 && largest < 1e100)) return 1.0;
  // Its inverse must be a double too.
  return std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1020, 1020));
}

}  // namespace

Spline premultiplied(const Curve& curve, bool rational) {
  const std::size_t n = curve.size();
  const auto dim = static_cast<std::size_t>(curve.dim());
  Spline spline;
  spline.degree = curve.degree();
  spline.rational = rational;
  spline.stride = curve.dim() + (rational ? 1 : 0);
  spline.knots = curve.knots();
  const std::span<const double> coords = curve.control_points().data();
  const double scale = spline.scale = power_of_two_scale(coords);
  if (!rational) {
    spline.coefficients.assign(coords.begin(), coords.end());
    if (scale != 1.0) {
      for (double& x : spline.coefficients) x *= scale;
    }
    return spline;
  }
  // Weights matter up to a common factor only; with the largest at 1 the products stay in range.
  double largest = 1.0;
  if (curve.is_rational()) largest = *std::max_element(curve.weights().begin(), curve.weights().end());
  spline.coefficients.resize(n * (dim + 1));
  for (std::size_t i = 0; i < n; ++i) {
    const double w = curve.is_rational() ? curve.weights()[i] / largest : 1.0;
    double* out = spline[i];
    for (std::size_t c = 0; c < dim; ++c) out[c] = w * (scale * coords[i * dim + c]);
    out[dim] = w;
  }
  return spline;
}

Curve euclidean(Spline spline) {
  if (!spline.rational) {
    if (spline.scale != 1.0) {
      for (double& x : spline.coefficients) x /= spline.scale;
    }
    return Curve(spline.degree, std::move(spline.knots),
                 Points(spline.stride, std::move(spline.coefficients)));
  }
  const std::size_t n = spline.size();
  const auto dim = static_cast<std::size_t>(spline.stride) - 1;
  std::vector<double> coords(n * dim);
  std::vector<double> weights(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double* in = spline[i];
    weights[i] = in[dim];
    for (std::size_t c = 0; c < dim; ++c) coords[i * dim + c] = in[c] / in[dim] / spline.scale;
  }
  return Curve(spline.degree, std::move(spline.knots), Points(spline.stride - 1, std::move(coords)),
               std::move(weights));
}

Blossom::Blossom(const Spline& spline)
    : spline_(spline),
      fresh_(static_cast<std::size_t>(spline.degree)),
      scratch_(static_cast<std::size_t>(spline.degree + 1) * static_cast<std::size_t>(spline.stride)) {}

void Blossom::operator()(const double* args, double* out) {
  const std::vector<double>& knots = spline_.knots;
  const auto p = static_cast<std::size_t>(spline_.degree);
  const auto stride = static_cast<std::size_t>(spline_.stride);
  const std::size_t n = spline_.size();

  // The knots among the arguments are consecutive, [begin, end): their control points are at hand. Of a knot
  // that stands there more often than asked for, the copies next to the other arguments are taken, or those
  // next to the domain.
  std::size_t begin = place_;
  if (begin > 0 && knots[begin - 1] >= args[0]) begin = 0;
  while (begin < knots.size() && knots[begin] < args[0]) ++begin;
  place_ = begin;
  std::size_t copies = 0;
  while (copies < p && args[copies] == args[0]) ++copies;
  std::size_t after = begin;
  while (after < knots.size() && knots[after] == args[0]) ++after;
  const bool right_end = copies == p && args[0] == knots[n];
  if (after - begin > copies && !right_end) begin = after - copies;
  std::size_t end = begin;
  std::size_t fresh = 0;
  for (std::size_t i = 0; i < p; ++i) {
    if (end < knots.size() && knots[end] == args[i]) {
      ++end;
    } else {
      fresh_[fresh++] = args[i];
    }
  }

  const double* from = spline_[begin - fresh - 1];
  if (fresh == 0) {
    std::copy(from, from + stride, out);
    return;
  }
  std::copy(from, from + (fresh + 1) * stride, scratch_.begin());
  for (std::size_t level = 1; level <= fresh; ++level) {
    const double x = fresh_[level - 1];
    for (std::size_t i = 0; i + level <= fresh; ++i) {
      const double lo = knots[begin + i - (fresh - level + 1)];
      const double hi = knots[end + i];
      const double share = (x - lo) / (hi - lo);
      double* a = scratch_.data() + i * stride;
      const double* b = a + stride;
      for (std::size_t c = 0; c < stride; ++c) a[c] = (1.0 - share) * a[c] + share * b[c];
    }
  }
  std::copy(scratch_.begin(), scratch_.begin() + static_cast<std::ptrdiff_t>(stride), out);
}

Spline over_knots(const Spline& spline, std::vector<double> knots) {
  Spline result;
  result.degree = spline.degree;
  result.stride = spline.stride;
  result.rational = spline.rational;
  result.scale = spline.scale;
  const std::size_t n = knots.size() - static_cast<std::size_t>(spline.degree) - 1;
  result.coefficients.resize(n * static_cast<std::size_t>(spline.stride));
  Blossom blossom(spline);
  for (std::size_t i = 0; i < n; ++i) blossom(knots.data() + i + 1, result[i]);
  result.knots = std::move(knots);
  return result;
}

std::vector<double> clamped_knots(const Spline& spline, Interval part) {
  const auto order = static_cast<std::size_t>(spline.degree) + 1;
  const auto first = std::upper_bound(spline.knots.begin(), spline.knots.end(), part.lo);
  const auto last = std::lower_bound(first, spline.knots.end(), part.hi);
  std::vector<double> knots(order, part.lo);
  knots.reserve(2 * order + static_cast<std::size_t>(last - first));
  knots.insert(knots.end(), first, last);
  knots.insert(knots.end(), order, part.hi);
  return knots;
}

bool is_clamped(const Curve& curve) {
  const Interval domain = curve.domain();
  return curve.knots().front() == domain.lo && curve.knots().back() == domain.hi;
}

Spline part_of(const Spline& spline, Interval part) {
  return over_knots(spline, clamped_knots(spline, part));
}

Spline clamped(Spline spline) {
  const Interval domain = spline.domain();
  if (spline.knots.front() == domain.lo && spline.knots.back() == domain.hi) return spline;
  return part_of(spline, domain);
}

void append(Spline& spline, const Spline& next, double shift) {
  const auto stride = static_cast<std::size_t>(spline.stride);
  const auto order = static_cast<std::size_t>(spline.degree) + 1;
  const std::size_t dim = stride - (spline.rational ? 1 : 0);
  const double factor = spline.rational ? spline.coefficients.back() / next.coefficients[stride - 1] : 1.0;
  const double ratio = spline.scale / next.scale;
  const double joint = spline.knots.back();
  spline.knots.pop_back();
  for (std::size_t i = order; i < next.knots.size(); ++i) {
    spline.knots.push_back(std::max(joint, next.knots[i] + shift));
  }
  for (std::size_t i = stride; i < next.coefficients.size(); ++i) {
    spline.coefficients.push_back((i % stride < dim ? ratio : 1.0) * (factor * next.coefficients[i]));
  }
}

Pieces decompose(const Spline& spline) {
  const auto p = static_cast<std::size_t>(spline.degree);
  const auto stride = static_cast<std::size_t>(spline.stride);
  const Interval domain = spline.domain();
  Pieces pieces;
  pieces.degree = spline.degree;
  pieces.stride = spline.stride;
  pieces.rational = spline.rational;
  pieces.scale = spline.scale;
  pieces.breaks.push_back({domain.lo, spline.degree + 1});
  const auto first = std::upper_bound(spline.knots.begin(), spline.knots.end(), domain.lo);
  const auto last = std::lower_bound(first, spline.knots.end(), domain.hi);
  for (auto knot = first; knot != last; ++knot) {
    if (*knot != pieces.breaks.back().value) pieces.breaks.push_back({*knot, 0});
    ++pieces.breaks.back().multiplicity;
  }
  pieces.breaks.push_back({domain.hi, spline.degree + 1});

  pieces.coefficients.resize(pieces.size() * pieces.piece_length());
  std::vector<double> args(p);
  Blossom blossom(spline);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::fill(args.begin(), args.end(), pieces.breaks[i].value);
    double* out = pieces[i];
    if (i > 0) {
      std::copy(out - stride, out, out);
    } else {
      blossom(args.data(), out);
    }
    for (std::size_t j = 1; j <= p; ++j) {
      args[p - j] = pieces.breaks[i + 1].value;
      blossom(args.data(), out + j * stride);
    }
  }
  return pieces;
}

namespace {

// The blossom of a Bezier piece at local parameters 0 (the first arguments), 1 (`ones` of them) and, `others`
// times, x.
void extrapolate(const double* piece, std::size_t stride, std::size_t ones, std::size_t others, double x,
                 std::vector<double>& scratch, double* out) {
  scratch.assign(piece + ones * stride, piece + (ones + others + 1) * stride);
  for (std::size_t level = others; level > 0; --level) {
    for (std::size_t i = 0; i < level * stride; ++i) {
      scratch[i] = (1.0 - x) * scratch[i] + x * scratch[i + stride];
    }
  }
  std::copy(scratch.begin(), scratch.begin() + static_cast<std::ptrdiff_t>(stride), out);
}

}  // namespace

Spline assemble(const Pieces& pieces) {
  const auto degree = static_cast<std::size_t>(pieces.degree);
  const auto stride = static_cast<std::size_t>(pieces.stride);
  const std::size_t last = pieces.size();
  Spline spline;
  spline.degree = pieces.degree;
  spline.stride = pieces.stride;
  spline.rational = pieces.rational;
  spline.scale = pieces.scale;
  std::vector<std::size_t> owner;  // which break a knot belongs to
  for (std::size_t b = 0; b <= last; ++b) {
    const bool end = b == 0 || b == last;
    const int least = (pieces.degree + 1) / 2;
    const int copies =
        end ? pieces.degree + 1 : std::clamp(pieces.breaks[b].multiplicity, least, pieces.degree);
    for (int i = 0; i < copies; ++i) {
      spline.knots.push_back(pieces.breaks[b].value);
      owner.push_back(b);
    }
  }

  const std::size_t n = spline.knots.size() - degree - 1;
  spline.coefficients.resize(n * stride);
  std::vector<double> scratch;
  for (std::size_t i = 0; i < n; ++i) {
    double* out = spline[i];
    const std::size_t left = owner[i + 1];
    const std::size_t right = owner[i + degree];
    std::size_t at_left = 1;
    while (at_left < degree && owner[i + 1 + at_left] == left) ++at_left;
    if (right <= left + 1) {
      const double* piece = pieces[left == last ? last - 1 : left];
      const std::size_t index = left == last ? degree : degree - at_left;
      std::copy(piece + index * stride, piece + (index + 1) * stride, out);
      continue;
    }
    // Three breaks: extrapolate the longer of the two pieces into the shorter, which loses the fewest digits.
    std::size_t at_right = 1;
    while (owner[i + degree - at_right] == right) ++at_right;
    const std::size_t between = degree - at_left - at_right;
    const double a = pieces.breaks[left].value;
    const double b = pieces.breaks[left + 1].value;
    const double c = pieces.breaks[right].value;
    if (b - a >= c - b) {
      extrapolate(pieces[left], stride, between, at_right, (c - a) / (b - a), scratch, out);
    } else {
      extrapolate(pieces[left + 1], stride, at_right, at_left, (a - b) / (c - b), scratch, out);
    }
  }
  return spline;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
