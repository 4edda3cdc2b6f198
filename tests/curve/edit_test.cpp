#include "tandem/curve/edit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "curve/random_curves.h"
#include "tandem/curve/knots.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using testing::distance;
using testing::largest_gap;
using testing::probes;
using testing::RandomCurves;

// Coordinates up to 1, some 20 roundings in the knots and as many in convex combinations, weights that differ
// by 100.
constexpr double kRounding = 3e-14;

TEST(Edit, InsertedKnotsKeepTheCurve) {
  RandomCurves random(1);
  for (int i = 0; i < 300; ++i) {
    const Curve curve = random.any(random.integer(1, 3));
    const double t = random.uniform(curve.domain().lo, curve.domain().hi);
    const int times = random.integer(1, curve.degree());
    const Curve more = insert_knot(curve, t, times);
    EXPECT_EQ(multiplicity(more.knots(), t), times);
    EXPECT_EQ(more.size(), curve.size() + static_cast<std::size_t>(times));
    EXPECT_EQ(more.domain(), curve.domain());
    EXPECT_LT(largest_gap(curve, more), kRounding);
  }
}

TEST(Edit, RefinesAtTheEndsOfAnUnclampedDomain) {
  RandomCurves random(2);
  for (int i = 0; i < 100; ++i) {
    const Curve curve = random.curve(random.integer(2, 5), 2, random.integer(1, 4), i % 2 == 0, false);
    std::vector<double> knots;
    for (int k = multiplicity(curve.knots(), 0.0); k < curve.degree(); ++k) knots.push_back(0.0);
    knots.push_back(0.123456);
    for (int k = multiplicity(curve.knots(), 1.0); k < curve.degree(); ++k) knots.push_back(1.0);
    const Curve more = refine(curve, knots);
    EXPECT_EQ(multiplicity(more.knots(), 1.0), curve.degree());
    EXPECT_LT(largest_gap(curve, more), kRounding);
  }
}

TEST(Edit, ClampedCurveStartsAndEndsAtItsControlPoints) {
  RandomCurves random(3);
  for (int i = 0; i < 200; ++i) {
    const Curve curve = random.any(2);
    const Curve clamped = clamp(curve);
    const auto p = static_cast<std::size_t>(curve.degree());
    EXPECT_EQ(clamped.knots()[0], clamped.knots()[p]);
    EXPECT_EQ(clamped.knots().back(), clamped.knots()[clamped.size()]);
    EXPECT_LT(largest_gap(curve, clamped), kRounding);
    EXPECT_EQ(clamp(clamped), clamped);
  }
}

TEST(Edit, SplitPartsAreThePartsOfTheCurve) {
  RandomCurves random(4);
  for (int i = 0; i < 200; ++i) {
    const Curve curve = random.any(3);
    double t = random.uniform(curve.domain().lo, curve.domain().hi);
    if (i % 3 == 0) t = curve.knots()[curve.knots().size() / 2];
    if (!(curve.domain().lo < t && t < curve.domain().hi)) continue;
    const SplitCurve parts = split(curve, t);
    EXPECT_EQ(parts.left.domain(), (Interval{curve.domain().lo, t}));
    EXPECT_EQ(parts.right.domain(), (Interval{t, curve.domain().hi}));
    EXPECT_LT(largest_gap(parts.left, curve), kRounding);
    EXPECT_LT(largest_gap(parts.right, curve), kRounding);
    const std::vector<Curve> both{parts.left, parts.right};
    EXPECT_LT(largest_gap(curve, join(both)), kRounding);
  }
}

TEST(Edit, SubcurveLiesOnTheCurve) {
  RandomCurves random(5);
  for (int i = 0; i < 200; ++i) {
    const Curve curve = random.any(2);
    const double a = random.uniform(curve.domain().lo, curve.domain().hi);
    const double b = random.uniform(curve.domain().lo, curve.domain().hi);
    if (a == b) continue;
    const Curve part = subcurve(curve, {std::min(a, b), std::max(a, b)});
    EXPECT_EQ(part.domain(), (Interval{std::min(a, b), std::max(a, b)}));
    EXPECT_LT(largest_gap(part, curve), kRounding);
  }
}

TEST(Edit, ReversedRunsBackwards) {
  RandomCurves random(6);
  for (int i = 0; i < 100; ++i) {
    const Curve curve = random.any(2);
    const Curve backwards = reverse(curve);
    EXPECT_EQ(backwards.domain(), curve.domain());
    for (const double t : probes(curve)) {
      const double other = curve.domain().lo + curve.domain().hi - t;
      EXPECT_LT(distance(curve.evaluate(t), backwards.evaluate(other)), 1e-13);
    }
    EXPECT_EQ(reverse(backwards).control_points(), curve.control_points());
  }
}

