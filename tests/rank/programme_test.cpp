#include "rank/programme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "rank/plain_programme.h"
#include "rank/shapes.h"

namespace {

using tandem::Node;
using tandem::detail::cheapest_path;
using tandem::detail::StepCharges;
using tandem::detail::TangentPlanes;
using namespace tandem::testing_rank;

/// Unit vectors at random; `few`: of eight directions only, so that there are ties and plateaus.
TangentPlanes random_tangents(std::mt19937& random, std::size_t count, bool few, std::size_t dim = 2) {
  TangentPlanes tangents{std::vector<std::vector<double>>(dim, std::vector<double>(count))};
  for (std::size_t i = 0; i < count; ++i) {
    const double angle =
        6.283185307179586 * (few ? static_cast<double>(random() % 8) / 8.0 : uniform(random, 0.0, 1.0));
    const double height = dim > 2 ? uniform(random, -1.0, 1.0) : 0.0;
    const double radius = std::sqrt(1.0 - height * height);
    tangents.planes[0][i] = radius * std::cos(angle);
    tangents.planes[1][i] = radius * std::sin(angle);
    if (dim > 2) tangents.planes[2][i] = height;
  }
  return tangents;
}

/// All paths, one by one.
double least_by_enumeration(const PlainProgramme& plain, std::size_t m1, std::size_t m2, bool closed,
                            const StepCharges& charges) {
  const std::size_t rows = closed ? m1 : m1 - 1;
  const std::size_t cols = closed ? m2 : m2 - 1;
  const double diagonal = charges.double_diagonal ? 2.0 : 1.0;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < (closed ? m1 : 1); ++k) {
    const std::function<void(std::size_t, std::size_t, double)> walk = [&](std::size_t i, std::size_t j,
                                                                           double sum) {
      if (i == rows && j == cols) {
        best = std::min(best, sum);
        return;
      }
      if (i < rows && j < cols) walk(i + 1, j + 1, sum + diagonal * plain.node(k + i + 1, j + 1));
      if (j < cols) walk(i, j + 1, sum + (plain.node(k + i, j + 1) + charges.charge));
      if (i < rows) walk(i + 1, j, sum + (plain.node(k + i + 1, j) + charges.charge));
    };
    walk(0, 0, closed ? 0.0 : diagonal * plain.node(0, 0));
  }
  return best;
}

TEST(PlainProgramme, EqualsEnumeration) {
  std::mt19937 random(30);
  for (int round = 0; round < 300; ++round) {
    const TangentPlanes a = random_tangents(random, 1 + random() % 5, round % 2 == 0);
    const TangentPlanes b = random_tangents(random, 1 + random() % 5, round % 2 == 0);
    const StepCharges charges{round % 3 != 0, round % 4 == 0 ? 0.0 : 0.125};
    for (const bool closed : {false, true}) {
      const PlainProgramme plain(a, b, closed, charges);
      EXPECT_NEAR(plain.best_sum(), least_by_enumeration(plain, a.size(), b.size(), closed, charges), 1e-12);
    }
  }
}

TEST(CheapestPath, IsOptimalWithinTheQuantum) {
  std::mt19937 random(31);
  for (int round = 0; round < 600; ++round) {
    const std::size_t dim = round % 5 == 0 ? 3 : 2;
    const TangentPlanes a = random_tangents(random, 1 + random() % 40, round % 2 == 0, dim);
    const TangentPlanes b = random_tangents(random, 1 + random() % 40, round % 2 == 0, dim);
    const StepCharges charges{round % 3 != 0, round % 4 == 0 ? 0.0 : uniform(random, 0.0, 2.0)};
    for (const bool closed : {false, true}) {
      const PlainProgramme plain(a, b, closed, charges);
      const double least = plain.best_sum();
      const auto path = cheapest_path(a, b, closed, charges);
      ASSERT_TRUE(path);
      // Two paths, rounded by half a quantum per unit of weight; the quantum is a share of 2^-30 of the
      // largest sum, at most twice 2 * (2 + 1) * 82.
      const double tolerance = 1.0 / 1048576.0 * static_cast<double>(a.size() + b.size());
      EXPECT_GE(path->sum, least - 1e-12);
      EXPECT_LE(path->sum, least + tolerance);
      EXPECT_NEAR(plain.sum_along(path->nodes), path->sum, 1e-12);
      const Node first = path->nodes.front();
      const int end = closed ? 0 : 1;
      EXPECT_TRUE(first.j == 0 && first.i >= 0 && first.i < static_cast<int>(a.size()));
      EXPECT_EQ(path->nodes.back(),
                (Node{first.i + static_cast<int>(a.size()) - end, static_cast<int>(b.size()) - end}));
      const auto same = cheapest_path(a, b, closed, charges, path->sum);
      ASSERT_TRUE(same);
      EXPECT_EQ(same->nodes, path->nodes);
      EXPECT_FALSE(cheapest_path(a, b, closed, charges, std::nextafter(path->sum, -1.0)));
    }
  }
}

}  // namespace
