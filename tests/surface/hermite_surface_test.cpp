#include "tandem/surface/hermite_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "random_surfaces.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"
#include "tandem/surface/edit.h"

namespace tandem {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// The angle between two planes given by unit normals.
double plane_angle(const Point& x, const Point& y) {
  const double cross[3] = {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  return std::asin(std::min(1.0, std::hypot(cross[0], cross[1], cross[2])));
}

/// A sheet like a roof tile: a wave along u that lies where `phase` says, at x = x0 .. x0 + 2 along v.
Surface sheet(double x0, double tilt, double phase, int degree = 3) {
  const std::size_t m = 16;
  const std::size_t n = 5;
  Points points(3, m * n);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double y = static_cast<double>(i);
      points[i * n + j][0] = x0 + 0.5 * static_cast<double>(j);
      points[i * n + j][1] = y;
      points[i * n + j][2] =
          tilt * static_cast<double>(j * j) + 2.0 * std::exp(-(y - phase) * (y - phase) / 4.0);
    }
  }
  std::vector<double> u;
  for (std::size_t k = 0; k < m + static_cast<std::size_t>(degree) + 1; ++k) {
    const double t = static_cast<double>(k) - degree;
    u.push_back(std::clamp(t, 0.0, static_cast<double>(m) - degree));
  }
  return Surface({degree, 3}, {u, {0, 0, 0, 0, 1, 2, 2, 2, 2}}, points);
}

/// Largest angle between the tangent planes of a blend and of its neighbour along a common edge.
/// rail(u): the neighbour's parameters there.
template <class Place>
double largest_break(const Surface& blend, double v, const Surface& neighbour, const Place& place) {
  double most = 0.0;
  const Interval u = blend.domain(Along::u);
  for (int i = 0; i <= 300; ++i) {
    const double at = u.lo + u.length() * i / 300;
    const auto [s, t] = place(at);
    most = std::max(most, plane_angle(blend.normal(at, v), neighbour.normal(s, t, {Side::left, Side::left})));
  }
  return most;
}

// Figures 1(b) and 7(b).
TEST(HermiteBlend, LeavesBothNeighboursSmoothlyAndWithoutTwist) {
  const Surface left = sheet(0.0, 0.3, 4.0);
  const Surface right = sheet(8.0, 0.2, 9.0);
  const Rail first = rail_of(left, Along::u, 2.0, Departure::onwards);
  const Rail second = rail_of(right, Along::u, 0.0, Departure::onwards);
  const HermiteSurface blend = blend_rails(first, second);
  EXPECT_LE(largest_break(blend.surface, 0.0, left, [](double u) { return std::pair(u, 2.0); }), 1e-9);
  const Curve& law = blend.match.reparametrization.v;
  EXPECT_LE(
      largest_break(blend.surface, 1.0, right, [&](double u) { return std::pair(law.evaluate(u)[0], 0.0); }),
      1e-9);
  EXPECT_TRUE(blend.report.validity.valid);
  EXPECT_LE(blend.report.crease_angle, 1.0 * kDegree);
  // The crest of the wave runs from one sheet's to the other's: it is no lower between them.
  const auto rise = [&](double v) {
    double low = 1e9;
    double high = -1e9;
    for (double u = 0.0; u <= first.curve.domain().hi; u += 0.01) {
      const double z = blend.surface.evaluate(u, v)[2];
      low = std::min(low, z);
      high = std::max(high, z);
    }
    return high - low;
  };
  EXPECT_GT(rise(0.5), 0.98 * rise(0.0));
}

TEST(HermiteBlend, MeetsRailsAndTangentsExactly) {
  testing::RandomCurves random(3);
  for (int round = 0; round < 5; ++round) {
    const Curve a = random.curve(3, 3, 4, round % 2 == 1, true);
    const Curve b = random.curve(2, 3, 3, false, true);
    const Curve ta = random.curve(2, 3, 2, round == 3, true);
    const Curve tb = random.curve(3, 3, 2, false, true);
    const HermiteSurface blend = blend_rails({a, ta}, {b, tb});
    const Reparametrization& r = blend.match.reparametrization;
    for (int i = 0; i <= 100; ++i) {
      const double u = i / 100.0;
      double v = r.v.evaluate(u)[0];
      if (r.reversed) v = 1.0 - v;
      const Points at0 = blend.surface.derivatives(u, 0.0, 1);
      const Points at1 = blend.surface.derivatives(u, 1.0, 1);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(at0[0][c], a.evaluate(u)[c], 1e-11);
        EXPECT_NEAR(at0[2][c], ta.evaluate(u)[c], 1e-10);
        EXPECT_NEAR(at1[0][c], b.evaluate(v)[c], 1e-11);
        EXPECT_NEAR(at1[2][c], tb.evaluate(v)[c], 1e-10);
      }
    }
  }
}

