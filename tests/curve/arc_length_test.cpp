#include "tandem/curve/arc_length.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "curve/random_curves.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using testing::RandomCurves;

Curve quarter_circle() {
  return Curve::bezier(Points({{1, 0}, {1, 1}, {0, 1}}), {1, std::sqrt(0.5), 1});
}

// Length of the parabola (t, t^2) from 0 to t.
double parabola_length(double t) {
  return 0.5 * t * std::sqrt(1 + 4 * t * t) + 0.25 * std::asinh(2 * t);
}

TEST(ArcLength, ClosedForms) {
  EXPECT_NEAR(arc_length(quarter_circle()), std::numbers::pi / 2, 1e-10);
  const Curve parabola = Curve::bezier(Points({{0, 0}, {0.5, 0}, {1, 1}}));
  for (const double accuracy : {1e-3, 1e-6, 1e-10, 1e-14}) {
    const ArcLength length(parabola, accuracy);
    for (int i = 0; i <= 20; ++i) {
      EXPECT_NEAR(length.length_to(i / 20.0), parabola_length(i / 20.0), accuracy * 1.5 + 1e-15);
    }
  }
  EXPECT_NEAR(arc_length(Curve::bezier(Points({{0, 0, 0}, {1, 2, 2}}))), 3.0, 1e-15);
}

