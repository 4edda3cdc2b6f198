#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "figures/animals.h"
#include "morph/test_shapes.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/nearest_point.h"
#include "tandem/io/load.h"
#include "tandem/match/match.h"
#include "tandem/match/validity.h"
#include "tandem/morph/morph.h"

// What Figures 8, 11 and 13 of [C] show, on the curves of docs/figures (morph_figures.cpp draws them).

namespace tandem {
namespace {

using figures::digitised;
using figures::edited_deer;
using figures::paper_options;
using test::apart;
using test::wrapped;

Curve animal(const std::string& name) {
  return load_shape(std::string(TANDEM_EXAMPLE_DATA) + "/" + name + ".svg").contours.front();
}

/// Share of the length along which <T1, T2> > 0 when points go together by their parameters alone.
double naive_share(const Curve& a, const Curve& b) {
  return check_validity(a, with_domain(b, a.domain()), NormKind::tangent).valid_share;
}

/// How far from `there` on b the point of b is that belongs to the point of a nearest to `here`.
double miss(const Curve& a, const Curve& b, const Match& match, const Point& here, const Point& there) {
  const double u = nearest_point(a, here).parameter;
  const Correspondence& c = match.correspondence;
  const double lap = c.domain_u.length();
  double at = u;
  while (at < c.points.front().u) at += lap;
  return apart(b.evaluate(wrapped(c.v_at(at), b)), there);
}

double naive_miss(const Curve& a, const Curve& b, const Point& here, const Point& there) {
  const Interval u = a.domain();
  const Interval v = b.domain();
  const double share = (nearest_point(a, here).parameter - u.lo) / u.length();
  return apart(b.evaluate(v.lo + share * v.length()), there);
}

std::vector<Point> points_of(const Curve& curve) {
  std::vector<Point> points;
  for (int k = 0; k < 60; ++k) {
    points.push_back(curve.evaluate(curve.domain().lo + curve.domain().length() * k / 60.0));
  }
  return points;
}

// Shapes of 400 units: what belongs together, and how near it should get.
constexpr double kNear = 25.0;

TEST(Figures, Figure8FeaturesOfDifferentShapesFindEachOther) {
  const Curve camel = animal("camel");
  const Curve cheetah = animal("cheetah");
  const Match found = match(camel, cheetah, paper_options(100, 2, 20));
  EXPECT_GT(found.report.validity.valid_share, naive_share(camel, cheetah) + 0.2);
  // The mouth, and the tip of the tail.
  const Point mouth_a{388.0, 88.0};
  const Point mouth_b{395.0, 40.0};
  EXPECT_LT(miss(camel, cheetah, found, mouth_a, mouth_b), kNear);
  EXPECT_GT(naive_miss(camel, cheetah, mouth_a, mouth_b), 2.0 * kNear);
}

/// Root mean square distance of two correspondences, in shares of the second curve's domain.
double difference(const Match& x, const Match& y) {
  double sum = 0.0;
  constexpr int kSteps = 500;
  const double period = x.correspondence.domain_v.length();
  for (int k = 0; k < kSteps; ++k) {
    const Interval u = x.curve.domain();
    const double at = u.lo + u.length() * k / kSteps;
    const double gap =
        (x.reparametrization.v.evaluate(at)[0] - y.reparametrization.v.evaluate(at)[0]) / period;
    sum += (gap - std::round(gap)) * (gap - std::round(gap));
  }
  return std::sqrt(sum / kSteps);
}

TEST(Figures, Figure11FewerNodesAreRougher) {
  const Curve a = animal("cheetah");
  const Curve b = animal("hamster");
  const Match fine = match(a, b, paper_options(300, 2, 60));
  const Match hundred = match(a, b, paper_options(100, 2, 20));
  const Match smooth = match(a, b, paper_options(300, 3, 50));
  const Match coarse = match(a, b, paper_options(20, 2, 10));
  EXPECT_GT(hundred.report.validity.valid_share, 0.95);
  EXPECT_GT(smooth.report.validity.valid_share, 0.95);
  // Twenty nodes see a path without an invalid one, but it is not the one that more nodes find.
  EXPECT_EQ(coarse.report.invalid_nodes, 0);
  EXPECT_LT(coarse.report.validity.valid_share, 0.9 * hundred.report.validity.valid_share);
  EXPECT_GT(coarse.report.validity.valid_share, naive_share(a, b));
  EXPECT_LT(difference(fine, hundred), 0.03);
  EXPECT_LT(difference(fine, smooth), 0.03);
  EXPECT_GT(difference(fine, coarse), 0.1);
}

TEST(Figures, Figure13AnEditedOutlineMovesOnlyWhereItWasEdited) {
  const Curve deer = animal("deer");
  const Curve a = digitised(edited_deer(deer, 0.5, 0.0));
  const Curve b = digitised(deer);
  const Match found = match(a, b, paper_options(100, 2, 20));
  const Shape half = Morph(a, b, found).at(0.5);
  // Below the antlers both outlines are the same: so are the in-betweens.
  double off = 0.0;
  double off_naive = 0.0;
  for (int k = 0; k < 100; ++k) {
    const double t = k / 100.0;
    const Point p = half.contours.front().evaluate(t);
    if (p[1] > 110.0) off = std::max(off, nearest_point(b, p).distance);
    const Point x = a.evaluate(t);
    const Point y = b.evaluate(t);
    const Point q{0.5 * (x[0] + y[0]), 0.5 * (x[1] + y[1])};
    if (q[1] > 110.0) off_naive = std::max(off_naive, nearest_point(b, q).distance);
  }
  EXPECT_LT(off, 0.1 * off_naive);
}

TEST(Figures, Figure13KeyFramesPassThroughEveryKey) {
  const Curve deer = animal("deer");
  std::vector<Shape> keys;
  for (const auto& [antlers, stride] : {std::pair(0.5, 0.0), std::pair(1.0, 0.0), std::pair(1.0, -0.5)}) {
    keys.push_back({{digitised(edited_deer(deer, antlers, stride))}});
  }
  MorphOptions options;
  options.match = paper_options(100, 2, 20);
  options.match.rotate = false;
  const Morph morph(keys, options);
  for (std::size_t key = 0; key < 3; ++key) {
    const Curve now = morph.at(static_cast<double>(key) / 2.0).contours.front();
    for (const Point& p : points_of(now)) {
      EXPECT_LT(nearest_point(keys[key].contours.front(), p).distance, 1e-6);
    }
  }
  // Consistent (spec C14): a point of the nose stays on the nose all the way.
  const double nose = nearest_point(keys[0].contours.front(), Point{39.5, 86.0}).parameter;
  for (const double s : {0.0, 0.3, 0.5, 0.7, 1.0}) {
    EXPECT_LT(apart(morph.at(s).contours.front().evaluate(nose), {42.0, 86.0}), 15.0) << s;
  }
}

}  // namespace
}  // namespace tandem
