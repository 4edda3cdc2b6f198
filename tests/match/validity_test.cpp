#include "tandem/match/validity.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace tandem {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Curve segment(double x0, double y0, double x1, double y1) {
  return Curve::bezier({{x0, y0}, {x1, y1}});
}

/// Two unit steps: first along `heading`, then turned by `turn`, both in degrees.
Curve elbow(double heading, double turn) {
  const double a = heading * kDegree;
  const double b = (heading + turn) * kDegree;
  const double x = std::cos(a);
  const double y = std::sin(a);
  return Curve(1, {0, 0, 0.5, 1, 1}, {{0, 0}, {x, y}, {x + std::cos(b), y + std::sin(b)}});
}

TEST(Validity, IsTheCosineForTwoSegments) {
  for (const double angle : {0.0, 10.0, 60.0, 89.0, 91.0, 120.0, 180.0}) {
    const Curve a = segment(1, 2, 4, 2);
    const Curve b = segment(0, 0, std::cos(angle * kDegree), std::sin(angle * kDegree));
    const Validity validity = check_validity(a, b);
    EXPECT_NEAR(validity.min_dot, std::cos(angle * kDegree), 1e-14);
    EXPECT_NEAR(validity.mean_dot, std::cos(angle * kDegree), 1e-14);
    EXPECT_EQ(validity.valid, angle < 90.0);
    EXPECT_EQ(validity.valid_share, angle < 90.0 ? 1.0 : 0.0);
  }
}

TEST(Validity, FindsTheInvalidPart) {
  // Quarter circle (heading 90 .. 180 degrees) against a line at 30 degrees: valid up to heading 120, a
  // third.
  const double w = std::sqrt(0.5);
  const Curve arc = Curve::bezier({{1, 0}, {1, 1}, {0, 1}}, {1, w, 1});
  const Curve line = segment(0, 0, std::cos(30 * kDegree), std::sin(30 * kDegree));
  const Validity validity = check_validity(arc, line);
  EXPECT_FALSE(validity.valid);
  EXPECT_NEAR(validity.min_dot, std::cos(150 * kDegree), 1e-14);
  EXPECT_EQ(validity.worst_u, 1.0);
  // Mean of both lengths' shares: of the arc's a third, of the line's the parameter there. The arc's speed is
  // not uniform: at heading h from its start (0 .. 90), u is the root of tan(h / 2) = ... ; taken from the
  // curve itself.
  double lo = 0.0;
  double hi = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double u = 0.5 * (lo + hi);
    const Points d = arc.derivatives(u, 1);
    (std::atan2(d[1][1], d[1][0]) < 120 * kDegree ? lo : hi) = u;
  }
  EXPECT_NEAR(validity.valid_share, 0.5 * (1.0 / 3.0 + lo), 2e-3);
}

TEST(Validity, SharpensTheMinimum) {
  // The least <T1,T2> lies inside the span, between any of its dyadic points.
  const Curve bump = Curve::bezier({{0, 0}, {1, 0.1}, {1.2, 1.3}, {2.5, 1.4}});
  double least = 1.0;
  double where = 0.0;
  for (int i = 0; i <= 1000000; ++i) {
    const double t = i / 1e6;
    const double s = 1 - t;
    const double dx = s * s * 1.0 + 2 * s * t * 0.2 + t * t * 1.3;
    const double dy = s * s * 0.1 + 2 * s * t * 1.2 + t * t * 0.1;
    const double value = dx / std::sqrt(dx * dx + dy * dy);
    if (value < least) {
      least = value;
      where = t;
    }
  }
  ASSERT_GT(where, 0.1);
  ASSERT_LT(where, 0.9);
  const Validity validity = check_validity(bump, segment(0, 0, 1, 0));
  EXPECT_NEAR(validity.min_dot, least, 1e-10);
  EXPECT_NEAR(validity.worst_u, where, 1e-4);
}

