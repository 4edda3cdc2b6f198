#include "tandem/match/rotation.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <vector>

#include "match/nearest_rotation.h"
#include "match/turns.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using testing_curves::product;

constexpr double kPi = 3.14159265358979323846;

Rotation planar(double degrees) {
  const double values[] = {std::cos(degrees * kPi / 180.0), std::sin(degrees * kPi / 180.0)};
  return {2, values};
}

std::vector<double> numbers(std::size_t count) {
  std::vector<double> x;
  for (std::size_t k = 0; k < count; ++k) x.push_back(*rc::gen::inRange(-1000, 1001) / 1000.0);
  return x;
}

Rotation random_rotation(int dim) {
  return detail::nearest_rotation(numbers(static_cast<std::size_t>(dim) * static_cast<std::size_t>(dim)), dim)
      .rotation;
}

double difference(const Rotation& r, const Rotation& s) {
  double most = 0.0;
  for (std::size_t k = 0; k < r.values().size(); ++k)
    most = std::max(most, std::abs(r.values()[k] - s.values()[k]));
  return most;
}

TEST(Rotation, OfThePlaneHasAnAngle) {
  EXPECT_TRUE(Rotation(2).is_identity());
  EXPECT_EQ(Rotation(2).degrees(), 0.0);
  EXPECT_NEAR(planar(30.0).degrees(), 30.0, 1e-12);
  EXPECT_NEAR(planar(-120.0).degrees(), -120.0, 1e-12);
  EXPECT_NEAR(planar(180.0).degrees(), 180.0, 1e-12);
  double out[2];
  const double x[] = {2.0, 0.0};
  planar(90.0).apply(x, out);
  EXPECT_NEAR(out[0], 0.0, 1e-15);
  EXPECT_NEAR(out[1], 2.0, 1e-15);
}

TEST(Rotation, InSpaceTurnsAboutItsAxis) {
  const double values[] = {0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0};  // x -> y
  const Rotation r(3, values);
  EXPECT_NEAR(r.degrees(), 90.0, 1e-12);
  const Rotation half = r.fraction(0.5);
  EXPECT_NEAR(half.values()[0], std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(half.values()[3], std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(half.values()[8], 1.0, 1e-14);
}

TEST(Rotation, FractionsAddUp) {
  for (const int dim : {1, 2, 3, 4, 5, 7}) {
    EXPECT_TRUE(rc::check([dim] {
      const Rotation r = random_rotation(dim);
      const double s = *rc::gen::inRange(-100, 200) / 100.0;
      RC_ASSERT(difference(r.fraction(0.0), Rotation(dim)) < 1e-13);
      RC_ASSERT(difference(r.fraction(1.0), r) < 1e-12);
      RC_ASSERT(difference(product(r.fraction(s), r.fraction(1.0 - s)), r) < 1e-12);
      RC_ASSERT(difference(product(r, r.inverse()), Rotation(dim)) < 1e-12);
    })) << dim;
  }
}

TEST(Rotation, HalfTurnsHaveFractions) {
  // Diagonal matrices with an even number of -1, next to one another and not.
  const std::vector<std::vector<double>> diagonals = {{-1, -1, 1},    {-1, 1, -1},      {1, -1, -1},
                                                      {-1, 1, 1, -1}, {-1, -1, -1, -1}, {-1, 1, -1, 1, 1}};
  for (const std::vector<double>& diagonal : diagonals) {
    const std::size_t n = diagonal.size();
    std::vector<double> values(n * n);
    for (std::size_t k = 0; k < n; ++k) values[k * n + k] = diagonal[k];
    const Rotation r(static_cast<int>(n), values);
    EXPECT_LT(difference(r.fraction(1.0), r), 1e-12) << n;
    EXPECT_LT(difference(product(r.fraction(0.5), r.fraction(0.5)), r), 1e-12) << n;
    EXPECT_NO_THROW(Rotation(static_cast<int>(n), r.fraction(0.3).values())) << n;
  }
}

TEST(Rotation, RefusesWhatIsNone) {
  const double mirror[] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0};
  EXPECT_THROW(Rotation(3, mirror), InvalidArgument);
  EXPECT_THROW(Rotation(2, mirror), InvalidArgument);
  const double scaled[] = {2.0, 0.0};
  EXPECT_THROW(Rotation(2, scaled), InvalidArgument);
  const double nan[] = {std::numeric_limits<double>::quiet_NaN(), 0.0};
  EXPECT_THROW(Rotation(2, nan), InvalidArgument);
  EXPECT_THROW(Rotation(0), InvalidArgument);
  const double minus[] = {-1.0};
  EXPECT_THROW(Rotation(1, minus), InvalidArgument);
}

TEST(NearestRotation, IsAsGoodAsAnyOther) {
  for (const int dim : {2, 3, 4}) {
    EXPECT_TRUE(rc::check([dim] {
      const auto n = static_cast<std::size_t>(dim);
      const std::vector<double> covariance = numbers(n * n);
      const auto score = [&](const Rotation& r) {
        Points columns(dim, n);
        for (std::size_t k = 0; k < n; ++k) columns[k][k] = 1.0;
        columns = r(columns);
        double sum = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
          for (std::size_t k = 0; k < n; ++k) sum += columns[k][i] * covariance[i * n + k];
        }
        return sum;
      };
      const detail::NearestRotation best = detail::nearest_rotation(covariance, dim);
      RC_ASSERT(std::abs(score(best.rotation) - best.score) < 1e-9);
      for (int k = 0; k < 5; ++k) RC_ASSERT(score(random_rotation(dim)) <= best.score + 1e-9);
    })) << dim;
  }
}

TEST(NearestRotation, TakesTheSmallestTurnThatOneDirectionLeavesOpen) {
  // x -> y alone: the turn about z by 90 degrees is the smallest of those that do it.
  const double covariance[] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  const Rotation r = detail::nearest_rotation(covariance, 3).rotation;
  EXPECT_NEAR(r.degrees(), 90.0, 1e-3);
  EXPECT_NEAR(r.values()[8], 1.0, 1e-3);
  const double none[9] = {};
  EXPECT_TRUE(detail::nearest_rotation(none, 3).rotation.is_identity());
}

}  // namespace
}  // namespace tandem
