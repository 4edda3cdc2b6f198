#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tandem/morph/path_morph.h"
#include "tandem/morph/quality.h"
#include "tandem/shape/path_builder.h"

namespace tandem {
namespace {

constexpr double kLength = 10.0;

Shape shape_of(PathBuilder builder) {
  const std::vector<CubicPath> paths = builder.take();
  return to_shape(paths);
}

Shape straight_arm() {
  PathBuilder builder;
  builder.move_to({0, 0});
  builder.line_to({0.5 * kLength, 0});
  builder.line_to({kLength, 0});
  return shape_of(std::move(builder));
}

// Bent on the spot, at the elbow.
Shape elbow(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  PathBuilder builder;
  builder.move_to({0, 0});
  builder.line_to({0.5 * kLength, 0});
  builder.line_to({0.5 * kLength * (1 + std::cos(angle)), 0.5 * kLength * std::sin(angle)});
  return shape_of(std::move(builder));
}

// Curled into an arc of a circle.
Shape curl(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  const double radius = kLength / angle;
  PathBuilder builder;
  builder.move_to({0, 0});
  builder.arc_to({radius, radius}, 0.0, degrees > 180.0, true,
                 {radius * std::sin(angle), radius * (1.0 - std::cos(angle))});
  return shape_of(std::move(builder));
}

void expect_limb(const Shape& a, const Shape& b) {
  const std::vector<Shape> keys{a, b};
  const PathMorph morph(keys);
  const MorphQuality quality = measure_quality(morph);
  EXPECT_EQ(quality.faulty, 0u);
  EXPECT_LE(quality.length_deviation, 0.01);
}

TEST(Bends, OfAnArmKeepItsLength) {
  for (const double degrees : {30.0, 90.0, 170.0}) expect_limb(straight_arm(), elbow(degrees));
  for (const double degrees : {90.0, 170.0, 300.0}) expect_limb(straight_arm(), curl(degrees));
  expect_limb(curl(300.0), straight_arm());
}

}  // namespace
}  // namespace tandem