TEST(Validity, SeesBothSidesOfCorners) {
  const Curve a = elbow(0, 0);
  EXPECT_NEAR(check_validity(a, elbow(20, 50)).min_dot, std::cos(70 * kDegree), 1e-14);
  EXPECT_NEAR(check_validity(a, elbow(-80, 100)).min_dot, std::cos(80 * kDegree), 1e-14);
  EXPECT_FALSE(check_validity(a, elbow(0, 91)).valid);
}

TEST(Validity, RefusesACornerThatBacktracksInBetween) {
  // Spec C13: turns of +170 and -170 degrees, with equal tangents before.
  const Validity validity = check_validity(elbow(0, 170), elbow(0, -170));
  EXPECT_FALSE(validity.valid);
  EXPECT_NEAR(validity.min_dot, std::cos(20 * kDegree), 1e-14);
  EXPECT_EQ(validity.valid_share, 1.0);
  EXPECT_TRUE(check_validity(elbow(0, 170), elbow(0, 175)).valid);
  EXPECT_TRUE(check_validity(elbow(0, 170), elbow(3, 150)).valid);
  EXPECT_TRUE(check_validity(elbow(-5, 179), elbow(5, 179)).valid);
  // Turned in the other sense as well.
  EXPECT_FALSE(check_validity(elbow(0, -170), elbow(0, 170)).valid);
  EXPECT_FALSE(check_validity(elbow(0, 150), elbow(-60, 270)).valid);
  EXPECT_NEAR(check_validity(elbow(0, 150), elbow(-60, 270)).min_dot, 0.5, 1e-14);
  EXPECT_TRUE(check_validity(elbow(0, 150), elbow(-60, 170)).valid);
}

TEST(Validity, AcceptsEqualCusps) {
  const Curve cusp = elbow(0, 180);
  EXPECT_TRUE(check_validity(cusp, cusp).valid);
  EXPECT_TRUE(check_validity(cusp, elbow(0, 170)).valid);
  EXPECT_TRUE(check_validity(cusp, elbow(0, -170)).valid);
  EXPECT_TRUE(check_validity(elbow(0, -170), cusp).valid);
}

/// A closed polygon of four edges with the given headings, in degrees; the first is 1 long, the third
/// `third`.
Curve loop(const std::array<double, 4>& headings, double third) {
  double x[4];
  double y[4];
  for (std::size_t i = 0; i < 4; ++i) {
    x[i] = std::cos(headings[i] * kDegree);
    y[i] = std::sin(headings[i] * kDegree);
  }
  // The other two edges close it.
  const double rest_x = -(x[0] + third * x[2]);
  const double rest_y = -(y[0] + third * y[2]);
  const double determinant = x[1] * y[3] - x[3] * y[1];
  const double second = (rest_x * y[3] - x[3] * rest_y) / determinant;
  const double px = x[0] + second * x[1];
  const double py = y[0] + second * y[1];
  return Curve(1, {0, 0, 1, 2, 3, 4, 4},
               {{0, 0}, {x[0], y[0]}, {px, py}, {px + third * x[2], py + third * y[2]}, {0, 0}});
}

TEST(Validity, LooksAtTheSeamOfClosedCurves) {
  // Nowhere more than 20 degrees apart; at the seam one turns by +170 degrees and the other by -170.
  const Curve a = loop({0, -60, 100, 190}, 0.9);
  const Curve b = loop({0, -60, 100, 170}, 0.5);
  ASSERT_TRUE(a.is_closed() && b.is_closed());
  const Validity validity = check_validity(a, b);
  EXPECT_NEAR(validity.min_dot, std::cos(20 * kDegree), 1e-12);
  EXPECT_FALSE(validity.valid);
  EXPECT_TRUE(check_validity(a, a).valid);
  // Cut open, there is no corner.
  const Interval open{0, 3.9};
  EXPECT_TRUE(check_validity(subcurve(a, open), subcurve(b, open)).valid);
}

