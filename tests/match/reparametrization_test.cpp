#include "tandem/match/reparametrization.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "match/paths.h"
#include "tandem/curve/knots.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using Pairs = std::vector<ParameterPair>;

ReductionOptions by_coefficients(int n, int order = 2) {
  ReductionOptions options;
  options.coefficients = n;
  options.order = order;
  return options;
}

ReductionOptions by_tolerance(double tolerance, int order = 2) {
  ReductionOptions options;
  options.tolerance = tolerance;
  options.order = order;
  return options;
}

double rise(const FitPath& path) {
  return path.points.back().v - path.points.front().v;
}

/// Largest distance of v to the path (to the nearest value where it steps up), as a share of its rise.
double deviation(const Curve& v, const FitPath& path) {
  double largest = 0.0;
  for (std::size_t i = 0; i < path.points.size();) {
    std::size_t end = i + 1;
    while (end < path.points.size() && path.points[end].u == path.points[i].u) ++end;
    const double value = v.evaluate(path.points[i].u)[0];
    largest = std::max({largest, path.points[i].v - value, value - path.points[end - 1].v});
    i = end;
  }
  return largest / rise(path);
}

/// What rounding of the domains' own numbers (far from 0) can make of a deviation: of u, times the steepest
/// slope.
double rounding(const FitPath& path, double steepest) {
  const auto size = [](double a, double b) { return std::max(std::abs(a), std::abs(b)) / (b - a); };
  const double u = size(path.points.front().u, path.points.back().u);
  const double v = size(path.points.front().v, path.points.back().v);
  return 1e-15 * (u * steepest + v + 1.0) * 16.0;
}

/// The contract of every fit, whatever the path.
void expect_sound(const Reparametrization& result, const FitPath& path, const ReductionOptions& options) {
  const Curve& v = result.v;
  RC_ASSERT(v.dim() == 1);
  RC_ASSERT(v.degree() == options.order - 1);
  RC_ASSERT(v.domain().lo == path.points.front().u);
  RC_ASSERT(v.domain().hi == path.points.back().u);
  RC_ASSERT(v.evaluate(v.domain().lo)[0] == path.points.front().v);
  RC_ASSERT(v.evaluate(v.domain().hi)[0] == path.points.back().v);
  RC_ASSERT(v.control_points().front()[0] == path.points.front().v);
  RC_ASSERT(v.control_points().back()[0] == path.points.back().v);
  const auto degree = static_cast<std::size_t>(v.degree());
  const auto ulps = [](double a, double b) { return 1e-15 * std::max(std::abs(a), std::abs(b)) / (b - a); };
  const double noise_u = ulps(v.domain().lo, v.domain().hi);
  const double noise_v = ulps(path.points.front().v, path.points.back().v);
  for (std::size_t i = 1; i < v.size(); ++i) {
    const double dv = (v.control_points()[i][0] - v.control_points()[i - 1][0]) / rise(path);
    // Slope of the control polygon over the Greville abscissae, relative to the mean slope.
    const double du =
        (v.knots()[i + degree] - v.knots()[i]) / v.domain().length() / static_cast<double>(degree);
    RC_ASSERT(dv > 0.0);
    RC_ASSERT(dv >= options.min_slope * (du * (1.0 - 1e-6) - noise_u) - noise_v);
    RC_ASSERT(dv <= (du * (1.0 + 1e-6) + noise_u) / options.min_slope + noise_v);
  }
  double previous = path.points.front().v;
  for (int k = 1; k <= 200; ++k) {
    const double value = v.evaluate(v.domain().lo + k / 200.0 * v.domain().length())[0];
    RC_ASSERT(value >= previous);
    previous = value;
  }
  const double noise = rounding(path, 1.0 / options.min_slope);
  RC_ASSERT(std::abs(result.max_deviation - deviation(v, path)) <= noise);
}

void expect_increasing(const Curve& v) {
  for (std::size_t i = 1; i < v.size(); ++i)
    EXPECT_GT(v.control_points()[i][0], v.control_points()[i - 1][0]);
}

