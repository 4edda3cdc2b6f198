#include "rank/direction_bound.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "rank/pair_cost.h"
#include "rank/shapes.h"
#include "rank/tangent_planes.h"
#include "rank/variant.h"

namespace {

using tandem::CompareOptions;
using tandem::RankCost;
using tandem::Rotation;
using tandem::ShapeDescriptor;
using tandem::detail::DirectionBound;
using tandem::detail::make_variant;
using tandem::detail::Variant;
using namespace tandem::testing_rank;

/// At no turn does a match cost less than the bound.
TEST(DirectionBound, IsNeverAboveTheCost) {
  std::mt19937 random(21);
  const std::vector<ShapeDescriptor> shapes = stars(40, 22, 30);
  double closest = 1.0;
  for (const RankCost cost : {RankCost::symmetric, RankCost::paper, RankCost::elastic}) {
    for (int round = 0; round < 150; ++round) {
      const CompareOptions options{.cost = cost, .rotate = round % 2 == 0};
      const Variant a = make_variant(shapes[random() % 40], round % 4 < 2, false, options);
      const Variant b = make_variant(shapes[random() % 40], false, false, options);
      const double bound = DirectionBound::lower_bound(a.bound, b.bound, options);
      const double angle = options.rotate ? uniform(random, 0.0, 6.3) : 0.0;
      const double turn[] = {std::cos(angle), std::sin(angle)};
      const tandem::detail::TangentPlanes query = tandem::detail::turned(a.tangents, Rotation(2, turn));
      const auto fit =
          tandem::detail::fit_pair({query, a.lengths}, {b.tangents, b.lengths}, true, options, 10.0);
      ASSERT_TRUE(fit);
      EXPECT_LE(bound, fit->cost);
      if (!options.rotate && fit->cost > 0.05) closest = std::min(closest, 1.0 - bound / fit->cost);
    }
  }
  EXPECT_LT(closest, 0.7);  // it says something: at least once it is more than 30 % of the cost
}

/// Every direction falls into the bin that it belongs to: turning both shapes by whole bins changes nothing.
TEST(DirectionBound, DoesNotDependOnACommonTurn) {
  const std::vector<ShapeDescriptor> shapes = stars(2, 23, 30);
  const CompareOptions options{.rotate = false};
  const Variant a = make_variant(shapes[0], false, false, options);
  const Variant b = make_variant(shapes[1], false, false, options);
  const std::vector<double> ones(64, 1.0);
  const double bound = DirectionBound::lower_bound(a.bound, b.bound, options);
  EXPECT_GT(bound, 0.0);
  for (int k = 1; k < 128; ++k) {
    const double angle = 6.283185307179586 * k / 128.0;
    const double turn[] = {std::cos(angle), std::sin(angle)};
    const Rotation rotation(2, turn);
    const DirectionBound turned_a(tandem::detail::turned(a.tangents, rotation),
                                  std::span(ones).first(a.tangents.size()));
    const DirectionBound turned_b(tandem::detail::turned(b.tangents, rotation),
                                  std::span(ones).first(b.tangents.size()));
    EXPECT_NEAR(DirectionBound::lower_bound(turned_a, turned_b, options), bound, 1e-12) << k;
  }
}

}  // namespace
