#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "morph/test_shapes.h"
#include "tandem/morph/path_morph.h"
#include "tandem/shape/transform.h"

namespace tandem {
namespace {

using test::any_outline;
using test::one;

std::vector<double> coordinates(const PathMorph& morph, double s) {
  std::vector<double> all(morph.coordinate_count());
  morph.at(s, all);
  return all;
}

double largest_difference(const std::vector<double>& p, const std::vector<double>& q) {
  EXPECT_EQ(p.size(), q.size());
  double most = 0.0;
  for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i)
    most = std::max(most, std::fabs(p[i] - q[i]));
  return most;
}

// How far the way back is from the way there.
double asymmetry(const PathMorph& morph) {
  double most = 0.0;
  for (const double s : {0.0, 0.07, 0.2, 0.31, 0.45, 0.5}) {
    most = std::max(most, largest_difference(coordinates(morph, s), coordinates(morph, 1.0 - s)));
  }
  return most;
}

Shape moved(const Curve& curve, double x, double y, double size = 1.0) {
  return one(transform(curve, Transform{size, 0.0, 0.0, size, x, y}));
}

Shape with(Shape shape, const Shape& more) {
  shape.contours.insert(shape.contours.end(), more.contours.begin(), more.contours.end());
  return shape;
}

constexpr BlendKind kKinds[] = {BlendKind::affine, BlendKind::hermite, BlendKind::intrinsic,
                                BlendKind::similarity, BlendKind::automatic};

RC_GTEST_PROP(Palindrome, ThereAndBackAgainIsTheSameWay, ()) {
  const Shape a = one(any_outline());
  const Shape b = one(transform(any_outline(), Transform::rotate_degrees(*rc::gen::inRange(0, 60))));
  MorphOptions options;
  options.match.samples = {40, 40};
  options.blend = *rc::gen::elementOf(std::vector<BlendKind>(std::begin(kKinds), std::end(kKinds)));
  options.smooth = *rc::gen::arbitrary<bool>();
  const PathMorph morph(std::vector<Shape>{a, b, a}, options);
  RC_ASSERT(asymmetry(morph) <= 1e-9);
}

RC_GTEST_PROP(Palindrome, OverMoreKeysToo, ()) {
  const Shape a = one(any_outline());
  const Shape b = one(any_outline());
  const Shape c = one(any_outline());
  MorphOptions options;
  options.match.samples = {40, 40};
  options.blend = BlendKind::affine;
  RC_ASSERT(asymmetry(PathMorph(std::vector<Shape>{a, b, c, b, a}, options)) <= 1e-9);
  RC_ASSERT(asymmetry(PathMorph(std::vector<Shape>{a, b, a, b, a}, options)) <= 1e-9);
  const PathMorph twice(std::vector<Shape>{a, b, a, b}, options);
  for (const double s : {0.0, 0.1, 0.3}) {
    RC_ASSERT(largest_difference(coordinates(twice, s), coordinates(twice, s + 2.0 / 3.0)) <= 1e-9);
  }
}

// A contour that dies comes back as the same one, with or without a detour of another one around it.
TEST(Palindrome, ContoursComeAndGo) {
  const Curve shape = test::blob(3, 0.0);
  const Shape a = with(moved(shape, 0, 0), moved(shape, 14, 0, 0.5));
  const Shape b = moved(test::blob(5, 0.0), 3, 0);
  const Shape c = with(moved(shape, 0, 0), with(moved(shape, 0, 14, 0.5), moved(shape, 14, 14, 0.7)));
  MorphOptions options;
  options.cuts = false;
  for (const auto& keys : {std::vector{a, b, a}, std::vector{b, a, b}, std::vector{a, b, c, b, a},
                           std::vector{b, c, a, c, b}, std::vector{c, a, c, a, c}}) {
    const PathMorph morph(keys, options);
    EXPECT_LE(asymmetry(morph), 1e-9);
    std::size_t most = 0;
    for (const Shape& key : keys) most = std::max(most, key.contours.size());
    if (keys.size() == 3) {
      EXPECT_EQ(morph.contours().size(), most);
    }
    const std::vector<MorphStep>& steps = morph.steps();
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const MorphStep& back = steps[steps.size() - 1 - k];
      EXPECT_EQ(steps[k].detour, back.detour);
      for (std::size_t t = 0; t < back.contours.size(); ++t) {
        EXPECT_EQ(steps[k].contours[t].a, back.contours[t].b);
        EXPECT_EQ(steps[k].contours[t].b, back.contours[t].a);
        ASSERT_EQ(steps[k].contours[t].match.has_value(), back.contours[t].match.has_value());
        if (!back.contours[t].match) continue;
        EXPECT_EQ(steps[k].contours[t].match->correspondence.points.size(),
                  back.contours[t].match->correspondence.points.size());
      }
    }
  }
}

TEST(Palindrome, TurnsBack) {
  const Curve bar = to_curve(CubicPath(to_cubic_path(test::blob(3, 0.0), 1e-6)));
  const Shape a = one(transform(bar, Transform{2.0, 0.0, 0.0, 0.4, 0.0, 0.0}));
  const Shape b = one(transform(a.contours.front(), Transform::rotate_degrees(60.0)));
  MorphOptions options;
  options.match.rotate = true;
  const PathMorph morph(std::vector<Shape>{a, b, a}, options);
  EXPECT_NEAR(morph.poses()[1].degrees, 60.0, 1.0);
  EXPECT_EQ(morph.poses()[2].degrees, 0.0);
  EXPECT_LE(asymmetry(morph), 1e-9);
}

}  // namespace
}  // namespace tandem