TEST(Validity, TakesLimitsWhereTheSpeedIsZero) {
  // A cubic with a zero first handle starts towards its third control point, one with a zero last handle ends
  // away from its second.
  const Curve zero_handles = Curve::bezier({{0, 0}, {0, 0}, {1, 0}, {1, 0}});
  const Validity straight = check_validity(zero_handles, segment(0, 0, 3, 0));
  EXPECT_TRUE(straight.valid);
  EXPECT_NEAR(straight.min_dot, 1.0, 1e-14);
  const Curve bent = Curve::bezier({{0, 0}, {0, 0}, {1, 1}, {1, 0}});
  EXPECT_NEAR(check_validity(bent, segment(0, 0, 0, -1)).min_dot, -std::sqrt(0.5), 1e-9);
  const Curve arriving = Curve::bezier({{0, 0}, {0, 1}, {1, 1}, {1, 1}});
  EXPECT_NEAR(check_validity(arriving, segment(0, 0, 1, 0)).min_dot, 0.0, 1e-12);
  EXPECT_NEAR(check_validity(arriving, segment(0, 0, 0, 1)).min_dot, 0.0, 1e-12);
}

TEST(Validity, TakesHigherLimitsFromTheRightSide) {
  // Speed zero to the second order, at both ends: the third derivative points forwards from either side.
  const Curve diagonal = segment(0, 0, 1, 1);
  EXPECT_NEAR(check_validity(Curve::bezier({{0, 0}, {1, 1}, {1, 1}, {1, 1}}), diagonal).min_dot, 1.0, 1e-14);
  EXPECT_NEAR(check_validity(Curve::bezier({{0, 0}, {0, 0}, {0, 0}, {1, 1}}), diagonal).min_dot, 1.0, 1e-14);
}

TEST(Validity, IntegratesSharpTurnsFinely) {
  // A narrow parabola: near its tip, for a fiftieth of the span, the tangent is upright; elsewhere it lies
  // flat.
  const double c = 0.37;
  const double h = 0.02;
  const Curve tip = Curve::bezier({{c * c, 0}, {c * c - c, h / 2}, {(1 - c) * (1 - c), h}});
  const Validity validity = check_validity(tip, segment(0, 0, 0, 1));
  double value_a = 0.0;
  double length_a = 0.0;
  double value_b = 0.0;
  const int n = 100000;
  for (int k = 0; k < n; ++k) {
    const double t = (k + 0.5) / n;
    const double speed = std::sqrt(4 * (t - c) * (t - c) + h * h);
    value_a += h / n;
    length_a += speed / n;
    value_b += h / speed / n;
  }
  // The trapezoidal rule over turns of up to half a radian.
  EXPECT_NEAR(validity.mean_dot, 0.5 * value_a / length_a + 0.5 * value_b, 3e-3);
}

TEST(Validity, FindsACuspInsideASpan) {
  // x = (t - 1/3)^2, y = (t - 1/3)^3: the tangent flips at t = 1/3, between any dyadic samples.
  const Curve cusp = [] {
    const double c = 1.0 / 3.0;
    const double x[] = {c * c, c * c - c, (1 - c) * (1 - c)};  // quadratic: t^2 - 2ct + c^2
    const double y0 = -c * c * c;
    const double y1 = y0 + c * c;
    const double y2 = y0 + 2 * c * c - c;
    const double y3 = (1 - c) * (1 - c) * (1 - c);
    return Curve::bezier({{x[0], y0}, {(x[0] + 2 * x[1]) / 3, y1}, {(2 * x[1] + x[2]) / 3, y2}, {x[2], y3}});
  }();
  const Validity validity = check_validity(cusp, segment(0, 0, 1, 0));
  EXPECT_FALSE(validity.valid);
  EXPECT_LT(validity.min_dot, -0.99);
  EXPECT_GT(validity.valid_share, 0.5);
}

