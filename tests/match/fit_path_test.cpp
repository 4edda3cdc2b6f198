#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "match/paths.h"
#include "tandem/match/reparametrization.h"

namespace tandem {
namespace {

using Pairs = std::vector<ParameterPair>;

TEST(FitPath, KeepsAnOpenPathAndTurnsAReversedOneRound) {
  const Correspondence c{{{0, 10}, {1, 12}, {4, 13}}, {0, 4}, {10, 13}, false, false};
  EXPECT_EQ(fit_path(c).points, c.points);
  const Correspondence r{{{0, 13}, {1, 12}, {4, 10}}, {0, 4}, {10, 13}, false, true};
  EXPECT_EQ(fit_path(r).points, (Pairs{{0, 10}, {1, 11}, {4, 13}}));
}

TEST(FitPath, KeepsVerticalStepsInOrder) {
  const Correspondence c{{{0, 0}, {0, 1}, {1, 1}, {1, 2}, {1, 3}}, {0, 1}, {0, 3}, false, false};
  EXPECT_EQ(fit_path(c).points, c.points);
}

TEST(FitPath, CutsAClosedPathAtAPointOfIt) {
  const Correspondence c{{{0.5, 3}, {1, 6}, {1.25, 7}, {1.5, 13}}, {0, 1}, {0, 10}, true, false};
  EXPECT_EQ(fit_path(c).points, (Pairs{{0, -4}, {0.25, -3}, {0.5, 3}, {1, 6}}));
}

TEST(FitPath, CutsAClosedPathBetweenPoints) {
  const Correspondence c{{{0.5, 3}, {0.75, 5}, {1.25, 9}, {1.5, 13}}, {0, 1}, {0, 10}, true, false};
  EXPECT_EQ(fit_path(c).points, (Pairs{{0, -3}, {0.25, -1}, {0.5, 3}, {0.75, 5}, {1, 7}}));
}

TEST(FitPath, CutsAJumpInTheMiddle) {
  const Correspondence c{
      {{0.5, 3}, {1, 6}, {1, 8}, {1, 9}, {1, 10}, {1.5, 13}}, {0, 1}, {0, 10}, true, false};
  EXPECT_EQ(fit_path(c).points, (Pairs{{0, -2}, {0, -1}, {0, 0}, {0.5, 3}, {1, 6}, {1, 8}}));
}

TEST(FitPath, TurnsAReversedClosedPathRound) {
  const Correspondence c{{{0.5, 3}, {1, 0}, {1.25, -1}, {1.5, -7}}, {0, 1}, {0, 10}, true, true};
  // v' = 10 - v: 7, 10, 11, 17.
  EXPECT_EQ(fit_path(c).points, (Pairs{{0, 0}, {0.25, 1}, {0.5, 7}, {1, 10}}));
}

TEST(FitPath, FindsCornersOnThePath) {
  const Correspondence c{{{0, 0}, {0.3, 0.5}, {0.3, 0.6}, {0.7, 0.8}, {1, 1}}, {0, 1}, {0, 1}, false, false};
  const double corners[] = {0.7 + 1e-14, 0.3, 0.7, 0.4, 0.3 + 1e-9};
  EXPECT_EQ(fit_path(c, corners).corner_parameters, (std::vector<double>{0.3, 0.7}));
  const Correspondence closed{{{0.5, 0}, {0.75, 0.5}, {1.25, 0.6}, {1.5, 1}}, {0, 1}, {0, 1}, true, false};
  const double turned[] = {1.25, 1.75, -0.5};
  EXPECT_EQ(fit_path(closed, turned).corner_parameters, (std::vector<double>{0.25, 0.5, 0.75}));
}

TEST(FitPath, MatchesCornersFarFromZero) {
  // A double at 1e6 tells parameters apart by 1e-10 only.
  const Correspondence c{{{1e6, 0}, {1e6 + 0.1, 0.5}, {1e6 + 1, 1}}, {1e6, 1e6 + 1}, {0, 1}, false, false};
  const double corners[] = {1e6 + 0.1 + 1.2e-10};
  EXPECT_EQ(fit_path(c, corners).corner_parameters.size(), 1u);
}

TEST(FitPath, RunsOverExactlyOnePeriod) {
  EXPECT_TRUE(rc::check([] {
    const Correspondence c = testing::any_correspondence();
    const FitPath path = fit_path(c);
    RC_ASSERT(path.points.size() >= 2u);
    RC_ASSERT(path.points.front().u == c.domain_u.lo);
    RC_ASSERT(path.points.back().u == c.domain_u.hi);
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      RC_ASSERT(path.points[i].u >= path.points[i - 1].u);
      RC_ASSERT(path.points[i].v >= path.points[i - 1].v);
    }
    const double rise = path.points.back().v - path.points.front().v;
    const double rounding =
        1e-14 * std::max({std::abs(path.points.front().v), std::abs(path.points.back().v), rise});
    RC_ASSERT(std::abs(rise - c.domain_v.length()) <= rounding);
    if (!c.closed) {
      RC_ASSERT(path.points.front().v == c.domain_v.lo);
      RC_ASSERT(path.points.back().v == c.domain_v.hi);
    }
  }));
}

TEST(FitPath, LiesOnTheCorrespondence) {
  EXPECT_TRUE(rc::check([] {
    const Correspondence c = testing::any_correspondence();
    const FitPath path = fit_path(c);
    const double size = std::max({std::abs(c.domain_v.lo), std::abs(c.domain_v.hi), c.domain_v.length()});
    for (std::size_t i = 1; i + 1 < path.points.size(); ++i) {
      const auto [u, v] = path.points[i];
      const bool alone = path.points[i - 1].u < u && u < path.points[i + 1].u;
      // Next to a jump the shift by a period decides on which side of it u lies.
      const double gap = std::min(u - path.points[i - 1].u, path.points[i + 1].u - u);
      if (!alone || gap < 1e-6 * c.domain_u.length()) continue;
      const double expected = c.reversed ? c.domain_v.lo + (c.domain_v.hi - c.v_at(u)) : c.v_at(u);
      RC_ASSERT(std::abs(v - expected) <= 1e-8 * std::max(size, std::abs(v)));
    }
  }));
}

}  // namespace
}  // namespace tandem