TEST(Fit, IsALineForTwoPoints) {
  const FitPath path{{{1, 10}, {3, 40}}, {}};
  for (const ReductionOptions& options : {by_coefficients(2), by_coefficients(20), by_coefficients(7, 4),
                                          by_tolerance(1e-3), by_tolerance(1e-3, 3), by_tolerance(1e-9, 5)}) {
    const Reparametrization result = fit(path, options);
    EXPECT_NEAR(result.v.evaluate(1.5)[0], 17.5, 1e-12);
    EXPECT_NEAR(result.v.evaluate(2.9)[0], 38.5, 1e-12);
    EXPECT_LE(result.max_deviation, 1e-15);
    EXPECT_FALSE(result.reversed);
  }
  EXPECT_EQ(fit(path, by_tolerance(1e-3)).v.size(), 2u);
  EXPECT_EQ(fit(path, by_tolerance(1e-3, 4)).v.size(), 4u);
  EXPECT_TRUE(fit(path, by_tolerance(1e-3), true).reversed);
}

TEST(Fit, ReproducesAPolylineOnItsOwnKnots) {
  // Breaks at thirds, and the least squares has nothing to average.
  const FitPath path{{{0, 0}, {0.5, 0.25}, {1, 0.5}, {1.5, 1.5}, {2, 2.5}, {2.5, 2.75}, {3, 3}}, {}};
  const Reparametrization result = fit(path, by_coefficients(4));
  const double expected[] = {0, 0.5, 2.5, 3};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(result.v.control_points()[i][0], expected[i], 1e-9);
  EXPECT_LE(result.max_deviation, 1e-9);
}

TEST(Fit, ReproducesASplineOfItsOwnKind) {
  const Curve truth =
      Curve::clamped_uniform(3, Points(1, std::vector<double>{0, 0.02, 0.3, 0.35, 0.4, 0.9, 1}));
  FitPath path;
  for (int i = 0; i <= 100; ++i) path.points.push_back({i / 100.0, truth.evaluate(i / 100.0)[0]});
  const Reparametrization result = fit(path, by_coefficients(7, 4));
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NEAR(result.v.control_points()[i][0], truth.control_points()[i][0], 1e-7);
  }
}

TEST(Fit, HoldsIncrementsThatTheDataWouldTurn) {
  // Flat, then steep: the unconstrained least squares overshoots.
  FitPath path;
  for (int i = 0; i <= 60; ++i) path.points.push_back({i / 100.0, 0.0});
  for (int i = 61; i <= 64; ++i) path.points.push_back({i / 100.0, (i - 60) * 0.25});
  for (int i = 65; i <= 100; ++i) path.points.push_back({i / 100.0, 1.0});
  for (const int order : {2, 3, 4}) {
    const ReductionOptions options = by_coefficients(20, order);
    const Reparametrization result = fit(path, options);
    expect_increasing(result.v);
    EXPECT_LE(result.max_deviation, 0.5);
  }
}

TEST(Fit, KeepsOnlyTheVerticesItNeeds) {
  FitPath path;
  for (int i = 0; i <= 40; ++i) path.points.push_back({i / 100.0, i / 200.0});
  for (int i = 41; i <= 100; ++i) path.points.push_back({i / 100.0, 0.2 + (i - 40) / 75.0});
  const Reparametrization result = fit(path, by_tolerance(1e-6));
  EXPECT_EQ(result.v.size(), 3u);
  EXPECT_EQ(result.v.knots(), (std::vector<double>{0, 0, 0.4, 1, 1}));
  EXPECT_LE(result.max_deviation, 1e-15);
}

TEST(Fit, PassesThroughCorners) {
  FitPath path;
  for (int i = 0; i <= 50; ++i) {
    const double u = i / 50.0;
    path.points.push_back({u, u * u * (3 - 2 * u)});
  }
  path.corner_parameters = {0.1, 0.5, 0.82};
  for (const int order : {2, 3, 4}) {
    const Reparametrization result = fit(path, by_tolerance(0.05, order));
    for (const double corner : path.corner_parameters) {
      EXPECT_NEAR(result.v.evaluate(corner)[0], corner * corner * (3 - 2 * corner), 1e-15);
      EXPECT_EQ(multiplicity(result.v.knots(), corner), order - 1);
    }
  }
}