TEST(Edit, OtherDomainSameCurve) {
  RandomCurves random(7);
  for (int i = 0; i < 100; ++i) {
    const Curve curve = random.any(2);
    const Interval to{1e6, 1e6 + 1};
    const Curve moved = with_domain(curve, to);
    EXPECT_EQ(moved.domain(), to);
    // A parameter near 1e6 is only good to 1e-10, and the speed is up to some 1e3.
    for (int k = 0; k <= 20; ++k) {
      const double s = k / 20.0;
      EXPECT_LT(
          distance(curve.evaluate(curve.domain().lo + s * curve.domain().length()), moved.evaluate(1e6 + s)),
          1e-6);
    }
    const Curve back = with_domain(with_domain(curve, {0, 8}), curve.domain());
    EXPECT_LT(largest_gap(curve, back), 1e-12);
  }
}

TEST(Edit, ElevatedCurveIsTheSameAndAsSmooth) {
  RandomCurves random(8);
  for (int i = 0; i < 200; ++i) {
    const Curve curve = random.any(2);
    const int times = random.integer(1, 4);
    const Curve higher = elevate_degree(curve, times);
    EXPECT_EQ(higher.degree(), curve.degree() + times);
    EXPECT_EQ(higher.domain(), curve.domain());
    for (const Knot& knot : distinct_knots(curve.knots())) {
      if (knot.value <= curve.domain().lo || knot.value >= curve.domain().hi) continue;
      EXPECT_EQ(multiplicity(higher.knots(), knot.value), knot.multiplicity + times);
    }
    EXPECT_LT(largest_gap(curve, higher), kRounding);
  }
}

TEST(Edit, ElevatedParabolaHasTheKnownControlPoints) {
  const Curve parabola = Curve::bezier(Points({{0, 0}, {3, 6}, {6, 0}}));
  EXPECT_EQ(elevate_degree(parabola).control_points(), Points({{0, 0}, {2, 4}, {4, 4}, {6, 0}}));
}

TEST(Edit, BezierSegmentsJoinToTheCurve) {
  RandomCurves random(9);
  for (int i = 0; i < 100; ++i) {
    const Curve curve = random.any(2);
    const std::vector<Curve> segments = bezier_segments(curve);
    for (const Curve& segment : segments) {
      EXPECT_EQ(segment.size(), static_cast<std::size_t>(curve.degree()) + 1);
      EXPECT_LT(largest_gap(segment, curve), kRounding);
    }
    EXPECT_LT(largest_gap(curve, join(segments)), kRounding);
  }
}

TEST(Edit, JoinsDifferentDegreesAndKinds) {
  const Curve line = Curve::bezier(Points({{0, 0}, {1, 0}}));
  const Curve arc = Curve::bezier(Points({{1, 0}, {2, 0}, {2, 1}}), {2.0, std::sqrt(2.0), 2.0}, {1, 2});
  const std::vector<Curve> parts{line, arc};
  const Curve joined = join(parts);
  EXPECT_EQ(joined.degree(), 2);
  EXPECT_EQ(joined.domain(), (Interval{0, 2}));
  EXPECT_LT(largest_gap(line, joined), kRounding);
  EXPECT_LT(largest_gap(arc, joined), kRounding);
}

TEST(Edit, MovedSeamOfAClampedCurve) {
  RandomCurves random(10);
  for (int i = 0; i < 100; ++i) {
    Points points = random.points(2, 9);
    points[8][0] = points[0][0];
    points[8][1] = points[0][1];
    std::vector<double> weights;
    if (i % 2 == 0) {
      weights = random.weights(9);
    }
    const Curve closed = with_domain(Curve::clamped_uniform(random.integer(1, 4), points, weights), {1, 4});
    ASSERT_TRUE(closed.is_closed());
    const double t = random.uniform(-10, 10);
    const Curve moved = move_seam(closed, t);
    EXPECT_EQ(moved.domain(), (Interval{t, t + 3.0}));
    EXPECT_TRUE(moved.is_closed());
    for (int k = 0; k < 50; ++k) {
      const double u = t + 3.0 * k / 50;
      double place = u;
      while (place < 1) place += 3.0;
      while (place >= 4) place -= 3.0;
      EXPECT_LT(distance(moved.evaluate(u), closed.evaluate(place)), 1e-12);
    }
  }
}

