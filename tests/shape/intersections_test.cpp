#include "tandem/shape/intersections.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <span>
#include <tuple>
#include <vector>

#include "shape/test_paths.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using test::cubic;
using test::polygon;
using test::polyline;

double orient(Vec2 a, Vec2 b, Vec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double length(Vec2 a, Vec2 b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

/// Crossings of all pairs of edges by the signs of four determinants; nothing when one of them is too near to
/// zero for a verdict, at edges that are no neighbours and meet.
struct BruteForce {
  std::vector<Crossing> crossings;
  bool near_degenerate = false;
};

BruteForce cross_all(const std::vector<std::vector<Vec2>>& polygons, double too_near) {
  struct Edge {
    Vec2 from, to;
    std::size_t polygon, index, count;
  };
  std::vector<Edge> edges;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    const std::size_t n = polygons[p].size();
    for (std::size_t i = 0; i < n; ++i) edges.push_back({polygons[p][i], polygons[p][(i + 1) % n], p, i, n});
  }
  BruteForce result;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Edge& a = edges[i];
      const Edge& b = edges[j];
      if (a.polygon == b.polygon && (b.index - a.index == 1 || b.index - a.index == a.count - 1)) continue;
      const std::array<double, 4> d{orient(a.from, a.to, b.from) / length(a.from, a.to),
                                    orient(a.from, a.to, b.to) / length(a.from, a.to),
                                    orient(b.from, b.to, a.from) / length(b.from, b.to),
                                    orient(b.from, b.to, a.to) / length(b.from, b.to)};
      for (const double x : d) result.near_degenerate = result.near_degenerate || std::fabs(x) < too_near;
      if ((d[0] > 0) == (d[1] > 0) || (d[2] > 0) == (d[3] > 0)) continue;
      const double u = d[2] / (d[2] - d[3]);
      const double v = d[0] / (d[0] - d[1]);
      result.crossings.push_back({a.polygon,
                                  b.polygon,
                                  static_cast<double>(a.index) + u,
                                  static_cast<double>(b.index) + v,
                                  {a.from.x + u * (a.to.x - a.from.x), a.from.y + u * (a.to.y - a.from.y)}});
    }
  }
  std::sort(result.crossings.begin(), result.crossings.end(), [](const Crossing& p, const Crossing& q) {
    return std::tie(p.path_a, p.path_b, p.u, p.v) < std::tie(q.path_a, q.path_b, q.u, q.v);
  });
  return result;
}

std::vector<Vec2> any_polygon() {
  const int n = *rc::gen::inRange(3, 40);
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    points.push_back({*rc::gen::inRange(-100000, 100001) * 1e-4, *rc::gen::inRange(-100000, 100001) * 1e-4});
  }
  return points;
}

void expect_same(const std::vector<Crossing>& found, const std::vector<Crossing>& expected) {
  RC_ASSERT(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    RC_ASSERT(found[i].path_a == expected[i].path_a);
    RC_ASSERT(found[i].path_b == expected[i].path_b);
    RC_ASSERT(std::fabs(found[i].u - expected[i].u) <= 1e-9);
    RC_ASSERT(std::fabs(found[i].v - expected[i].v) <= 1e-9);
    RC_ASSERT(length(found[i].point, expected[i].point) <= 1e-9);
  }
}

TEST(Crossings, OfPolygonsAreThoseOfAllPairsOfEdges) {
  EXPECT_TRUE(rc::check([] {
    std::vector<std::vector<Vec2>> polygons(*rc::gen::inRange<std::size_t>(1, 4));
    std::vector<CubicPath> paths;
    for (auto& points : polygons) {
      points = any_polygon();
      paths.push_back(polygon(points));
    }
    const BruteForce brute = cross_all(polygons, 20 * 1e-5);
    RC_PRE(!brute.near_degenerate);
    expect_same(find_crossings(paths, {.scale = 20.0}), brute.crossings);
    RC_ASSERT(is_simple(paths, {.scale = 20.0}) == brute.crossings.empty());
    std::vector<Crossing> own;
    for (const Crossing& c : brute.crossings) {
      if (c.path_a == c.path_b) own.push_back(c);
    }
    expect_same(find_crossings(paths, {.scale = 20.0, .between = false}), own);
  }));
}

