#include "tandem/shape/nesting.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "shape/test_paths.h"
#include "tandem/error.h"
#include "tandem/shape/measures.h"

namespace tandem {
namespace {

using test::circle;
using test::polygon;
using test::polyline;
using test::reversed;

CubicPath square(double x, double y, double size) {
  return polygon({{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}});
}

/// Turns of the ray from p to the path, from the angles it sweeps over.
int winding(const CubicPath& path, Vec2 p) {
  double sum = 0.0;
  const int steps = 8;
  for (std::size_t i = 0; i < path.segment_count() * steps; ++i) {
    const Vec2 a = test::at(path, static_cast<double>(i) / steps);
    const Vec2 b = test::at(path, static_cast<double>(i + 1) / steps);
    const Vec2 u{a.x - p.x, a.y - p.y};
    const Vec2 v{b.x - p.x, b.y - p.y};
    sum += std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
  }
  return static_cast<int>(std::lround(sum / (2 * std::numbers::pi)));
}

bool is_filled(const std::vector<CubicPath>& paths, Vec2 p, FillRule rule) {
  int sum = 0;
  for (const CubicPath& path : paths) {
    if (path.is_closed()) sum += winding(path, p);
  }
  return rule == FillRule::nonzero ? sum != 0 : sum % 2 != 0;
}

TEST(Nesting, OfARingWithAnIsland) {
  const std::vector<CubicPath> paths{circle({0, 0}, 1), reversed(circle({0, 0}, 2)), circle({0, 0}, 3),
                                     circle({9, 0}, 1)};
  for (const FillRule rule : {FillRule::nonzero, FillRule::evenodd}) {
    const auto nesting = find_nesting(paths, rule);
    EXPECT_EQ(nesting[0].role, ContourRole::solid);
    EXPECT_EQ(nesting[0].parent, 1u);
    EXPECT_EQ(nesting[0].depth, 2u);
    EXPECT_EQ(nesting[1].role, ContourRole::hole);
    EXPECT_EQ(nesting[1].parent, 2u);
    EXPECT_EQ(nesting[1].depth, 1u);
    for (const std::size_t i : {2u, 3u}) {
      EXPECT_EQ(nesting[i].role, ContourRole::solid);
      EXPECT_FALSE(nesting[i].parent.has_value());
      EXPECT_EQ(nesting[i].depth, 0u);
    }
    for (const NestedContour& contour : nesting) EXPECT_FALSE(contour.changes_nothing);
  }
}

TEST(Nesting, OfEqualDirectionsDependsOnTheRule) {
  const std::vector<CubicPath> paths{square(0, 0, 9), square(1, 1, 5), reversed(square(2, 2, 3)),
                                     reversed(square(3, 3, 1))};
  const auto nonzero = find_nesting(paths, FillRule::nonzero);
  // Winding numbers 1, 2, 1, 0.
  EXPECT_EQ(nonzero[1].role, ContourRole::solid);
  EXPECT_EQ(nonzero[2].role, ContourRole::hole);
  EXPECT_EQ(nonzero[3].role, ContourRole::hole);
  EXPECT_FALSE(nonzero[0].changes_nothing);
  EXPECT_TRUE(nonzero[1].changes_nothing);
  EXPECT_TRUE(nonzero[2].changes_nothing);
  EXPECT_FALSE(nonzero[3].changes_nothing);
  const auto evenodd = find_nesting(paths, FillRule::evenodd);
  EXPECT_EQ(evenodd[1].role, ContourRole::hole);
  EXPECT_EQ(evenodd[2].role, ContourRole::solid);
  EXPECT_EQ(evenodd[3].role, ContourRole::hole);
  for (const NestedContour& contour : evenodd) EXPECT_FALSE(contour.changes_nothing);
}

TEST(Nesting, HoldsForContoursThatTouchOrSlightlyCross) {
  // A hole that shares an edge with its solid, sticks out of it by a bit, or touches it at a joint.
  for (const double x : {0.0, -0.05, 0.05}) {
    const auto nesting =
        find_nesting(std::vector{square(0, 0, 4), reversed(square(x, 1, 2))}, FillRule::nonzero);
    EXPECT_EQ(nesting[1].role, ContourRole::hole) << x;
    EXPECT_EQ(nesting[1].parent, 0u) << x;
    EXPECT_FALSE(nesting[0].parent.has_value()) << x;
  }
  // Neighbours that share an edge, and one that overlaps by less than half, lie beside each other.
  for (const double x : {4.0, 3.9, 2.5}) {
    const auto nesting = find_nesting(std::vector{square(0, 0, 4), square(x, 0, 4)}, FillRule::nonzero);
    EXPECT_FALSE(nesting[1].parent.has_value()) << x;
    EXPECT_EQ(nesting[1].role, ContourRole::solid) << x;
  }
  // A crescent around a disc is no container of it.
  const CubicPath crescent = polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 9}, {9, 9}, {9, 1}, {0, 1}});
  EXPECT_FALSE(
      find_nesting(std::vector{crescent, circle({5, 5}, 3)}, FillRule::nonzero)[1].parent.has_value());
}

