#include "tandem/curve/compatible.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "curve/random_curves.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using testing::largest_gap;
using testing::RandomCurves;

TEST(Compatible, SameSpaceSameGeometry) {
  RandomCurves random(50);
  for (int i = 0; i < 100; ++i) {
    std::vector<Curve> curves;
    for (int k = 0; k < 3; ++k) curves.push_back(random.any(2));
    const std::vector<Curve> same = make_compatible(curves);
    ASSERT_EQ(same.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(same[k].degree(), same[0].degree());
      EXPECT_EQ(same[k].knots(), same[0].knots());
      EXPECT_EQ(same[k].is_rational(), same[0].is_rational());
      EXPECT_EQ(same[k].domain(), curves[0].domain());
      // Mapping the domain rounds the knots, and the curves are fast near short spans.
      EXPECT_LT(largest_gap(with_domain(same[k], curves[k].domain()), curves[k]), 1e-11);
    }
  }
}

TEST(Compatible, NearlyEqualKnotsBecomeOne) {
  const Points points({{0, 0}, {1, 2}, {3, 1}, {4, 0}});
  const std::vector<Curve> curves{Curve(2, {0, 0, 0, 0.5, 1, 1, 1}, points),
                                  Curve(2, {0, 0, 0, 0.5 + 1e-12, 1, 1, 1}, points),
                                  Curve(2, {0, 0, 0, 0.6, 1, 1, 1}, points)};
  const std::vector<Curve> same = make_compatible(curves);
  EXPECT_EQ(same[0].knots(), (std::vector<double>{0, 0, 0, 0.5, 0.6, 1, 1, 1}));
  EXPECT_LT(largest_gap(same[1], curves[1]), 1e-11);
}

TEST(Compatible, OwnNearKnotsStayApart) {
  const Curve twin(1, {0, 0, 0.5, 0.5 + 1e-12, 1, 1}, Points({{0, 0}, {1, 2}, {3, 1}, {4, 0}}));
  const std::vector<Curve> curves{twin, twin};
  EXPECT_EQ(make_compatible(curves)[1], twin);
}

TEST(Compatible, NeverMovesAKnotOntoAnotherOfItsOwn) {
  // Two corners of b lie within snapping distance of a's one; both there would break the curve.
  const Curve a(1, {0, 0, 0.5, 1, 1}, Points({{0, 0}, {1, 2}, {4, 0}}));
  for (const double gap : {-5e-11, 5e-11}) {
    const double lo = std::min(0.5, 0.5 + gap);
    const double hi = std::max(0.5, 0.5 + gap);
    const Curve b(1, {0, 0, lo, hi, 1, 1}, Points({{0, 0}, {1, 2}, {1, 3}, {4, 0}}));
    const std::vector<Curve> same = make_compatible(std::vector<Curve>{a, b});
    EXPECT_EQ(same[1], b);
    EXPECT_EQ(same[0].knots(), b.knots());
  }
}

TEST(CommonDenominator, BlendsEuclideanPoints) {
  RandomCurves random(51);
  for (int i = 0; i < 100; ++i) {
    std::vector<Curve> curves;
    const int count = random.integer(2, 3);
    for (int k = 0; k < count; ++k) {
      curves.push_back(
          random.curve(random.integer(1, 4), 2, random.integer(1, 4), random.integer(0, 2) > 0, k % 2 == 0));
    }
    const std::vector<Curve> same = with_common_denominator(curves);
    for (std::size_t k = 0; k < same.size(); ++k) {
      ASSERT_EQ(same[k].knots(), same[0].knots());
      ASSERT_EQ(same[k].weights(), same[0].weights());
      // 1e-12 of the size, times the lengths of the shortest spans in the rounding of knots.
      EXPECT_LT(largest_gap(same[k], curves[k]), 2e-12) << i;
    }
    // Blended control points are the control points of the blend of points.
    Points blend(2, same[0].size());
    for (std::size_t c = 0; c < blend.data().size(); ++c) {
      blend.data()[c] = 0.3 * same[0].control_points().data()[c] + 0.7 * same[1].control_points().data()[c];
    }
    const Curve between(same[0].degree(), same[0].knots(), blend, same[0].weights());
    for (int k = 0; k <= 20; ++k) {
      const Point a = curves[0].evaluate(k / 20.0);
      const Point b = curves[1].evaluate(k / 20.0);
      const Point c = between.evaluate(k / 20.0);
      EXPECT_NEAR(c[0], 0.3 * a[0] + 0.7 * b[0], 2e-12);
      EXPECT_NEAR(c[1], 0.3 * a[1] + 0.7 * b[1], 2e-12);
    }
  }
}

TEST(CommonDenominator, DegreesAddUpOnlyWhereTheyMust) {
  const Points arc({{1, 0}, {1, 1}, {0, 1}});
  const double h = std::sqrt(0.5);
  const Curve circle = Curve::bezier(arc, {1, h, 1});
  const Curve other = Curve::bezier(arc, {1, 2, 1});
  const Curve cubic = Curve::bezier(Points({{0, 0}, {1, 2}, {3, 1}, {4, 0}}));
  const auto degree = [](std::vector<Curve> curves) { return with_common_denominator(curves)[0].degree(); };
  EXPECT_EQ(degree({circle, other}), 4);
  EXPECT_EQ(degree({circle, cubic}), 5);
  EXPECT_EQ(degree({circle, Curve::bezier(arc, {3, 3 * h, 3})}), 2);  // the same weights but for a factor
  EXPECT_EQ(degree({circle, elevate_degree(circle)}), 3);
  EXPECT_EQ(degree({circle, elevate_degree(circle), cubic}), 5);
  EXPECT_EQ(degree({cubic, Curve::bezier(arc, {2, 2, 2})}), 3);  // constant weights are none
  EXPECT_EQ(degree({cubic, cubic}), 3);
}

TEST(CommonDenominator, KeepsContinuity) {
  RandomCurves random(52);
  const std::vector<double> knots{0, 0, 0, 0, 0.5, 1, 1, 1, 1};
  const std::vector<Curve> curves{Curve(3, knots, random.points(2, 5), random.weights(5)),
                                  Curve(3, knots, random.points(2, 5), random.weights(5))};
  EXPECT_EQ(multiplicity(with_common_denominator(curves)[0].knots(), 0.5), 4);  // degree 6, C2
}

TEST(CommonDenominator, HugeCoordinates) {
  const std::vector<Curve> curves{Curve::bezier(Points({{0, 0}, {1e300, 1e300}, {2e300, 0}}), {1, 2, 1}),
                                  Curve::bezier(Points({{0, 0}, {1e-300, 1e300}, {1e300, 0}}), {1, 0.5, 3})};
  const std::vector<Curve> same = with_common_denominator(curves);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_LT(largest_gap(same[k], curves[k]) / 1e300, 1e-14);
}

TEST(Compatible, RefusesNoneAndMixedDimensions) {
  EXPECT_THROW((void)make_compatible({}), InvalidArgument);
  const std::vector<Curve> mixed{Curve::bezier(Points({{0.0}, {1.0}})),
                                 Curve::bezier(Points({{0, 0}, {1, 1}}))};
  EXPECT_THROW((void)make_compatible(mixed), InvalidArgument);
}

}  // namespace
}  // namespace tandem