// On a coarse grid vertices fall onto edges and onto each other all the time. Moved apart by a generic affine
// map or not, the verdict is the same, and so it is from any start and in the other direction.
TEST(Crossings, DoNotDependOnStartAndDirection) {
  EXPECT_TRUE(rc::check([] {
    const int n = *rc::gen::inRange(4, 12);
    std::vector<Vec2> points;
    for (int i = 0; i < n; ++i) {
      const Vec2 p{1.0 * *rc::gen::inRange(0, 5), 1.0 * *rc::gen::inRange(0, 5)};
      if (points.empty() || !(p == points.back() || p == points.front())) points.push_back(p);
    }
    const auto count = [](const std::vector<Vec2>& p) {
      const std::vector<CubicPath> path{polygon(p)};
      return find_crossings(path).size();
    };
    if (points.size() < 2) return;
    const std::size_t crossings = count(points);
    std::vector<Vec2> other = points;
    std::rotate(other.begin(), other.begin() + *rc::gen::inRange<std::ptrdiff_t>(0, std::ssize(points)),
                other.end());
    RC_ASSERT(count(other) == crossings);
    std::reverse(other.begin(), other.end());
    RC_ASSERT(count(other) == crossings);
    for (Vec2& p : other) p = {0.6 * p.x - 0.8 * p.y + 0.3, 0.8 * p.x + 0.6 * p.y};
    RC_ASSERT(count(other) == crossings);
  }));
}

// P(u) = P(v) of a t^3 + b t^2 + c t is linear in u + v and u^2 + u v + v^2.
TEST(Crossings, OfOneCubicAreItsDoublePoint) {
  int loops = 0;
  EXPECT_TRUE(rc::check([&loops] {
    const auto number = [] { return *rc::gen::inRange(-1000, 1001) / 100.0; };
    const std::array<Vec2, 4> p{Vec2{number(), number()}, Vec2{number(), number()}, Vec2{number(), number()},
                                Vec2{number(), number()}};
    const auto powers = [](double p0, double p1, double p2, double p3) {
      return std::array<double, 3>{3 * (p1 - p0), 3 * (p0 - 2 * p1 + p2), p3 - 3 * p2 + 3 * p1 - p0};
    };
    const auto [cx, bx, ax] = powers(p[0].x, p[1].x, p[2].x, p[3].x);
    const auto [cy, by, ay] = powers(p[0].y, p[1].y, p[2].y, p[3].y);
    const double det = ax * by - ay * bx;
    RC_PRE(std::fabs(det) > 1e-3);
    const double q = -(cx * by - cy * bx) / det;
    const double s = -(ax * cy - ay * cx) / det;
    const double discriminant = 4 * q - 3 * s * s;
    RC_PRE(std::fabs(discriminant) > 1e-2);  // no cusp
    const double root = discriminant > 0 ? std::sqrt(discriminant) : 0.0;
    const double u = 0.5 * (s - root);
    const double v = 0.5 * (s + root);
    for (const double x : {u, v, u - 1, v - 1}) RC_PRE(std::fabs(x) > 1e-2);  // not at an end
    const std::vector<CubicPath> path{cubic(p[0], p[1], p[2], p[3])};
    const bool loop = discriminant > 0 && u > 0 && v < 1;
    const bool clear = !loop || !test::shallow(path[0], u, v, 0.05);
    RC_PRE(clear);
    std::vector<Crossing> proper;
    for (const Crossing& c : find_crossings(path)) {
      if (c.u < c.v) {
        proper.push_back(c);
        continue;
      }
      // A bend as sharp as a cusp: epsilon wide, ten epsilons from its tip.
      const double beside = 1e-4 * length({-10, -10}, {10, 10});
      const Vec2 tip = test::at(path[0], c.u);
      double back = c.u;
      double on = c.u;
      while (length(test::at(path[0], back), tip) < beside) back -= 1e-5;
      while (length(test::at(path[0], on), tip) < beside) on += 1e-5;
      RC_ASSERT(length(test::at(path[0], back), test::at(path[0], on)) <= 0.3 * beside);
    }
    RC_ASSERT(proper.size() == (loop ? 1u : 0u));
    if (loop) {
      ++loops;
      RC_ASSERT(std::fabs(proper[0].u - u) <= 1e-7);
      RC_ASSERT(std::fabs(proper[0].v - v) <= 1e-7);
    }
  }));
  EXPECT_GT(loops, 0);
}