TEST(Edit, MovedSeamOfAPeriodicCurveStaysSmooth) {
  RandomCurves random(11);
  for (int degree = 1; degree <= 4; ++degree) {
    const auto p = static_cast<std::size_t>(degree);
    const Points base = random.points(2, 7);
    Points points;
    std::vector<double> knots;
    for (std::size_t i = 0; i < 7 + p; ++i) points.push_back(base[i % 7]);
    for (std::size_t i = 0; i < 7 + 2 * p + 1; ++i) knots.push_back(static_cast<double>(i));
    const Curve periodic(degree, knots, points);
    ASSERT_TRUE(periodic.is_periodic());
    const double lo = periodic.domain().lo;
    for (const double t : {lo, lo + 0.3, lo + 3.0, lo + 6.99, lo - 20.5, lo + 700.0}) {
      const Curve moved = move_seam(periodic, t);
      EXPECT_EQ(moved.domain(), (Interval{t, t + 7.0}));
      for (const Knot& knot : distinct_knots(moved.knots())) {
        if (t < knot.value && knot.value < t + 7.0) {
          EXPECT_EQ(knot.multiplicity, 1);
        }
      }
      for (int k = 0; k < 50; ++k) {
        const double u = t + 7.0 * k / 50;
        double place = u;
        while (place < lo) place += 7.0;
        while (place >= lo + 7) place -= 7.0;
        EXPECT_LT(distance(moved.evaluate(u), periodic.evaluate(place)), 1e-12);
      }
    }
  }
}

// Periodic curves with uneven and repeated knots, rational too: unclamped from a clamped knot sequence per
// turn.
TEST(Edit, MovedSeamOfAnUnevenPeriodicCurve) {
  RandomCurves random(15);
  for (int i = 0; i < 200; ++i) {
    const int degree = random.integer(2, 4);
    const auto p = static_cast<std::size_t>(degree);
    std::vector<double> turn{0.1};  // knots of one turn, over [0.1, 1.3)
    while (turn.size() < 8) {
      const int copies = random.integer(1, degree - 1);
      const double next = turn.back() + random.uniform(0.01, 0.2);
      turn.insert(turn.end(), static_cast<std::size_t>(copies), next);
    }
    const std::size_t n = turn.size();
    const double period = turn.back() + 0.07 - 0.1;
    std::vector<double> knots;
    for (std::size_t k = 0; k < n + 2 * p + 1; ++k) {
      // Knot k stands p places before the start of the domain.
      const auto place =
          static_cast<std::ptrdiff_t>(k) - static_cast<std::ptrdiff_t>(p) + static_cast<std::ptrdiff_t>(n);
      const auto in_turn = static_cast<std::size_t>(place) % n;
      knots.push_back(turn[in_turn] +
                      period * (static_cast<double>(static_cast<std::size_t>(place) / n) - 1.0));
    }
    const Points base = random.points(2, n);
    const std::vector<double> base_weights = random.weights(n);
    Points points;
    std::vector<double> weights;
    for (std::size_t k = 0; k < n + p; ++k) {
      points.push_back(base[k % n]);
      if (i % 2 == 0) weights.push_back(base_weights[k % n]);
    }
    const Curve periodic(degree, knots, points, weights);
    ASSERT_TRUE(periodic.is_periodic());
    const double lo = periodic.domain().lo;
    const double length = periodic.domain().length();
    for (const double t : {lo, turn[3], turn[5] + length, random.uniform(-3, 3)}) {
      const Curve moved = move_seam(periodic, t);
      EXPECT_EQ(moved.domain(), (Interval{t, t + length}));
      EXPECT_LE(moved.size(), periodic.size() + 1);  // a seam between knots takes one more
      EXPECT_TRUE(moved.is_closed());
      for (int k = 0; k < 60; ++k) {
        const double u = t + length * k / 60;
        double place = u;
        while (place < lo) place += length;
        while (place >= lo + length) place -= length;
        // Speeds reach 1e3, parameters are rounded a few times.
        EXPECT_LT(distance(moved.evaluate(u), periodic.evaluate(place)), 1e-11);
      }
    }
  }
}

TEST(Edit, MovingTheSeamAroundAndBackKeepsKnots) {
  Points square({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}});
  const Curve closed(1, {0, 0, 1, 2, 3, 4, 4}, square);
  const Curve moved = move_seam(closed, 2.0);
  EXPECT_EQ(moved.knots(), (std::vector<double>{2, 2, 3, 4, 5, 6, 6}));
  EXPECT_EQ(moved.control_points(), Points({{1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}}));
}

TEST(Edit, InsertedKnotsCanBeRemoved) {
  RandomCurves random(12);
  for (int i = 0; i < 200; ++i) {
    const Curve curve = random.any(2);
    const double t = random.uniform(curve.domain().lo, curve.domain().hi);
    const int times = random.integer(1, curve.degree());
    const Curve more = insert_knot(curve, t, times);
    const KnotRemoval removal = remove_knot(more, t, times, 1e-9);
    EXPECT_EQ(removal.removed, times);
    EXPECT_EQ(removal.curve.knots(), curve.knots());
    EXPECT_LE(largest_gap(curve, removal.curve), removal.deviation + kRounding);
  }
}

