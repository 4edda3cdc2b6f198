#include "morph/mirror.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Places along the outline; axes are looked for at them and half-way between.
constexpr std::size_t kPlaces = 256;
// The root mean square of how far the mirror image is off, in radii of gyration: at the nearest place, where
// as much may come from the axis not running through it, and at the axis itself.
constexpr double kRoughly = 0.04;
constexpr double kExactly = 0.01;
// Axes of two outlines are parallel within this angle, in degrees.
constexpr double kParallel = 2.0;
// An axis meets the outline in a joint that is as near, in shares of the length.
constexpr double kAtJoint = 0.004;
// Shares of the length that differ by rounding alone.
constexpr double kRounding = 1e-9;
constexpr double kDegrees = 57.29577951308232;

using Complex = std::complex<double>;

/// What comes of mirroring an outline.
struct Reflected {
  double twice_axis = 0.0;  ///< direction of the axis, doubled, in radians
  double error = 0.0;       ///< how far the mirror image is off, in radii of gyration
};

/// Points at equal lengths, about their mean.
struct Ring {
  std::vector<Complex> points;
  double square = 0.0;

  Ring(const Curve& outline, const ArcLength& lengths) {
    Complex sum;
    for (std::size_t i = 0; i < kPlaces; ++i) {
      const Point p = outline.evaluate(
          lengths.parameter_at(lengths.length() * static_cast<double>(i) / static_cast<double>(kPlaces)));
      points.emplace_back(p[0], p[1]);
      sum += points.back();
    }
    for (Complex& p : points) {
      p -= sum / static_cast<double>(kPlaces);
      square += std::norm(p);
    }
  }
  [[nodiscard]] Complex at(double place) const {
    const double n = static_cast<double>(kPlaces);
    place -= n * std::floor(place / n);
    const auto i = std::min(static_cast<std::size_t>(place), kPlaces - 1);
    return points[i] + (place - static_cast<double>(i)) * (points[(i + 1) % kPlaces] - points[i]);
  }
  // How well the outline agrees on an axis through place k / 2, see reflected(): at most 1. Every pair of
  // points counts, so one part of all sums at a time, in loops over lanes.
  [[nodiscard]] std::vector<double> agreement() const {
    std::vector<double> x(2 * kPlaces);
    std::vector<double> y(2 * kPlaces);
    for (std::size_t i = 0; i < 2 * kPlaces; ++i) {
      x[i] = points[i % kPlaces].real();
      y[i] = points[i % kPlaces].imag();
    }
    std::vector<double> re(kPlaces);
    std::vector<double> im(kPlaces);
    for (std::size_t i = 0; i < kPlaces; ++i) {
      const double* back_x = x.data() + kPlaces - i;
      const double* back_y = y.data() + kPlaces - i;
      for (std::size_t k = 0; k < kPlaces; ++k) {
        re[k] += x[i] * back_x[k] - y[i] * back_y[k];
        im[k] += x[i] * back_y[k] + y[i] * back_x[k];
      }
    }
    std::vector<double> agreement(kPlaces);
    for (std::size_t k = 0; k < kPlaces; ++k) agreement[k] = std::abs(Complex(re[k], im[k])) / square;
    return agreement;
  }
  // Of a point and its mirror image the product is e^(2 i phi) times the square of their distance from the
  // centre, phi being the axis: the sum of products over the outline tells how well they agree on one.
  [[nodiscard]] Reflected reflected(double center) const {
    Complex sum;
    double squares = 0.0;
    for (std::size_t t = 0; t < kPlaces; ++t) {
      const Complex on = at(center + static_cast<double>(t));
      const Complex back = at(center - static_cast<double>(t));
      sum += on * back;
      squares += std::norm(on) + std::norm(back);
    }
    return {std::arg(sum), std::sqrt(std::max(0.0, squares - 2.0 * std::abs(sum)) / square)};
  }
};

double wrapped(double degrees, double period) {
  return degrees - period * std::round(degrees / period);
}

double at_joint(double u, double length, const ArcLength& lengths, Interval domain) {
  const double joint = std::round(u);
  const bool near = std::fabs(lengths.length_to(joint) - lengths.length_to(u)) <= kAtJoint * length;
  if (!near) return u;
  return joint >= domain.hi ? domain.lo : joint;
}

}  // namespace

std::vector<Mirror> find_mirrors(const Curve& outline) {
  std::vector<Mirror> found;
  if (outline.dim() != 2 || !outline.is_closed() || !(outline.extent() > 0.0)) return found;
  const ArcLength lengths(outline, 1e-4);
  const Ring ring(outline, lengths);
  if (!(ring.square > 0.0)) return found;
  const std::vector<double> agreement = ring.agreement();
  const double least = 1.0 - 0.5 * kRoughly * kRoughly;
  for (std::size_t k = 0; k < kPlaces; ++k) {
    const double before = agreement[(k + kPlaces - 1) % kPlaces];
    const double after = agreement[(k + 1) % kPlaces];
    // Rounding decides nothing on a circle.
    if (agreement[k] < least || agreement[k] + 1e-9 < std::max(before, after)) continue;
    const double bend = before - 2.0 * agreement[k] + after;
    const double shift = bend < -1e-9 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
    const double place = 0.5 * (static_cast<double>(k) + shift);
    const Reflected image = ring.reflected(place);
    if (image.error > kExactly) continue;
    const double n = static_cast<double>(kPlaces);
    const auto parameter = [&](double at) {
      const double share = at / n - std::floor(at / n);
      return at_joint(lengths.parameter_at(share * lengths.length()), lengths.length(), lengths,
                      outline.domain());
    };
    const Complex axis = ring.at(place) - ring.at(place + 0.5 * n);
    double degrees = 0.5 * image.twice_axis * kDegrees;
    if (std::fabs(wrapped(std::arg(axis) * kDegrees - degrees, 360.0)) > 90.0) degrees += 180.0;
    found.push_back({parameter(place), parameter(place + 0.5 * n), degrees});
  }
  return found;
}

