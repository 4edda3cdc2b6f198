#include "tandem/morph/morph.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "morph/test_shapes.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using test::any_outline;
using test::blob;
using test::distance;
using test::one;
using test::points_along;

// Few nodes: what is tested here does not depend on how good the match is.
MorphOptions quick() {
  MorphOptions options;
  options.match.samples = {24, 24};
  return options;
}

MorphOptions unturned() {
  MorphOptions options = quick();
  options.match.rotate = false;
  return options;
}

constexpr double kRounding = 1e-11;  // of shapes of size 10

TEST(LocateKey, FindsKeysExactly) {
  for (std::size_t n = 2; n <= 60; ++n) {
    for (std::size_t i = 0; i < n; ++i) {
      const KeyPosition at = locate_key(static_cast<double>(i) / static_cast<double>(n - 1), n);
      EXPECT_EQ(static_cast<double>(at.key) + at.local, static_cast<double>(i)) << n;
      EXPECT_TRUE(at.local == 0.0 || at.local == 1.0);
      EXPECT_LT(at.key, n - 1);
    }
  }
}

TEST(LocateKey, ExtrapolatesAlongTheOuterPairs) {
  EXPECT_EQ(locate_key(-0.5, 3).key, 0u);
  EXPECT_EQ(locate_key(-0.5, 3).local, -1.0);
  EXPECT_EQ(locate_key(1.5, 3).key, 1u);
  EXPECT_EQ(locate_key(1.5, 3).local, 2.0);
  EXPECT_EQ(locate_key(1e300, 3).key, 1u);
  EXPECT_THROW((void)locate_key(0.5, 1), InvalidArgument);
  EXPECT_THROW((void)locate_key(std::numeric_limits<double>::quiet_NaN(), 2), InvalidArgument);
  EXPECT_THROW((void)locate_key(std::numeric_limits<double>::infinity(), 2), InvalidArgument);
}

TEST(Morph, SaysWhatIsWrong) {
  const Shape shape = one(blob(5, 0));
  const Shape spatial = one(Curve::bezier(Points({{0, 0, 0}, {1, 1, 1}})));
  const auto message = [](const std::vector<Shape>& keys) -> std::string {
    try {
      const Morph morph(keys);
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    return "nothing thrown";
  };
  EXPECT_EQ(message({shape}), "morph: 1 key shapes, expected at least 2");
  EXPECT_EQ(message({shape, Shape{}}), "morph: key 1 has no contours");
  EXPECT_EQ(message({shape, spatial}), "morph: contour 0 of key 1 has dimension 3, expected 2 as in key 0");
}

// Both ends are the inputs: A as it is, B at v(u).
TEST(Morph, EndsAreTheInputs) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Shape> keys{one(any_outline()), one(any_outline())};
    const Morph morph(keys, quick());
    RC_ASSERT(morph.key_count() == 2u);
    RC_ASSERT(morph.contour_count() == 1u);
    RC_ASSERT(morph.match(0, 0).has_value());
    const Curve& a = keys[0].contours[0];
    const Reparametrization& v = morph.match(0, 0)->reparametrization;
    const Curve b = v.reversed ? reverse(keys[1].contours[0]) : keys[1].contours[0];
    const Curve first = morph.at(0.0).contours[0];
    const Curve last = morph.at(1.0).contours[0];
    RC_ASSERT(first.domain() == a.domain());
    for (const double u : test::parameters(a, 60)) {
      RC_ASSERT(test::apart(first.evaluate(u), a.evaluate(u)) <= kRounding);
      RC_ASSERT(test::apart(last.evaluate(u), b.evaluate(test::wrapped(v.v.evaluate(u)[0], b))) <= kRounding);
    }
  }));
}

TEST(Morph, BlendsPointByPoint) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<Shape> keys{one(any_outline()), one(any_outline())};
    const Morph morph(keys, unturned());
    const Curve a = morph.at(0.0).contours[0];
    const Curve b = morph.at(1.0).contours[0];
    const double s = *rc::gen::inRange(-200, 60) / 100.0;
    const Curve between = morph.at(s).contours[0];
    RC_ASSERT(between.knots() == a.knots());
    for (const double t : test::parameters(a, 50)) {
      const Point p = a.evaluate(t);
      const Point q = b.evaluate(t);
      const Point r = between.evaluate(t);
      for (std::size_t k = 0; k < 2; ++k) {
        RC_ASSERT(std::fabs(r[k] - ((1 - s) * p[k] + s * q[k])) <= kRounding * (1 + std::fabs(s)));
      }
    }
  }));
}