TEST(Fit, StepsUpByAsMuchAsTheSlopesAllow) {
  // All vertical: one jump in the middle, between two flats.
  const FitPath path{{{0, 0}, {0.5, 0}, {0.5, 0.5}, {0.5, 1}, {1, 1}}, {}};
  const Reparametrization result = fit(path, by_tolerance(1e-3));
  // 0 -> 0.5 and up to 1 again: the middle of the jump is met; a path of three vertices deviates by nothing
  // there.
  EXPECT_EQ(result.v.evaluate(0.5)[0], 0.5);
  EXPECT_LE(result.max_deviation, 1e-3);
  const FitPath ends{{{0, 0}, {0, 1}, {1, 1}, {1, 2}}, {}};
  EXPECT_EQ(fit(ends, by_tolerance(1e-3)).v.size(), 2u);
  EXPECT_EQ(fit(ends, by_tolerance(1e-3)).max_deviation, 0.0);
}

TEST(Fit, IsSoundForEveryPathAndOption) {
  EXPECT_TRUE(rc::check([] {
    const Correspondence c = testing::any_correspondence();
    std::vector<double> corners;
    for (const ParameterPair& point : c.points) {
      if (*rc::gen::inRange(0, 5) == 0) corners.push_back(point.u);
    }
    const FitPath path = fit_path(c, corners);
    ReductionOptions options;
    options.order = *rc::gen::inRange(2, 6);
    options.min_slope = *rc::gen::element(1e-3, 1e-6, 0.1, 0.7, 1.0);
    options.tolerance = *rc::gen::element(1e-3, 1e-1, 1e-8);
    if (*rc::gen::arbitrary<bool>()) options.coefficients = *rc::gen::inRange(options.order, 60);
    expect_sound(fit(path, options), path, options);
  }));
}

TEST(Fit, MeetsTheToleranceWhereTheSlopesAllowIt) {
  EXPECT_TRUE(rc::check([] {
    // Increments between 1 and 9 of each other, so that no relative slope leaves [1e-3, 1e3].
    const auto n = *rc::gen::inRange<std::size_t>(1, 60);
    const Interval u = testing::domain_of_any_size();
    const Interval v = testing::domain_of_any_size();
    const auto steps = [n] {
      std::vector<double> result;
      for (std::size_t i = 0; i < n; ++i) result.push_back(*rc::gen::inRange(1, 10));
      return result;
    };
    const std::vector<double> us = testing::onto(u, steps());
    const std::vector<double> vs = testing::onto(v, steps());
    FitPath path;
    for (std::size_t i = 0; i <= n; ++i) path.points.push_back({us[i], vs[i]});
    for (std::size_t i = 1; i < n; ++i) {
      if (*rc::gen::inRange(0, 8) == 0) path.corner_parameters.push_back(us[i]);
    }
    const ReductionOptions options =
        by_tolerance(*rc::gen::element(1e-3, 1e-2, 1e-5), *rc::gen::element(2, 3, 4));
    const Reparametrization result = fit(path, options);
    expect_sound(result, path, options);
    RC_ASSERT(result.max_deviation <= options.tolerance * (1.0 + 1e-9) + rounding(path, 10.0));
    for (const double corner : path.corner_parameters) {
      const auto at = std::find(us.begin(), us.end(), corner) - us.begin();
      const double size = std::max(std::abs(v.lo), std::abs(v.hi));
      RC_ASSERT(std::abs(result.v.evaluate(corner)[0] - vs[static_cast<std::size_t>(at)]) <= 1e-15 * size);
    }
  }));
}

