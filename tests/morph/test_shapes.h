#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/curve/knots.h"
#include "tandem/shape/path_builder.h"
#include "tandem/shape/shape.h"

/// Shapes to morph, and how far they are from each other.
namespace tandem::test {

inline Shape one(const Curve& curve) {
  return Shape{{curve}};
}

/// A smooth closed outline with `lobes` bulges about (center, center): a periodic cubic.
inline Curve blob(int lobes, double center, double radius = 5.0) {
  Points points;
  const int n = 4 * lobes + 4;
  for (int i = 0; i < n + 3; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    const double r = radius * (1 + 0.25 * std::sin(lobes * angle));
    const std::array<double, 2> p{center + r * std::cos(angle), center + r * std::sin(angle)};
    points.push_back(p);
  }
  for (std::size_t i = 0; i < 3; ++i) {  // the last points repeat the first ones exactly
    for (std::size_t k = 0; k < 2; ++k) points[static_cast<std::size_t>(n) + i][k] = points[i][k];
  }
  std::vector<double> knots;
  for (int i = 0; i < n + 7; ++i) knots.push_back((i - 3) / static_cast<double>(n));
  return Curve(3, std::move(knots), std::move(points));
}

/// A closed path of lines and cubics about the origin, of size about 10.
inline Curve any_outline() {
  const int n = *rc::gen::inRange(3, 9);
  const auto wobble = [] { return *rc::gen::inRange(-100, 101) / 100.0; };
  PathBuilder builder;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    const Vec2 p{5 * std::cos(angle) + wobble(), 5 * std::sin(angle) + wobble()};
    if (i == 0) {
      builder.move_to(p);
    } else if (*rc::gen::arbitrary<bool>()) {
      builder.line_to(p);
    } else {
      const Vec2 c = builder.current();
      builder.cubic_to({c.x + wobble(), c.y + wobble()}, {p.x + wobble(), p.y + wobble()}, p);
    }
  }
  builder.close();
  return to_curve(builder.take().front());
}

inline double apart(const Point& p, const Point& q) {
  double sum = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) sum += (p[k] - q[k]) * (p[k] - q[k]);
  return std::sqrt(sum);
}

/// t within the domain of a closed curve.
inline double wrapped(double t, const Curve& closed) {
  const double period = closed.domain().length();
  return t - std::floor((t - closed.domain().lo) / period) * period;
}

/// Parameters over the whole domain, the knots among them.
inline std::vector<double> parameters(const Curve& curve, int count) {
  std::vector<double> ts;
  for (const Knot& knot : distinct_knots(curve.knots())) {
    if (curve.domain().contains(knot.value)) ts.push_back(knot.value);
  }
  for (int i = 0; i <= count; ++i) ts.push_back(curve.domain().lo + curve.domain().length() * i / count);
  return ts;
}

inline std::vector<Point> points_along(const Curve& curve, int count) {
  std::vector<Point> points;
  for (const double t : parameters(curve, count)) points.push_back(curve.evaluate(t));
  return points;
}

/// Largest distance of the points from the curve: the nearest few of many short pieces, searched by golden
/// sections.
inline double distance(const std::vector<Point>& points, const Curve& curve) {
  struct Piece {
    double lo, hi;
    Point p, q;
  };
  std::vector<Piece> pieces;
  constexpr int kPerSpan = 8;
  const std::vector<Knot> knots = distinct_knots(curve.knots());
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    if (knots[i].value < curve.domain().lo || knots[i + 1].value > curve.domain().hi) continue;
    const double step = (knots[i + 1].value - knots[i].value) / kPerSpan;
    for (int k = 0; k < kPerSpan; ++k) {
      const double lo = knots[i].value + k * step;
      pieces.push_back({lo, lo + step, curve.evaluate(lo), curve.evaluate(lo + step)});
    }
  }
  const auto to_chord = [&](const Point& x, const Piece& piece) {
    double along = 0.0;
    double squared = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      along += (x[k] - piece.p[k]) * (piece.q[k] - piece.p[k]);
      squared += (piece.q[k] - piece.p[k]) * (piece.q[k] - piece.p[k]);
    }
    const double share = squared > 0.0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
    Point foot = piece.p;
    for (std::size_t k = 0; k < x.size(); ++k) foot[k] += share * (piece.q[k] - piece.p[k]);
    return apart(x, foot);
  };
  double worst = 0.0;
  for (const Point& point : points) {
    std::vector<std::pair<double, const Piece*>> near;
    for (const Piece& piece : pieces) near.emplace_back(to_chord(point, piece), &piece);
    const std::size_t few = std::min<std::size_t>(4, near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(few), near.end());
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < few; ++i) {
      double lo = near[i].second->lo;
      double hi = near[i].second->hi;
      best = std::min({best, apart(point, near[i].second->p), apart(point, near[i].second->q)});
      constexpr double golden = 0.6180339887498949;
      for (int k = 0; k < 45 && best > 1e-13; ++k) {
        const double a = hi - golden * (hi - lo);
        const double b = lo + golden * (hi - lo);
        const double da = apart(point, curve.evaluate(a));
        const double db = apart(point, curve.evaluate(b));
        best = std::min({best, da, db});
        (da < db ? hi : lo) = da < db ? b : a;
      }
    }
    worst = std::max(worst, best);
  }
  return worst;
}

}  // namespace tandem::test
