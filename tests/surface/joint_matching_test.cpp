#include "surface/joint_matching.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace tandem {
namespace {

using detail::SectionPath;

SectionPath path(std::vector<ParameterPair> points, bool closed) {
  return {{std::move(points), {0, 1}, {0, 1}, closed, false}, {}, {}};
}

// Once round, u = 0.5 comes back at 0.6: section k of four takes k quarters of that back.
TEST(SpreadRound, SharesWhatIsLeftOver) {
  std::vector<ParameterPair> dense;
  for (int i = 0; i <= 40; ++i) dense.push_back({i / 40.0, i / 40.0});
  const std::vector<SectionPath> paths(4, path(dense, false));
  const std::vector<SectionPath> spread =
      detail::spread_round(paths, path({{0, 0}, {0.5, 0.6}, {1, 1}}, false));
  ASSERT_EQ(spread.size(), 4u);
  EXPECT_EQ(spread[0].correspondence.points, paths[0].correspondence.points);
  for (std::size_t k = 1; k < 4; ++k) {
    const double share = static_cast<double>(k) / 4;
    EXPECT_NEAR(spread[k].correspondence.u_at(0.6 - 0.1 * share), 0.6, 1e-12) << k;
    EXPECT_NEAR(spread[k].correspondence.u_at(0.0), 0.0, 1e-12);
    EXPECT_NEAR(spread[k].correspondence.u_at(1.0), 1.0, 1e-12);
  }
}

// Of loops whole turns are nothing to be taken back.
TEST(SpreadRound, KnowsTurnsOfLoops) {
  const std::vector<SectionPath> paths(5,
                                       path({{0, 0}, {0.25, 0.25}, {0.5, 0.5}, {0.75, 0.75}, {1, 1}}, true));
  const std::vector<SectionPath> spread =
      detail::spread_round(paths, path({{0, 1.2}, {0.5, 1.7}, {1, 2.2}}, true));
  for (std::size_t k = 1; k < 5; ++k) {
    const double back = 0.2 * static_cast<double>(k) / 5;
    EXPECT_NEAR(spread[k].correspondence.v_at(0.5), 0.5 - back, 1e-12) << k;
  }
}

}  // namespace
}  // namespace tandem
