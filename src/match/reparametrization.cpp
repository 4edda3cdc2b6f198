#include "tandem/match/reparametrization.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "match/limit_slopes.h"
#include "match/simplify.h"
#include "match/uniform_fit.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

/// Far beyond any use; larger numbers are typing errors that would only fill the memory.
constexpr int kMostCoefficients = 1'000'000;
constexpr int kHighestOrder = 32;
/// Spans of one piece (between two corners) at which doubling ends, tolerance or not.
constexpr std::size_t kMostSpans = 1024;

void check_options(const ReductionOptions& options) {
  if (options.order < 2 || options.order > kHighestOrder) {
    throw InvalidArgument(
        fmt::format("the order of v is {}, expected 2 .. {}", options.order, kHighestOrder));
  }
  if (!(options.min_slope > 0.0 && options.min_slope <= 1.0)) {
    throw InvalidArgument(fmt::format(
        "the least slope of v is {}, expected more than 0 and at most 1 (the mean)", options.min_slope));
  }
  if (options.coefficients) {
    if (*options.coefficients < options.order || *options.coefficients > kMostCoefficients) {
      throw InvalidArgument(fmt::format("{} coefficients for v of order {}, expected {} .. {}",
                                        *options.coefficients, options.order, options.order,
                                        kMostCoefficients));
    }
  } else if (!(options.tolerance > 0.0)) {
    throw InvalidArgument(fmt::format("the tolerance is {}, expected more than 0", options.tolerance));
  }
}

void check_path(const std::vector<ParameterPair>& points) {
  if (points.size() < 2) {
    throw InvalidArgument(fmt::format("the path has {} points, expected at least 2", points.size()));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [u, v] = points[i];
    if (!std::isfinite(u) || !std::isfinite(v)) {
      throw InvalidArgument(
          fmt::format("point {} of the path is ({}, {}), expected finite numbers", i, u, v));
    }
    if (i > 0 && (u < points[i - 1].u || v < points[i - 1].v)) {
      throw InvalidArgument(fmt::format("point {} of the path is ({}, {}), which steps back from ({}, {})", i,
                                        u, v, points[i - 1].u, points[i - 1].v));
    }
  }
  const auto [u0, v0] = points.front();
  const auto [u1, v1] = points.back();
  if (!(u1 > u0) || !(v1 > v0) || !std::isfinite(u1 - u0) || !std::isfinite(v1 - v0)) {
    throw InvalidArgument(fmt::format(
        "the path leads from ({}, {}) to ({}, {}), expected to rise in u and in v by finite lengths", u0, v0,
        u1, v1));
  }
}

/// The unit square that the path fills: there the mean slope is 1, whatever the units of u and v are.
class Frame {
 public:
  explicit Frame(const std::vector<ParameterPair>& points)
      : u_{points.front().u, points.back().u}, v_{points.front().v, points.back().v} {}

  [[nodiscard]] const Interval& u() const { return u_; }
  [[nodiscard]] double x(double u) const { return (u - u_.lo) / u_.length(); }
  [[nodiscard]] double y(double v) const { return (v - v_.lo) / v_.length(); }
  [[nodiscard]] double u(double x) const { return at(u_, x); }
  [[nodiscard]] double v(double y) const { return at(v_, y); }

 private:
  [[nodiscard]] static double at(const Interval& interval, double share) {
    if (share >= 1.0) return interval.hi;
    return share <= 0.0 ? interval.lo : interval.clamp(interval.lo + share * interval.length());
  }

  Interval u_;
  Interval v_;
};

/// The path's points with the steps at one u drawn together, in the unit square.
struct Vertices {
  std::vector<double> x;           ///< increasing
  std::vector<double> y;           ///< half-way up the step; at the ends the path's own ends
  std::vector<double> low;         ///< foot of the step
  std::vector<double> high;        ///< and its head
  std::vector<ParameterPair> own;  ///< (x, y) as parameters, without the rounding of the unit square
  std::vector<std::size_t> fixed;  ///< first, corners, last

  [[nodiscard]] std::size_t size() const { return x.size(); }
};

