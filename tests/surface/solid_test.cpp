#include "tandem/surface/solid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "tandem/error.h"

namespace tandem {
namespace {

constexpr double kPi = std::numbers::pi;

// A closed cubic loop about (x, y) in the plane z; near enough to a circle for a volume within 1e-3.
Curve circle(double x, double y, double z, double r, bool clockwise = false) {
  constexpr int n = 32;
  // Cubic B-spline control points of a circle lie this much outside: 1 / (2/3 + cos(2 pi / n) / 3).
  const double radius = r * 3.0 / (2.0 + std::cos(2.0 * kPi / n));
  Points points(3, n + 3);
  std::vector<double> knots;
  for (int i = 0; i < n + 3; ++i) {
    const double a = (clockwise ? -2.0 : 2.0) * kPi * i / n;
    points[static_cast<std::size_t>(i)][0] = x + radius * std::cos(a);
    points[static_cast<std::size_t>(i)][1] = y + radius * std::sin(a);
    points[static_cast<std::size_t>(i)][2] = z;
  }
  for (int i = 0; i < n + 7; ++i) knots.push_back(i);
  return Curve(3, knots, points);
}

Curve polygon(const std::vector<std::array<double, 2>>& corners, double z) {
  Points points(3, corners.size() + 1);
  std::vector<double> knots{0.0};
  for (std::size_t i = 0; i <= corners.size(); ++i) {
    const auto& c = corners[i % corners.size()];
    points[i][0] = c[0];
    points[i][1] = c[1];
    points[i][2] = z;
    knots.push_back(static_cast<double>(i));
  }
  knots.push_back(knots.back());
  return Curve(1, knots, points);
}

Curve square(double size, double z) {
  const double h = 0.5 * size;
  return polygon({{-h, -h}, {h, -h}, {h, h}, {-h, h}}, z);
}

// V - E + F, with the vertices that triangles use.
int euler_characteristic(const TriangleMesh& mesh) {
  std::set<std::uint32_t> vertices;
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      vertices.insert(t[k]);
      edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
  }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(mesh.triangles.size());
}

void expect_closed(const Solid& solid, int characteristic) {
  EXPECT_TRUE(is_watertight(solid.mesh));
  EXPECT_TRUE(boundary_edges(solid.mesh).empty());
  EXPECT_EQ(euler_characteristic(solid.mesh), characteristic);
  EXPECT_GT(solid.report.volume, 0.0);
  EXPECT_DOUBLE_EQ(solid.report.volume, volume(solid.mesh));
}

TEST(Solid, OfTwoSquaresIsAPrism) {
  const Solid solid = contours_to_solid(std::vector<std::vector<Curve>>{{square(2, 1)}, {square(2, 4)}});
  expect_closed(solid, 2);
  EXPECT_NEAR(solid.report.volume, 12.0, 1e-12);
  EXPECT_NEAR(area(solid.mesh), 2 * 4 + 4 * 6, 1e-12);
  EXPECT_EQ(solid.report.caps, 2);
  EXPECT_EQ(solid.report.bands, 1);
}

TEST(Solid, OfTwoCirclesIsAFrustum) {
  const Solid solid =
      contours_to_solid(std::vector<std::vector<Curve>>{{circle(0, 0, 0, 2)}, {circle(0.3, 0, 3, 1)}});
  expect_closed(solid, 2);
  EXPECT_NEAR(solid.report.volume, kPi * 3.0 / 3.0 * (4 + 2 + 1), 0.01 * 7 * kPi);
}

// Whatever the directions of the contours, and downwards as well as upwards.
TEST(Solid, FacesOutwards) {
  for (const double height : {3.0, -3.0}) {
    for (int k = 0; k < 4; ++k) {
      const Solid solid = contours_to_solid(std::vector<std::vector<Curve>>{
          {circle(0, 0, 0, 2, k % 2 == 1)}, {circle(0, 0, height, 2, k / 2 == 1)}});
      expect_closed(solid, 2);
      EXPECT_NEAR(solid.report.volume, 12 * kPi, 0.12 * kPi);
    }
  }
}

TEST(Solid, HasHoles) {
  // A tube is a torus to topology.
  const Solid tube = contours_to_solid(std::vector<std::vector<Curve>>{
      {circle(0, 0, 0, 2), circle(0, 0, 0, 1)}, {circle(0, 0, 1, 1), circle(0, 0, 1, 2)}});
  expect_closed(tube, 0);
  EXPECT_NEAR(tube.report.volume, 3 * kPi, 0.03 * kPi);
  EXPECT_EQ(tube.report.caps, 2);

  // A hole that ends half way leaves a cup.
  const Solid cup =
      contours_to_solid(std::vector<std::vector<Curve>>{{circle(0, 0, 0, 2)},
                                                        {circle(0, 0, 1, 2), circle(0, 0, 1, 1)},
                                                        {circle(0, 0, 2, 2), circle(0, 0, 2, 1)}});
  expect_closed(cup, 2);
  EXPECT_NEAR(cup.report.volume, 4 * kPi + 3 * kPi, 0.07 * kPi);

  // One that begins and ends inside is a void: two spheres.
  const Solid hollow =
      contours_to_solid(std::vector<std::vector<Curve>>{{circle(0, 0, 0, 2)},
                                                        {circle(0, 0, 1, 2), circle(0, 0, 1, 1)},
                                                        {circle(0, 0, 2, 2), circle(0, 0, 2, 1)},
                                                        {circle(0, 0, 3, 2)}});
  expect_closed(hollow, 4);
  EXPECT_NEAR(hollow.report.volume, 11 * kPi, 0.11 * kPi);
}

TEST(Solid, Branches) {
  for (const bool upside_down : {false, true}) {
    std::vector<std::vector<Curve>> levels = {{circle(0, 0, 0, 3)},
                                              {circle(-1.5, 0, 2, 1), circle(1.5, 0.2, 2, 0.8)},
                                              {circle(-2, 0, 4, 1), circle(2, 0.2, 4, 0.8)}};
    if (upside_down) std::reverse(levels.begin(), levels.end());
    const Solid solid = contours_to_solid(levels);
    expect_closed(solid, 2);
    EXPECT_EQ(solid.report.branches, 1);
    EXPECT_EQ(solid.report.caps, 3);
    EXPECT_EQ(solid.report.bands, 4);
    const double legs = 2 * kPi * (1 + 0.64);
    EXPECT_GT(solid.report.volume, legs + 2 * kPi * (1 + 0.64));
    EXPECT_LT(solid.report.volume, legs + 2 * kPi * 9);
  }
}

// Two legs that part and meet again enclose a hole.
TEST(Solid, PartsAndMeets) {
  const Solid ring = contours_to_solid(std::vector<std::vector<Curve>>{
      {circle(0, 0, 0, 3)}, {circle(-2, 0, 2, 0.8), circle(2, 0, 2, 0.8)}, {circle(0, 0, 4, 3)}});
  expect_closed(ring, 0);
  EXPECT_EQ(ring.report.branches, 2);

  // Cut on both sides of one contour: three below, four above.
  std::vector<std::vector<Curve>> crossing = {{}, {circle(0, 0, 2, 4)}, {}};
  for (int k = 0; k < 4; ++k) {
    const double a = 2 * kPi * k / 4 + 0.3;
    crossing[2].push_back(circle(2.5 * std::cos(a), 2.5 * std::sin(a), 4, 0.9));
  }
  for (int k = 0; k < 3; ++k) {
    const double a = 2 * kPi * k / 3;
    crossing[0].push_back(circle(2.5 * std::cos(a), 2.5 * std::sin(a), 0, 0.9));
  }
  const Solid both = contours_to_solid(crossing);
  expect_closed(both, 2);
  EXPECT_EQ(both.report.branches, 2);
  EXPECT_EQ(both.report.caps, 7);
}

TEST(Solid, EndsWhatHasNoPartner) {
  const Solid solid =
      contours_to_solid(std::vector<std::vector<Curve>>{{circle(0, 0, 0, 1), circle(5, 0, 0, 1)},
                                                        {circle(0, 0, 1, 1), circle(9, 0, 1, 1)},
                                                        {circle(0, 0, 2, 1), circle(9, 0, 2, 1)}});
  // Nothing comes of the one at (5, 0).
  EXPECT_TRUE(is_watertight(solid.mesh));
  EXPECT_EQ(euler_characteristic(solid.mesh), 4);
  EXPECT_NEAR(solid.report.volume, 3 * kPi, 0.03 * kPi);
  EXPECT_EQ(solid.report.caps, 4);
  EXPECT_EQ(solid.report.left_out, 1);
}

TEST(Solid, LiesInAnyParallelPlanes) {
  std::vector<std::vector<Curve>> levels = {{square(2, 0)}, {square(2, 3)}};
  for (auto& level : levels) {
    Points p = level[0].control_points();
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double x = p[i][0];
      const double z = p[i][2];
      p[i][0] = 100 + 0.6 * x - 0.8 * z;
      p[i][2] = 0.8 * x + 0.6 * z;
    }
    level[0] = Curve(1, level[0].knots(), p);
  }
  const Solid solid = contours_to_solid(levels);
  expect_closed(solid, 2);
  EXPECT_NEAR(solid.report.volume, 12.0, 1e-9);
}

