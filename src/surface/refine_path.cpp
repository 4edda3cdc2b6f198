#include "surface/refine_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "curve/evaluator.h"
#include "match/vector.h"
#include "tandem/curve/arc_length.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Places to either side of where the path was, per pass.
constexpr int kPlaces = 8;
/// The window of the first pass, in distances to the neighbours (the mean distance at least); then as a
/// multiple of the distance of the places of the pass before. The last pass leaves them 1/700 of that
/// distance apart.
constexpr double kFirstWindow = 3.0;
constexpr double kNextWindow = 2.0;
constexpr int kPasses = 5;
/// Between nodes that are valid by less than this (6 degrees short of perpendicular tangents) another one is
/// put before the next pass: the path may be invalid between them.
constexpr double kDoubtful = 0.1;
/// Values below this count as invalid here: the fit that follows moves the path by a little.
constexpr double kMargin = 0.01;
/// Weight of invalidity against cost: a hundredth of a node's length with perpendicular tangents is worth
/// avoiding at the price of a whole node's.
constexpr double kInvalidWeight = 100.0;
/// Lengths of curves only scale the strain here.
constexpr double kLengthAccuracy = 1e-3;

struct Place {
  double v = 0.0;
  double cost = 0.0;   ///< per unit of length, invalidity included
  double value = 0.0;  ///< > 0: valid
  Point point;         ///< on the second curve
  double best = 0.0;   ///< of all ways to get here
  std::size_t from = 0;
};

/// A node of the path, which may slide along the second curve by `reach`.
struct Slider {
  ParameterPair at;
  double reach = 0.0;
  double value = 1.0;
};

/// Points of both rails with their tangents.
class Site {
 public:
  explicit Site(const Curve& curve) : evaluator_(curve), tangent_(static_cast<std::size_t>(curve.dim())) {}

  void look(double t, Point& point) {
    point.resize(tangent_.size());
    evaluator_.point_and_derivative(t, Side::right, point, tangent_);
    normalize(tangent_);
  }
  [[nodiscard]] const Point& tangent() const { return tangent_; }

 private:
  Evaluator evaluator_;
  Point tangent_;
};

Slider between(const Slider& x, const Slider& y) {
  return {{0.5 * x.at.u + 0.5 * y.at.u, 0.5 * x.at.v + 0.5 * y.at.v},
          std::max(x.reach, y.reach),
          std::min(x.value, y.value)};
}

/// The path's points with one between each two; of steps at one u the middle. Ends and corners stay.
std::vector<Slider> sliders(const FitPath& path) {
  std::vector<Slider> nodes;
  for (std::size_t i = 0; i < path.points.size();) {
    std::size_t end = i + 1;
    while (end < path.points.size() && path.points[end].u == path.points[i].u) ++end;
    const double low = path.points[i].v;
    const double high = path.points[end - 1].v;
    const double v = i == 0 ? low : end == path.points.size() ? high : 0.5 * low + 0.5 * high;
    if (i > 0) nodes.push_back(between(nodes.back(), {{path.points[i].u, v}}));
    nodes.push_back({{path.points[i].u, v}});
    i = end;
  }
  const double mean_gap = (nodes.back().at.v - nodes.front().at.v) / static_cast<double>(nodes.size() - 1);
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    const bool corner =
        std::binary_search(path.corner_parameters.begin(), path.corner_parameters.end(), nodes[i].at.u);
    const double gap = std::max(nodes[i].at.v - nodes[i - 1].at.v, nodes[i + 1].at.v - nodes[i].at.v);
    // A flat path is not to stay where it is.
    if (!corner) nodes[i].reach = kFirstWindow * std::max(gap, mean_gap);
  }
  return nodes;
}

/// More of them where two in a row are doubtful.
std::vector<Slider> with_more_in_doubt(const std::vector<Slider>& nodes) {
  std::vector<Slider> more = {nodes.front()};
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (std::min(nodes[i - 1].value, nodes[i].value) < kDoubtful) {
      more.push_back(between(nodes[i - 1], nodes[i]));
    }
    more.push_back(nodes[i]);
  }
  return more;
}

