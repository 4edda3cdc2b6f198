#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tandem/curve/arc_length.h"
#include "tandem/curve/curve.h"
#include "tandem/match/match.h"

/// The curves and options of Figures 8, 11 and 13 of [C]; the figures and their tests share them.
namespace tandem::figures {

/// [C]'s own method: m nodes per curve, v(u) of this order with so many coefficients.
inline MatchOptions paper_options(int m, int order, int coefficients) {
  MatchOptions options;
  options.method = Method::paper;
  options.samples = {m, m};
  options.reduction = ReductionOptions{.coefficients = coefficients, .order = order};
  return options;
}

/// The outline as it comes from a digitiser: a polygon of points at equal distances along it, from its start.
inline Curve digitised(const Curve& outline) {
  constexpr int kPoints = 300;
  const ArcLength length(outline);
  Points points(2, kPoints + 1);
  std::vector<double> knots{0.0};
  for (int i = 0; i <= kPoints; ++i) {
    const Point p = outline.evaluate(length.parameter_at(length.length() * (i % kPoints) / kPoints));
    for (std::size_t k = 0; k < 2; ++k) points[static_cast<std::size_t>(i)][k] = p[k];
    knots.push_back(static_cast<double>(i) / kPoints);
  }
  knots.push_back(1.0);
  return Curve(1, std::move(knots), std::move(points));
}

/// examples/data/deer.svg with its antlers at `antlers` of their size, and its hind legs moved by `stride`.
inline Curve edited_deer(const Curve& deer, double antlers, double stride) {
  constexpr std::array kRoot = {105.0, 78.0};  // of the antlers
  constexpr double kNeck = 20.0;               // above the root: from here on it is all antlers
  constexpr double kKnee = 260.0;
  Points points = deer.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto p = points[i];
    const double up = std::fmin(std::fmax((kRoot[1] - p[1]) / kNeck, 0.0), 1.0);
    for (std::size_t k = 0; k < 2; ++k) p[k] -= up * (1.0 - antlers) * (p[k] - kRoot[k]);
    p[0] += stride * std::fmax(p[1] - kKnee, 0.0);
  }
  return Curve(deer.degree(), deer.knots(), std::move(points));
}

}  // namespace tandem::figures