TEST(Validity, FindsANarrowNearCusp) {
  // Nearly a cusp: within a hundredth of the span the tangent turns by nearly half a circle.
  const double h = 1e-4;
  const double c = 0.37;
  // x = (t - c)^2, y' = small at c: y = (t - c)^3 + h t.
  const auto point = [&](double t) {
    return std::array<double, 2>{(t - c) * (t - c), (t - c) * (t - c) * (t - c) + h * t};
  };
  const auto slope = [&](double t) { return std::array<double, 2>{2 * (t - c), 3 * (t - c) * (t - c) + h}; };
  const auto p0 = point(0), p3 = point(1), d0 = slope(0), d1 = slope(1);
  const Curve curve = Curve::bezier({{p0[0], p0[1]},
                                     {p0[0] + d0[0] / 3, p0[1] + d0[1] / 3},
                                     {p3[0] - d1[0] / 3, p3[1] - d1[1] / 3},
                                     {p3[0], p3[1]}});
  // Against a copy of itself whose own flip comes a little later it is opposite in between, for 1/500 of the
  // span.
  const Validity validity = check_validity(curve, reverse(reverse(curve)));
  EXPECT_TRUE(validity.valid);
  const double e = c + 0.002;
  const auto later = [&](double t) {
    return std::array<double, 2>{(t - e) * (t - e), (t - e) * (t - e) * (t - e) + h * t};
  };
  const auto later_slope = [&](double t) {
    return std::array<double, 2>{2 * (t - e), 3 * (t - e) * (t - e) + h};
  };
  const auto q0 = later(0), q3 = later(1), e0 = later_slope(0), e1 = later_slope(1);
  const Curve other = Curve::bezier({{q0[0], q0[1]},
                                     {q0[0] + e0[0] / 3, q0[1] + e0[1] / 3},
                                     {q3[0] - e1[0] / 3, q3[1] - e1[1] / 3},
                                     {q3[0], q3[1]}});
  EXPECT_FALSE(check_validity(curve, other).valid);
}

TEST(Validity, FindsAShortReversalBetweenSamples) {
  // On a line: speed 3 (t - c)^2 - 3 w^2, negative for |t - c| < w alone, far less than the distance of
  // samples.
  for (const double w : {0.02, 0.002, 2e-4}) {
    for (const double c : {0.31, 0.4375, 0.77}) {
      const auto x = [c, w](double t) { return (t - c) * (t - c) * (t - c) - 3 * w * w * t; };
      const auto slope = [c, w](double t) { return 3 * (t - c) * (t - c) - 3 * w * w; };
      const Curve back_and_forth =
          Curve::bezier(Points(1, std::vector<double>{x(0), x(0) + slope(0) / 3, x(1) - slope(1) / 3, x(1)}));
      const Validity validity =
          check_validity(back_and_forth, Curve::bezier(Points(1, std::vector<double>{0.0, 1.0})));
      EXPECT_FALSE(validity.valid) << "w " << w << ", c " << c;
      EXPECT_NEAR(validity.worst_u, c, w + 1e-9);  // the speed's very zero counts as either side
    }
  }
}

TEST(Validity, StandsStillWithoutHarm) {
  // A span without length has no tangent and contradicts nothing (spec C18).
  const Curve pause(1, {0, 0, 1, 2, 3, 3}, {{0, 0}, {1, 0}, {1, 0}, {2, 0}});
  const Curve moving(1, {0, 0, 1, 2, 3, 3}, {{0, 0}, {1, 0}, {1, 1}, {2, 1}});
  const Validity validity = check_validity(pause, moving);
  EXPECT_TRUE(validity.valid);
  EXPECT_EQ(validity.min_dot, 1.0);
  const Curve point = Curve::bezier({{1, 1}, {1, 1}});
  EXPECT_TRUE(check_validity(point, point).valid);
  EXPECT_EQ(check_validity(point, segment(0, 0, 1, 0)).mean_dot, 1.0);
}

TEST(Validity, RuledNormUsesOneSign) {
  // Parallel lines, the second one above: fine, from either side. Crossing over: not, although the product
  // stays positive on both sides of the crossing.
  const Curve low = segment(0, 0, 1, 0);
  const Curve high = segment(0, 1, 1, 1);
  EXPECT_TRUE(check_validity(low, high, NormKind::ruled).valid);
  EXPECT_TRUE(check_validity(high, low, NormKind::ruled).valid);
  EXPECT_NEAR(check_validity(low, high, NormKind::ruled).min_dot, 1.0, 1e-14);
  const Curve crossing = segment(0, 1, 1, -1);
  const Validity validity = check_validity(low, crossing, NormKind::ruled);
  EXPECT_FALSE(validity.valid);
  EXPECT_NEAR(validity.valid_share, 0.5, 1e-2);
}

