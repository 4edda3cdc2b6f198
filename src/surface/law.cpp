#include "tandem/surface/law.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "match/fit_kinds.h"
#include "match/path_vertices.h"
#include "match/uniform_fit.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::EndSlopes;
using detail::Frame;
using detail::SlopeRange;

/// Spans at which halving ends, tolerance or not, as a share of the domain: where a part of one curve has no
/// counterpart a path rises by a tenth between nodes that looking once more has put 1/700 of their distance
/// apart.
constexpr double kShortestSpan = 1.0 / 16384.0;
/// Doubles that must lie between two corners, times the order: else the later one is no break of its own.
constexpr double kRoomPerCoefficient = 16.0;
/// Slopes at the seam stay this far within the range, so that the neighbours can make up for them.
constexpr double kInsideRange = 4.0;

/// The path in the unit square.
struct Data {
  std::vector<double> x;
  std::vector<double> y;

  [[nodiscard]] Data part(double from, double to) const {
    const auto first = std::lower_bound(x.begin(), x.end(), from) - x.begin();
    const auto last = std::upper_bound(x.begin(), x.end(), to) - x.begin();
    return {{x.begin() + first, x.begin() + last}, {y.begin() + first, y.begin() + last}};
  }
};

Data in_unit_square(const std::vector<ParameterPair>& points, const Frame& frame) {
  Data data;
  for (const ParameterPair& point : points) {
    data.x.push_back(frame.x(point.u));
    data.y.push_back(frame.y(point.v));
  }
  return data;
}

/// From one corner to the next, in the unit square.
struct Piece {
  double x0 = 0.0;
  double x1 = 1.0;
  double y0 = 0.0;
  double y1 = 1.0;
};

struct Spline {
  std::vector<double> breaks;  ///< of the spans, ends included
  std::vector<double> values;  ///< coefficients
  double deviation = std::numeric_limits<double>::infinity();
};

std::vector<double> clamped_knots(const std::vector<double>& breaks, int degree) {
  std::vector<double> knots(static_cast<std::size_t>(degree), breaks.front());
  knots.insert(knots.end(), breaks.begin(), breaks.end());
  knots.insert(knots.end(), static_cast<std::size_t>(degree), breaks.back());
  return knots;
}

/// Fits one piece of a law, with spans as short as they need to be.
class PieceFit {
 public:
  PieceFit(Data data, const Piece& piece, const LawOptions& options, const EndSlopes& ends)
      : data_(std::move(data)), piece_(piece), options_(options), degree_(options.order - 1), ends_(ends) {}

  [[nodiscard]] Spline run() {
    std::vector<double> breaks = first_breaks();
    Spline best;
    while (true) {
      Spline next = fit(std::move(breaks));
      const std::vector<double> halved = halve_bad_spans(next);
      const bool done = next.deviation <= options_.tolerance || halved.size() == next.breaks.size();
      if (next.deviation < best.deviation || best.values.empty()) best = std::move(next);
      if (done) return best;
      breaks = halved;
    }
  }

 private:
  /// A single span; or, where a slope is to be met at an end, four, so that coefficients are left to fit, and
  /// those at the ends so short that the slope takes no more than a quarter of the rise.
  [[nodiscard]] std::vector<double> first_breaks() const {
    if (!ends_.first && !ends_.last) return {piece_.x0, piece_.x1};
    const double slope = std::max(ends_.first.value_or(0.0), ends_.last.value_or(0.0));
    const double quarter = 0.25 * (piece_.x1 - piece_.x0);
    const double end = std::min(quarter, 0.25 * (piece_.y1 - piece_.y0) / slope);
    return {piece_.x0, piece_.x0 + end, piece_.x0 + 2.0 * quarter, piece_.x1 - end, piece_.x1};
  }

  [[nodiscard]] Spline fit(std::vector<double> breaks) const {
    const SlopeRange range{options_.min_slope, 1.0 / options_.min_slope};
    detail::ScalarFit fitted = detail::fit_scalar_spline(data_.x, data_.y, clamped_knots(breaks, degree_),
                                                         degree_, piece_.y0, piece_.y1, range, ends_);
    return {std::move(breaks), std::move(fitted.coefficients), fitted.deviation};
  }

  /// The breaks with the middles of the spans on which the spline is off by more than the tolerance.
  [[nodiscard]] std::vector<double> halve_bad_spans(const Spline& spline) const {
    const Curve v(degree_, clamped_knots(spline.breaks, degree_), Points(1, spline.values));
    std::vector<double> breaks = {spline.breaks.front()};
    std::size_t l = 0;
    for (std::size_t span = 0; span + 1 < spline.breaks.size(); ++span) {
      const double lo = spline.breaks[span];
      const double hi = spline.breaks[span + 1];
      bool bad = false;
      for (; l < data_.x.size() && data_.x[l] <= hi; ++l) bad = bad || deviation(v, l) > options_.tolerance;
      if (bad && hi - lo > kShortestSpan) breaks.push_back(lo + 0.5 * (hi - lo));
      breaks.push_back(hi);
    }
    return breaks;
  }

  /// To the nearest of the values that share the abscissa of value l.
  [[nodiscard]] double deviation(const Curve& v, std::size_t l) const {
    const double x = data_.x[l];
    const auto [first, last] = std::equal_range(data_.x.begin(), data_.x.end(), x);
    const double value = v.evaluate(x)[0];
    const double low = data_.y[static_cast<std::size_t>(first - data_.x.begin())];
    const double high = data_.y[static_cast<std::size_t>(last - data_.x.begin()) - 1];
    return std::max({0.0, low - value, value - high});
  }