// Random stacks of stars, some of them branching: closed, whatever they look like.
TEST(Solid, IsAlwaysClosed) {
  std::mt19937 random(3);
  const auto number = [&](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  };
  const auto star = [&](double x, double y, double z, double r) {
    std::vector<std::array<double, 2>> corners;
    const int n = std::uniform_int_distribution<int>(3, 12)(random);
    for (int i = 0; i < n; ++i) {
      const double a = 2 * kPi * i / n;
      const double own = r * number(0.3, 1.0);
      corners.push_back({x + own * std::cos(a), y + own * std::sin(a)});
    }
    return polygon(corners, z);
  };
  for (int trial = 0; trial < 8; ++trial) {
    std::vector<std::vector<Curve>> levels(4);
    for (std::size_t l = 0; l < levels.size(); ++l) {
      const int count = std::uniform_int_distribution<int>(1, 3)(random);
      for (int k = 0; k < count; ++k) {
        // Apart from each other, but each in the reach of several of the next level.
        const double a = 2 * kPi * k / count + 0.7 * static_cast<double>(l);
        const double d = count == 1 ? 0.0 : 2.0;
        levels[l].push_back(
            star(d * std::cos(a), d * std::sin(a), static_cast<double>(l), count == 1 ? 4 : 1.7));
      }
    }
    const Solid solid = contours_to_solid(levels);
    EXPECT_TRUE(is_watertight(solid.mesh)) << trial;
    EXPECT_GT(solid.report.volume, 0.0) << trial;
    EXPECT_EQ(euler_characteristic(solid.mesh) % 2, 0) << trial;
  }
}