TEST(Validity, RuledNormSeesCurvesThatCrossTwice) {
  // Between two samples the second curve dips below the first one and comes back; each ruling is vertical.
  const Curve a = Curve::clamped_uniform(2, {{0, -0.9}, {1, 0.44}, {2, -0.06}, {3, -2}});
  const Curve b = Curve::clamped_uniform(2, {{0, 0.2}, {1, -0.08}, {2, 0.92}, {3, -1.5}});
  EXPECT_FALSE(check_validity(a, b, NormKind::ruled).valid);
  EXPECT_TRUE(check_validity(a, b, NormKind::tangent).valid);
}

TEST(Validity, RuledNormCanBeValidWhereTangentsAreNot) {
  // Spec C13: (4) > 0 and (3) < 0. Lines that lean away from the chord to opposite sides.
  const Curve a = Curve::bezier({{0, 0}, {0.1, 1}});
  const Curve b = Curve::bezier({{5, 0}, {5.5, 0.2}});
  EXPECT_TRUE(check_validity(a, b, NormKind::ruled).valid);
  const Curve c = Curve::bezier({{0, 0}, {-1, 0.5}});
  const Curve d = Curve::bezier({{5, 0}, {6, 0.5}});
  EXPECT_TRUE(check_validity(c, d, NormKind::ruled).valid);
  EXPECT_FALSE(check_validity(c, d, NormKind::tangent).valid);
}

TEST(Validity, RuledNormInSpaceMeasuresTwist) {
  // Tangents at right angles to the chord, twisted by 60 degrees against each other.
  const Curve a = Curve::bezier({{0, 0, 0}, {1e-3, 0, 0}});
  const Curve b = Curve::bezier({{0, 0, 1}, {0.5e-3, std::sqrt(0.75) * 1e-3, 1}});
  EXPECT_NEAR(check_validity(a, b, NormKind::ruled).min_dot, 0.5, 1e-5);
  EXPECT_NEAR(check_validity(a, a, NormKind::ruled).min_dot, 1.0, 1e-14);
}

TEST(Validity, DoesNotDependOnSize) {
  for (const double size : {1e-300, 1e-150, 1.0, 1e150, 1e300}) {
    const auto scaled = [size](const Curve& curve) {
      Points points = curve.control_points();
      for (double& x : points.data()) x *= size;
      return Curve(curve.degree(), curve.knots(), points);
    };
    const Curve a = Curve::bezier({{0, 0}, {0.3, 0.4}, {0.8, 0.1}, {1, 0}});
    const Curve b = Curve::bezier({{0, 0.2}, {0.3, 0.1}, {0.8, 0.1}, {1, 0.3}});
    for (const NormKind norm : {NormKind::tangent, NormKind::ruled}) {
      const Validity plain = check_validity(a, b, norm);
      const Validity big = check_validity(scaled(a), scaled(b), norm);
      EXPECT_EQ(plain.valid, big.valid);
      EXPECT_NEAR(plain.min_dot, big.min_dot, 1e-9);
      EXPECT_NEAR(plain.mean_dot, big.mean_dot, 1e-9);
      EXPECT_NEAR(plain.valid_share, big.valid_share, 1e-9);
    }
  }
}

