#include "morph/score.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <vector>

#include "tandem/shape/path_builder.h"

namespace tandem {
namespace {

using detail::ContourEnds;
using detail::Judge;
using detail::PlanarFrame;
using detail::Score;
using detail::StepBlend;

CubicPath triangle(Vec2 p, double size) {
  PathBuilder builder;
  builder.move_to(p);
  builder.line_to({p.x + size, p.y});
  builder.line_to({p.x, p.y + size});
  builder.close();
  return builder.take().front();
}

/// Two triangles on their ways, which may meet.
std::vector<StepBlend> random_blends(int count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0.0, 12.0);
  std::vector<StepBlend> blends;
  for (int k = 0; k < count; ++k) {
    // The same keys' in-betweens are judged: only what lies between them differs.
    const std::vector<ContourEnds> ends{{triangle({0, 0}, 3), triangle({8, 0}, 3)},
                                        {triangle({8, 8}, 2), triangle({0, 8}, 2)}};
    blends.emplace_back(BlendKind::affine, PlanarFrame{}, ends);
    const Vec2 way{place(random) - 6.0, place(random) - 12.0};
    blends.back().set_detour(1, {0.0, 0.02 * place(random), way});
  }
  return blends;
}

// What steps out of the picture on its way is worse than what steps as far within, and turning on the spot is
// neither.
TEST(Judge, LikesInBetweensNearTheKeys) {
  const std::vector<ContourEnds> ends{{triangle({0, 0}, 10), triangle({4, 0}, 10)}};
  const auto blemish = [&](Vec2 way) {
    StepBlend blend(BlendKind::affine, PlanarFrame{}, ends);
    blend.set_detour(0, {.offset = way});
    Judge judge(18.0);
    const Score score = judge.judge(blend, {});
    EXPECT_EQ(score.faults, 0);
    return score.blemish;
  };
  const double straight = blemish({0, 0});
  EXPECT_NEAR(blemish({0, 2}), straight, 1e-12);
  EXPECT_GT(blemish({0, 8}), straight + 0.03);
}

TEST(Judge, BeatsWhatItScoresBetterThan) {
  const std::vector<StepBlend> blends = random_blends(40);
  Judge judge(16.0);
  int beaten = 0;
  int faulty = 0;
  for (std::size_t k = 0; k + 1 < blends.size(); ++k) {
    const Score limit = judge.judge(blends[k], {});
    const Score full = judge.judge(blends[k + 1], {});
    const std::optional<Score> won = judge.beat(blends[k + 1], limit);
    EXPECT_EQ(won.has_value(), full.better_than(limit)) << k;
    beaten += won ? 0 : 1;
    faulty += full.faults > 0 ? 1 : 0;
    const std::optional<Score> faultless = judge.find_faultless(blends[k + 1]);
    EXPECT_EQ(faultless.has_value(), full.faults == 0) << k;
    for (const auto& found : {won, faultless}) {
      if (!found) continue;
      EXPECT_EQ(found->faults, full.faults) << k;
      EXPECT_EQ(found->trouble, full.trouble) << k;
      EXPECT_NEAR(found->blemish, full.blemish, 1e-12) << k;
    }
  }
  EXPECT_GT(beaten, 5);
  EXPECT_LT(beaten, 35);
  EXPECT_GT(faulty, 5);
  EXPECT_LT(faulty, 35);
}

}  // namespace
}  // namespace tandem
