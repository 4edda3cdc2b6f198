#include "tandem/match/correspondence.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "match/paths.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using testing::any_correspondence;

double largest(const Interval& domain) {
  return std::max({std::abs(domain.lo), std::abs(domain.hi), domain.length()});
}

TEST(Correspondence, InterpolatesLinearly) {
  const Correspondence c{{{0, 10}, {1, 12}, {4, 13}}, {0, 4}, {10, 13}, false, false};
  EXPECT_DOUBLE_EQ(c.v_at(0.5), 11.0);
  EXPECT_DOUBLE_EQ(c.v_at(2.5), 12.5);
  EXPECT_DOUBLE_EQ(c.u_at(11.0), 0.5);
  EXPECT_DOUBLE_EQ(c.u_at(12.5), 2.5);
  EXPECT_EQ(c.v_at(1.0), 12.0);
}

TEST(Correspondence, ClampsWhenOpen) {
  const Correspondence c{{{0, 10}, {4, 13}}, {0, 4}, {10, 13}, false, false};
  EXPECT_EQ(c.v_at(-1.0), 10.0);
  EXPECT_EQ(c.v_at(5.0), 13.0);
  EXPECT_EQ(c.u_at(9.0), 0.0);
  EXPECT_EQ(c.u_at(1e300), 4.0);
}

TEST(Correspondence, TakesTheMiddleOfAJump) {
  // Up at u = 1, standing still from u = 1 to 3.
  const Correspondence c{{{0, 0}, {1, 1}, {1, 1.5}, {1, 4}, {3, 4}, {4, 5}}, {0, 4}, {0, 5}, false, false};
  EXPECT_EQ(c.v_at(1.0), 2.5);
  EXPECT_EQ(c.u_at(4.0), 2.0);
  EXPECT_EQ(c.u_at(2.0), 1.0);
  EXPECT_EQ(c.v_at(2.0), 4.0);
}

TEST(Correspondence, RunsBackwardsWhenReversed) {
  const Correspondence c{{{0, 5}, {1, 4}, {1, 2}, {2, 0}}, {0, 2}, {0, 5}, false, true};
  EXPECT_EQ(c.v_at(0.5), 4.5);
  EXPECT_EQ(c.v_at(1.0), 3.0);
  EXPECT_EQ(c.u_at(4.5), 0.5);
  EXPECT_EQ(c.u_at(3.0), 1.0);
  EXPECT_EQ(c.u_at(1.0), 1.5);
}

TEST(Correspondence, RunsOnPeriodByPeriodWhenClosed) {
  const Correspondence c{{{0.25, 3}, {0.5, 7}, {1.25, 13}}, {0, 1}, {0, 10}, true, false};
  EXPECT_DOUBLE_EQ(c.v_at(0.375), 5.0);
  EXPECT_DOUBLE_EQ(c.v_at(0.375 + 2), 25.0);
  EXPECT_DOUBLE_EQ(c.v_at(0.375 - 3), -25.0);
  EXPECT_DOUBLE_EQ(c.v_at(0.25), 3.0);
  EXPECT_DOUBLE_EQ(c.v_at(1.25), 13.0);
  EXPECT_DOUBLE_EQ(c.u_at(5.0), 0.375);
  EXPECT_DOUBLE_EQ(c.u_at(25.0), 2.375);
  const Correspondence back{{{0.25, 3}, {0.5, -1}, {1.25, -7}}, {0, 1}, {0, 10}, true, true};
  EXPECT_DOUBLE_EQ(back.v_at(0.375), 1.0);
  EXPECT_DOUBLE_EQ(back.v_at(1.375), -9.0);
  EXPECT_DOUBLE_EQ(back.u_at(1.0), 0.375);
  EXPECT_DOUBLE_EQ(back.u_at(-9.0), 1.375);
}

TEST(Correspondence, TakesTheMiddleOfAJumpAtTheSeam) {
  // The jump at u = 0 (mod 1) leads from 8 - 10 = -2 to 2.
  const Correspondence c{{{0, 0}, {0, 2}, {0.5, 5}, {1, 8}, {1, 10}}, {0, 1}, {0, 10}, true, false};
  EXPECT_DOUBLE_EQ(c.v_at(0.0), 0.0);
  EXPECT_DOUBLE_EQ(c.v_at(1.0), 10.0);
  const Correspondence lopsided{{{0, 1}, {0, 2}, {0.5, 5}, {1, 8}, {1, 11}}, {0, 1}, {0, 10}, true, false};
  EXPECT_DOUBLE_EQ(lopsided.v_at(0.0), 0.0);
  EXPECT_DOUBLE_EQ(lopsided.v_at(3.0), 30.0);
}

