#include "tandem/match/norm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "match/brute_force.h"
#include "match/random_curves.h"
#include "tandem/error.h"
#include "tandem/match/elastic.h"
#include "tandem/match/programme.h"
#include "tandem/match/samples.h"

namespace tandem {
namespace {

using testing_curves::closed_curve;
using testing_curves::open_curve;

const UserNorm kHeightNorm = [](const NormArguments& x) {
  return NormValue{std::fabs(x.point1[1] - x.point2[1]), x.tangent1[0] * x.tangent2[0] < -0.5};
};

const Norm kAllNorms[] = {NormKind::tangent, NormKind::ruled, NormKind::distance, NormKind::bottleneck,
                          kHeightNorm};

Aggregate aggregate_of(const Norm& norm) {
  return std::holds_alternative<NormKind>(norm) && std::get<NormKind>(norm) == NormKind::bottleneck
             ? Aggregate::maximum
             : Aggregate::sum;
}

TEST(Norm, TablesHoldTheFormulasOfThePaper) {
  std::mt19937 random(1);
  const Samples a = sample(open_curve(random), {.count = 9, .sampling = Sampling::parameter});
  const Samples b = sample(open_curve(random), {.count = 11, .sampling = Sampling::parameter});
  const NodeTable tangent = node_costs(a, b, NormKind::tangent);
  const NodeTable ruled = node_costs(a, b, NormKind::ruled);
  const NodeTable distance = node_costs(a, b, NormKind::distance);
  ASSERT_EQ(tangent.rows, 9u);
  ASSERT_EQ(tangent.cols, 11u);
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t j = 0; j < 11; ++j) {
      const auto t1 = a.tangents_out[i];
      const auto t2 = b.tangents_out[j];
      const double dx = a.positions[i][0] - b.positions[j][0];
      const double dy = a.positions[i][1] - b.positions[j][1];
      const double ipm = t1[0] * t2[0] + t1[1] * t2[1];
      // [C] eq. (6) as printed.
      const double product = (t1[0] * dy - t1[1] * dx) * (t2[0] * dy - t2[1] * dx) / (dx * dx + dy * dy);
      const std::size_t k = tangent.index(i, j);
      EXPECT_EQ(tangent.invalid[k], ipm < 0.0 ? 1 : 0);
      EXPECT_NEAR(tangent.cost[k], ipm < 0.0 ? 0.0 : 1.0 - ipm, 1e-15);
      if (std::fabs(product) > 1e-12) {
        EXPECT_EQ(ruled.invalid[k], product < 0.0 ? 1 : 0);
      }
      EXPECT_NEAR(ruled.cost[k], product < 0.0 ? 0.0 : 1.0 - product, 1e-12);
      EXPECT_NEAR(distance.cost[k], std::sqrt(dx * dx + dy * dy), 1e-14);
    }
  }
}

TEST(Norm, RuledIsNotStrongerThanTangent) {
  // Spec C13: configurations with (4) > 0 and (3) < 0 exist, against [C]'s claim.
  std::mt19937 random(2);
  int contradictions = 0;
  for (int n = 0; n < 1000; ++n) {
    const double a1 = testing_curves::uniform(random, 0.0, 6.2831853);
    const double a2 = testing_curves::uniform(random, 0.0, 6.2831853);
    const double ad = testing_curves::uniform(random, 0.0, 6.2831853);
    const double tangent = std::cos(a1 - a2);
    const double ruled = std::sin(a1 - ad) * std::sin(a2 - ad);
    if (ruled > 0.0 && tangent < 0.0) ++contradictions;
  }
  EXPECT_NEAR(contradictions, 126, 40);
}

TEST(Norm, SignedRuledTestSeesBothFactorsChange) {
  // Two parallel lines, run through in the same direction: the first lies to the right of the ruling.
  const Curve low = Curve::bezier(Points({{0, 0}, {4, 0}}));
  const Curve high = Curve::bezier(Points({{0, 1}, {4, 1}}));
  const Samples a = sample(low, {.count = 5});
  const Samples b = sample(high, {.count = 5});
  const NodeTable positive = chord_costs(a, b, NormKind::ruled, {}, RuledSign::positive);
  const NodeTable negative = chord_costs(a, b, NormKind::ruled, {}, RuledSign::negative);
  EXPECT_NE(positive.invalid[0], negative.invalid[0]);
  // The product cannot tell.
  const NodeTable product = node_costs(a, b, NormKind::ruled);
  EXPECT_EQ(product.invalid[0], 0);
  EXPECT_NEAR(product.cost[0], 0.0, 1e-15);
}

TEST(Norm, AntiTwistFormInSpace) {
  const Samples a = sample(Curve::bezier(Points({{0, 0, 0}, {1, 0, 0}})), {.count = 2});
  const Samples b = sample(Curve::bezier(Points({{0, 0, 1}, {1, 1, 1}})), {.count = 2});
  const NodeTable t = node_costs(a, b, NormKind::ruled);
  // At the first pair d is perpendicular to both tangents: the plain product of the tangents is left.
  EXPECT_NEAR(t.cost[0], 1.0 - std::sqrt(0.5), 1e-15);
}

