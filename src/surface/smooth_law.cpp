#include "surface/smooth_law.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

constexpr int kDegree = 2;
/// Spans to begin with between two corners, and the shortest ones, as shares of the domain.
constexpr std::size_t kFirstSpans = 4;
constexpr double kShortestSpan = 1.0 / 1024.0;
/// Share of uniform speed that is mixed into a path: the least slope that a match allows by default.
constexpr double kUniformShare = 1e-3;
/// Pins are met within this share of v's range, a little above rounding; some rounds do where pins lie apart,
/// and where they share coefficients it takes many.
constexpr double kMetWithin = 1e-14;
constexpr int kMostRounds = 200;

/// v of a path as a function of u, at places where it steps its middle.
class PathValues {
 public:
  PathValues(const FitPath& path, bool closed) : points_(path.points), closed_(closed) {
    double least = 1e300;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const double rise = (points_[i].v - points_[i - 1].v) / length_v();
      const double run = (points_[i].u - points_[i - 1].u) / length_u();
      least = std::min({least, run > 0.0 ? rise / run : 0.0, rise > 0.0 ? run / rise : 0.0});
    }
    uniform_ = least < kUniformShare ? kUniformShare : 0.0;
  }

  [[nodiscard]] double lo() const { return points_.front().u; }
  [[nodiscard]] double hi() const { return points_.back().u; }
  [[nodiscard]] double length_u() const { return hi() - lo(); }
  [[nodiscard]] double length_v() const { return points_.back().v - points_.front().v; }
  [[nodiscard]] const std::vector<ParameterPair>& points() const { return points_; }

  [[nodiscard]] double operator()(double u) const {
    if (closed_ && u < lo()) return (*this)(u + length_u()) - length_v();
    if (closed_ && u > hi()) return (*this)(u - length_u()) + length_v();
    const double straight = points_.front().v + (u - lo()) / length_u() * length_v();
    return uniform_ == 0.0 ? on_path(u) : (1.0 - uniform_) * on_path(u) + uniform_ * straight;
  }

 private:
  [[nodiscard]] double on_path(double u) const {
    const auto first = std::lower_bound(points_.begin(), points_.end(), u,
                                        [](const ParameterPair& p, double x) { return p.u < x; });
    if (first == points_.end()) return points_.back().v;
    if (first->u == u) {
      if (first == points_.begin()) return first->v;
      auto last = first;
      while (last + 1 != points_.end() && (last + 1)->u == u) ++last;
      return last + 1 == points_.end() ? last->v : 0.5 * (first->v + last->v);
    }
    if (first == points_.begin()) return first->v;
    const ParameterPair& a = *(first - 1);
    const double share = (u - a.u) / (first->u - a.u);
    return (1.0 - share) * a.v + share * first->v;
  }

  const std::vector<ParameterPair>& points_;
  bool closed_;
  double uniform_ = 0.0;
};

/// Distinct knots from end to end, and which of them are corners.
struct Breaks {
  std::vector<double> values;
  std::vector<bool> corner;
};

Breaks first_breaks(const FitPath& path, const PathValues& values) {
  std::vector<double> fixed{values.lo()};
  for (const double u : path.corner_parameters) {
    if (u > values.lo() && u < values.hi()) fixed.push_back(u);
  }
  fixed.push_back(values.hi());
  Breaks breaks;
  for (std::size_t i = 0; i + 1 < fixed.size(); ++i) {
    for (std::size_t k = 0; k < kFirstSpans; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(kFirstSpans);
      breaks.values.push_back(k == 0 ? fixed[i] : (1.0 - share) * fixed[i] + share * fixed[i + 1]);
      breaks.corner.push_back(k == 0);
    }
  }
  breaks.values.push_back(values.hi());
  breaks.corner.push_back(true);
  return breaks;
}

bool corner_at_seam(const FitPath& path, const PathValues& values) {
  const std::vector<double>& corners = path.corner_parameters;
  return !corners.empty() && (corners.front() == values.lo() || corners.back() == values.hi());
}

/// The spline over these breaks; across a smooth seam the knots of the other end go on.
Curve spline_over(const Breaks& breaks, const PathValues& values, bool smooth_seam) {
  std::vector<double> knots;
  const std::vector<double>& b = breaks.values;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const bool end = i == 0 || i + 1 == b.size();
    const int times = end ? (smooth_seam ? 1 : kDegree + 1) : (breaks.corner[i] ? kDegree : 1);
    knots.insert(knots.end(), static_cast<std::size_t>(times), b[i]);
  }
  if (smooth_seam) {
    const double period = values.length_u();
    const std::vector<double> turn = knots;
    const std::size_t n = turn.size();
    knots.insert(knots.begin(), {turn[n - 3] - period, turn[n - 2] - period});
    knots.insert(knots.end(), {turn[1] + period, turn[2] + period});
  }
  Points coefficients(1, knots.size() - kDegree - 1);
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    coefficients[i][0] = values(knots[i + 1] == knots[i + 2] ? knots[i + 1] : 0.5 * (knots[i + 1] + knots[i + 2]));
  }
  return Curve(kDegree, std::move(knots), std::move(coefficients));
}