// y = T3(x) between -1 and 1 meets y = 1/2 at cosines of 20, 140 and 260 degrees.
TEST(Crossings, OfTwoCurvesAreTheRoots) {
  // Power basis 4 x^3 - 3 x with x = 2 t - 1, as Bernstein coefficients.
  const std::vector<CubicPath> paths{cubic({-1, -1}, {-1. / 3, 5}, {1. / 3, -5}, {1, 1}),
                                     polyline({{2, 0.5}, {-2, 0.5}})};
  const std::vector<Crossing> found = find_crossings(paths);
  ASSERT_EQ(found.size(), 3u);
  const std::array<double, 3> xs{-0.93969262078590838, -0.17364817766693035, 0.76604444311897804};
  for (std::size_t i = 0; i < 3; ++i) {
    // 4 x^3 - 3 x = 1/2 at cos 20, cos 140, cos 260, up to the order: check the equation and the parameters.
    EXPECT_NEAR(4 * std::pow(found[i].point.x, 3) - 3 * found[i].point.x, 0.5, 1e-12);
    EXPECT_NEAR(found[i].point.y, 0.5, 1e-12);
    EXPECT_NEAR(found[i].u, 0.5 * (found[i].point.x + 1), 1e-12);
    EXPECT_NEAR(found[i].v, 0.25 * (2 - found[i].point.x), 1e-12);
  }
  EXPECT_NEAR(found[0].point.x, -0.76604444311897804, 1e-12);
  EXPECT_NEAR(found[1].point.x, xs[1], 1e-12);
  EXPECT_NEAR(found[2].point.x, 0.93969262078590838, 1e-12);
}

TEST(Crossings, AreFoundAtEverySizeAndPlace) {
  for (const double size : {1e-300, 1e-200, 1e-3, 1.0, 1e200, 1e307}) {
    std::vector<Vec2> eight{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    std::vector<Vec2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    for (Vec2& p : eight) p = {size * p.x, size * p.y};
    for (Vec2& p : square) p = {size * p.x, size * p.y};
    const std::vector<CubicPath> crossed{polygon(eight)};
    const std::vector<CubicPath> simple{polygon(square)};
    ASSERT_EQ(find_crossings(crossed).size(), 1u) << size;
    EXPECT_NEAR(find_crossings(crossed)[0].point.x / size, 1.0, 1e-12) << size;
    EXPECT_NEAR(find_crossings(crossed)[0].u, 0.5, 1e-12) << size;
    EXPECT_TRUE(is_simple(simple)) << size;
    EXPECT_NEAR(fold_fraction(crossed), 0.5, 1e-9) << size;
    EXPECT_EQ(fold_fraction(simple), 0.0) << size;
  }
}

TEST(Crossings, RightThroughVerticesCount) {
  // An eight that passes (0, 0) twice, at joints both times, or once at a joint and once inside a line.
  const std::vector<CubicPath> joints{polygon({{0, 0}, {1, 1}, {1, -1}, {0, 0}, {-1, 1}, {-1, -1}})};
  ASSERT_EQ(find_crossings(joints).size(), 1u);
  EXPECT_EQ(find_crossings(joints)[0].u, 0.0);
  EXPECT_EQ(find_crossings(joints)[0].v, 3.0);
  const std::vector<CubicPath> joint_and_line{polygon({{0, 0}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}})};
  ASSERT_EQ(find_crossings(joint_and_line).size(), 1u);
  EXPECT_EQ(find_crossings(joint_and_line)[0].v, 2.5);
  const std::vector<CubicPath> two{polyline({{-1, -1}, {0, 0}, {1, 1}}),
                                   polyline({{-1, 1}, {0, 0}, {1, -1}})};
  ASSERT_EQ(find_crossings(two).size(), 1u);
  EXPECT_TRUE(find_crossings(two, {.between = false}).empty());
}