TEST(Solid, SaysWhetherItsTrianglesCross) {
  const Solid good = contours_to_solid(std::vector<std::vector<Curve>>{
      {circle(0, 0, -1, 2)}, {circle(0, 0, 0, 2)}, {circle(-1.5, 0, 1, 1), circle(1.5, 0, 1, 1)}});
  EXPECT_EQ(good.report.simple, Verdict::certified);
  // A contour that branches right at a cap: along the chord it is cut at the solid has no thickness.
  const Solid pinched = contours_to_solid(
      std::vector<std::vector<Curve>>{{circle(0, 0, 0, 2)}, {circle(-1.5, 0, 1, 1), circle(1.5, 0, 1, 1)}});
  EXPECT_EQ(pinched.report.simple, Verdict::violated);
  // An E whose arms point the other way on the next level: half way they pass through each other.
  const auto comb = [](double side, double z) {
    std::vector<std::array<double, 2>> corners = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 2}, {4, 2},
                                                  {4, 3}, {1, 3}, {1, 4}, {4, 4}, {4, 5}, {0, 5}};
    for (auto& c : corners) c[0] *= side;
    return polygon(corners, z);
  };
  const Solid crossed = contours_to_solid(std::vector<std::vector<Curve>>{{comb(1.0, 0)}, {comb(-1.0, 1)}});
  EXPECT_TRUE(is_watertight(crossed.mesh));
  EXPECT_EQ(crossed.report.simple, Verdict::violated);
  EXPECT_NE(crossed.report.crossing[0], crossed.report.crossing[1]);
}

std::string message(const std::vector<std::vector<Curve>>& levels) {
  try {
    static_cast<void>(contours_to_solid(levels));
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(Solid, RefusesWhatIsNoStack) {
  EXPECT_EQ(message({{square(1, 0)}}), "1 level of contours, expected at least 2");
  EXPECT_EQ(message({{square(1, 0)}, {}}), "level 1 has no contours");
  EXPECT_EQ(message({{square(1, 0)}, {square(1, 0)}}),
            "level 1 does not lie beyond level 0, expected levels in order");
  EXPECT_EQ(message({{square(1, 0)}, {square(1, 2)}, {square(1, 1)}}),
            "level 2 does not lie beyond level 1, expected levels in order");
  EXPECT_EQ(message({{square(1, 0)}, {Curve(1, {0, 0, 1, 1}, Points({{0, 0, 1}, {1, 0, 1}}))}}),
            "contour 0 of level 1 is open, expected a closed one");
  EXPECT_EQ(
      message({{square(1, 0)}, {Curve(1, {0, 0, 1, 2, 3, 3}, Points({{0, 0}, {1, 0}, {1, 1}, {0, 0}}))}}),
      "contour 0 of level 1 has dimension 2, expected 3");
  EXPECT_NE(message({{square(1, 0)},
                     {Curve(1, {0, 0, 1, 2, 3, 3}, Points({{0, 0, 1}, {1, 0, 1}, {1, 1, 2}, {0, 0, 1}}))}})
                .find("plane"),
            std::string::npos);
  const Curve far_left = polygon({{-9, 0}, {-8, 0}, {-8, 1}}, 1);
  const Curve far_right = polygon({{9, 0}, {10, 0}, {10, 1}}, 1);
  EXPECT_EQ(message({{square(1, 0)}, {far_left, far_right}}),
            "no contour overlaps one of the next level, seen along the levels' normal");
  EXPECT_EQ(message({{square(1, 0)}, {polygon({{0, 0}, {1, 0}}, 1)}}),
            "contour 0 of level 1 encloses no area");
}

}  // namespace
}  // namespace tandem
