#include "tandem/rank/all_pairs.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "rank/shapes.h"
#include "tandem/error.h"

namespace {

using tandem::all_pairs;
using tandem::all_pairs_digest;
using tandem::AllPairsOptions;
using tandem::CompareOptions;
using tandem::CostMatrix;
using tandem::PairTile;
using tandem::PairTiles;
using tandem::RankCost;
using tandem::ShapeDescriptor;
using namespace tandem::testing_rank;

/// Closed and open, planar and spatial, and two that are the same.
std::vector<ShapeDescriptor> mixed(std::size_t closed, unsigned seed) {
  std::vector<ShapeDescriptor> shapes = stars(closed, seed, 16);
  std::mt19937 random(seed);
  for (int k = 0; k < 3; ++k) {
    shapes.push_back(describe(wave(random), {.samples = 12}));
    shapes.push_back(describe(wave(random, 3), {.samples = 12}));
  }
  shapes.push_back(shapes.front());
  return shapes;
}

bool same_bits(const std::vector<double>& x, const std::vector<double>& y) {
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
}

TEST(PairTiles, HoldEveryPairOnce) {
  for (const std::size_t n : {0U, 1U, 2U, 3U, 23U, 24U, 48U, 49U, 100U, 383U, 500U}) {
    const PairTiles tiles(n);
    std::vector<int> seen(n * n, 0);
    for (std::size_t k = 0; k < tiles.size(); ++k) {
      const PairTile tile = tiles.tile(k);
      EXPECT_EQ(tiles.index(tile.row / tiles.side(), tile.column / tiles.side()), k);
      std::size_t pairs = 0;
      for (std::size_t i = tile.row; i < tile.row_end; ++i) {
        for (std::size_t j = std::max(tile.column, i + 1); j < tile.column_end; ++j, ++pairs)
          ++seen[i * n + j];
      }
      EXPECT_EQ(tile.pairs(), pairs);
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        ASSERT_EQ(seen[i * n + j], i < j ? 1 : 0) << n << ": " << i << " " << j;
    }
    EXPECT_THROW((void)tiles.tile(tiles.size()), tandem::InvalidArgument);
    EXPECT_THROW((void)tiles.index(0, tiles.blocks()), tandem::InvalidArgument);
  }
}

TEST(AllPairs, IsCompareOfEachPair) {
  const std::vector<ShapeDescriptor> shapes = mixed(30, 5);
  for (const RankCost cost : {RankCost::symmetric, RankCost::paper}) {
    const CompareOptions options{.cost = cost, .mirror = true};
    const CostMatrix matrix = all_pairs(shapes, {.compare = options});
    ASSERT_EQ(matrix.size, shapes.size());
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      EXPECT_EQ(matrix(i, i), 0.0);
      for (std::size_t j = i + 1; j < shapes.size(); ++j) {
        const bool comparable =
            shapes[i].dim() == shapes[j].dim() && shapes[i].is_closed() == shapes[j].is_closed();
        ASSERT_EQ(std::isnan(matrix(i, j)), !comparable);
        if (!comparable) {
          ASSERT_TRUE(std::isnan(matrix(j, i)));
          continue;
        }
        EXPECT_EQ(matrix(i, j), matrix(j, i));
        const double forward = compare(shapes[i], shapes[j], options).cost;
        EXPECT_TRUE(matrix(i, j) == forward || matrix(i, j) == compare(shapes[j], shapes[i], options).cost);
      }
    }
    // The copy at the end costs the others what its twin does.
    for (std::size_t j = 1; j + 1 < shapes.size(); ++j) {
      EXPECT_TRUE(matrix(0, j) == matrix(shapes.size() - 1, j) || std::isnan(matrix(0, j)));
    }
  }
}

