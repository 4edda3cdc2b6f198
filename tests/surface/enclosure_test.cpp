#include "surface/enclosure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "planar_pairs.h"
#include "surface/bernstein_enclosure.h"
#include "surface/enclosed_spline.h"

namespace tandem {
namespace {

using detail::Enclosure;
using detail::Enclosures;

// long double holds sums of doubles of like size exactly, and of everything else 11 digits more than double.
class Doubles {
 public:
  explicit Doubles(unsigned seed) : random_(seed) {}

  double next() {
    const int exponent = static_cast<int>(random_() % 40) - 20;
    const double x = std::ldexp(static_cast<double>(random_()) * 0x1p-32 + 0.5, exponent);
    switch (random_() % 8) {
      case 0:
        return 0.0;
      case 1:
        return std::round(x);
      default:
        return random_() % 2 == 0 ? x + 0x1p-40 : -x - 0x1p-50 * x;
    }
  }

 private:
  std::mt19937 random_;
};

void expect_enclosed(const Enclosure& e, long double exact) {
  EXPECT_LE(e.lo, exact);
  EXPECT_GE(e.hi, exact);
  // Not wider than four ulps: the ends are moved by one or two.
  EXPECT_LE(e.hi - e.lo, 4.0L * std::numeric_limits<double>::epsilon() * std::abs(exact) + 1e-300L);
}

TEST(Enclosure, HoldsTheExactResult) {
  Doubles doubles(1);
  for (int i = 0; i < 20000; ++i) {
    const double x = doubles.next();
    const double y = doubles.next();
    const auto lx = static_cast<long double>(x);
    expect_enclosed(Enclosure(x) + y, lx + y);
    expect_enclosed(Enclosure(x) - y, lx - y);
    expect_enclosed(Enclosure(x) * y, lx * y);
    if (y > 0.0) expect_enclosed(Enclosure(x) / Enclosure(y), lx / y);
    // Exact sums stay exact (long double knows whether they are if it holds the sum).
    const bool alike = x != 0.0 && y != 0.0 && std::abs(std::ilogb(x) - std::ilogb(y)) < 10;
    if (alike && static_cast<long double>(x + y) == lx + y) {
      const Enclosure sum = Enclosure(x) + y;
      EXPECT_EQ(sum.lo, sum.hi);
    }
  }
}

TEST(Enclosure, OfIntervalsHoldsAllThatIsMadeOfTheirMembers) {
  Doubles doubles(2);
  for (int i = 0; i < 5000; ++i) {
    const double a = doubles.next();
    const double b = doubles.next();
    const double c = doubles.next();
    const double d = doubles.next();
    const Enclosure x(std::min(a, b), std::max(a, b));
    const Enclosure y(std::min(c, d), std::max(c, d));
    const Enclosure product = x * y;
    const Enclosure difference = x - y;
    for (const double p : {x.lo, x.middle(), x.hi}) {
      for (const double q : {y.lo, y.middle(), y.hi}) {
        EXPECT_LE(product.lo, static_cast<long double>(p) * q);
        EXPECT_GE(product.hi, static_cast<long double>(p) * q);
        EXPECT_LE(difference.lo, static_cast<long double>(p) - q);
        EXPECT_GE(difference.hi, static_cast<long double>(p) - q);
        if (!y.is_positive()) continue;
        const Enclosure quotient = x / y;
        EXPECT_LE(quotient.lo, static_cast<long double>(p) / q);
        EXPECT_GE(quotient.hi, static_cast<long double>(p) / q);
      }
    }
  }
}

TEST(Enclosure, ProvesNothingBeyondTheRangeOfDouble) {
  const Enclosure huge(1e300);
  const Enclosure nothing = huge * huge - huge * huge;
  EXPECT_FALSE(nothing.is_positive() || nothing.is_negative() || nothing.is_zero());
  EXPECT_FALSE((Enclosure(1.0) / Enclosure(-1.0, 1.0)).is_positive());
  const Enclosure tiny = Enclosure(1e-200) * Enclosure(1e-200);
  EXPECT_FALSE(tiny.is_zero());
  EXPECT_LE(tiny.lo, 0.0);
  EXPECT_GT(tiny.hi, 0.0);
  EXPECT_TRUE((Enclosure(0.0) * Enclosure(-1.0, 1.0)).is_zero());
}

// Value of a polynomial by its Bernstein coefficients.
long double value(const Enclosures& f, long double t) {
  std::vector<long double> c;
  for (const Enclosure& x : f) c.push_back(x.middle());
  for (std::size_t r = c.size() - 1; r > 0; --r) {
    for (std::size_t i = 0; i < r; ++i) c[i] = (1 - t) * c[i] + t * c[i + 1];
  }
  return c[0];
}

TEST(BernsteinEnclosure, MultipliesElevatesAndDivides) {
  Doubles doubles(3);
  for (std::size_t m = 0; m < 6; ++m) {
    Enclosures f(m + 1);
    Enclosures g(4);
    for (Enclosure& x : f) x = doubles.next();
    for (Enclosure& x : g) x = doubles.next();
    g.front() = 0.0;
    const Enclosures fg = detail::product(f, g);
    ASSERT_EQ(fg.size(), m + 4);
    for (const long double t : {0.0L, 0.125L, 0.3L, 0.9L, 1.0L}) {
      const long double exact = value(f, t) * value(g, t);
      EXPECT_NEAR(static_cast<double>(value(fg, t) - exact), 0.0,
                  1e-12 * (1.0 + std::abs(static_cast<double>(exact))));
      EXPECT_NEAR(static_cast<double>(value(detail::elevated(g, 7), t) - value(g, t)), 0.0, 1e-8);
      EXPECT_NEAR(static_cast<double>(t * value(detail::without_zero_at_0(g), t) - value(g, t)), 0.0, 1e-8);
      const auto [left, right] = detail::halves(f);
      EXPECT_NEAR(static_cast<double>(value(left, t) - value(f, t / 2)), 0.0, 1e-8);
      EXPECT_NEAR(static_cast<double>(value(right, t) - value(f, (1 + t) / 2)), 0.0, 1e-8);
    }
  }
  EXPECT_EQ(detail::common_sign({1.0, 0.0, Enclosure(1.0, 2.0)}), 1);
  EXPECT_EQ(detail::common_sign({-1.0, 0.0}), -1);
  EXPECT_EQ(detail::common_sign({0.0, 0.0}), 0);
  EXPECT_EQ(detail::common_sign({1.0, Enclosure(0.0, 1.0)}), 0);
}

TEST(EnclosedSpline, HoldsPointsAndDerivativesOfAnyPart) {
  testing::RandomCurves random(4);
  for (int i = 0; i < 200; ++i) {
    const Curve curve = random.curve(random.integer(1, 6), 2, random.integer(1, 6), false, i % 2 == 0);
    const detail::Frame frame{{0.0, 0.0}, 0};
    const detail::EnclosedSpline spline(
        curve.degree(), curve.knots(),
        detail::homogeneous(curve.control_points(), curve.weights(), false, frame), 2);
    const std::vector<double> breaks = spline.breaks();
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
      const double at = breaks[k] + random.uniform(0.1, 0.9) * (breaks[k + 1] - breaks[k]);
      const Interval part{breaks[k], at};
      const Enclosures points = spline.bezier(part);
      const Enclosures speeds = spline.hodograph(part);
      const auto exact = testing::LongCurve(curve).at(at);
      // long double rounds, too: a few of its own ulps of slack.
      const long double slack = 1e-17L * (1 + std::abs(exact.d[0]) + std::abs(exact.d[1]));
      const long double factor = (static_cast<long double>(part.hi) - part.lo) / curve.degree();
      for (std::size_t c = 0; c < 2; ++c) {
        const Enclosure& point = points[points.size() - 2 + c];
        const Enclosure& speed = speeds[speeds.size() - 2 + c];
        EXPECT_LE(point.lo, exact.p[c] + slack);
        EXPECT_GE(point.hi, exact.p[c] - slack);
        EXPECT_LE(point.hi - point.lo, 1e-13);
        EXPECT_LE(speed.lo, factor * exact.d[c] + slack);
        EXPECT_GE(speed.hi, factor * exact.d[c] - slack);
        EXPECT_LE(speed.hi - speed.lo, 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace tandem