Vertices make_vertices(const FitPath& path, const Frame& frame) {
  Vertices vertices;
  const std::vector<ParameterPair>& points = path.points;
  const std::vector<double>& corners = path.corner_parameters;
  for (std::size_t i = 0; i < points.size();) {
    std::size_t end = i + 1;
    while (end < points.size() && points[end].u == points[i].u) ++end;
    double v = points[i].v;
    if (i > 0)
      v = end == points.size() ? points.back().v : (end == i + 1 ? v : 0.5 * v + 0.5 * points[end - 1].v);
    const double x = frame.x(points[i].u);
    // Parameters may differ by less than their shares of the domain can (near 0): one vertex then.
    if (!vertices.x.empty() && x <= vertices.x.back()) {
      vertices.high.back() = frame.y(points[end - 1].v);
      if (end == points.size()) vertices.own.back() = points.back();
      i = end;
      continue;
    }
    const bool corner = std::binary_search(corners.begin(), corners.end(), points[i].u);
    if (i == 0 || end == points.size() || corner) vertices.fixed.push_back(vertices.size());
    vertices.x.push_back(x);
    vertices.y.push_back(frame.y(v));
    vertices.low.push_back(frame.y(points[i].v));
    vertices.high.push_back(frame.y(points[end - 1].v));
    vertices.own.push_back({points[i].u, v});
    i = end;
  }
  return vertices;
}

std::vector<double> pick(const std::vector<double>& values, const std::vector<std::size_t>& indices) {
  std::vector<double> picked;
  picked.reserve(indices.size());
  for (const std::size_t i : indices) picked.push_back(values[i]);
  return picked;
}

/// Heights of the vertices, moved as little as may be so that no slope leaves the range: corners first.
std::vector<double> admissible_heights(const Vertices& vertices, const SlopeRange& range) {
  std::vector<double> y = vertices.y;
  const std::size_t ends[] = {0, vertices.fixed.size() - 1};
  const std::vector<double> held =
      limit_slopes(pick(vertices.x, vertices.fixed), pick(y, vertices.fixed), ends, range);
  for (std::size_t k = 0; k < held.size(); ++k) y[vertices.fixed[k]] = held[k];
  return limit_slopes(vertices.x, y, vertices.low, vertices.high, vertices.fixed, range);
}

Curve scalar_curve(int degree, std::vector<double> knots, std::vector<double> values) {
  return Curve(degree, std::move(knots), Points(1, std::move(values)));
}

/// Leaves out vertices whose steps have drowned in rounding (domains far from 0): the slopes that are left
/// lie in the range, but for what the rounding of the ends makes of it.
std::vector<ParameterPair> without_drowned(std::vector<ParameterPair> vertices, const Frame& frame,
                                           const SlopeRange& range) {
  constexpr double kRounding = 1e-6;
  const double mean = 1.0;
  const auto admissible = [&](const ParameterPair& a, const ParameterPair& b) {
    if (!(b.u > a.u) || !(b.v > a.v)) return false;
    const double slope = (frame.y(b.v) - frame.y(a.v)) / (frame.x(b.u) - frame.x(a.u));
    return slope >= mean * range.lo * (1.0 - kRounding) && slope <= mean * range.hi * (1.0 + kRounding);
  };
  std::vector<ParameterPair> kept;
  kept.reserve(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const bool last = i + 1 == vertices.size();
    while (last && kept.size() > 1 && !admissible(kept.back(), vertices[i])) kept.pop_back();
    if (kept.empty() || last || admissible(kept.back(), vertices[i])) kept.push_back(vertices[i]);
  }
  return kept;
}

double polyline_deviation(const std::vector<ParameterPair>& polyline, const Vertices& vertices,
                          const Frame& frame) {
  double deviation = 0.0;
  std::size_t k = 1;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    while (k + 1 < polyline.size() && polyline[k].u < vertices.own[i].u) ++k;
    const double x0 = frame.x(polyline[k - 1].u);
    const double x1 = frame.x(polyline[k].u);
    const double share = std::clamp((vertices.x[i] - x0) / (x1 - x0), 0.0, 1.0);
    const double y = (1.0 - share) * frame.y(polyline[k - 1].v) + share * frame.y(polyline[k].v);
    deviation = std::max({deviation, vertices.low[i] - y, y - vertices.high[i]});
  }
  return deviation;
}