  Data data_;
  Piece piece_;
  const LawOptions& options_;
  int degree_;
  EndSlopes ends_;
};

/// Ends and corners, as far as doubles can tell them apart.
std::vector<ParameterPair> break_points(const FitPath& path, const LawOptions& options, const Frame& frame) {
  const detail::Vertices vertices = detail::make_vertices(path, frame);
  const std::vector<double> y =
      detail::admissible_heights(vertices, {options.min_slope, 1.0 / options.min_slope});
  std::vector<ParameterPair> points;
  for (const std::size_t i : vertices.fixed) points.push_back(detail::parameters(vertices, i, y[i], frame));
  return detail::without_drowned(points, kRoomPerCoefficient * options.order);
}

/// The slope at the seam of a loop: that of a law over the piece that the seam divides.
double seam_slope(const Data& data, const std::vector<Piece>& pieces, const LawOptions& options) {
  // Half a period to either side is far enough from the seam not to matter there.
  const double left = std::max(pieces.back().x0, 0.5);
  const double right = std::min(pieces.front().x1, 0.5);
  Data before = data.part(left, 1.0);
  for (double& x : before.x) x -= 1.0;
  for (double& y : before.y) y -= 1.0;
  const Data after = data.part(0.0, right);
  Piece piece{before.x.front(), after.x.back(), before.y.front(), after.y.back()};
  before.x.insert(before.x.end(), after.x.begin(), after.x.end());
  before.y.insert(before.y.end(), after.y.begin(), after.y.end());
  const Spline spline = PieceFit(std::move(before), piece, options, {}).run();
  const int degree = options.order - 1;
  const Curve v(degree, clamped_knots(spline.breaks, degree), Points(1, spline.values));
  const double least = kInsideRange * options.min_slope;
  return std::clamp(v.derivatives(0.0, 1)[1][0], least, 1.0 / least);
}

std::vector<Piece> pieces_between(const std::vector<ParameterPair>& corners, const Frame& frame) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    pieces.push_back(
        {frame.x(corners[i].u), frame.x(corners[i + 1].u), frame.y(corners[i].v), frame.y(corners[i + 1].v)});
  }
  return pieces;
}

/// The law, joined from the pieces' splines: full multiplicity at both ends, one less at the corners.
class Joined {
 public:
  Joined(const Frame& frame, int order)
      : frame_(frame), degree_(order - 1), knots_(static_cast<std::size_t>(order), frame.u().lo) {}

  void add(const Spline& spline, const ParameterPair& from, const ParameterPair& to) {
    if (values_.empty()) values_.push_back(from.v);
    for (std::size_t i = 1; i + 1 < spline.breaks.size(); ++i) knots_.push_back(frame_.u(spline.breaks[i]));
    knots_.insert(knots_.end(), static_cast<std::size_t>(degree_), to.u);
    for (std::size_t i = 1; i + 1 < spline.values.size(); ++i) {
      values_.push_back(std::clamp(frame_.v(spline.values[i]), from.v, to.v));
    }
    values_.push_back(to.v);
    deviation_ = std::max(deviation_, spline.deviation);
  }

  [[nodiscard]] Reparametrization finish(bool reversed) && {
    knots_.push_back(frame_.u().hi);
    return {Curve(degree_, std::move(knots_), Points(1, std::move(values_))), deviation_, reversed};
  }

 private:
  const Frame& frame_;
  int degree_;
  std::vector<double> knots_;
  std::vector<double> values_;
  double deviation_ = 0.0;
};

/// Is the seam of the loop one of the corners?
bool seam_is_corner(const FitPath& path) {
  return std::any_of(path.corner_parameters.begin(), path.corner_parameters.end(),
                     [&](double u) { return u <= path.points.front().u || u >= path.points.back().u; });
}

Reparametrization fit_pieces(const FitPath& path, const LawOptions& options, bool loop, bool reversed) {
  const Frame frame(path.points);
  const Data data = in_unit_square(path.points, frame);
  const std::vector<ParameterPair> points = break_points(path, options, frame);
  const std::vector<Piece> pieces = pieces_between(points, frame);

  std::optional<double> slope;
  if (loop && !seam_is_corner(path)) slope = seam_slope(data, pieces, options);
  Joined law(frame, options.order);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    EndSlopes ends;
    if (i == 0) ends.first = slope;
    if (i + 1 == pieces.size()) ends.last = slope;
    PieceFit fit(data.part(pieces[i].x0, pieces[i].x1), pieces[i], options, ends);
    law.add(fit.run(), points[i], points[i + 1]);
  }
  return std::move(law).finish(reversed);
}

bool increasing(const Points& values) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (!(values[i - 1][0] < values[i][0])) return false;
  }
  return true;
}

}  // namespace

Reparametrization smooth_law(const FitPath& path, const LawOptions& options, bool loop, bool reversed) {
  const ReductionOptions reduction{{}, options.tolerance, options.order, options.min_slope};
  if (options.order == 2) return fit(path, reduction, reversed);
  // For the checks of path and options alone: with the whole domain for a tolerance it takes no time.
  ReductionOptions coarse = reduction;
  if (options.tolerance > 0.0) coarse.tolerance = 1.0;
  static_cast<void>(fit(path, coarse));
  Reparametrization law = fit_pieces(path, options, loop, reversed);
  // Where doubles cannot tell the values apart fit() takes care.
  return increasing(law.v.control_points()) ? law : fit(path, reduction, reversed);
}

}  // namespace v0
}  // namespace tandem