TEST(Fit, HasNoRoomToImprove) {
  // The coefficients of a fit are a minimum: no admissible change of two neighbouring increments lowers the
  // sum of squares, nor of any two increments.
  EXPECT_TRUE(rc::check([] {
    const FitPath path = fit_path(testing::any_correspondence(true));
    const int order = *rc::gen::inRange(2, 5);
    const int n = *rc::gen::inRange(order + 1, 16);
    const ReductionOptions options = by_coefficients(n, order);
    const Curve v = fit(path, options).v;
    const auto squares = [&path](const Curve& curve) {
      double sum = 0.0;
      for (const auto& [u, y] : path.points) sum += (curve.evaluate(u)[0] - y) * (curve.evaluate(u)[0] - y);
      return sum;
    };
    const double least = squares(v);
    const auto degree = static_cast<std::size_t>(order - 1);
    const auto count = static_cast<std::size_t>(n);
    for (std::size_t from = 0; from + 1 < count; ++from) {
      for (std::size_t to = 0; to + 1 < count; ++to) {
        if (from == to) continue;
        const double greville =
            (v.knots()[from + 1 + degree] - v.knots()[from + 1]) / static_cast<double>(degree);
        const double increment = v.control_points()[from + 1][0] - v.control_points()[from][0];
        const double room = increment - options.min_slope * greville;
        const double step = std::min(1e-3, room);
        if (step <= 0.0) continue;
        Points moved = v.control_points();
        // Take `step` from one increment and give it to another: the coefficients between them move.
        for (std::size_t i = std::min(from, to) + 1; i <= std::max(from, to); ++i) {
          moved[i][0] += from < to ? -step : step;
        }
        // The pull towards uniform speed is 1e-12 of the data's weight.
        const double pull = 1e-12 * static_cast<double>(path.points.size()) * 400.0;
        RC_ASSERT(squares(Curve(order - 1, v.knots(), moved)) >= least - pull);
      }
    }
  }));
}

/// The paper's kind of path: whole steps on an m x m grid along the polyline through the given vertices.
FitPath staircase(int m, const Pairs& vertices) {
  FitPath path;
  int j = 0;
  std::size_t k = 1;
  for (int i = 0; i < m; ++i) {
    const double u = i / (m - 1.0);
    while (k + 1 < vertices.size() && vertices[k].u < u) ++k;
    const ParameterPair a = vertices[k - 1];
    const ParameterPair b = vertices[k];
    const double v = a.v + (b.v - a.v) * (u - a.u) / (b.u - a.u);
    const int to = i + 1 == m ? m - 1 : static_cast<int>(v * (m - 1) + 0.5);
    path.points.push_back({u, j / (m - 1.0)});
    while (j < to) path.points.push_back({u, ++j / (m - 1.0)});
  }
  return path;
}

TEST(Fit, NeedsAQuarterOfThePiecesOnThePathsOwnVertices) {
  // Spec C7, on a path of plateaus and steep rises, m = 100. Measured: 14 pieces against 80 for the same
  // deviation at a tolerance of half a grid step, 11 against 52 at one step. (On a smooth path both need
  // about as many.)
  const FitPath path = staircase(100, {{0, 0},
                                       {0.07, 0.01},
                                       {0.1, 0.2},
                                       {0.31, 0.24},
                                       {0.34, 0.45},
                                       {0.36, 0.46},
                                       {0.62, 0.5},
                                       {0.66, 0.74},
                                       {0.9, 0.8},
                                       {0.93, 0.98},
                                       {1, 1}});
  for (const double tolerance : {0.005, 0.01}) {
    const Reparametrization own = fit(path, by_tolerance(tolerance));
    EXPECT_LE(own.max_deviation, tolerance);
    const int pieces = static_cast<int>(own.v.size()) - 1;
    for (int uniform = 1; uniform < 4 * pieces; ++uniform) {
      EXPECT_GT(fit(path, by_coefficients(uniform + 1)).max_deviation, own.max_deviation);
    }
  }
}

