#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "match/random_curves.h"
#include "match/turns.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"
#include "tandem/match/match.h"
#include "tandem/match/rotation.h"

namespace tandem {
namespace {

using testing_curves::closed_curve;
using testing_curves::moved;
using testing_curves::open_curve;
using testing_curves::product;
using testing_curves::random_rotation;
using testing_curves::turned;
using testing_curves::uniform;

constexpr double kPi = 3.14159265358979323846;

Rotation planar(double degrees) {
  const double values[] = {std::cos(degrees * kPi / 180.0), std::sin(degrees * kPi / 180.0)};
  return {2, values};
}

Rotation found_by(const Match& match) {
  return {match.curve.dim(), match.report.rotation};
}

double largest_difference(const std::vector<double>& x, const std::vector<double>& y) {
  double most = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) most = std::max(most, std::fabs(x[k] - y[k]));
  return most;
}

Curve polygon(int sides, double phase_degrees = 0.0) {
  Points points;
  for (int k = 0; k <= sides; ++k) {
    const double angle = (360.0 * (k % sides) / sides + phase_degrees) * kPi / 180.0;
    points.push_back(std::vector<double>{5.0 * std::cos(angle), 5.0 * std::sin(angle)});
  }
  return Curve::clamped_uniform(1, std::move(points));
}

/// An exact circle, of nine control points.
Curve circle() {
  const double w = std::sqrt(0.5);
  return Curve(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
               Points({{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}),
               {1, w, 1, w, 1, w, 1, w, 1});
}

const MatchOptions kTurning{.samples = {48, 48}, .rotate = true};

TEST(MatchRotation, IsNotLookedForUnlessAsked) {
  const Curve a = polygon(5);
  const Match match = tandem::match(a, turned(a, planar(30.0)));
  EXPECT_TRUE(found_by(match).is_identity());
}

TEST(MatchRotation, OfWhatIsNotTurnedIsNone) {
  std::mt19937 random(1);
  for (int n = 0; n < 10; ++n) {
    const Curve closed = closed_curve(random);
    EXPECT_TRUE(found_by(match(closed, moved(closed, {3.0, 4.0}), kTurning)).is_identity());
    const Curve open = open_curve(random, 3);
    EXPECT_TRUE(found_by(match(open, open, kTurning)).is_identity());
  }
}

TEST(MatchRotation, OfOpenCurvesIsFoundInAnyDimension) {
  std::mt19937 random(2);
  for (const int dim : {2, 3, 4}) {
    for (int n = 0; n < 10; ++n) {
      const Curve a = open_curve(random, dim);
      const Rotation turn = random_rotation(random, dim);
      const bool back = n % 2 == 1;
      const Curve b = turned(back ? reverse(a) : a, turn, 0.5);
      const Match match = tandem::match(a, b, kTurning);
      EXPECT_LT(largest_difference(match.report.rotation, turn.values()), 1e-6) << dim;
      EXPECT_EQ(match.report.direction, back ? Direction::reversed : Direction::forward);
      EXPECT_TRUE(match.report.validity.valid);
      // The curve itself is not turned.
      for (const double u : {0.0, 0.3, 1.0}) {
        Point p = a.evaluate(u);
        turn.apply(p, p);
        for (double& x : p) x *= 0.5;
        EXPECT_LT(largest_difference(p, match.curve.evaluate(u)), 1e-6);
      }
    }
  }
}

TEST(MatchRotation, OfTheLineIsNone) {
  const Curve a = Curve::clamped_uniform(2, Points({{0.0}, {1.0}, {3.0}, {4.0}}));
  const Curve b = Curve::clamped_uniform(2, Points({{0.0}, {2.0}, {3.0}, {9.0}}));
  EXPECT_TRUE(found_by(match(a, b, kTurning)).is_identity());
}

TEST(MatchRotation, PrefersTheSmallestOfEqualTurns) {
  for (const int sides : {3, 4, 7, 12}) {
    for (const double degrees : {5.0, -20.0, 77.0, 135.0, 179.0}) {
      const double period = 360.0 / sides;
      const double smallest = degrees - period * std::round(degrees / period);
      const Match match = tandem::match(polygon(sides), polygon(sides, degrees), kTurning);
      // Half a period may go either way.
      EXPECT_NEAR(std::fabs(found_by(match).degrees()), std::fabs(smallest), 1e-6) << sides << ' ' << degrees;
      EXPECT_LT(match.report.cost, 1e-9);
    }
  }
}

TEST(MatchRotation, OfCirclesIsNone) {
  const Match match = tandem::match(circle(), turned(circle(), planar(50.0)), kTurning);
  EXPECT_NEAR(found_by(match).degrees(), 0.0, 1e-6);
  EXPECT_LT(match.report.cost, 1e-9);
}

TEST(MatchRotation, IsNoReflection) {
  // A scalene triangle and its mirror image: no turn makes one of the other.
  const Curve a = Curve::clamped_uniform(1, Points({{0, 0}, {10, 0}, {2, 3}, {0, 0}}));
  const Curve b = Curve::clamped_uniform(1, Points({{0, 0}, {-10, 0}, {-2, 3}, {0, 0}}));
  const Match match = tandem::match(a, b, kTurning);
  const Rotation rotation = found_by(match);  // would throw for a reflection
  EXPECT_GT(match.report.cost, 1e-3);
  EXPECT_NEAR(rotation.values()[0] * rotation.values()[0] + rotation.values()[1] * rotation.values()[1], 1.0,
              1e-12);
}

TEST(MatchRotation, IsInverseTheOtherWayRound) {
  std::mt19937 random(3);
  int compared = 0;
  for (int n = 0; n < 12; ++n) {
    const Curve a = n % 2 == 0 ? closed_curve(random) : open_curve(random, 3);
    const Curve b = n % 2 == 0 ? closed_curve(random) : open_curve(random, 3);
    const Match there = match(a, b, kTurning);
    const Match back = match(b, a, kTurning);
    EXPECT_NEAR(there.report.cost, back.report.cost, 1e-9);
    EXPECT_EQ(there.report.direction, back.report.direction);
    EXPECT_LT(largest_difference(found_by(there).inverse().values(), back.report.rotation), 1e-6);
    ++compared;
  }
  EXPECT_EQ(compared, 12);
}

TEST(MatchRotation, NeverCostsMoreThanNone) {
  std::mt19937 random(4);
  for (int n = 0; n < 10; ++n) {
    const Curve a = closed_curve(random);
    const Curve b = closed_curve(random);
    for (const Method method : {Method::elastic, Method::paper}) {
      const MatchOptions as_they_lie{.method = method, .samples = {48, 48}};
      MatchOptions turning = as_they_lie;
      turning.rotate = true;
      const MatchReport plain = match(a, b, as_they_lie).report;
      const MatchReport best = match(a, b, turning).report;
      EXPECT_LE(best.invalid_length, plain.invalid_length + 1e-6);
      if (std::fabs(best.invalid_length - plain.invalid_length) <= 1e-6) {
        EXPECT_LE(best.cost, plain.cost + 1e-9);
      }
    }
  }
}

// The match is the optimum for the rotation: what comes out for the rotation given is the same.
TEST(MatchRotation, MayBeGiven) {
  std::mt19937 random(5);
  for (int n = 0; n < 6; ++n) {
    const Curve a = closed_curve(random);
    const Curve b = closed_curve(random);
    const Match found = match(a, b, kTurning);
    const Match given = match(a, b, {.samples = {48, 48}, .rotation = found.report.rotation});
    EXPECT_EQ(found.report.cost, given.report.cost);
    EXPECT_EQ(found.report.path, given.report.path);
    EXPECT_EQ(found.report.rotation, given.report.rotation);
    // And the same as that of the curve turned back by hand.
    const Match by_hand = match(a, turned(b, found_by(found).inverse()), {.samples = {48, 48}});
    EXPECT_NEAR(found.report.cost, by_hand.report.cost, 1e-9);
    EXPECT_NEAR(found.report.validity.min_dot, by_hand.report.validity.min_dot, 1e-6);
  }
}

TEST(MatchRotation, DoesNotDependOnThreads) {
  std::mt19937 random(6);
  for (int n = 0; n < 4; ++n) {
    const Curve a = closed_curve(random);
    const Curve b = closed_curve(random);
    MatchOptions one = {.samples = {80, 80}, .rotate = true, .threads = 1};
    MatchOptions many = one;
    many.threads = 4;
    const MatchReport x = match(a, b, one).report;
    const MatchReport y = match(a, b, many).report;
    EXPECT_EQ(x.rotation, y.rotation);
    EXPECT_EQ(x.path, y.path);
    EXPECT_EQ(x.cost, y.cost);
  }
}

TEST(MatchRotation, GoesWithEveryLayoutAndMethod) {
  const Curve a = polygon(5);
  const Curve b = turned(move_seam(a, 0.37), planar(25.0));
  for (const ClosedMode closed :
       {ClosedMode::automatic, ClosedMode::yes, ClosedMode::pinned, ClosedMode::no}) {
    for (const Method method : {Method::elastic, Method::paper}) {
      const Match match =
          tandem::match(a, b, {.method = method, .samples = {50, 50}, .rotate = true, .closed = closed});
      EXPECT_NO_THROW((void)found_by(match));
      // Where the seams need not meet, the turn is found.
      if (closed != ClosedMode::no && method == Method::elastic) {
        EXPECT_NEAR(found_by(match).degrees(), 25.0, closed == ClosedMode::pinned ? 2.0 : 1e-6);
      }
    }
  }
  const Curve cut = turned(clamp(move_seam(a, 0.4)), planar(25.0));
  for (const NormKind norm : {NormKind::distance, NormKind::bottleneck}) {
    const Match match = tandem::match(a, cut, {.norm = norm, .rotate = true});
    EXPECT_NEAR(found_by(match).degrees(), 25.0, 1e-6);
  }
}

TEST(MatchRotation, CoarseToFineFindsTheTurnOnTheCoarseSamples) {
  std::mt19937 random(8);
  const Curve a = closed_curve(random);
  const Match match = tandem::match(a, turned(a, planar(100.0)), {.rotate = true, .coarse_to_fine = true});
  EXPECT_NEAR(found_by(match).degrees(), 100.0, 1e-6);
  EXPECT_FALSE(match.report.exact);
}

TEST(MatchRotation, RefusesTheRuledNormAndWhatIsNoRotation) {
  const Curve a = polygon(5);
  EXPECT_THROW((void)match(a, a, {.norm = NormKind::ruled, .rotate = true}), InvalidArgument);
  EXPECT_THROW((void)match(a, a, {.norm = NormKind::ruled, .rotation = {0.0, 1.0}}), InvalidArgument);
  EXPECT_NO_THROW((void)match(a, a, {.norm = NormKind::ruled, .rotation = {1.0, 0.0}}));
  EXPECT_THROW((void)match(a, a, {.rotation = {1.0, 1.0}}), InvalidArgument);
  EXPECT_THROW((void)match(a, a, {.rotation = {1.0, 0.0, 0.0}}), InvalidArgument);
}

TEST(MatchRotation, SurvivesHugeAndTinyCoordinates) {
  for (const double size : {1e300, 1e-300}) {
    const Curve a = turned(polygon(5), Rotation(2), 0.1 * size);
    const Match match = tandem::match(a, turned(a, planar(20.0)), kTurning);
    EXPECT_NEAR(found_by(match).degrees(), 20.0, 1e-6) << size;
    EXPECT_TRUE(match.report.validity.valid);
  }
}

TEST(MatchRotation, CanBeCancelled) {
  const Curve a = polygon(5);
  for (const int allowed : {0, 1, 3, 8}) {
    int calls = 0;
    MatchOptions options = kTurning;
    options.progress = [&](double fraction) {
      EXPECT_GE(fraction, 0.0);
      EXPECT_LE(fraction, 1.0);
      return calls++ < allowed;
    };
    EXPECT_TRUE(match(a, polygon(7, 10.0), options).report.cancelled) << allowed;
  }
}

TEST(CommonRotation, TakesAllPairsTogether) {
  std::mt19937 random(9);
  std::vector<Curve> a;
  std::vector<Curve> b;
  const Rotation turn = planar(-70.0);
  for (int n = 0; n < 3; ++n) {
    a.push_back(closed_curve(random));
    b.push_back(moved(turned(move_seam(a.back(), 0.3), turn), {1.0 * n, 2.0}));
  }
  EXPECT_LT(largest_difference(common_rotation(a, b, {.samples = {48, 48}}).values(), turn.values()), 1e-6);
  // A square alone would take 20 degrees the other way.
  const std::vector<Curve> with_square = {a[0], polygon(4)};
  const std::vector<Curve> turned_both = {b[0], turned(polygon(4), turn)};
  EXPECT_LT(largest_difference(common_rotation(with_square, turned_both, {.samples = {48, 48}}).values(),
                               turn.values()),
            1e-6);
}

Curve bar(double width, double height) {
  return Curve(1, {0, 0, 1, 2, 3, 4, 4}, Points({{0, 0}, {width, 0}, {width, height}, {0, height}, {0, 0}}));
}

// Bars that differ in proportion alone match at next to no cost, once turned: the search for the best start
// must not wait until its bounds agree with the path to a share of that.
TEST(CommonRotation, EndsWhereAMatchCostsNextToNothing) {
  const Match match = tandem::match(bar(2, 18), bar(24, 4), {.samples = {64, 64}, .rotate = true});
  EXPECT_NEAR(std::fabs(found_by(match).degrees()), 90.0, 1e-6);
}

TEST(CommonRotation, WantsAGain) {
  std::mt19937 random(10);
  const Curve a = closed_curve(random);
  const std::vector<Curve> first = {a};
  const std::vector<Curve> same = {turned(a, planar(40.0))};
  EXPECT_NEAR(common_rotation(first, same, kTurning, 0.99).degrees(), 40.0, 1e-6);
  const std::vector<Curve> other = {closed_curve(random)};
  EXPECT_FALSE(common_rotation(first, other, kTurning, 0.0).is_identity());
  EXPECT_TRUE(common_rotation(first, other, kTurning, 0.99).is_identity());
  EXPECT_THROW((void)common_rotation({}, {}), InvalidArgument);
  EXPECT_THROW((void)common_rotation(first, std::vector<Curve>{a, a}), InvalidArgument);
}

}  // namespace
}  // namespace tandem