std::optional<SharedMirror> shared_mirror(std::span<const Mirror> a, std::span<const Mirror> b,
                                          double degrees) {
  std::optional<SharedMirror> best;
  std::pair<double, double> least{};
  for (const Mirror& p : a) {
    for (const Mirror& q : b) {
      const double apart = wrapped(q.degrees - degrees - p.degrees, 180.0);
      if (std::fabs(apart) > kParallel) continue;
      // In steps of half a degree, so that rounding does not choose.
      const std::pair<double, double> rank{std::round(2.0 * std::fabs(apart)),
                                           std::round(2.0 * std::fabs(wrapped(p.degrees - 90.0, 180.0)))};
      if (best && !(rank < least)) continue;
      least = rank;
      const bool same = std::fabs(wrapped(q.degrees - degrees - p.degrees, 360.0)) <= 90.0;
      best = SharedMirror{
          {ParameterPair{p.u, same ? q.u : q.opposite}, ParameterPair{p.opposite, same ? q.opposite : q.u}}};
    }
  }
  return best;
}

Reflection::Reflection(const Curve& outline, double u) : domain_(outline.domain()), lengths_(outline, 1e-6) {
  start_ = lengths_.length_to(u);
}

double Reflection::share(double u) const {
  const double laps = std::floor((u - domain_.lo) / domain_.length());
  const double share = (lengths_.length_to(u - laps * domain_.length()) - start_) / lengths_.length();
  return share - std::floor(share);
}

double Reflection::parameter(double share) const {
  const double length = share * lengths_.length() + start_;
  const double laps = std::floor(length / lengths_.length());
  return lengths_.parameter_at(length - laps * lengths_.length()) + laps * domain_.length();
}

double asymmetry(const Correspondence& correspondence, const Reflection& a, const Reflection& b) {
  double sum = 0.0;
  double whole = 0.0;
  const std::vector<ParameterPair>& points = correspondence.points;
  const auto off = [](double x) { return std::fabs(x - std::round(x)); };
  if (points.empty()) return 0.0;
  ParameterPair from{a.share(points.front().u), b.share(points.front().v)};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const ParameterPair at{0.5 * (points[i].u + points[i + 1].u), 0.5 * (points[i].v + points[i + 1].v)};
    const double p = a.share(at.u);
    const double q = b.share(at.v);
    const double on_b = off(b.share(correspondence.v_at(a.parameter(1.0 - p))) + q);
    const double on_a = off(a.share(correspondence.u_at(b.parameter(1.0 - q))) + p);
    const ParameterPair to{a.share(points[i + 1].u), b.share(points[i + 1].v)};
    const double step_a = to.u - from.u;
    const double step_b = to.v - from.v;
    from = to;
    const double weight = step_a - std::floor(step_a) + step_b - std::floor(step_b);
    const double least = std::min(on_a, on_b);
    sum += weight * least * least;
    whole += weight;
  }
  return whole > 0.0 ? std::sqrt(sum / whole) : 0.0;
}

Correspondence mirrored(const Correspondence& correspondence, const Reflection& a, const Reflection& b) {
  // Shares from the axis on, over the first half.
  std::vector<ParameterPair> half{{0.0, 0.0}};
  const auto from_axis = [](double share) { return share > 1.0 - kRounding ? 0.0 : share; };
  for (std::size_t i = 0; i + 1 < correspondence.points.size(); ++i) {
    const ParameterPair& p = correspondence.points[i];
    const ParameterPair q{from_axis(a.share(p.u)), from_axis(b.share(p.v))};
    if (q.u <= 0.5 && q.v <= 0.5) half.push_back(q);
  }
  std::sort(half.begin(), half.end(), [](const ParameterPair& p, const ParameterPair& q) {
    return p.u != q.u ? p.u < q.u : p.v < q.v;
  });
  const std::size_t size = half.size();
  half.push_back({0.5, 0.5});
  for (std::size_t i = size; i-- > 0;) half.push_back({1.0 - half[i].u, 1.0 - half[i].v});
  Correspondence made = correspondence;
  made.points.clear();
  for (const ParameterPair& p : half) {
    const double u = a.parameter(p.u);
    const double v = b.parameter(p.v);
    // Rounding must not step back.
    made.points.push_back(made.points.empty() ? ParameterPair{u, v}
                                              : ParameterPair{std::max(u, made.points.back().u),
                                                              std::max(v, made.points.back().v)});
  }
  made.points.back() = {made.points.front().u + made.domain_u.length(),
                        made.points.front().v + made.domain_v.length()};
  return made;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