TEST(Nesting, OfEqualContoursPutsTheLaterIntoTheEarlier) {
  for (const bool turned : {false, true}) {
    const CubicPath other = turned ? reversed(circle({1, 1}, 2)) : circle({1, 1}, 2);
    const auto nesting = find_nesting(std::vector{circle({1, 1}, 2), other}, FillRule::nonzero);
    EXPECT_FALSE(nesting[0].parent.has_value());
    EXPECT_EQ(nesting[1].parent, 0u);
    EXPECT_EQ(nesting[1].changes_nothing, !turned);
  }
}

TEST(Nesting, OfOpenAndCollapsedContours) {
  const auto nesting = find_nesting(std::vector{square(0, 0, 9), polyline({{1, 1}, {3, 1}, {2, 2}}),
                                                polygon({{4, 4}, {4, 4}}), polygon({{5, 5}, {6, 6}})},
                                    FillRule::nonzero);
  EXPECT_EQ(nesting[1].role, ContourRole::stroke);
  EXPECT_FALSE(nesting[1].parent.has_value());
  EXPECT_TRUE(nesting[2].changes_nothing);
  EXPECT_TRUE(nesting[3].changes_nothing);
  EXPECT_TRUE(find_nesting({}, FillRule::evenodd).empty());
}

// Squares within squares and beside each other, in any direction and order.
TEST(Orient, FillsTheSameWithSolidsPositiveAndHolesNegative) {
  EXPECT_TRUE(rc::check([] {
    std::vector<CubicPath> paths;
    const auto add = [&](auto&& self, double x, double y, double size, int depth) -> void {
      if (*rc::gen::arbitrary<bool>()) {
        const CubicPath contour = square(x, y, size);
        paths.insert(paths.begin() + *rc::gen::inRange<std::ptrdiff_t>(0, std::ssize(paths) + 1),
                     *rc::gen::arbitrary<bool>() ? contour : reversed(contour));
      }
      if (depth == 0) return;
      self(self, x + 0.1 * size, y + 0.1 * size, 0.6 * size, depth - 1);
      self(self, x + 0.75 * size, y + 0.75 * size, 0.2 * size, depth - 1);
    };
    add(add, 0, 0, 10, 4);
    const FillRule rule = *rc::gen::element(FillRule::nonzero, FillRule::evenodd);
    const std::vector<CubicPath> oriented = orient(paths, rule);
    RC_ASSERT(oriented.size() == paths.size());
    const auto before = find_nesting(paths, rule);
    const auto after = find_nesting(oriented, FillRule::nonzero);
    for (std::size_t i = 0; i < paths.size(); ++i) {
      RC_ASSERT(test::controls_of(oriented[i]).front() == test::controls_of(paths[i]).front());
      RC_ASSERT(after[i].parent == before[i].parent);
      if (before[i].changes_nothing) continue;
      RC_ASSERT(after[i].role == before[i].role);
      RC_ASSERT((signed_area(oriented[i]) > 0) == (before[i].role == ContourRole::solid));
    }
    for (int i = 0; i < 50; ++i) {
      const Vec2 p{*rc::gen::inRange(0, 100000) * 1e-4 + 3.7e-5,
                   *rc::gen::inRange(0, 100000) * 1e-4 + 3.1e-5};
      RC_ASSERT(is_filled(paths, p, rule) == is_filled(oriented, p, FillRule::nonzero));
    }
  }));
}

TEST(Nesting, RefusesWhatIsNotPlanar) {
  const std::vector<CubicPath> space{CubicPath(Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}})};
  EXPECT_THROW((void)find_nesting(space, FillRule::nonzero), InvalidArgument);
  EXPECT_THROW((void)orient(space, FillRule::nonzero), InvalidArgument);
}

}  // namespace
}  // namespace tandem
