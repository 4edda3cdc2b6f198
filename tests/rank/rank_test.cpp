#include "tandem/rank/rank.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "rank/shapes.h"
#include "tandem/error.h"

namespace {

using tandem::Candidate;
using tandem::Curve;
using tandem::RankCost;
using tandem::Ranking;
using tandem::RankOptions;
using tandem::ShapeDescriptor;
using namespace tandem::testing_rank;

void expect_same(const Ranking& x, const Ranking& y) {
  ASSERT_EQ(x.best.size(), y.best.size());
  for (std::size_t k = 0; k < x.best.size(); ++k) {
    EXPECT_EQ(x.best[k].index, y.best[k].index);
    EXPECT_EQ(x.best[k].name, y.best[k].name);
    EXPECT_EQ(x.best[k].comparison.cost, y.best[k].comparison.cost);
    EXPECT_EQ(x.best[k].comparison.rotation, y.best[k].comparison.rotation);
    EXPECT_EQ(x.best[k].comparison.mirrored, y.best[k].comparison.mirrored);
  }
}

TEST(Rank, PruningAndThreadsDoNotChangeTheAnswer) {
  std::vector<ShapeDescriptor> shapes = stars(400, 11, 24);
  for (std::size_t k = 0; k < 40; ++k) shapes.push_back(shapes[k]);  // ties
  // The query is an L among other L's, whose few directions most stars do not fit at any turn.
  std::mt19937 random(12);
  for (int k = 0; k < 30; ++k) {
    const double x = uniform(random, 1.0, 2.0);
    const double y = uniform(random, 1.0, 2.0);
    const Curve ell = polygon({{0, 0}, {x + 1, 0}, {x + 1, 1}, {1, 1}, {1, y + 1}, {0, y + 1}});
    shapes.insert(shapes.begin() + k, describe(moved(ell, 0.2 * k, 1.0, 0.0, 0.0), {.samples = 24}));
  }
  shapes.insert(shapes.begin() + 100, shapes[0]);
  for (const RankCost cost : {RankCost::symmetric, RankCost::paper}) {
    for (const bool rotate : {false, true}) {
      RankOptions options{.compare = {.cost = cost, .rotate = rotate, .mirror = rotate}, .top = 7};
      options.prune = false;
      options.stream.threads = 1;
      const Ranking exhaustive = rank(shapes[0], shapes, options);
      EXPECT_EQ(exhaustive.pruned, 0U);
      EXPECT_LT(exhaustive.best[0].comparison.cost, 1e-6);  // itself, or an L with as many nodes per side
      options.prune = true;
      for (const int threads : {1, 2, 4}) {
        options.stream.threads = threads;
        const Ranking pruned = rank(shapes[0], shapes, options);
        expect_same(pruned, exhaustive);
        // 106 to 443 in order; with threads, those that start before the first L's are done escape.
        EXPECT_GT(pruned.pruned, 50U);
      }
    }
  }
}

TEST(Rank, KeepsAllWithoutATop) {
  const std::vector<ShapeDescriptor> shapes = stars(30, 12, 16);
  const Ranking ranking = rank(shapes[0], shapes);
  EXPECT_EQ(ranking.best.size(), shapes.size());
  EXPECT_EQ(ranking.candidates, shapes.size());
  EXPECT_EQ(ranking.pruned, 0U);
  for (std::size_t k = 1; k < ranking.best.size(); ++k)
    EXPECT_LE(ranking.best[k - 1].comparison.cost, ranking.best[k].comparison.cost);
}

TEST(Rank, CountsWhatCannotBeDescribedOrCompared) {
  std::mt19937 random(13);
  const ShapeDescriptor query = describe(star(random));
  int next = 0;
  std::vector<std::string> told;
  RankOptions options;
  options.stream.on_failure = [&](const Candidate& candidate, const tandem::Error& error) {
    told.push_back(candidate.name + ": " + error.what());
  };
  const tandem::CandidateSource source = [&]() -> std::optional<Candidate> {
    if (next == 9) return std::nullopt;
    const int k = next++;
    return Candidate{std::to_string(k), [k]() -> ShapeDescriptor {
                       std::mt19937 own(static_cast<unsigned>(k));
                       if (k % 3 == 0) throw tandem::InvalidArgument("broken");
                       return k % 3 == 1 ? describe(star(own)) : describe(wave(own));
                     }};
  };
  const Ranking ranking = rank(query, source, options);
  EXPECT_EQ(ranking.candidates, 9U);
  EXPECT_EQ(ranking.failed, 3U);
  EXPECT_EQ(ranking.incomparable, 3U);
  EXPECT_EQ(ranking.best.size(), 3U);
  EXPECT_EQ(told, (std::vector<std::string>{"0: broken", "3: broken", "6: broken"}));
}

TEST(Rank, StopsWhenToldTo) {
  const std::vector<ShapeDescriptor> shapes = stars(600, 14, 8);
  int asked = 0;
  RankOptions options;
  options.stream.progress = [&](double fraction) {
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
    return ++asked < 2;
  };
  const Ranking ranking = rank(shapes[0], shapes, options);
  EXPECT_TRUE(ranking.cancelled);
  EXPECT_LT(ranking.candidates, shapes.size());
}

TEST(DescribeAll, KeepsTheOrder) {
  int next = 0;
  const tandem::CandidateSource source = [&]() -> std::optional<Candidate> {
    if (next == 700) return std::nullopt;
    const int k = next++;
    return Candidate{std::to_string(k), [k] {
                       std::mt19937 own(static_cast<unsigned>(k));
                       return describe(star(own), {.samples = 8, .name = std::to_string(k)});
                     }};
  };
  int seen = 0;
  EXPECT_TRUE(describe_all(source, [&](ShapeDescriptor shape) {
    EXPECT_EQ(shape.name(), std::to_string(seen));
    ++seen;
  }));
  EXPECT_EQ(seen, 700);
}

}  // namespace