TEST(Norm, StandstillCarriesNoTangentCost) {
  // Out and back on a line: at the middle the speed is 0 and the direction turns round.
  const Samples a =
      sample(Curve::bezier(Points({{0, 0}, {1, 0}, {0, 0}})), {.count = 3, .sampling = Sampling::parameter});
  const Samples b =
      sample(Curve::bezier(Points({{0, 0}, {0, 1}})), {.count = 3, .sampling = Sampling::parameter});
  EXPECT_EQ(a.speeds[1], 0.0);
  EXPECT_TRUE(a.corners[1]);
  const NodeTable t = node_costs(a, b, NormKind::tangent);
  for (std::size_t j = 0; j < 3; ++j) {
    EXPECT_EQ(t.cost[t.index(1, j)], 0.0);
    EXPECT_EQ(t.invalid[t.index(1, j)], 0);
    EXPECT_EQ(t.cost[t.index(0, j)], 1.0);
  }
}

TEST(Norm, CurvatureIsASecondFeature) {
  std::mt19937 random(3);
  const Samples a = sample(open_curve(random), {.count = 30});
  const NodeTable plain = chord_costs(a, a, NormKind::tangent);
  const NodeTable with = chord_costs(a, a, NormKind::tangent, {.curvature = true, .curvature_weight = 0.5});
  bool differs = false;
  for (std::size_t i = 0; i < with.rows; ++i) {
    for (std::size_t j = 0; j < with.cols; ++j) {
      const double extra = with.cost[with.index(i, j)] - plain.cost[plain.index(i, j)];
      EXPECT_GE(extra, 0.0);
      EXPECT_LE(extra, 0.5);
      differs = differs || extra > 0.01;
      if (i == j) {
        EXPECT_EQ(extra, 0.0);
      }
    }
  }
  EXPECT_TRUE(differs);
}

TEST(Norm, RejectsBadInput) {
  std::mt19937 random(4);
  const Samples plane = sample(open_curve(random, 2), {.count = 4});
  const Samples space = sample(open_curve(random, 3), {.count = 4});
  EXPECT_THROW((void)node_costs(plane, space, NormKind::tangent), InvalidArgument);
  const UserNorm bad = [](const NormArguments&) { return NormValue{std::nan(""), false}; };
  EXPECT_THROW((void)node_costs(plane, plane, bad), InvalidArgument);
}

/// The programmes on the costs of real curves, in every norm, against all paths.
TEST(Norm, ProgrammesEqualBruteForceInEveryNorm) {
  std::mt19937 random(5);
  for (int n = 0; n < 1000; ++n) {
    const int m1 = 3 + static_cast<int>(random() % 3);
    const int m2 = 3 + static_cast<int>(random() % 3);
    const Curve open1 = open_curve(random);
    const Curve open2 = open_curve(random);
    const Curve loop1 = closed_curve(random);
    const Curve loop2 = closed_curve(random);
    const Samples a = sample(open1, {.count = m1, .sampling = Sampling::parameter});
    const Samples b = sample(open2, {.count = m2, .sampling = Sampling::parameter});
    const Samples c = sample(loop1, {.count = m1, .sampling = Sampling::parameter, .cyclic = true});
    const Samples d = sample(loop2, {.count = m2, .sampling = Sampling::parameter, .cyclic = true});
    for (const Norm& norm : kAllNorms) {
      const Aggregate aggregate = aggregate_of(norm);
      const auto expect_same = [&](const Path& path, const brute::Found& best) {
        ASSERT_EQ(path.nodes.empty(), best.cost == std::numeric_limits<double>::infinity());
        if (path.nodes.empty()) return;
        EXPECT_EQ(path.invalid, best.invalid);
        // A loop may be added up from any of its nodes: the order of the sum, and so its rounding, differs.
        EXPECT_NEAR(path.cost, best.cost, 1e-13 * std::max(1.0, best.cost));
      };
      const NodeTable open = node_costs(a, b, norm);
      const NodeTable loops = node_costs(c, d, norm);
      expect_same(open_path(open, aggregate), brute::open(open, aggregate));
      expect_same(closed_path(loops, aggregate), brute::closed(loops, aggregate));
      const EdgeTable open_edges = edge_costs(a, b, chord_costs(a, b, norm), {}, aggregate);
      const EdgeTable loop_edges = edge_costs(c, d, chord_costs(c, d, norm), {}, aggregate);
      expect_same(open_path(open_edges, aggregate), brute::open(open_edges, aggregate));
      expect_same(closed_path(loop_edges, aggregate), brute::closed(loop_edges, aggregate));
    }
  }
}

}  // namespace
}  // namespace tandem