TEST(Edit, RemovalMovesTheCurveByNoMoreThanItSays) {
  RandomCurves random(13);
  int removed = 0;
  int refused = 0;
  for (int i = 0; i < 500; ++i) {
    const Curve curve = random.any(2);
    const double t = curve.knots()[static_cast<std::size_t>(curve.degree()) + 1];
    if (t >= curve.domain().hi) continue;
    const double tolerance = random.uniform(0.0, 2.0);
    const KnotRemoval removal = remove_knot(curve, t, 2, tolerance);
    (removal.removed > 0 ? removed : refused) += 1;
    EXPECT_LE(removal.deviation, tolerance);
    EXPECT_EQ(removal.curve.size() + static_cast<std::size_t>(removal.removed), curve.size());
    EXPECT_LE(largest_gap(curve, removal.curve), removal.deviation + kRounding);
  }
  EXPECT_GT(removed, 50);
  EXPECT_GT(refused, 50);
}

TEST(Edit, RemovesOnlyInteriorKnots) {
  const Curve curve(1, {0, 0, 1, 2, 2}, Points({{0, 0}, {1, 0}, {2, 0}}));
  EXPECT_EQ(remove_knot(curve, 0.0, 1, 9.0).removed, 0);
  EXPECT_EQ(remove_knot(curve, 0.5, 1, 9.0).removed, 0);
  EXPECT_EQ(remove_knot(curve, 1.0, 5, 0.0).removed, 1);  // a straight joint
  EXPECT_THROW((void)remove_knot(curve, 1.0, -1, 1.0), InvalidArgument);
  EXPECT_THROW((void)remove_knot(curve, 1.0, 1, NAN), InvalidArgument);
}

TEST(Edit, DerivativeCurveIsTheDerivative) {
  RandomCurves random(14);
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    const Curve curve = random.any(2);
    std::vector<Knot> inner = distinct_knots(curve.knots());
    const bool breaks = std::any_of(inner.begin(), inner.end(), [&](const Knot& k) {
      return k.multiplicity >= curve.degree() && curve.domain().lo < k.value && k.value < curve.domain().hi;
    });
    if (breaks) {
      EXPECT_THROW((void)derivative_curve(curve), InvalidArgument);
      continue;
    }
    ++compared;
    const Curve derivative = derivative_curve(curve);
    EXPECT_EQ(derivative.domain(), curve.domain());
    EXPECT_EQ(derivative.degree(),
              curve.is_rational() ? 2 * curve.degree() : std::max(1, curve.degree() - 1));
    for (const double t : probes(curve)) {
      const Points d = curve.derivatives(t, 2);
      const double slack = 1e-12 * (derivative.extent() + testing::norm(d[2]) + testing::norm(d[1]));
      const Point found = derivative.evaluate(t);
      EXPECT_NEAR(found[0], d[1][0], slack);
      EXPECT_NEAR(found[1], d[1][1], slack);
    }
  }
  EXPECT_GT(compared, 50);
}

TEST(Edit, RefusesWhatCannotBe) {
  const Curve curve = Curve::bezier(Points({{0, 0}, {1, 2}, {3, 0}}));
  EXPECT_THROW((void)insert_knot(curve, 2.0), InvalidArgument);
  EXPECT_THROW((void)insert_knot(curve, 0.5, 3), InvalidArgument);
  EXPECT_THROW((void)insert_knot(curve, 0.0, 1), InvalidArgument);
  EXPECT_THROW((void)insert_knot(curve, 0.5, -1), InvalidArgument);
  EXPECT_THROW((void)insert_knot(curve, NAN), InvalidArgument);
  EXPECT_THROW((void)refine(curve, std::vector<double>{0.6, 0.5}), InvalidArgument);
  EXPECT_THROW((void)split(curve, 0.0), InvalidArgument);
  EXPECT_THROW((void)split(curve, NAN), InvalidArgument);
  EXPECT_THROW((void)subcurve(curve, {0.5, 0.5}), InvalidArgument);
  EXPECT_THROW((void)subcurve(curve, {0.5, 1.5}), InvalidArgument);
  EXPECT_THROW((void)with_domain(curve, {1, 1}), InvalidArgument);
  EXPECT_THROW((void)with_domain(curve, {0, INFINITY}), InvalidArgument);
  EXPECT_THROW((void)elevate_degree(curve, -1), InvalidArgument);
  EXPECT_THROW((void)move_seam(curve, 0.5), InvalidArgument);
  EXPECT_THROW((void)join({}), InvalidArgument);
  const std::vector<Curve> apart{curve, curve};
  EXPECT_THROW((void)join(apart), InvalidArgument);
}

}  // namespace
}  // namespace tandem