/// The largest deviation on each span, at the path's points and the middle of the span.
std::vector<double> deviations(const Curve& law, const Breaks& breaks, const PathValues& values) {
  std::vector<double> worst(breaks.values.size() - 1, 0.0);
  const auto look = [&](std::size_t span, double u) {
    worst[span] = std::max(worst[span], std::abs(law.evaluate(u)[0] - values(u)) / values.length_v());
  };
  std::size_t span = 0;
  for (const ParameterPair& point : values.points()) {
    while (span + 1 < worst.size() && breaks.values[span + 1] < point.u) ++span;
    look(span, point.u);
  }
  for (std::size_t i = 0; i < worst.size(); ++i) look(i, 0.5 * (breaks.values[i] + breaks.values[i + 1]));
  return worst;
}

/// Halves the spans that miss the path.
bool halve(Breaks& breaks, const std::vector<double>& worst, double tolerance, double shortest) {
  Breaks finer;
  bool halved = false;
  for (std::size_t i = 0; i < worst.size(); ++i) {
    const double a = breaks.values[i];
    const double b = breaks.values[i + 1];
    finer.values.push_back(a);
    finer.corner.push_back(breaks.corner[i]);
    if (worst[i] > tolerance && b - a > shortest) {
      finer.values.push_back(0.5 * (a + b));
      finer.corner.push_back(false);
      halved = true;
    }
  }
  finer.values.push_back(breaks.values.back());
  finer.corner.push_back(true);
  breaks = std::move(finer);
  return halved;
}

/// Shifts coefficients so that the law meets the path at the pins: each moves the three that matter there,
/// until none has to move any more. False when that cannot be, or not increasingly.
bool meet_pins(Curve& law, const PathValues& values, const std::vector<double>& pins, bool smooth_seam) {
  Points coefficients = law.control_points();
  const std::size_t n = coefficients.size();
  // Across a smooth seam the last two are the first two again.
  const std::size_t turn = smooth_seam ? n - kDegree : n;
  const double wanted = kMetWithin * values.length_v();
  bool met = false;
  for (int round = 0; !met && round < kMostRounds; ++round) {
    met = true;
    for (const double u : pins) {
      const double gap = values(u) - law.evaluate(u)[0];
      if (std::abs(gap) <= wanted) continue;
      met = false;
      const std::size_t first = find_span(law.knots(), kDegree, u) - kDegree;
      for (std::size_t i = first; i <= first + kDegree; ++i) {
        for (std::size_t k = i % turn; k < n; k += turn) coefficients[k][0] += gap;
      }
      law = Curve(kDegree, law.knots(), coefficients);
    }
  }
  for (std::size_t i = 1; i < n; ++i) met = met && coefficients[i - 1][0] < coefficients[i][0];
  return met;
}

/// Halves the spans with pins, and those beside them: shorter ones need less of a shift.
bool halve_at(Breaks& breaks, const std::vector<double>& pins, double shortest) {
  std::vector<double> worst(breaks.values.size() - 1, 0.0);
  for (std::size_t i = 0; i < worst.size(); ++i) {
    const double from = breaks.values[i == 0 ? 0 : i - 1];
    const double to = breaks.values[std::min(i + 2, worst.size())];
    for (const double u : pins) worst[i] = from <= u && u <= to ? 1.0 : worst[i];
  }
  return halve(breaks, worst, 0.5, shortest);
}

/// A pin's place within the period.
double in_turn(double u, const PathValues& values, bool closed) {
  return closed ? u - std::floor((u - values.lo()) / values.length_u()) * values.length_u() : u;
}

Reparametrization fit_law(const FitPath& path, const SmoothLawOptions& options, bool reversed);

Reparametrization with_pins_as_corners(FitPath path, SmoothLawOptions options,
                                       const std::vector<double>& pins, bool reversed) {
  path.corner_parameters.insert(path.corner_parameters.end(), pins.begin(), pins.end());
  std::vector<double>& corners = path.corner_parameters;
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  options.pins.clear();
  return fit_law(path, options, reversed);
}

Reparametrization fit_law(const FitPath& path, const SmoothLawOptions& options, bool reversed) {
  const PathValues values(path, options.closed);
  const bool smooth_seam = options.closed && !corner_at_seam(path, values);
  Breaks breaks = first_breaks(path, values);
  Curve law = spline_over(breaks, values, smooth_seam);
  std::vector<double> worst = deviations(law, breaks, values);
  while (halve(breaks, worst, options.tolerance, kShortestSpan * values.length_u())) {
    law = spline_over(breaks, values, smooth_seam);
    worst = deviations(law, breaks, values);
  }
  if (!options.pins.empty()) {
    std::vector<double> pins;
    for (const double u : options.pins) pins.push_back(in_turn(u, values, options.closed));
    while (!meet_pins(law, values, pins, smooth_seam)) {
      if (!halve_at(breaks, pins, kShortestSpan * values.length_u())) {
        return with_pins_as_corners(path, options, pins, reversed);
      }
      law = spline_over(breaks, values, smooth_seam);
    }
    worst = deviations(law, breaks, values);
  }
  return {clamp(law), *std::max_element(worst.begin(), worst.end()), reversed};
}

}  // namespace

Reparametrization smooth_law(const FitPath& path, const SmoothLawOptions& options, bool reversed) {
  return fit_law(path, options, reversed);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
