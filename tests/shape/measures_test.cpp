#include "tandem/shape/measures.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "shape/test_paths.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using test::circle;
using test::cubic;
using test::make_path;
using test::polygon;
using test::polyline;

TEST(SignedArea, OfPolygonsAndParabolas) {
  EXPECT_NEAR(signed_area(polygon({{0, 0}, {4, 0}, {4, 3}})), 6.0, 1e-14);
  EXPECT_NEAR(signed_area(polygon({{0, 0}, {4, 3}, {4, 0}})), -6.0, 1e-14);
  EXPECT_NEAR(signed_area(polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}})), 0.0, 1e-14);  // an eight
  // y = x (1 - x) as a cubic, from 1 back to 0: 1/6; open, closed by the line.
  EXPECT_NEAR(signed_area(cubic({1, 0}, {2. / 3, 1. / 3}, {1. / 3, 1. / 3}, {0, 0})), 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(signed_area(circle({7, -3}, 2)), 4 * std::numbers::pi, 4 * std::numbers::pi * 3e-4);
  EXPECT_EQ(signed_area(polyline({{1, 1}, {1, 1}})), 0.0);
}

// Against the polygon of many points, in which each cubic's error is of second order.
TEST(SignedArea, IsTheLimitOfPolygons) {
  EXPECT_TRUE(rc::check([] {
    const CubicPath path = test::any_closed_path();
    double sum = 0.0;
    const int steps = 2000;
    for (std::size_t i = 0; i < path.segment_count() * steps; ++i) {
      const Vec2 p = test::at(path, static_cast<double>(i) / steps);
      const Vec2 q = test::at(path, static_cast<double>(i + 1) / steps);
      sum += 0.5 * (p.x * q.y - p.y * q.x);
    }
    RC_ASSERT(std::fabs(signed_area(path) - sum) <= 1e-2);
    RC_ASSERT(std::fabs(signed_area(path) + signed_area(test::reversed(path))) <= 1e-10);
  }));
}

TEST(SignedArea, AtEverySizeAndFarOff) {
  EXPECT_NEAR(signed_area(polygon({{0, 0}, {1e-150, 0}, {0, 1e-150}})) / 0.5e-300, 1.0, 1e-12);
  EXPECT_NEAR(signed_area(polygon({{0, 0}, {1e150, 0}, {0, 1e150}})) / 0.5e300, 1.0, 1e-12);
  EXPECT_NEAR(signed_area(polygon({{1e8, 1e8}, {1e8 + 1, 1e8}, {1e8, 1e8 + 1}})), 0.5, 1e-7);
}

TEST(TangentBreaks, AreTheExteriorAngles) {
  EXPECT_TRUE(rc::check([] {
    const double a = *rc::gen::inRange(0, 18001) / 100.0;
    const double turn = *rc::gen::inRange(0, 36000) / 100.0 * std::numbers::pi / 180.0;
    const double b = turn + a * std::numbers::pi / 180.0;
    const CubicPath path =
        polyline({{-std::cos(turn), -std::sin(turn)}, {0, 0}, {3 * std::cos(b), 3 * std::sin(b)}});
    const std::vector<double> breaks = tangent_breaks(path);
    RC_ASSERT(breaks.size() == 2u);
    RC_ASSERT(breaks[0] == 0.0);
    RC_ASSERT(std::fabs(breaks[1] - a * std::numbers::pi / 180.0) <= 1e-12);
  }));
  for (const double angle : tangent_breaks(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}))) {
    EXPECT_NEAR(angle, std::numbers::pi / 2, 1e-14);
  }
  for (const double angle : tangent_breaks(circle({3, 4}, 1e-200))) EXPECT_NEAR(angle, 0.0, 1e-12);
}

TEST(TangentBreaks, SeeTheSmallest) {
  for (const double angle : {1e-3, 1e-9, 1e-12}) {
    EXPECT_NEAR(tangent_breaks(polyline({{-1, 0}, {0, 0}, {1, angle}}))[1], angle, 1e-3 * angle + 1e-14);
  }
}

TEST(TangentBreaks, LookPastHandlesAndSegmentsOfNoLength) {
  // Both handles at the joint have no length.
  const CubicPath none = make_path({{0, 0}, {1, 0}, {3, 0}, {3, 0}, {3, 0}, {3, 2}, {3, 3}}, false);
  EXPECT_NEAR(tangent_breaks(none)[1], std::numbers::pi / 2, 1e-14);
  // A segment that is a point lies between.
  const CubicPath point = polyline({{0, 0}, {1, 0}, {1, 0}, {1, 1}});
  EXPECT_NEAR(tangent_breaks(point)[1], std::numbers::pi / 2, 1e-14);
  EXPECT_NEAR(tangent_breaks(point)[2], std::numbers::pi / 2, 1e-14);
  // A closed path of no extent, and a closed one from a smooth joint.
  for (const double angle : tangent_breaks(polygon({{1, 1}, {1, 1}}))) EXPECT_EQ(angle, 0.0);
  EXPECT_NEAR(tangent_breaks(polygon({{1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}}))[0], 0.0, 1e-15);
}

TEST(Measures, RefuseWhatIsNotPlanar) {
  const CubicPath space(Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}});
  EXPECT_THROW((void)signed_area(space), InvalidArgument);
  EXPECT_THROW((void)tangent_breaks(space), InvalidArgument);
}

}  // namespace
}  // namespace tandem
