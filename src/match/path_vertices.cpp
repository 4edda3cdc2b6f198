#include "match/path_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

std::vector<double> pick(const std::vector<double>& values, const std::vector<std::size_t>& indices) {
  std::vector<double> picked;
  picked.reserve(indices.size());
  for (const std::size_t i : indices) picked.push_back(values[i]);
  return picked;
}

}  // namespace

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
    // Parameters may differ by less than their shares of the domain can: one vertex then.
    if (!vertices.x.empty() && x <= vertices.x.back()) {
      vertices.high.back() = frame.y(points[end - 1].v);
      if (end == points.size()) {
        vertices.y.back() = vertices.high.back();
        vertices.own.back() = points.back();
        if (vertices.fixed.back() + 1 != vertices.size()) vertices.fixed.push_back(vertices.size() - 1);
      }
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

std::vector<double> admissible_heights(const Vertices& vertices, const SlopeRange& range) {
  std::vector<double> y = vertices.y;
  const std::size_t ends[] = {0, vertices.fixed.size() - 1};
  const std::vector<double> held =
      limit_slopes(pick(vertices.x, vertices.fixed), pick(y, vertices.fixed), ends, range);
  for (std::size_t k = 0; k < held.size(); ++k) y[vertices.fixed[k]] = held[k];
  return limit_slopes(vertices.x, y, vertices.low, vertices.high, vertices.fixed, range);
}

ParameterPair parameters(const Vertices& vertices, std::size_t i, double y, const Frame& frame) {
  return {vertices.own[i].u, y == vertices.y[i] ? vertices.own[i].v : frame.v(y)};
}

std::vector<ParameterPair> without_drowned(const std::vector<ParameterPair>& points, double ulps) {
  const auto [u0, v0] = points.front();
  const auto [u1, v1] = points.back();
  const double unit = ulps * std::numeric_limits<double>::epsilon();
  const double least_u = unit * std::max(std::abs(u0), std::abs(u1));
  const double least_v = unit * std::max(std::abs(v0), std::abs(v1));
  const auto rises = [least_u, least_v](const ParameterPair& a, const ParameterPair& b) {
    return b.u - a.u > least_u && b.v - a.v > least_v;
  };
  std::vector<ParameterPair> kept{points.front()};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (rises(kept.back(), points[i])) kept.push_back(points[i]);
  }
  while (kept.size() > 1 && !rises(kept.back(), points.back())) kept.pop_back();
  kept.push_back(points.back());
  return kept;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
