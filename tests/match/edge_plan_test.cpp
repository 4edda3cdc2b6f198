#include "match/edge_plan.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

#include "match/random_curves.h"
#include "match/search.h"
#include "tandem/match/elastic.h"
#include "tandem/match/match.h"

namespace tandem {
namespace {

using detail::EdgePlan;
using detail::EdgePlans;
using detail::Layout;
using testing_curves::closed_curve;
using testing_curves::open_curve;

// Whatever the norm's features, and however many other curves were matched in between.
TEST(EdgePlan, SharedOnesChangeNothing) {
  std::mt19937 random(3);
  EdgePlans plans;
  for (int n = 0; n < 8; ++n) {
    const Samples a = sample(closed_curve(random), {.count = 30 + n, .cyclic = true});
    const Samples b = sample(closed_curve(random), {.count = 40 - n, .cyclic = true});
    for (const double weight : {0.0, 1.0}) {
      for (const double lambda : {0.02, 0.1}) {
        MatchOptions options;
        options.threads = 1;
        options.features.position_weight = weight;
        options.features.lenient = weight > 0.0;
        options.elastic.lambda = lambda;
        const Path alone = detail::search(a, b, options, Layout::toroidal).path;
        const Path shared = detail::search(a, b, options, Layout::toroidal, nullptr, &plans).path;
        EXPECT_EQ(shared.nodes, alone.nodes) << n;
        EXPECT_EQ(shared.cost, alone.cost) << n;
        EXPECT_EQ(shared.invalid, alone.invalid) << n;
      }
    }
  }
}

TEST(EdgePlan, IsFoundAgainForTheSameLengthsOnly) {
  std::mt19937 random(4);
  const Samples a = sample(closed_curve(random), {.count = 20, .cyclic = true});
  const Samples b = sample(closed_curve(random), {.count = 20, .cyclic = true});
  Samples other = b;
  other.chord_lengths[7] *= 1.0 + 1e-15;
  EdgePlans plans;
  const auto plan = plans.find(a, b, 6);
  EXPECT_EQ(plans.find(a, b, 6), plan);
  EXPECT_NE(plans.find(a, b, 5), plan);
  EXPECT_NE(plans.find(b, a, 6), plan);
  EXPECT_NE(plans.find(a, other, 6), plan);
}

// Of many samples with chords of as many lengths the weights are not kept but made row by row.
TEST(EdgePlan, EdgesAreThoseOfTheFormulaWhereWeightsAreNotKept) {
  std::mt19937 random(5);
  constexpr int kCount = 480;
  constexpr double kLambda = 0.03;
  const ElasticOptions options{.lambda = kLambda, .longest_step = 3};
  const SampleOptions sampling{.count = kCount, .sampling = Sampling::parameter};
  const Samples a = sample(open_curve(random), sampling);
  const Samples b = sample(open_curve(random), sampling);
  ASSERT_FALSE(EdgePlan(a, b, options.longest_step).keeps_weights());
  const NodeTable chords = chord_costs(a, b, NormKind::tangent);
  const EdgeTable edges = edge_costs(a, b, chords, options);
  const auto expected = [&](std::size_t i, std::size_t j, const Step& step) {
    double length_a = 0.0;
    double length_b = 0.0;
    double sum = 0.0;
    for (int k = 1; k <= step.a; ++k) length_a += a.chord_lengths[i - static_cast<std::size_t>(k)];
    for (int k = 1; k <= step.b; ++k) length_b += b.chord_lengths[j - static_cast<std::size_t>(k)];
    for (std::size_t p = 1; p <= static_cast<std::size_t>(step.a); ++p) {
      for (std::size_t q = 1; q <= static_cast<std::size_t>(step.b); ++q) {
        const double share = (step.a > 1 ? a.chord_lengths[i - p] / length_a : 1.0) *
                             (step.b > 1 ? b.chord_lengths[j - q] / length_b : 1.0);
        sum += share * chords.cost[chords.index(i - p, j - q)];
      }
    }
    const double difference = length_a - length_b;
    return 0.5 * (length_a + length_b) * sum + kLambda * difference * difference / (length_a + length_b);
  };
  for (std::size_t s = 0; s < edges.steps.size(); ++s) {
    const Step& step = edges.steps[s];
    if (step.a > 1 && step.b > 1) continue;  // of one stretch on one of the curves: shares multiply
    for (std::size_t i = 3; i < a.size(); i += 7) {
      for (std::size_t j = 3; j < b.size(); j += 11) {
        const double cost = expected(i, j, step);
        EXPECT_NEAR(edges.cost[edges.index(i, s, j)], cost, 1e-12 * (1.0 + cost)) << i << " " << j;
      }
    }
  }
}

}  // namespace
}  // namespace tandem
