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

/// Places to either side of where the path was, per pass; the windows of the passes as shares of the distance
/// to the neighbours. The last leaves places less than 1/100 of that distance apart.
constexpr int kPlaces = 8;
constexpr double kWindows[] = {3.0, 0.8, 0.2, 0.05};
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
  Point point;         ///< on the second curve
  double best = 0.0;   ///< of all ways to get here
  std::size_t from = 0;
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

/// The path's points with one between each two; of steps at one u the middle.
FitPath subdivided(const FitPath& path) {
  FitPath result{{}, path.corner_parameters};
  std::vector<ParameterPair> points;
  for (std::size_t i = 0; i < path.points.size();) {
    std::size_t end = i + 1;
    while (end < path.points.size() && path.points[end].u == path.points[i].u) ++end;
    const bool at_end = i == 0 || end == path.points.size();
    const double low = path.points[i].v;
    const double high = path.points[end - 1].v;
    points.push_back({path.points[i].u, !at_end ? 0.5 * low + 0.5 * high : i == 0 ? low : high});
    i = end;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) {
      result.points.push_back(
          {0.5 * points[i - 1].u + 0.5 * points[i].u, 0.5 * points[i - 1].v + 0.5 * points[i].v});
    }
    result.points.push_back(points[i]);
  }
  return result;
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

  void pass(FitPath& path, double window) {
    std::vector<std::vector<Place>> rows(path.points.size());
    Point before;
    Point here;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      first_.look(path.points[i].u, here);
      rows[i] = places(path, i, window, here);
      if (i > 0) {
        reach(rows[i - 1], rows[i], distance(before, here) / length_first_);
      }
      std::swap(before, here);
    }
    take_best(path, rows);
  }

 private:
  /// Where point i of the path may go.
  [[nodiscard]] std::vector<Place> places(const FitPath& path, std::size_t i, double window,
                                          const Point& here) {
    const std::vector<ParameterPair>& points = path.points;
    const bool fixed =
        i == 0 || i + 1 == points.size() ||
        std::binary_search(path.corner_parameters.begin(), path.corner_parameters.end(), points[i].u);
    const double reach =
        fixed ? 0.0 : window * std::max(points[i].v - points[i - 1].v, points[i + 1].v - points[i].v);
    const int count = fixed ? 0 : kPlaces;
    std::vector<Place> result;
    for (int k = -count; k <= count; ++k) {
      Place place;
      place.v = points[i].v + reach * k / kPlaces;
      if (!(place.v >= points.front().v && place.v <= points.back().v)) continue;
      second_.look(place.v, place.point);
      const RailValue value = norm_({first_.tangent(), second_.tangent(), here, place.point});
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

  static void take_best(FitPath& path, const std::vector<std::vector<Place>>& rows) {
    if (!std::isfinite(rows.back().back().best)) return;
    std::size_t at = 0;
    for (std::size_t i = rows.size(); i-- > 0;) {
      path.points[i].v = rows[i][at].v;
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
  FitPath refined = subdivided(path);
  Refinement refinement(first, second, norm, options);
  for (const double window : kWindows) refinement.pass(refined, window);
  return refined;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