/// Curves with few distinct coordinates: cusps, loops, zero handles, repeated points and corners are common.
Curve nasty_curve(int dim, const Interval& domain) {
  const int degree = *rc::gen::inRange(1, 5);
  const auto n = *rc::gen::inRange<std::size_t>(static_cast<std::size_t>(degree) + 1, 10);
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, domain.lo);
  const std::size_t inner = n - static_cast<std::size_t>(degree) - 1;
  std::vector<int> places;
  for (std::size_t i = 0; i < inner; ++i) places.push_back(*rc::gen::inRange(1, 8));
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < inner; ++i) {
    // No more than `degree` equal ones: the curve must not break.
    if (i >= static_cast<std::size_t>(degree) && places[i] <= places[i - static_cast<std::size_t>(degree)]) {
      places[i] = places[i - 1] + 1;
    }
    if (i > 0) places[i] = std::max(places[i], places[i - 1]);
    knots.push_back(domain.lo + domain.length() * places[i] / 20.0);
  }
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, domain.hi);
  Points points(dim, n);
  for (double& x : points.data()) x = *rc::gen::inRange(-3, 4);
  std::vector<double> weights;
  if (*rc::gen::inRange(0, 3) == 0) {
    for (std::size_t i = 0; i < n; ++i) weights.push_back(*rc::gen::element(0.2, 1.0, 5.0));
  }
  return Curve(degree, knots, points, weights);
}

/// A smooth curve that runs roughly along the first axis.
Curve tame_curve(int dim) {
  const auto n = *rc::gen::inRange<std::size_t>(4, 9);
  Points points(dim, n);
  for (std::size_t i = 0; i < n; ++i) {
    points[i][0] = static_cast<double>(i);
    for (std::size_t c = 1; c < static_cast<std::size_t>(dim); ++c)
      points[i][c] = *rc::gen::inRange(-100, 101) / 50.0;
  }
  return Curve::clamped_uniform(*rc::gen::inRange(2, 4), points);
}

double scalar_product(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t c = 0; c < a.size(); ++c) sum += a[c] * b[c];
  return sum;
}

TEST(Validity, AgreesWithDenseSampling) {
  EXPECT_TRUE(rc::check([] {
    const int dim = *rc::gen::inRange(1, 4);
    const Interval domain = *rc::gen::element(Interval{0, 1}, Interval{-7, 3}, Interval{1e6, 1e6 + 1});
    const Curve a = nasty_curve(dim, domain);
    const Curve b = nasty_curve(dim, domain);
    const Validity validity = check_validity(a, b);
    RC_ASSERT(validity.min_dot >= -1.0 && validity.min_dot <= validity.mean_dot + 1e-12);
    RC_ASSERT(validity.mean_dot <= 1.0 + 1e-12);
    RC_ASSERT(validity.valid_share >= 0.0 && validity.valid_share <= 1.0);
    RC_ASSERT(domain.contains(validity.worst_u));
    RC_ASSERT(!validity.valid || (validity.min_dot > 0.0 && validity.valid_share == 1.0));
    const int samples = 2003;
    double least = 1.0;
    for (int k = 0; k <= samples; ++k) {
      const double u = domain.lo + domain.length() * k / samples;
      const Points da = a.derivatives(u, 1);
      const Points db = b.derivatives(u, 1);
      const double speeds = std::sqrt(scalar_product(da[1], da[1]) * scalar_product(db[1], db[1]));
      if (speeds < 1e-6) continue;
      least = std::min(least, scalar_product(da[1], db[1]) / speeds);
    }
    // A minimum above zero is sharpened, not bounded; but no sign change is missed.
    RC_ASSERT(validity.min_dot <= 1e-12 || least > -1e-12);
    RC_ASSERT(validity.min_dot <= least + 0.1);
  }));
}