TEST(HermiteBlend, ClosedRailsFindTheirSeam) {
  // Two rings whose seams lie a third of a turn apart, tangents along the axis and outwards.
  const auto ring = [](double radius, double z, double turn, bool vectors) {
    const std::size_t n = 12;
    Points points(3, n + 3);
    for (std::size_t i = 0; i < n + 3; ++i) {
      const double t = turn + 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      const double r = radius * (1.0 + 0.3 * std::cos(2.0 * (t - turn)) + 0.1 * std::cos(3.0 * t));
      points[i][0] = vectors ? 0.5 * std::cos(t) : r * std::cos(t);
      points[i][1] = vectors ? 0.5 * std::sin(t) : r * std::sin(t);
      points[i][2] = vectors ? 1.5 : z;
    }
    std::vector<double> knots;
    for (int k = 0; k < static_cast<int>(n) + 7; ++k) knots.push_back((k - 3.0) / static_cast<double>(n));
    return Curve(3, knots, points);
  };
  const Rail first{ring(3, 0, 0.0, false), ring(3, 0, 0.0, true)};
  const Rail second{ring(2, 4, 2.0, false), ring(2, 4, 2.0, true)};
  const HermiteSurface blend = blend_rails(first, second);
  EXPECT_TRUE(blend.surface.is_closed(Along::u));
  EXPECT_LE(blend.report.crease_angle, 1e-6);
  const Curve& law = blend.match.reparametrization.v;
  for (int i = 0; i <= 50; ++i) {
    const double u = i / 50.0;
    double v = law.evaluate(u)[0];
    v -= std::floor(v);
    const Points at1 = blend.surface.derivatives(u, 1.0, 1);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(at1[0][c], second.curve.evaluate(v)[c], 1e-11);
      EXPECT_NEAR(at1[2][c], second.tangents.evaluate(v)[c], 1e-11);
    }
  }
}

TEST(RailOf, IsTheDerivativeAcrossTimesFullness) {
  testing::RandomSurfaces random(11);
  for (int round = 0; round < 10; ++round) {
    const Surface surface = random.surface(3, 2, 3, false, round % 2 == 0);
    for (const Along along : {Along::u, Along::v}) {
      const Along across = along == Along::u ? Along::v : Along::u;
      const Interval t = surface.domain(across);
      for (const double at : {t.lo, t.lo + 0.37 * t.length(), t.hi}) {
        const Rail rail = rail_of(surface, along, at, Departure::back, 2.5);
        const Interval s = surface.domain(along);
        for (int i = 0; i <= 10; ++i) {
          const double x = s.lo + s.length() * i / 10;
          const Points d = along == Along::u ? surface.derivatives(x, at, 1) : surface.derivatives(at, x, 1);
          for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(rail.curve.evaluate(x)[c], d[0][c], 1e-12);
            EXPECT_NEAR(rail.tangents.evaluate(x)[c], -2.5 * d[along == Along::u ? 2 : 1][c], 1e-8);
          }
        }
      }
    }
  }
}

TEST(RailOf, OfARationalSurfaceKeepsTheTangentPlane) {
  testing::RandomSurfaces random(12);
  const Surface surface = random.surface(2, 3, 3, true, true);
  const Interval t = surface.domain(Along::v);
  const Rail rail = rail_of(surface, Along::u, t.hi);
  const Interval s = surface.domain(Along::u);
  for (int i = 0; i <= 20; ++i) {
    const double x = s.lo + s.length() * i / 20;
    const Points d = surface.derivatives(x, t.hi, 1, {Side::right, Side::left});
    const Point tangent = rail.tangents.evaluate(x);
    double dot = 0.0;
    double square = 0.0;
    double own = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      dot += tangent[c] * d[2][c];
      square += d[2][c] * d[2][c];
      own += tangent[c] * tangent[c];
    }
    EXPECT_NEAR(dot / std::sqrt(square * own), 1.0, 1e-12);
  }
}

std::string message_of(const Rail& first, const Rail& second) {
  try {
    static_cast<void>(blend_rails(first, second));
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "nothing thrown";
}

TEST(HermiteBlend, SaysWhatIsWrongWithItsInput) {
  const Curve line = Curve::bezier({{0, 0, 0}, {1, 0, 0}});
  const Curve other = Curve::bezier({{0, 0, 2}, {1, 0, 2}});
  const Curve up = Curve::bezier({{0, 0, 1}, {0, 0, 1}});
  const Curve planar = Curve::bezier({{0, 1}, {0, 1}});
  const Curve longer = with_domain(up, {0.0, 2.0});
  EXPECT_EQ(message_of({line, up}, {other, up}), "nothing thrown");
  EXPECT_NE(message_of({line, planar}, {other, up}).find("the first rail has dimension 3, its tangents 2"),
            std::string::npos);
  EXPECT_NE(message_of({line, up}, {other, longer}).find("the second rail runs over"), std::string::npos);
  EXPECT_NE(message_of({line, up}, {line, up}).find("coincide"), std::string::npos);
  EXPECT_THROW(static_cast<void>(rail_of(sheet(0, 0, 3), Along::u, 5.0)), InvalidArgument);
  EXPECT_THROW(static_cast<void>(rail_of(sheet(0, 0, 3), Along::u, 0.0, Departure::back, 0.0)),
               InvalidArgument);
}

}  // namespace
}  // namespace tandem
