#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/curve/edit.h"
#include "tandem/rank/shape_descriptor.h"

namespace tandem::testing_rank {

inline double uniform(std::mt19937& random, double lo, double hi) {
  return lo + (hi - lo) * (static_cast<double>(random()) / 4294967296.0);
}

/// A closed polygon through these points.
inline Curve polygon(std::vector<Point> corners) {
  corners.push_back(corners.front());
  Points points(static_cast<int>(corners.front().size()), 0);
  for (const Point& p : corners) points.push_back(p);
  return Curve::clamped_uniform(1, std::move(points));
}

/// A star-shaped polygon round the origin with 5 to 12 corners: simple, counter-clockwise, no symmetry.
inline Curve star(std::mt19937& random) {
  const std::size_t n = 5 + random() % 8;
  std::vector<Point> corners;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle =
        6.283185307179586 * (static_cast<double>(i) + uniform(random, -0.3, 0.3)) / static_cast<double>(n);
    const double radius = uniform(random, 0.4, 2.0);
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon(std::move(corners));
}

/// A cubic that wanders to the right.
inline Curve wave(std::mt19937& random, int dim = 2) {
  const std::size_t n = 6 + random() % 7;
  Points points(dim, n);
  for (std::size_t i = 0; i < n; ++i) {
    points[i][0] = static_cast<double>(i) + uniform(random, -0.8, 0.8);
    for (int c = 1; c < dim; ++c) points[i][static_cast<std::size_t>(c)] = uniform(random, -2.0, 2.0);
  }
  return Curve::clamped_uniform(3, std::move(points));
}

/// Turned by `angle`, scaled, moved, and before that mirrored.
inline Curve moved(const Curve& curve, double angle, double scale, double x, double y,
                   bool mirrored = false) {
  Points points = curve.control_points();
  const double c = scale * std::cos(angle);
  const double s = scale * std::sin(angle);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double px = mirrored ? -points[i][0] : points[i][0];
    const double py = points[i][1];
    points[i][0] = c * px - s * py + x;
    points[i][1] = s * px + c * py + y;
  }
  return Curve(curve.degree(), curve.knots(), std::move(points), curve.weights());
}

inline std::vector<ShapeDescriptor> stars(std::size_t count, unsigned seed, int samples = 40) {
  std::mt19937 random(seed);
  std::vector<ShapeDescriptor> shapes;
  for (std::size_t i = 0; i < count; ++i) {
    const Curve turned = moved(star(random), uniform(random, 0.0, 6.0), 1.0, 0.0, 0.0, random() % 2 == 0);
    shapes.push_back(describe(turned, {.samples = samples, .name = "star " + std::to_string(i)}));
  }
  return shapes;
}

}  // namespace tandem::testing_rank