TEST(Crossings, TouchesAreNone) {
  // Two loops on one point, without passing through.
  EXPECT_TRUE(is_simple(std::vector{polygon({{0, 0}, {1, 1}, {1, -1}, {0, 0}, {-1, -1}, {-1, 1}})}));
  // A tip on a line, a tip on a tip, a shared edge, a shared end.
  EXPECT_TRUE(is_simple(std::vector{polygon({{0, 0}, {4, 0}, {4, 3}, {2, 0}, {0, 3}})}));
  EXPECT_TRUE(
      is_simple(std::vector{polygon({{0, 0}, {1, 1}, {-1, 1}}), polygon({{0, 0}, {1, -1}, {-1, -1}})}));
  EXPECT_TRUE(is_simple(std::vector{polygon({{0, 0}, {1, 0}, {0, 1}}), polygon({{0, 0}, {1, 0}, {0, -1}})}));
  EXPECT_TRUE(is_simple(std::vector{polyline({{0, 0}, {1, 0}}), polyline({{0, 0}, {0, 1}})}));
  // An open end on a line.
  EXPECT_TRUE(is_simple(std::vector{polyline({{0, 0}, {2, 0}}), polyline({{1, 0}, {1, 1}})}));
  // Two circles that touch from outside and from inside.
  EXPECT_TRUE(is_simple(std::vector{test::circle({0, 0}, 1), test::circle({2, 0}, 1)}));
  EXPECT_TRUE(is_simple(std::vector{test::circle({0, 0}, 2), test::circle({1, 0}, 1)}));
  // A slit: there and back again.
  EXPECT_TRUE(is_simple(std::vector{polygon({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {2, 4}, {0, 4}})}));
  // A ring as one contour: out, across a bridge, round the hole, back across the bridge.
  EXPECT_TRUE(is_simple(std::vector{polygon(
      {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 3}, {2, 3}, {2, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 3}, {0, 3}})}));
}

TEST(Crossings, EpsilonIsHowFarEdgesMustReachBeyondEachOther) {
  for (const double reach : {0.5, 2.0}) {
    // Scale 1: the tip goes through the line by `reach` epsilons, and comes back.
    const std::vector<CubicPath> path{
        polygon({{0, 0}, {0.5, 0}, {0.5, 0.5}, {0.25, -reach * 1e-5}, {0, 0.5}})};
    EXPECT_EQ(find_crossings(path, {.scale = 1.0}).size(), reach > 1 ? 2u : 0u) << reach;
    EXPECT_EQ(find_crossings(path, {.epsilon = 1e-4, .scale = 1.0}).size(), 0u) << reach;
    EXPECT_EQ(find_crossings(path, {.scale = 0.1}).size(), 2u) << reach;
  }
}

TEST(Crossings, CuspsAndRetrogradeMotionCount) {
  // (t^2, t^3) about t = 1/2, in several directions.
  for (const double degrees : {0.0, 30.0, 77.0}) {
    const double c = std::cos(degrees * 0.017453292519943295);
    const double s = std::sin(degrees * 0.017453292519943295);
    const auto turned = [&](double x, double y) { return Vec2{c * x - s * y, s * x + c * y}; };
    const std::vector<CubicPath> cusp{cubic(turned(0, 0), turned(1, 1), turned(0, 1), turned(1, 0))};
    const std::vector<Crossing> found = find_crossings(cusp);
    ASSERT_EQ(found.size(), 1u) << degrees;
    EXPECT_EQ(found[0].u, 0.5);
    EXPECT_EQ(found[0].v, 0.5);
    // A little more is a loop, a little less is a sharp bend.
    const std::vector<CubicPath> loop{cubic(turned(0, 0), turned(1.1, 1), turned(-0.1, 1), turned(1, 0))};
    ASSERT_EQ(find_crossings(loop).size(), 1u) << degrees;
    EXPECT_LT(find_crossings(loop)[0].u, 0.45);
    EXPECT_GT(find_crossings(loop)[0].v, 0.55);
    EXPECT_TRUE(is_simple(std::vector{cubic(turned(0, 0), turned(0.9, 1), turned(0.1, 1), turned(1, 0))}));
  }
  // There and back on a line, inside a segment.
  EXPECT_EQ(find_crossings(std::vector{cubic({0, 0}, {2, 1}, {-1, -0.5}, {1, 0.5})}).size(), 2u);
  // The same at a joint is a thin tip.
  EXPECT_TRUE(is_simple(std::vector{polyline({{0, 0}, {2, 1}, {0.5, 0.25}})}));
}