TEST(Fit, SaysWhatIsWrong) {
  const FitPath path{{{0, 0}, {1, 1}}, {}};
  const auto refuses = [](const FitPath& p, const ReductionOptions& options) {
    EXPECT_THROW((void)fit(p, options), InvalidArgument);
  };
  refuses(path, by_coefficients(1));
  refuses(path, by_coefficients(3, 4));
  refuses(path, by_coefficients(2'000'000'000));
  refuses(path, by_tolerance(0.0));
  refuses(path, by_tolerance(-1.0));
  refuses(path, by_tolerance(std::numeric_limits<double>::quiet_NaN()));
  refuses(path, by_tolerance(1e-3, 1));
  refuses(path, by_tolerance(1e-3, 1000));
  ReductionOptions steep;
  steep.min_slope = 0.0;
  refuses(path, steep);
  steep.min_slope = 2.0;
  refuses(path, steep);
  refuses({}, {});
  refuses({{{0, 0}}, {}}, {});
  refuses({{{0, 0}, {0, 1}}, {}}, {});
  refuses({{{0, 0}, {1, 0}}, {}}, {});
  refuses({{{0, 0}, {1, 2}, {0.5, 3}, {2, 4}}, {}}, {});
  refuses({{{0, 0}, {0.5, 0.6}, {0.6, 0.5}, {2, 4}}, {}}, {});
  refuses({{{0, 0}, {0.5, std::numeric_limits<double>::quiet_NaN()}, {2, 4}}, {}}, {});
  refuses({{{-1e308, 0}, {1e308, 1}}, {}}, {});
  try {
    (void)fit(FitPath{{{0, 0}, {1, 2}, {0.5, 3}, {2, 4}}, {}}, {});
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(), "point 2 of the path is (0.5, 3), which steps back from (1, 2)");
  }
}

TEST(Fit, DrawsParametersTogetherThatTheDomainCannotTellApart) {
  // 0 and the end differ, but not as shares of [-1, 2^-60]; likewise the start and the point after it in the
  // second.
  const double tiny = std::ldexp(1.0, -60);
  const FitPath late{{{-1, 0}, {-0.5, 0.2}, {0, 0.5}, {tiny, 1}}, {}};
  const FitPath corner{late.points, {0}};
  const FitPath early{{{-tiny, 0}, {0, 0.5}, {0.5, 0.7}, {1, 1}}, {0}};
  for (const FitPath& path : {late, corner, early}) {
    for (const ReductionOptions& options : {by_tolerance(1e-3), by_tolerance(1e-3, 3), by_coefficients(10)}) {
      const Curve v = fit(path, options).v;
      EXPECT_EQ(v.domain(), (Interval{path.points.front().u, path.points.back().u}));
      EXPECT_EQ(v.control_points().front()[0], 0.0);
      EXPECT_EQ(v.control_points().back()[0], 1.0);
      expect_increasing(v);
    }
  }
}

TEST(Fit, KeepsIncrementsThatRoundingWouldClose) {
  // Flat, then steep, far from 0: the least slope alone would ask for increments of 1.5e-11 where doubles
  // are 1.2e-10 apart.
  const FitPath path{{{0, 1e6}, {0.6, 1e6}, {0.8, 1e6 + 0.3}, {1, 1e6 + 0.3}}, {}};
  for (const int order : {2, 3, 4}) {
    ReductionOptions options = by_coefficients(20, order);
    options.min_slope = 1e-9;
    expect_increasing(fit(path, options).v);
    options = by_tolerance(1e-6, order);
    options.min_slope = 1e-9;
    expect_increasing(fit(path, options).v);
  }
}

TEST(Fit, RefusesCoefficientsThatDoublesCannotHold) {
  const FitPath path{{{0, 1e15}, {0.5, 1e15 + 1}, {1, 1e15 + 2}}, {}};
  EXPECT_THROW((void)fit(path, by_coefficients(50)), InvalidArgument);
  EXPECT_NO_THROW((void)fit(path, by_tolerance(1e-3)));
  EXPECT_NO_THROW((void)fit(path, by_tolerance(1e-3, 3)));
  const FitPath denormal{{{0, 0}, {1e-323, 0.5}, {2e-323, 1}}, {}};
  EXPECT_THROW((void)fit(denormal, by_coefficients(50)), InvalidArgument);
}

}  // namespace
}  // namespace tandem