TEST(Correspondence, SaysWhatIsMissing) {
  EXPECT_THROW((void)Correspondence{}.v_at(0.5), InvalidArgument);
  EXPECT_THROW((void)Correspondence{}.u_at(0.5), InvalidArgument);
  EXPECT_TRUE(Correspondence{}.inverse().points.empty());
}

TEST(Correspondence, SurvivesHostileParameters) {
  const Correspondence one{{{0.5, 0.25}}, {0, 1}, {0, 1}, true, false};
  EXPECT_EQ(one.v_at(0.5), 0.25);
  EXPECT_EQ(one.v_at(2.5), 2.25);
  const Correspondence c{{{0, 0}, {1, 1}}, {0, 1}, {0, 1}, true, false};
  EXPECT_EQ(c.v_at(1e300), 1e300);
  EXPECT_NO_THROW((void)c.v_at(std::numeric_limits<double>::quiet_NaN()));
  const Correspondence point{{{0, 0}, {0, 0}}, {0, 0}, {0, 0}, true, false};
  EXPECT_EQ(point.v_at(3.0), 0.0);
}

TEST(Correspondence, InverseOfTheInverseIsTheSame) {
  EXPECT_TRUE(rc::check([] {
    const Correspondence c = any_correspondence();
    const Correspondence twice = c.inverse().inverse();
    RC_ASSERT(twice.points == c.points);
    RC_ASSERT(twice.domain_u == c.domain_u);
    RC_ASSERT(twice.domain_v == c.domain_v);
    RC_ASSERT(twice.closed == c.closed && twice.reversed == c.reversed);
  }));
}

TEST(Correspondence, InverseKeepsTheContract) {
  EXPECT_TRUE(rc::check([] {
    const Correspondence c = any_correspondence();
    const Correspondence inverse = c.inverse();
    for (std::size_t i = 1; i < inverse.points.size(); ++i) {
      RC_ASSERT(inverse.points[i].u >= inverse.points[i - 1].u);
      const double step = inverse.points[i].v - inverse.points[i - 1].v;
      RC_ASSERT((c.reversed ? -step : step) >= 0.0);
    }
    if (c.closed) {
      const ParameterPair first = inverse.points.front();
      const ParameterPair last = inverse.points.back();
      const double du = inverse.domain_u.length();
      const double dv = c.reversed ? -inverse.domain_v.length() : inverse.domain_v.length();
      RC_ASSERT(std::abs(last.u - first.u - du) <= 1e-14 * largest(inverse.domain_u) * 8);
      RC_ASSERT(std::abs(last.v - first.v - dv) <= 1e-14 * largest(inverse.domain_v) * 8);
    }
  }));
}

TEST(Correspondence, InverseAnswersTheOtherQuestion) {
  EXPECT_TRUE(rc::check([] {
    const Correspondence c = any_correspondence();
    const Correspondence inverse = c.inverse();
    const double share = *rc::gen::inRange(-20, 41) / 20.0;
    const double v = c.domain_v.lo + share * c.domain_v.length();
    const double u = c.domain_u.lo + share * c.domain_u.length();
    RC_ASSERT(std::abs(c.u_at(v) - inverse.v_at(v)) <= 1e-9 * c.domain_u.length());
    RC_ASSERT(std::abs(c.v_at(u) - inverse.u_at(u)) <= 1e-9 * c.domain_v.length());
  }));
}

TEST(Correspondence, IsMonotoneAndPassesThroughItsPoints) {
  EXPECT_TRUE(rc::check([] {
    const Correspondence c = any_correspondence();
    double previous = 0.0;
    for (int k = 0; k <= 100; ++k) {
      const double u = c.domain_u.lo + (k / 50.0 - 0.5) * c.domain_u.length();
      const double v = c.v_at(u);
      const double rounding = 1e-13 * largest(c.domain_v);
      if (k > 0) RC_ASSERT((c.reversed ? previous - v : v - previous) >= -rounding);
      previous = v;
    }
    for (std::size_t i = 1; i + 1 < c.points.size(); ++i) {
      const bool alone = c.points[i - 1].u < c.points[i].u && c.points[i].u < c.points[i + 1].u;
      if (alone && !c.closed) RC_ASSERT(c.v_at(c.points[i].u) == c.points[i].v);
    }
  }));
}

}  // namespace
}  // namespace tandem