TEST(AllPairs, DoesNotDependOnThreadsOrTheOrderOfTiles) {
  const std::vector<ShapeDescriptor> shapes = mixed(60, 6);
  const CostMatrix one = all_pairs(shapes, {.threads = 1});
  for (const int threads : {2, 4, 0}) {
    EXPECT_TRUE(same_bits(all_pairs(shapes, {.threads = threads}).costs, one.costs));
  }
  const PairTiles tiles(shapes.size());
  std::size_t left = tiles.size();
  std::set<std::size_t> seen;
  const bool finished = all_pairs(
      shapes, [&]() { return left == 0 ? std::nullopt : std::optional(--left); },
      [&](std::size_t index, std::span<const double> costs) {
        EXPECT_TRUE(seen.insert(index).second);
        const PairTile tile = tiles.tile(index);
        std::size_t k = 0;
        for (std::size_t i = tile.row; i < tile.row_end; ++i) {
          for (std::size_t j = std::max(tile.column, i + 1); j < tile.column_end; ++j, ++k) {
            EXPECT_TRUE(costs[k] == one(i, j) || std::isnan(one(i, j)));
          }
        }
        EXPECT_EQ(costs.size(), k);
      },
      {.threads = 2});
  EXPECT_TRUE(finished);
  EXPECT_EQ(seen.size(), tiles.size());
}

TEST(AllPairs, APermutedCorpusPermutesTheMatrix) {
  const std::vector<ShapeDescriptor> shapes = mixed(9, 7);
  const CostMatrix matrix = all_pairs(shapes);
  EXPECT_TRUE(rc::check([&](unsigned seed) {
    std::vector<std::size_t> order(shapes.size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    std::vector<ShapeDescriptor> shuffled;
    for (const std::size_t k : order) shuffled.push_back(shapes[k]);
    const CostMatrix other = all_pairs(shuffled);
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = 0; j < order.size(); ++j) {
        const double x = other(i, j);
        const double y = matrix(order[i], order[j]);
        RC_ASSERT(x == y || (std::isnan(x) && std::isnan(y)));
      }
    }
  }));
}

TEST(AllPairs, StopsWhenProgressSaysSo) {
  const std::vector<ShapeDescriptor> shapes = stars(40, 8, 16);
  for (const int threads : {1, 2}) {
    std::atomic<int> asked = 0;
    const AllPairsOptions options{.threads = threads, .progress = [&](double fraction) {
                                    EXPECT_GE(fraction, 0.0);
                                    EXPECT_LE(fraction, 1.0);
                                    return ++asked < 50;
                                  }};
    const CostMatrix matrix = all_pairs(shapes, options);
    EXPECT_TRUE(matrix.cancelled);
    EXPECT_TRUE(matrix.costs.empty());
    EXPECT_LE(asked, 50 + threads);
  }
}

TEST(AllPairs, HandsOnWhatTheSinkThrows) {
  const std::vector<ShapeDescriptor> shapes = stars(40, 9, 16);
  std::size_t next = 0;
  const auto run = [&] {
    (void)all_pairs(
        shapes, [&]() { return std::optional(next++); },
        [](std::size_t, std::span<const double>) { throw tandem::IoError("the disk is full"); });
  };
  EXPECT_THROW(run(), tandem::IoError);
  EXPECT_LT(next, 100U);
}

TEST(AllPairs, TakesNoShapeOrOne) {
  EXPECT_TRUE(all_pairs(std::vector<ShapeDescriptor>{}).costs.empty());
  EXPECT_EQ(all_pairs(stars(1, 1, 8)).costs, std::vector<double>{0.0});
}

TEST(AllPairsDigest, ChangesWithWhatChangesTheCosts) {
  const std::vector<ShapeDescriptor> shapes = stars(4, 10, 12);
  std::set<std::uint64_t> digests = {all_pairs_digest(shapes)};
  EXPECT_TRUE(digests.insert(all_pairs_digest(shapes, {.cost = RankCost::paper})).second);
  EXPECT_TRUE(digests.insert(all_pairs_digest(shapes, {.rotate = false})).second);
  EXPECT_TRUE(digests.insert(all_pairs_digest(shapes, {.mirror = true})).second);
  EXPECT_TRUE(digests.insert(all_pairs_digest(shapes, {.charge = 0.2})).second);
  EXPECT_TRUE(digests.insert(all_pairs_digest(std::span(shapes).first(3))).second);
  std::vector<ShapeDescriptor> other = shapes;
  std::swap(other[0], other[1]);
  EXPECT_TRUE(digests.insert(all_pairs_digest(other)).second);
  other = shapes;
  other[2] = describe(polygon({{0, 0}, {1, 0}, {0, 1}}), {.samples = 12});
  EXPECT_TRUE(digests.insert(all_pairs_digest(other)).second);
  other = shapes;
  other[0] = ShapeDescriptor(true, shapes[0].tangents(), shapes[0].lengths(), "another name", "and label");
  EXPECT_FALSE(digests.insert(all_pairs_digest(other)).second);
}

}  // namespace