Reparametrization fit_polyline(const FitPath& path, const ReductionOptions& options,
                               const SlopeRange& range) {
  const Frame frame(path.points);
  const Vertices vertices = make_vertices(path, frame);
  const std::vector<double> y = admissible_heights(vertices, range);

  std::vector<double> low(y.size());
  std::vector<double> high(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    low[i] = std::min(vertices.low[i] - options.tolerance, y[i]);
    high[i] = std::max(vertices.high[i] + options.tolerance, y[i]);
  }
  std::vector<ParameterPair> polyline{path.points.front()};
  for (std::size_t piece = 0; piece + 1 < vertices.fixed.size(); ++piece) {
    const std::size_t begin = vertices.fixed[piece];
    const std::size_t count = vertices.fixed[piece + 1] - begin + 1;
    const auto part = [begin, count](const std::vector<double>& all) {
      return std::span<const double>(all).subspan(begin, count);
    };
    const std::vector<std::size_t> chosen = fewest_vertices(part(vertices.x), part(y), part(low), part(high));
    for (std::size_t k = 1; k < chosen.size(); ++k) {
      const std::size_t i = begin + chosen[k];
      polyline.push_back({vertices.own[i].u, y[i] == vertices.y[i] ? vertices.own[i].v : frame.v(y[i])});
    }
  }
  polyline = without_drowned(std::move(polyline), frame, range);

  std::vector<double> knots{polyline.front().u};
  std::vector<double> values;
  for (const ParameterPair& vertex : polyline) {
    knots.push_back(vertex.u);
    values.push_back(vertex.v);
  }
  knots.push_back(polyline.back().u);
  return {scalar_curve(1, std::move(knots), std::move(values)), polyline_deviation(polyline, vertices, frame),
          false};
}

/// Clamped knots, `spans` of equal length over [lo, hi]; empty when doubles cannot tell them apart.
std::vector<double> uniform_knots(double lo, double hi, std::size_t spans, int degree) {
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, lo);
  knots.reserve(knots.size() * 2 + spans);
  for (std::size_t i = 1; i < spans; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(spans);
    const double knot = lo + share * (hi - lo);
    if (!(knot > knots.back()) || !(knot < hi)) return {};
    knots.push_back(knot);
  }
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, hi);
  return knots;
}

bool increasing(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(), [](double a, double b) { return !(a < b); }) ==
         values.end();
}

/// A part of the path, between two corners, and its spline.
struct Piece {
  std::vector<double> knots;   ///< in u
  std::vector<double> values;  ///< in v; empty when doubles cannot hold that many
  double deviation = 0.0;
};

struct PathData {
  std::vector<double> x;
  std::vector<double> y;
};

Piece fit_piece(std::span<const double> x, std::span<const double> y, Interval u, Interval v,
                std::size_t spans, int degree, const Frame& frame, const SlopeRange& range) {
  Piece piece;
  piece.knots = uniform_knots(u.lo, u.hi, spans, degree);
  if (piece.knots.empty()) return piece;
  std::vector<double> shares;
  shares.reserve(piece.knots.size());
  for (const double knot : piece.knots) shares.push_back(frame.x(knot));
  ScalarFit fit = fit_scalar_spline(x, y, shares, degree, frame.y(v.lo), frame.y(v.hi), range);
  for (double& coefficient : fit.coefficients) coefficient = frame.v(coefficient);
  fit.coefficients.front() = v.lo;
  fit.coefficients.back() = v.hi;
  if (!increasing(fit.coefficients)) return piece;
  piece.values = std::move(fit.coefficients);
  piece.deviation = fit.deviation;
  return piece;
}

PathData in_unit_square(const std::vector<ParameterPair>& points, const Frame& frame) {
  PathData data;
  data.x.reserve(points.size());
  data.y.reserve(points.size());
  for (const ParameterPair& point : points) {
    data.x.push_back(frame.x(point.u));
    data.y.push_back(frame.y(point.v));
  }
  return data;
}

