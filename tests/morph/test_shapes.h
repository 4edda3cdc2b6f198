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

/// Largest distance of the points from the curve: of many short pieces the nearest few, by their chords,
/// halved again and again. Several are kept, since near a cusp the distance has more than one dip.
inline double distance(const std::vector<Point>& points, const Curve& curve) {
  struct Piece {
    double lo, hi;
    Point p, q;
    double away = 0.0;
  };
  constexpr int kPerSpan = 8;
  constexpr std::size_t kKept = 8;
  constexpr int kHalvings = 42;
  std::vector<Piece> all;
  const std::vector<Knot> knots = distinct_knots(curve.knots());
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    if (knots[i].value < curve.domain().lo || knots[i + 1].value > curve.domain().hi) continue;
    const double step = (knots[i + 1].value - knots[i].value) / kPerSpan;
    for (int k = 0; k < kPerSpan; ++k) {
      const double lo = knots[i].value + k * step;
      all.push_back({lo, lo + step, curve.evaluate(lo), curve.evaluate(lo + step)});
    }
  }
  const auto to_chord = [](const Point& x, const Piece& piece) {
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
  const auto keep_nearest = [&](const Point& x, std::vector<Piece>& pieces) {
    for (Piece& piece : pieces) piece.away = to_chord(x, piece);
    const auto nearer = [](const Piece& a, const Piece& b) { return a.away < b.away; };
    const std::size_t kept = std::min(kKept, pieces.size());
    std::partial_sort(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(kept), pieces.end(),
                      nearer);
    pieces.resize(kept);
  };
  double worst = 0.0;
  for (const Point& point : points) {
    std::vector<Piece> near = all;
    keep_nearest(point, near);
    for (int round = 0; round < kHalvings; ++round) {
      std::vector<Piece> halves;
      for (const Piece& piece : near) {
        const double middle = 0.5 * (piece.lo + piece.hi);
        const Point p = curve.evaluate(middle);
        halves.push_back({piece.lo, middle, piece.p, p});
        halves.push_back({middle, piece.hi, p, piece.q});
      }
      keep_nearest(point, halves);
      near = std::move(halves);
    }
    worst = std::max(worst, near.front().away);
  }
  return worst;
}

}  // namespace tandem::test
