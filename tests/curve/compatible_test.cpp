#include "tandem/curve/compatible.h"

#include <gtest/gtest.h>

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

TEST(Compatible, RefusesNoneAndMixedDimensions) {
  EXPECT_THROW((void)make_compatible({}), InvalidArgument);
  const std::vector<Curve> mixed{Curve::bezier(Points({{0.0}, {1.0}})),
                                 Curve::bezier(Points({{0, 0}, {1, 1}}))};
  EXPECT_THROW((void)make_compatible(mixed), InvalidArgument);
}

}  // namespace
}  // namespace tandem
