#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "match/fit_kinds.h"
#include "match/path_vertices.h"
#include "match/uniform_fit.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Spans at which halving ends, tolerance or not, as a share of the whole domain. A piece between two corners
/// may have kFewestSpans of them however short it is.
constexpr double kShortestSpan = 1.0 / 1024.0;
constexpr double kFewestSpans = 16.0;
/// Doubles that must lie between two corners, times the order: else the later one is no break of its own.
constexpr double kRoomPerCoefficient = 16.0;

/// Width of the least increment of v in doubles: enough that rounding cannot close it.
constexpr double kDoublesPerIncrement = 4.0;

/// Clamped knots, `spans` of equal length over the domain; empty when doubles cannot tell them apart.
std::vector<double> uniform_knots(const Interval& domain, std::size_t spans, int degree) {
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, domain.lo);
  knots.reserve(knots.size() * 2 + spans);
  for (std::size_t i = 1; i < spans; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(spans);
    const double knot = domain.lo + share * domain.length();
    if (!(knot > knots.back()) || !(knot < domain.hi)) return {};
    knots.push_back(knot);
  }
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, domain.hi);
  return knots;
}

/// The path, or the part of it from one corner to the next.
struct Part {
  std::span<const double> x;  ///< in the unit square
  std::span<const double> y;
  Interval u;
  Interval v;
};

/// The range with its lower end raised so far that every increment is some doubles wide; but not above the
/// mean slope.
SlopeRange with_room(const SlopeRange& range, const Part& part, std::span<const double> shares, int degree,
                     const Frame& frame) {
  const double size = std::max(std::abs(part.v.lo), std::abs(part.v.hi));
  const double unit =
      kDoublesPerIncrement * std::numeric_limits<double>::epsilon() * size / frame.v().length();
  double shortest = 1.0;
  const auto reach = static_cast<std::size_t>(degree);
  for (std::size_t i = 1; i + reach + 1 < shares.size(); ++i) {
    shortest = std::min(shortest, (shares[i + reach] - shares[i]) / degree);
  }
  const double rise = frame.y(part.v.hi) - frame.y(part.v.lo);
  const double mean = rise / (shares.back() - shares.front());
  return {std::max(range.lo, std::min(unit / shortest, mean)), range.hi};
}

bool increasing(const std::vector<double>& values) {
  const auto not_below = [](double a, double b) { return !(a < b); };
  return std::adjacent_find(values.begin(), values.end(), not_below) == values.end();
}

struct Spline {
  std::vector<double> knots;   ///< in u
  std::vector<double> values;  ///< in v
  double deviation = 0.0;
};

/// Nothing when doubles cannot tell the knots or the values apart.
std::optional<Spline> fit_uniform(const Part& part, std::size_t spans, int degree, const Frame& frame,
                                  const SlopeRange& range) {
  std::vector<double> knots = uniform_knots(part.u, spans, degree);
  if (knots.empty()) return std::nullopt;
  std::vector<double> shares;
  shares.reserve(knots.size());
  for (const double knot : knots) shares.push_back(frame.x(knot));
  const SlopeRange slopes = with_room(range, part, shares, degree, frame);
  ScalarFit fit =
      fit_scalar_spline(part.x, part.y, shares, degree, frame.y(part.v.lo), frame.y(part.v.hi), slopes);
  std::vector<double>& values = fit.coefficients;
  for (double& value : values) value = part.v.clamp(frame.v(value));
  values.front() = part.v.lo;
  values.back() = part.v.hi;
  if (!increasing(values)) return std::nullopt;
  return Spline{std::move(knots), std::move(values), fit.deviation};
}