// A loop of 1/1000 of the picture in a bend.
TEST(Crossings, SmallLoopsAreSeen) {
  for (const double size : {3e-2, 3e-3, 3e-4}) {
    const std::vector<CubicPath> loop{cubic({0, 0}, {1 + size, 1}, {-size, 1}, {1, 0})};
    EXPECT_EQ(find_crossings(loop, {.scale = 1.5}).size(), 1u) << size;
  }
}

TEST(Crossings, EndAtTheLimit) {
  const std::vector<CubicPath> star{polygon({{0, 1}, {0.6, -0.8}, {-1, 0.3}, {1, 0.3}, {-0.6, -0.8}})};
  const std::vector<PathView> views = view_paths(star);
  CrossingFinder finder;
  EXPECT_EQ(finder.find(views).size(), 5u);
  EXPECT_EQ(finder.find(views, 2).size(), 2u);
  EXPECT_FALSE(finder.is_simple(views));
  EXPECT_EQ(finder.find(views).size(), 5u);
  EXPECT_TRUE(finder.is_simple({}));
}

// What a finder remembers of the paths that stay as they were is what a new one finds.
TEST(Crossings, RememberedOnesAreThoseFoundAnew) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0.0, 8.0);
  const auto triangle = [&](double size) {
    const Vec2 p{place(random), place(random)};
    return polygon({p, {p.x + size, p.y + 0.2 * size}, {p.x + 0.3 * size, p.y + size}});
  };
  const auto sorted = [](std::span<const Crossing> found) {
    std::vector<Crossing> all(found.begin(), found.end());
    std::sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) {
      return std::tie(a.path_a, a.path_b, a.u, a.v) < std::tie(b.path_a, b.path_b, b.u, b.v);
    });
    return all;
  };
  const IntersectionOptions options{.scale = 12.0};
  CrossingFinder remembers(options);
  std::vector<CubicPath> paths;
  for (int k = 0; k < 5; ++k) paths.push_back(triangle(4.0));
  std::size_t most = 0;
  for (int round = 0; round < 200; ++round) {
    paths[static_cast<std::size_t>(round) % paths.size()] = triangle(round % 3 == 0 ? 1.0 : 4.0);
    if (round % 50 == 30) paths.push_back(triangle(4.0));
    if (round % 50 == 45) paths.pop_back();
    const std::vector<PathView> views = view_paths(paths);
    const std::span<const PathView> some = std::span(views).subspan(1);
    if (round % 4 == 1)
      EXPECT_EQ(remembers.fold_fraction(views), CrossingFinder(options).fold_fraction(views));
    if (round % 4 == 2) EXPECT_EQ(remembers.fold_fraction(some), CrossingFinder(options).fold_fraction(some));
    CrossingFinder anew(options);
    const std::vector<Crossing> all = sorted(anew.find(views));
    most = std::max(most, all.size());
    if (round % 5 == 4) EXPECT_EQ(remembers.find(views, 2).size(), std::min<std::size_t>(2, all.size()));
    EXPECT_EQ(sorted(remembers.find(views)), all) << round;
  }
  EXPECT_GT(most, 10u);
}

TEST(Crossings, OpenPathsAreNotClosedByALine) {
  const std::vector<Vec2> z{{0, 0}, {2, 0}, {0, 2}, {2, 2}};
  EXPECT_TRUE(is_simple(std::vector{polyline(z)}));
  EXPECT_FALSE(is_simple(std::vector{polygon(z)}));
}

