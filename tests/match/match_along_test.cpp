#include "match/match_along.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "match/random_curves.h"
#include "tandem/curve/edit.h"

namespace tandem {
namespace {

using detail::inverse_match;
using detail::match_along;
using testing_curves::closed_curve;
using testing_curves::open_curve;

void expect_near(const std::vector<double>& x, const std::vector<double>& y) {
  ASSERT_EQ(x.size(), y.size());
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], y[i], 1e-12);
}

void expect_same(const Match& x, const Match& y, const Curve& a) {
  EXPECT_EQ(x.report.direction, y.report.direction);
  EXPECT_EQ(x.report.samples, y.report.samples);
  EXPECT_EQ(x.reparametrization.reversed, y.reparametrization.reversed);
  expect_near(x.samples_a.parameters, y.samples_a.parameters);
  expect_near(x.samples_b.parameters, y.samples_b.parameters);
  EXPECT_NEAR(x.report.validity.valid_share, y.report.validity.valid_share, 1e-6);
  for (std::size_t k = 0; k < x.report.rotation.size(); ++k) {
    EXPECT_NEAR(x.report.rotation[k], y.report.rotation[k], 1e-12);
  }
  ASSERT_EQ(x.curve.domain(), y.curve.domain());
  for (int k = 0; k <= 50; ++k) {
    const double u = a.domain().lo + a.domain().length() * k / 50.0;
    const double off = x.correspondence.v_at(u) - y.correspondence.v_at(u);
    const double period = x.correspondence.domain_v.length();
    EXPECT_NEAR(x.correspondence.closed ? std::remainder(off, period) : off, 0.0, 1e-9);
    const Point p = x.curve.evaluate(u);
    const Point q = y.curve.evaluate(u);
    EXPECT_LE(std::hypot(p[0] - q[0], p[1] - q[1]), 1e-6) << u;
  }
}

TEST(MatchAlong, ItsOwnCorrespondenceIsTheMatch) {
  std::mt19937 random(11);
  for (int n = 0; n < 8; ++n) {
    const bool closed = n % 2 == 0;
    const Curve a = closed ? closed_curve(random) : open_curve(random);
    const Curve b = closed ? closed_curve(random) : open_curve(random);
    const Match found = match(a, b, {.samples = {48, 48}});
    expect_same(match_along(a, b, {}, found, found.correspondence), found, a);
  }
}

// The whole match follows, not the correspondence alone.
TEST(MatchAlong, FollowsTheCorrespondence) {
  std::mt19937 random(12);
  const Curve a = open_curve(random);
  const Curve b = open_curve(random);
  const Match found = match(a, b, {.samples = {48, 48}});
  Correspondence along = found.correspondence;
  along.reversed = false;
  along.points = {{0.0, 0.0}, {0.3, 0.6}, {1.0, 1.0}};
  const Match made = match_along(a, b, {}, found, along);
  const Point p = made.curve.evaluate(0.3);
  const Point q = b.evaluate(0.6);
  EXPECT_NEAR(p[0], q[0], 1e-9);
  EXPECT_NEAR(p[1], q[1], 1e-9);
  EXPECT_NEAR(made.reparametrization.v.evaluate(0.15)[0], 0.3, 1e-9);
}

TEST(InverseMatch, IsWhatMatchingTheOtherWayRoundFinds) {
  std::mt19937 random(13);
  for (int n = 0; n < 12; ++n) {
    const bool closed = n % 3 == 0;
    const Curve a = closed ? closed_curve(random) : open_curve(random);
    const Curve given = closed ? closed_curve(random) : open_curve(random);
    const Curve b = n % 2 == 0 ? given : reverse(given);
    MatchOptions options{.samples = {48, 48}};
    if (closed) options.direction = Direction::forward;
    if (n > 8) options.rotation = {0.8, 0.6};
    const Match there = match(a, b, options);
    MatchOptions back = options;
    if (n > 8) back.rotation = {0.8, -0.6};
    expect_same(inverse_match(a, b, options, there), match(b, a, back), b);
  }
}

}  // namespace
}  // namespace tandem