class Refinement {
 public:
  Refinement(const Curve& first, const Curve& second, const RailNorm& norm, const RefineOptions& options)
      : first_(first),
        second_(second),
        norm_(norm),
        strain_(options.strain),
        length_first_(arc_length(first, kLengthAccuracy)),
        length_second_(arc_length(second, kLengthAccuracy)) {}

  void pass(std::vector<Slider>& nodes) {
    std::vector<std::vector<Place>> rows(nodes.size());
    const Interval range{nodes.front().at.v, nodes.back().at.v};
    Point before;
    Point here;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      first_.look(nodes[i].at.u, here);
      rows[i] = places(nodes[i], range, here);
      if (i > 0) reach(rows[i - 1], rows[i], distance(before, here) / length_first_);
      std::swap(before, here);
    }
    take_best(nodes, rows);
  }

 private:
  /// Where a node may go.
  [[nodiscard]] std::vector<Place> places(const Slider& node, const Interval& range, const Point& here) {
    const int count = node.reach > 0.0 ? kPlaces : 0;
    std::vector<Place> result;
    for (int k = -count; k <= count; ++k) {
      Place place;
      place.v = node.at.v + node.reach * k / kPlaces;
      if (!range.contains(place.v)) continue;
      second_.look(place.v, place.point);
      const RailValue value = norm_({first_.tangent(), second_.tangent(), here, place.point});
      place.value = value.value;
      place.cost = value.cost + kInvalidWeight * std::max(0.0, kMargin - value.value);
      result.push_back(std::move(place));
    }
    return result;
  }

  /// The best way to each place of a row from the row before.
  void reach(const std::vector<Place>& from, std::vector<Place>& to, double way_first) const {
    for (Place& place : to) {
      place.best = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < from.size(); ++k) {
        if (!(from[k].v < place.v)) break;
        const double way_second = distance(from[k].point, place.point) / length_second_;
        const double way = way_first + way_second;
        const double gap = way_first - way_second;
        const double cost = from[k].best + 0.25 * (from[k].cost + place.cost) * way +
                            (way > 0.0 ? strain_ * gap * gap / way : 0.0);
        if (cost < place.best) {
          place.best = cost;
          place.from = k;
        }
      }
    }
  }

  static void take_best(std::vector<Slider>& nodes, const std::vector<std::vector<Place>>& rows) {
    std::size_t at = 0;
    const bool reached = std::isfinite(rows.back().back().best);
    for (std::size_t i = rows.size(); i-- > 0;) {
      nodes[i].reach *= kNextWindow / kPlaces;
      if (!reached) continue;
      nodes[i].at.v = rows[i][at].v;
      nodes[i].value = rows[i][at].value;
      at = rows[i][at].from;
    }
  }

  Site first_;
  Site second_;
  const RailNorm& norm_;
  double strain_;
  double length_first_;
  double length_second_;
};

}  // namespace

FitPath refine_path(const Curve& first, const Curve& second, const FitPath& path, const RailNorm& norm,
                    const RefineOptions& options) {
  Refinement refinement(first, second, norm, options);
  std::vector<Slider> nodes = sliders(path);
  for (int pass = 0; pass < kPasses; ++pass) {
    if (pass > 0) nodes = with_more_in_doubt(nodes);
    refinement.pass(nodes);
  }
  FitPath refined{{}, path.corner_parameters};
  for (const Slider& node : nodes) refined.points.push_back(node.at);
  return refined;
}

FitPath refine_path_along_first(const Curve& first, const Curve& second, const FitPath& path,
                                const RailNorm& norm, const RefineOptions& options) {
  FitPath inverse;
  for (const ParameterPair& point : path.points) {
    inverse.points.push_back({point.v, point.u});
    const bool corner =
        std::binary_search(path.corner_parameters.begin(), path.corner_parameters.end(), point.u);
    if (corner) inverse.corner_parameters.push_back(point.v);
  }
  const RailNorm swapped = [&](const NormArguments& pair) {
    return norm({pair.tangent2, pair.tangent1, pair.point2, pair.point1});
  };
  FitPath refined{{}, path.corner_parameters};
  for (const ParameterPair& point : refine_path(second, first, inverse, swapped, options).points)
    refined.points.push_back({point.v, point.u});
  return refined;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
