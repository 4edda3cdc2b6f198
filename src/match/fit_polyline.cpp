#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "match/fit_kinds.h"
#include "match/path_vertices.h"
#include "match/simplify.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

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

}  // namespace

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
      polyline.push_back(parameters(vertices, i, y[i], frame));
    }
  }
  polyline = without_drowned(polyline, 0.0);

  std::vector<double> knots{polyline.front().u};
  std::vector<double> values;
  for (const ParameterPair& vertex : polyline) {
    knots.push_back(vertex.u);
    values.push_back(vertex.v);
  }
  knots.push_back(polyline.back().u);
  return {Curve(1, std::move(knots), Points(1, std::move(values))),
          polyline_deviation(polyline, vertices, frame), false};
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