// Spec C2: eq. (1) blends Euclidean points, whatever the weights are.
TEST(Morph, BlendsRationalCurvesInEuclideanSpace) {
  const double w = std::sqrt(0.5);
  const Curve arc = Curve::bezier(Points({{1, 0}, {1, 1}, {0, 1}}), {1, w, 1});
  const Curve other = Curve::bezier(Points({{3, 0}, {3, 2}, {2, 3}, {0, 3}}), {1, 0.5, 4, 2});
  const std::vector<Shape> keys{one(arc), one(other)};
  const Morph morph(keys, quick());
  const Curve a = morph.at(0.0).contours[0];
  const Curve b = morph.at(1.0).contours[0];
  double worst = 0.0;
  for (const double s : {-0.5, 0.25, 0.5, 0.9, 1.5}) {
    const Curve between = morph.at(s).contours[0];
    for (const double t : test::parameters(a, 200)) {
      const Point p = arc.evaluate(t);
      const Point q = b.evaluate(t);
      const Point r = between.evaluate(t);
      worst = std::max(worst, test::apart(p, a.evaluate(t)));
      worst = std::max(worst, test::apart(r, {(1 - s) * p[0] + s * q[0], (1 - s) * p[1] + s * q[1]}));
    }
  }
  EXPECT_LE(worst, 1e-12);
  EXPECT_LE(distance(points_along(b, 60), other), kRounding);
}

TEST(Morph, GoesThroughAllKeysInTurn) {
  const std::vector<Shape> keys{one(blob(3, 0)), one(blob(5, 10)), one(blob(8, -10)), one(blob(4, 3))};
  const Morph morph(keys, quick());
  EXPECT_EQ(morph.key_count(), 4u);
  ASSERT_EQ(morph.keys(0).size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const Curve drawn = morph.at(static_cast<double>(i) / 3.0).contours[0];
    EXPECT_EQ(drawn, morph.keys(0)[i]);
    EXPECT_LE(distance(points_along(drawn, 60), keys[i].contours[0]), kRounding);
    EXPECT_EQ(drawn.knots(), morph.keys(0)[0].knots());
  }
  const Curve beyond = morph.at(4.0 / 3.0).contours[0];
  const Point p = morph.keys(0)[2].evaluate(0.4);
  const Point q = morph.keys(0)[3].evaluate(0.4);
  EXPECT_NEAR(beyond.evaluate(0.4)[0], 2 * q[0] - p[0], 1e-12);
}

TEST(Morph, ContoursWithoutPartnerGrowFromTheirCentre) {
  Shape ring = one(blob(6, 0, 4.0));
  ring.contours.push_back(blob(4, 1.0, 2.0));
  ring.fill_rule = FillRule::evenodd;
  const std::vector<Shape> keys{one(blob(5, 0, 4.0)), ring, one(blob(7, 0, 4.0))};
  const Morph morph(keys, quick());
  EXPECT_EQ(morph.fill_rule(), FillRule::evenodd);
  ASSERT_EQ(morph.contour_count(), 2u);
  EXPECT_TRUE(morph.match(0, 0).has_value());
  EXPECT_FALSE(morph.match(0, 1).has_value());
  EXPECT_FALSE(morph.match(1, 1).has_value());
  const Point center = bounding_box(ring.contours[1]).center();
  for (const double s : {0.0, 1.0}) {
    const Curve point = morph.at(s).contours[1];
    EXPECT_EQ(point.extent(), 0.0);
    EXPECT_EQ(point.evaluate(0.3), center);
  }
  EXPECT_LE(distance(points_along(morph.at(0.5).contours[1], 100), ring.contours[1]), kRounding);
  EXPECT_EQ(morph.at(0.5).contours.size(), 2u);
}

double signed_area(const Curve& curve) {
  const std::vector<Point> points = points_along(curve, 400);
  const std::size_t n = points.size();
  std::vector<double> ts = test::parameters(curve, 400);
  std::sort(ts.begin(), ts.end());
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Point p = curve.evaluate(ts[i]);
    const Point q = curve.evaluate(ts[i + 1]);
    area += (p[0] * q[1] - p[1] * q[0]) / 2.0;
  }
  return area;
}

// The nonzero rule tells a hole by its direction against the contour around it: at every key the directions
// must be the source's, all or none of them turned.
TEST(Morph, HolesStayHoles) {
  const Curve outer = blob(5, 0, 6.0);
  const Curve hole = blob(4, 0, 2.0);
  const Curve island = blob(6, 0, 1.0);
  const Shape ring{{outer, reverse(hole)}};
  const Shape other_way{{reverse(blob(3, 0, 6.0)), blob(7, 0, 3.0)}};
  const Shape both_one_way{{blob(3, 0, 6.0), blob(7, 20, 3.0)}};
  const Shape three{{reverse(blob(6, 0, 6.0)), blob(7, 0, 3.0), reverse(island)}};
  for (const std::vector<Shape>& keys : {std::vector<Shape>{ring, other_way},
                                         {ring, both_one_way},
                                         {both_one_way, ring},
                                         {ring, other_way, both_one_way, three},
                                         {ring, three, other_way, three}}) {
    const Morph morph(keys, quick());
    for (std::size_t key = 0; key < keys.size(); ++key) {
      const Shape drawn = morph.at(static_cast<double>(key) / static_cast<double>(keys.size() - 1));
      const double turned = signed_area(drawn.contours[0]) * signed_area(keys[key].contours[0]);
      for (std::size_t c = 0; c < keys[key].contours.size(); ++c) {
        EXPECT_GT(signed_area(drawn.contours[c]) * signed_area(keys[key].contours[c]) * turned, 0.0)
            << "key " << key << " contour " << c;
      }
    }
  }
}