TEST(ArcLength, CuspAndTurningBack) {
  // (t^2, t^3) over [-1, 1]: a cusp in the middle; each half has length (13 sqrt(13) - 8) / 27.
  const Curve cusp = Curve::bezier(Points({{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}), {}, {-1, 1});
  const ArcLength length(cusp);
  const double half = (13 * std::sqrt(13.0) - 8) / 27;
  EXPECT_NEAR(length.length(), 2 * half, 1e-10);
  EXPECT_NEAR(length.parameter_at(half), 0.0, 1e-5);  // the length grows with t^2 there
  // There and back on a line: 3 t (1 - t) / 3, up to 1/4 and down again.
  EXPECT_NEAR(arc_length(Curve::bezier(Points({{0.0}, {0.5}, {0.0}}))), 0.5, 1e-10);
}

TEST(ArcLength, InverseIsTheInverse) {
  RandomCurves random(40);
  for (int i = 0; i < 100; ++i) {
    const Curve curve = random.any(random.integer(1, 3));
    const ArcLength length(curve);
    EXPECT_EQ(length.parameter_at(0.0), curve.domain().lo);
    EXPECT_EQ(length.parameter_at(length.length()), curve.domain().hi);
    double before = curve.domain().lo;
    for (int k = 1; k < 40; ++k) {
      const double s = length.length() * k / 40;
      const double t = length.parameter_at(s);
      EXPECT_GT(t, before);
      before = t;
      EXPECT_NEAR(length.length_to(t), s, 1e-10 * length.length());
    }
  }
}

TEST(ArcLength, AddsUpOverParts) {
  RandomCurves random(41);
  for (int i = 0; i < 50; ++i) {
    const Curve curve = random.any(2);
    const ArcLength length(curve);
    const double t = random.uniform(curve.domain().lo, curve.domain().hi);
    EXPECT_NEAR(arc_length(split(curve, t).left), length.length_to(t), 2e-10 * length.length());
    EXPECT_NEAR(arc_length(reverse(curve)), length.length(), 2e-10 * length.length());
  }
}

TEST(ArcLength, StandingStillTakesTheFirstParameter) {
  const Curve dwell(1, {0, 0, 1, 2, 3, 3}, Points({{0, 0}, {1, 0}, {1, 0}, {1, 1}}));
  const ArcLength length(dwell);
  EXPECT_EQ(length.length(), 2.0);
  EXPECT_EQ(length.parameter_at(1.0), 1.0);
  EXPECT_EQ(length.length_to(1.7), 1.0);
  EXPECT_NEAR(length.parameter_at(1.5), 2.5, 1e-15);
  const Curve late(1, {0, 0, 1, 2, 2}, Points({{0, 0}, {1, 0}, {1, 0}}));
  EXPECT_EQ(ArcLength(late).parameter_at(1.0), 1.0);
  EXPECT_EQ(ArcLength(late).length_to(2.0), 1.0);
}

TEST(ArcLength, OfAPointIsZero) {
  const ArcLength length(Curve::bezier(Points({{2, 2}, {2, 2}, {2, 2}}), {}, {5, 7}));
  EXPECT_EQ(length.length(), 0.0);
  EXPECT_EQ(length.parameter_at(0.0), 5.0);
  EXPECT_EQ(length.parameter_at(1.0), 5.0);  // the whole of it is reached at once
}

TEST(ArcLength, HugeTinyAndFarOff) {
  for (const double size : {1e300, 1e-300}) {
    const Curve arc =
        Curve::bezier(Points({{size, 0}, {size, size}, {0, size}}), {1, std::sqrt(0.5), 1}, {1e6, 1e6 + 1});
    const ArcLength length(arc);
    EXPECT_NEAR(length.length() / size, std::numbers::pi / 2, 1e-10);
    EXPECT_NEAR(length.parameter_at(length.length() / 2), 1e6 + 0.5, 1e-9);
  }
}

// Composite midpoint rule over each span, Richardson-extrapolated: slow, and good to some 1e-11 on smooth
// curves.
double brute_force(const Curve& curve) {
  double total = 0.0;
  for (const Curve& piece : bezier_segments(curve)) {
    const Interval domain = piece.domain();
    std::vector<double> estimates;
    for (int n = 512; n <= 4096; n *= 2) {
      double sum = 0.0;
      for (int i = 0; i < n; ++i) {
        const double t = domain.lo + domain.length() * (i + 0.5) / n;
        sum += testing::norm(piece.derivatives(t, 1)[1]);
      }
      estimates.push_back(sum * domain.length() / n);
    }
    for (double factor = 4.0; estimates.size() > 1; factor *= 4.0) {
      for (std::size_t i = 0; i + 1 < estimates.size(); ++i) {
        estimates[i] = (factor * estimates[i + 1] - estimates[i]) / (factor - 1.0);
      }
      estimates.pop_back();
    }
    total += estimates[0];
  }
  return total;
}

TEST(ArcLength, AgreesWithBruteForceWithinTheAccuracy) {
  RandomCurves random(42);
  for (int i = 0; i < 20; ++i) {
    const Curve curve = random.curve(random.integer(1, 5), random.integer(2, 4), 2, i % 2 == 0, true);
    const double expected = brute_force(curve);
    for (const double accuracy : {1e-4, 1e-9}) {
      EXPECT_NEAR(arc_length(curve, accuracy), expected, accuracy * expected);
    }
  }
}

TEST(ArcLength, NearCusps) {
  // (t^2 + e, t^3 + e t): closer and closer to a cusp; the accuracy holds against a much stricter one.
  for (const double e : {1e-2, 1e-4, 1e-6, 1e-8, 1e-12}) {
    const Curve curve = Curve::bezier(
        Points({{1, -1 - e}, {-1.0 / 3, 1 - e / 3}, {-1.0 / 3, -1 + e / 3}, {1, 1 + e}}), {}, {-1, 1});
    const double exact = arc_length(curve, 1e-15);
    EXPECT_NEAR(arc_length(curve, 1e-10), exact, 1e-10 * exact);
    const ArcLength length(curve);
    for (int k = 0; k <= 100; ++k) {
      const double s = length.length() * k / 100;
      EXPECT_NEAR(length.length_to(length.parameter_at(s)), s, 1e-10 * length.length());
    }
  }
}

TEST(ArcLength, VeryHighDegree) {
  Points points(2, 1100);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i][0] = static_cast<double>(i);
    points[i][1] = 2.0 * static_cast<double>(i);
  }
  // A straight line at constant speed, beyond the degrees whose binomial coefficients fit into a double.
  EXPECT_NEAR(arc_length(Curve::bezier(points), 1e-6), 1099 * std::sqrt(5.0), 1e-6);
}

TEST(ArcLength, RefusesNonsense) {
  EXPECT_THROW(ArcLength(quarter_circle(), 0.0), InvalidArgument);
  EXPECT_THROW(ArcLength(quarter_circle(), -1.0), InvalidArgument);
  EXPECT_THROW(ArcLength(quarter_circle(), NAN), InvalidArgument);
}

}  // namespace
}  // namespace tandem