TEST(Validity, MakesEveryInBetweenLocallySimple) {
  // [C] Lemma 1: the projection of the in-between's derivative on the first curve's is positive.
  int valid = 0;
  EXPECT_TRUE(rc::check([&valid] {
    const int dim = *rc::gen::inRange(2, 4);
    const Curve a = tame_curve(dim);
    const Curve b = tame_curve(dim);
    const Validity validity = check_validity(a, b);
    if (validity.valid) ++valid;
    bool simple = true;
    for (int k = 0; k <= 300; ++k) {
      const Points da = a.derivatives(k / 300.0, 1);
      const Points db = b.derivatives(k / 300.0, 1);
      for (const double s : {0.0, 0.3, 0.5, 0.9, 0.999}) {
        double projection = 0.0;
        for (std::size_t c = 0; c < static_cast<std::size_t>(dim); ++c) {
          projection += ((1 - s) * da[1][c] + s * db[1][c]) * da[1][c];
        }
        simple = simple && projection > 0.0;
      }
    }
    if (validity.valid) RC_ASSERT(simple);
    // And where it is not valid, the place that is named shows it.
    const Points da = a.derivatives(validity.worst_u, 1);
    const Points db = b.derivatives(validity.worst_u, 1);
    const double speeds = std::sqrt(scalar_product(da[1], da[1]) * scalar_product(db[1], db[1]));
    RC_ASSERT(std::abs(scalar_product(da[1], db[1]) / speeds - validity.min_dot) <= 1e-9);
  }));
  EXPECT_GE(valid, 5);
}

TEST(Validity, MakesTheRuledSurfaceLocallySimple) {
  // Lemma 2, with the signed test: the Jacobian of (1-s) a + s b keeps its sign.
  int valid = 0;
  EXPECT_TRUE(rc::check([&valid] {
    const Curve a = tame_curve(2);
    Points raised = tame_curve(2).control_points();
    const double lift = *rc::gen::element(0.5, 2.0, 6.0);
    for (std::size_t i = 0; i < raised.size(); ++i) raised[i][1] += lift;
    const Curve b = Curve::clamped_uniform(2, raised);
    const Validity validity = check_validity(a, b, NormKind::ruled);
    // A tangent along a ruling is on either side of it by rounding.
    if (!validity.valid || validity.min_dot < 1e-9) return;
    ++valid;
    int sign = 0;
    for (int k = 0; k <= 300; ++k) {
      const Points da = a.derivatives(k / 300.0, 1);
      const Points db = b.derivatives(k / 300.0, 1);
      for (const double s : {0.0, 0.3, 0.5, 0.9, 1.0}) {
        const double x = (1 - s) * da[1][0] + s * db[1][0];
        const double y = (1 - s) * da[1][1] + s * db[1][1];
        // Where the curves meet the ruling has no length.
        if (std::abs(db[0][0] - da[0][0]) + std::abs(db[0][1] - da[0][1]) < 1e-12) continue;
        const double jacobian = (db[0][0] - da[0][0]) * y - (db[0][1] - da[0][1]) * x;
        const int here = jacobian > 0.0 ? 1 : -1;
        RC_ASSERT(sign == 0 || here == sign);
        sign = here;
      }
    }
  }));
  EXPECT_GE(valid, 5);
}

TEST(Validity, IsSymmetric) {
  EXPECT_TRUE(rc::check([] {
    const Interval domain{0.0, 1.0};
    const Curve a = nasty_curve(2, domain);
    const Curve b = nasty_curve(2, domain);
    for (const NormKind norm : {NormKind::tangent, NormKind::ruled}) {
      const Validity one = check_validity(a, b, norm);
      const Validity other = check_validity(b, a, norm);
      // Where the curves nearly meet, the direction of the short chord carries the rounding of the
      // coordinates.
      const double rounding = norm == NormKind::ruled ? 1e-9 : 1e-12;
      RC_ASSERT(std::abs(one.min_dot - other.min_dot) <= rounding);
      // A right angle is on either side of zero by rounding.
      RC_ASSERT(one.valid == other.valid || std::abs(one.min_dot) < rounding);
      RC_ASSERT(std::abs(one.valid_share - other.valid_share) <= rounding);
      RC_ASSERT(std::abs(one.mean_dot - other.mean_dot) <= rounding);
    }
  }));
}

TEST(Validity, SaysWhatIsWrong) {
  const Curve a = segment(0, 0, 1, 0);
  const Curve space = Curve::bezier({{0, 0, 0}, {1, 0, 0}});
  EXPECT_THROW((void)check_validity(a, space), InvalidArgument);
  EXPECT_THROW((void)check_validity(a, with_domain(a, {0, 2})), InvalidArgument);
}

}  // namespace
}  // namespace tandem
