#pragma once

#include <cmath>
#include <vector>

#include "tandem/surface/surface.h"

namespace tandem::testing {

/// A half circle of radius 1 from angle 0 to pi, rational of degree 2: x, y and weight of 5 control points.
inline const std::vector<std::vector<double>>& half_circle() {
  static const double w = std::sqrt(0.5);
  static const std::vector<std::vector<double>> points = {
      {1, 0, 1}, {1, 1, w}, {0, 1, 1}, {-1, 1, w}, {-1, 0, 1}};
  return points;
}

/// The whole circle: 9 control points, the last is the first.
inline std::vector<std::vector<double>> circle() {
  std::vector<std::vector<double>> points = half_circle();
  for (std::size_t i = 1; i < 5; ++i) {
    points.push_back({-half_circle()[i][0], -half_circle()[i][1], half_circle()[i][2]});
  }
  return points;
}

inline std::vector<double> quadratic_knots(int pieces) {
  std::vector<double> knots(3, 0.0);
  for (int i = 1; i < pieces; ++i) knots.insert(knots.end(), 2, static_cast<double>(i));
  knots.insert(knots.end(), 3, static_cast<double>(pieces));
  return knots;
}

/// A profile (radius, height, weight) turned about the z axis; u runs round, v along the profile.
inline Surface revolve(const std::vector<std::vector<double>>& profile, int degree, std::vector<double> knots) {
  const std::vector<std::vector<double>> round = circle();
  Points points(3, round.size() * profile.size());
  std::vector<double> weights;
  for (std::size_t i = 0; i < round.size(); ++i) {
    for (std::size_t j = 0; j < profile.size(); ++j) {
      const auto at = points[i * profile.size() + j];
      at[0] = round[i][0] * profile[j][0];
      at[1] = round[i][1] * profile[j][0];
      at[2] = profile[j][1];
      weights.push_back(round[i][2] * profile[j][2]);
    }
  }
  return Surface({2, degree}, {quadratic_knots(4), std::move(knots)}, std::move(points), std::move(weights));
}

/// Radius 1 about the origin, from the south pole to the north pole: normals point outwards.
inline Surface sphere() {
  std::vector<std::vector<double>> profile;
  for (const std::vector<double>& p : half_circle()) profile.push_back({p[1], -p[0], p[2]});
  return revolve(profile, 2, quadratic_knots(2));
}

/// The tube of radius r about a circle of radius 1.
inline Surface torus(double r) {
  std::vector<std::vector<double>> profile;
  for (const std::vector<double>& p : circle()) profile.push_back({1.0 + r * p[0], r * p[1], p[2]});
  return revolve(profile, 2, quadratic_knots(4));
}

/// A closed can of radius 1 and height 2: a polyline turned round, with two creases and two poles.
inline Surface can() {
  return revolve({{0, -1, 1}, {1, -1, 1}, {1, 1, 1}, {0, 1, 1}}, 1, {0, 0, 1, 2, 3, 3});
}

}  // namespace tandem::testing