TEST(Morph, DirectionsAreFreeUnderTheEvenOddRule) {
  Shape ring{{blob(5, 0, 6.0), reverse(blob(4, 0, 2.0))}};
  Shape both_one_way{{blob(3, 0, 6.0), blob(4, 0, 2.0)}};
  ring.fill_rule = FillRule::evenodd;
  const std::vector<Shape> keys{ring, both_one_way};
  const Morph morph(keys, quick());
  EXPECT_EQ(morph.match(0, 0)->report.direction, Direction::forward);
  EXPECT_EQ(morph.match(0, 1)->report.direction, Direction::reversed);
}

TEST(Morph, ContoursMayVanishAndComeBack) {
  Shape two = one(blob(6, 0, 4.0));
  two.contours.push_back(blob(4, 1.0, 2.0));
  Shape other = one(blob(3, 0, 4.0));
  other.contours.push_back(blob(7, 20.0, 2.0));
  const std::vector<Shape> keys{two, one(blob(5, 0, 4.0)), other};
  const Morph morph(keys, quick());
  EXPECT_EQ(morph.at(0.5).contours[1].extent(), 0.0);
  EXPECT_LE(distance(points_along(morph.at(0.0).contours[1], 100), two.contours[1]), kRounding);
  EXPECT_LE(distance(points_along(morph.at(1.0).contours[1], 100), other.contours[1]), kRounding);
}

TEST(Morph, PointsGrowWhereTheyAre) {
  const Curve point = Curve::bezier(Points({{7, 7}, {7, 7}}));
  const std::vector<Shape> keys{one(point), one(blob(5, 0))};
  const Morph morph(keys, quick());
  EXPECT_FALSE(morph.match(0, 0).has_value());
  EXPECT_EQ(morph.at(0.0).contours[0].evaluate(0.5), (Point{7, 7}));
  EXPECT_LE(distance(points_along(morph.at(1.0).contours[0], 100), keys[1].contours[0]), kRounding);
  const std::vector<Shape> points{one(point), one(Curve::bezier(Points({{9, 9}, {9, 9}})))};
  EXPECT_EQ(Morph(points).at(0.5).contours[0].evaluate(0.5), (Point{8, 8}));
}

TEST(Morph, ClosedCurvesAreCutForOpenOnes) {
  const Curve open = Curve::clamped_uniform(3, Points({{0, 0}, {2, 5}, {5, 5}, {8, 1}, {9, -3}}));
  const Curve closed = blob(5, 0);
  for (const std::vector<Curve>& order : {std::vector<Curve>{closed, open},
                                          {open, closed},
                                          {closed, open, closed},
                                          {open, closed, open},
                                          {closed, closed, open, open, closed}}) {
    std::vector<Shape> keys;
    for (const Curve& curve : order) keys.push_back(one(curve));
    const Morph morph(keys, quick());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const Curve drawn = morph.at(static_cast<double>(i) / static_cast<double>(keys.size() - 1)).contours[0];
      EXPECT_LE(distance(points_along(drawn, 60), order[i]), kRounding) << i;
      EXPECT_LE(distance(points_along(order[i], 60), drawn), 1e-3) << i;
    }
  }
}

TEST(Morph, TakesAMatchThatIsThereAlready) {
  const Curve a = blob(3, 0);
  const Curve b = blob(6, 5);
  const Match found = match(a, b);
  const Morph morph(a, b, found);
  const std::vector<Shape> keys{one(a), one(b)};
  EXPECT_EQ(morph.at(0.37), Morph(keys).at(0.37));
}

TEST(Morph, WorksInAnyDimension) {
  const Curve a = Curve::clamped_uniform(3, Points({{0, 0, 0}, {1, 2, 3}, {4, 1, 0}, {6, 6, 1}}));
  const Curve b = Curve::clamped_uniform(2, Points({{0, 1, 0}, {1, 2, 5}, {4, 3, 0}}));
  const std::vector<Shape> keys{one(a), one(b)};
  const Morph morph(keys, quick());
  EXPECT_EQ(morph.at(0.5).dim(), 3);
}

TEST(Morph, ReportsProgressAndStops) {
  const std::vector<Shape> keys{one(blob(3, 0)), one(blob(5, 0)), one(blob(7, 0))};
  double last = 0.0;
  bool backwards = false;
  MorphOptions options = quick();
  options.match.progress = [&](double fraction) {
    backwards = backwards || fraction < last || fraction > 1.0;
    last = fraction;
    return true;
  };
  EXPECT_FALSE(Morph(keys, options).cancelled());
  EXPECT_FALSE(backwards);
  EXPECT_GT(last, 0.5);
  options.match.progress = [](double) { return false; };
  EXPECT_TRUE(Morph(keys, options).cancelled());
}

}  // namespace
}  // namespace tandem