Reparametrization fit_coefficients(const FitPath& path, const ReductionOptions& options,
                                   const SlopeRange& range) {
  const Frame frame(path.points);
  const PathData data = in_unit_square(path.points, frame);
  const int degree = options.order - 1;
  const auto spans = static_cast<std::size_t>(*options.coefficients - degree);
  const Interval v{path.points.front().v, path.points.back().v};
  Piece piece = fit_piece(data.x, data.y, frame.u(), v, spans, degree, frame, range);
  if (piece.values.empty()) {
    throw InvalidArgument(
        fmt::format("{} coefficients do not fit into u in [{}, {}], v in [{}, {}]: doubles cannot "
                    "tell the knots or the values apart, expected fewer",
                    *options.coefficients, frame.u().lo, frame.u().hi, v.lo, v.hi));
  }
  return {scalar_curve(degree, std::move(piece.knots), std::move(piece.values)), piece.deviation, false};
}

Reparametrization fit_spline(const FitPath& path, const ReductionOptions& options, const SlopeRange& range) {
  const Frame frame(path.points);
  const PathData data = in_unit_square(path.points, frame);
  const Vertices vertices = make_vertices(path, frame);
  const std::vector<double> y = admissible_heights(vertices, range);
  const int degree = options.order - 1;

  // Breaks: ends and corners, as far as doubles can tell them apart.
  std::vector<ParameterPair> breaks;
  for (const std::size_t i : vertices.fixed) {
    breaks.push_back({vertices.own[i].u, y[i] == vertices.y[i] ? vertices.own[i].v : frame.v(y[i])});
  }
  breaks = without_drowned(std::move(breaks), frame, range);

  const auto full = static_cast<std::ptrdiff_t>(options.order);
  std::vector<double> knots(static_cast<std::size_t>(full), frame.u().lo);
  std::vector<double> values{path.points.front().v};
  double deviation = 0.0;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const Interval u{breaks[i].u, breaks[i + 1].u};
    const Interval v{breaks[i].v, breaks[i + 1].v};
    const auto begin = std::lower_bound(data.x.begin(), data.x.end(), frame.x(u.lo)) - data.x.begin();
    const auto end = std::upper_bound(data.x.begin(), data.x.end(), frame.x(u.hi)) - data.x.begin();
    const auto count = static_cast<std::size_t>(end - begin);
    const std::span<const double> x =
        std::span<const double>(data.x).subspan(static_cast<std::size_t>(begin), count);
    const std::span<const double> h =
        std::span<const double>(data.y).subspan(static_cast<std::size_t>(begin), count);
    Piece best;
    for (std::size_t spans = 1; spans <= kMostSpans; spans *= 2) {
      Piece piece = fit_piece(x, h, u, v, spans, degree, frame, range);
      if (piece.values.empty()) break;
      if (best.values.empty() || piece.deviation < best.deviation) best = std::move(piece);
      if (best.deviation <= options.tolerance || spans > 4 * count) break;
    }
    if (best.values.empty()) {
      throw InvalidArgument(
          fmt::format("a v of order {} does not fit into u in [{}, {}], v in [{}, {}]: doubles "
                      "cannot tell its coefficients apart, expected a lower order",
                      options.order, u.lo, u.hi, v.lo, v.hi));
    }
    deviation = std::max(deviation, best.deviation);
    knots.insert(knots.end(), best.knots.begin() + full, best.knots.end() - 1);
    values.insert(values.end(), best.values.begin() + 1, best.values.end());
  }
  knots.push_back(frame.u().hi);
  return {scalar_curve(degree, std::move(knots), std::move(values)), deviation, false};
}

}  // namespace

Reparametrization fit(const FitPath& path, const ReductionOptions& options, bool reversed) {
  check_options(options);
  check_path(path.points);
  const SlopeRange range{options.min_slope, 1.0 / options.min_slope};
  Reparametrization result = options.coefficients ? fit_coefficients(path, options, range)
                             : options.order == 2 ? fit_polyline(path, options, range)
                                                  : fit_spline(path, options, range);
  result.reversed = reversed;
  return result;
}

}  // namespace v0
}  // namespace tandem
