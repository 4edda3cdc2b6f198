#pragma once

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "tandem/curve/arc_length.h"
#include "tandem/curve/curve.h"
#include "tandem/match/correspondence.h"

/// Curves whose true correspondence is known: one feature on a straight line, at different places.
namespace tandem::truth {

/// The graph of `feature` over [0, 10] as a cubic B-spline, the feature moved to start at x = `start` and
/// `width` wide. Control points stand at the Greville abscissae (x(t) = 10 t exactly), 0.1 apart: moved by
/// multiples of 0.1, the feature keeps its shape to rounding.
inline Curve feature_line(const std::function<double(double)>& feature, double start, double width) {
  constexpr int spans = 100;
  Points points(2, spans + 3);
  std::vector<double> knots(3, 0.0);
  for (int k = 0; k <= spans; ++k) knots.push_back(static_cast<double>(k) / spans);
  knots.insert(knots.end(), 3, 1.0);
  for (std::size_t i = 0; i < spans + 3; ++i) {
    const double x = 10.0 * (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3.0;
    const double local = (x - start) / width;
    points[i][0] = x;
    points[i][1] = local > 0.0 && local < 1.0 ? feature(local) : 0.0;
  }
  return Curve(3, knots, std::move(points));
}

inline Curve wave(double start) {
  return feature_line([](double x) { return std::sin(2.0 * 3.14159265358979 * x); }, start, 2.0);
}

inline Curve bell(double start) {
  return feature_line([](double x) { return 1.5 * std::pow(std::sin(3.14159265358979 * x), 2); }, start, 2.0);
}

/// RMS distance, in arc length (shares of the whole), between a correspondence and the truth for two feature
/// lines: the features map onto each other, and so do the straight parts before and behind them.
inline double rms_error(const Curve& a, double start_a, const Curve& b, double start_b, double width,
                        const Correspondence& c) {
  const ArcLength arc_a(a);
  const ArcLength arc_b(b);
  const auto at = [](const ArcLength& arc, double x) { return arc.length_to(x / 10.0) / arc.length(); };
  const double a0 = at(arc_a, start_a);
  const double a1 = at(arc_a, start_a + width);
  const double b0 = at(arc_b, start_b);
  const double b1 = at(arc_b, start_b + width);
  double sum = 0.0;
  constexpr int n = 2000;
  for (int k = 0; k < n; ++k) {
    const double s = (k + 0.5) / n;
    const double truth = s < a0   ? s / a0 * b0
                         : s < a1 ? b0 + (s - a0) / (a1 - a0) * (b1 - b0)
                                  : b1 + (s - a1) / (1.0 - a1) * (1.0 - b1);
    const double found = arc_b.length_to(c.v_at(arc_a.parameter_at(s * arc_a.length()))) / arc_b.length();
    sum += (found - truth) * (found - truth);
  }
  return std::sqrt(sum / n);
}

}  // namespace tandem::truth