TEST(Crossings, PointsAndCollapsedPathsHaveNone) {
  EXPECT_TRUE(is_simple(std::vector{polyline({{1, 1}, {1, 1}})}));
  EXPECT_TRUE(is_simple(std::vector{polygon({{1, 1}, {1, 1}, {1, 1}}), polygon({{0, 0}, {3, 0}, {1, 3}})}));
  EXPECT_EQ(fold_fraction(std::vector{polygon({{1, 1}, {1, 1}})}), 0.0);
  EXPECT_EQ(fold_fraction(std::vector{polygon({{1, 1}, {2, 2}})}), 0.0);
}

TEST(Crossings, RefuseWhatIsNotPlanarAndBadOptions) {
  const std::vector<CubicPath> space{CubicPath(Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}})};
  EXPECT_THROW((void)find_crossings(space), InvalidArgument);
  EXPECT_THROW((void)fold_fraction(space), InvalidArgument);
  EXPECT_THROW(CrossingFinder({.tolerance = 0.0}), InvalidArgument);
  EXPECT_THROW(CrossingFinder({.epsilon = std::numeric_limits<double>::quiet_NaN()}), InvalidArgument);
  EXPECT_THROW(CrossingFinder({.scale = -1.0}), InvalidArgument);
}

// Random closed cubics: each crossing found lies on the curve at both parameters, and a simple verdict means
// that the polygon of 4,000 points has no crossing either.
TEST(Crossings, OfCubicsLieOnBothBranches) {
  EXPECT_TRUE(rc::check([] {
    const CubicPath path = test::any_closed_path();
    const std::vector<CubicPath> paths{path};
    const std::vector<Crossing> found = find_crossings(paths);
    for (const Crossing& c : found) {
      RC_ASSERT(length(test::at(path, c.u), c.point) <= 2e-3);
      RC_ASSERT(length(test::at(path, c.v), c.point) <= 2e-3);
      RC_ASSERT(c.u <= c.v);
    }
    if (found.empty()) {
      std::vector<Vec2> dense;
      const int steps = 100;
      for (std::size_t i = 0; i < path.segment_count() * steps; ++i) {
        dense.push_back(test::at(path, static_cast<double>(i) / steps));
      }
      for (const Crossing& c : cross_all({dense}, 0.0).crossings) {
        // Only a loop as small as the tolerance, or a crossing at a small angle, may be told otherwise.
        const double end = static_cast<double>(dense.size());
        const auto reach = [&](double from, double to) {
          double far = 0.0;
          for (double u = from; u < to; u += 0.5) {
            far = std::max(far, length(c.point, test::at(path, std::fmod(u, end) / steps)));
          }
          return far;
        };
        const double loop = std::min(reach(c.u, c.v), reach(c.v, c.u + end));
        const bool excused = loop < 3e-2 || test::shallow(path, c.u / steps, c.v / steps, 0.03);
        RC_ASSERT(excused);
      }
    }
  }));
}

TEST(Folds, AreTheShareWithTheWrongWindingNumber) {
  // A square of 4 x 4 and a part of 1 x 4 that is wound round twice: the path overlaps itself there.
  const std::vector<CubicPath> twice{polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}),
                                     polygon({{3, 0}, {5, 0}, {5, 4}, {3, 4}})};
  EXPECT_NEAR(fold_fraction(twice), 1.0 / 5.0, 1e-12);
  // An eight of triangles: areas 1 and 4.
  const std::vector<CubicPath> eight{polygon({{0, 0}, {1, 1}, {1, -1}, {-2, 2}, {-2, -2}})};
  EXPECT_NEAR(fold_fraction(eight), 0.2, 1e-3);
  // A hole wound the other way is no fold, one wound the same way is.
  const CubicPath outer = test::circle({0, 0}, 2);
  EXPECT_NEAR(fold_fraction(std::vector{outer, test::reversed(test::circle({0, 0}, 1))}), 0.0, 1e-12);
  EXPECT_NEAR(fold_fraction(std::vector{outer, test::circle({0, 0}, 1)}), 0.25, 1e-3);
  EXPECT_NEAR(fold_fraction(std::vector{outer, test::reversed(test::circle({5, 0}, 1))}), 0.2, 1e-3);
  // An open path encloses what it would when closed.
  EXPECT_NEAR(fold_fraction(std::vector{outer, polyline({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})}),
              4.0 / (4 * 3.141592653589793), 1e-3);
}

}  // namespace
}  // namespace tandem