/// Spans halved until the tolerance holds, or they are as short as they may be: the best of these.
std::optional<Spline> fit_within(const Part& part, double tolerance, int degree, const Frame& frame,
                                 const SlopeRange& range) {
  const double share = frame.x(part.u.hi) - frame.x(part.u.lo);
  const double most_spans = std::max(kFewestSpans, share / kShortestSpan);
  std::optional<Spline> best;
  for (std::size_t spans = 1; static_cast<double>(spans) <= most_spans; spans *= 2) {
    std::optional<Spline> spline = fit_uniform(part, spans, degree, frame, range);
    if (!spline) break;
    if (!best || spline->deviation < best->deviation) best = std::move(spline);
    if (best->deviation <= tolerance) break;
  }
  return best;
}

struct PathData {
  std::vector<double> x;
  std::vector<double> y;

  /// The points with u in [from.u, to.u].
  [[nodiscard]] Part part(const ParameterPair& from, const ParameterPair& to, const Frame& frame) const {
    const auto first = std::lower_bound(x.begin(), x.end(), frame.x(from.u));
    const auto last = std::upper_bound(first, x.end(), frame.x(to.u));
    const auto skipped = static_cast<std::size_t>(first - x.begin());
    const auto count = static_cast<std::size_t>(last - first);
    return {std::span(x).subspan(skipped, count),
            std::span(y).subspan(skipped, count),
            {from.u, to.u},
            {from.v, to.v}};
  }
};

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

[[noreturn]] void throw_too_many(int coefficients, const Part& part) {
  throw InvalidArgument(
      fmt::format("{} coefficients for u in [{}, {}], v in [{}, {}]: doubles cannot tell the knots or "
                  "the values apart, expected fewer",
                  coefficients, part.u.lo, part.u.hi, part.v.lo, part.v.hi));
}

/// Ends and corners, as far as doubles can tell them apart.
std::vector<ParameterPair> breaks(const FitPath& path, int order, const Frame& frame,
                                  const SlopeRange& range) {
  const Vertices vertices = make_vertices(path, frame);
  const std::vector<double> y = admissible_heights(vertices, range);
  std::vector<ParameterPair> points;
  for (const std::size_t i : vertices.fixed) points.push_back(parameters(vertices, i, y[i], frame));
  return without_drowned(points, kRoomPerCoefficient * order);
}

}  // namespace

Reparametrization fit_coefficients(const FitPath& path, const ReductionOptions& options,
                                   const SlopeRange& range) {
  const Frame frame(path.points);
  const PathData data = in_unit_square(path.points, frame);
  const int degree = options.order - 1;
  const Part whole = data.part(path.points.front(), path.points.back(), frame);
  const auto spans = static_cast<std::size_t>(*options.coefficients - degree);
  std::optional<Spline> spline = fit_uniform(whole, spans, degree, frame, range);
  if (!spline) throw_too_many(*options.coefficients, whole);
  return {Curve(degree, std::move(spline->knots), Points(1, std::move(spline->values))), spline->deviation,
          false};
}

Reparametrization fit_smooth(const FitPath& path, const ReductionOptions& options, const SlopeRange& range) {
  const Frame frame(path.points);
  const PathData data = in_unit_square(path.points, frame);
  const std::vector<ParameterPair> corners = breaks(path, options.order, frame, range);

  // Full multiplicity at both ends, one less at the corners between.
  std::vector<double> knots(static_cast<std::size_t>(options.order), frame.u().lo);
  std::vector<double> values{path.points.front().v};
  double deviation = 0.0;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Part part = data.part(corners[i], corners[i + 1], frame);
    const std::optional<Spline> spline = fit_within(part, options.tolerance, options.order - 1, frame, range);
    if (!spline) throw_too_many(options.order, part);
    knots.insert(knots.end(), spline->knots.begin() + options.order, spline->knots.end() - 1);
    values.insert(values.end(), spline->values.begin() + 1, spline->values.end());
    deviation = std::max(deviation, spline->deviation);
  }
  knots.push_back(frame.u().hi);
  return {Curve(options.order - 1, std::move(knots), Points(1, std::move(values))), deviation, false};
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
