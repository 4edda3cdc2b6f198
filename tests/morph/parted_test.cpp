#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "morph/measures.h"
#include "morph/score.h"
#include "morph/step_blend.h"
#include "morph/step_keys.h"
#include "morph/turn_price.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/shape/path_builder.h"

namespace tandem {
namespace {

using namespace detail;  // NOLINT: what is tested is all in there

CubicPath polygon(const std::vector<Vec2>& points, bool close = true) {
  PathBuilder builder;
  builder.move_to(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) builder.line_to(points[i]);
  if (close) builder.close();
  return builder.take().front();
}

CubicPath box(double x, double y, double width, double height) {
  return polygon({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
}

CubicPath point(const CubicPath& like, Vec2 at) {
  Points points = like.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i][0] = at.x;
    points[i][1] = at.y;
  }
  return CubicPath(std::move(points), like.is_closed());
}

struct Parted {
  std::size_t paired = 0;
  std::vector<bool> of_a;  ///< whether each contour of the first key has its partner
};

std::optional<Parted> part(const std::vector<CubicPath>& a, const std::vector<CubicPath>& b,
                           std::size_t count) {
  const StepKeys keys({a, {10, 10}}, {b, {10, 10}}, {});
  const Turned turned = keys.pair(Rotation(2), {});
  const auto found = keys.match(turned, {});
  const auto parted = keys.parted(*found, turned, count);
  if (!parted) return std::nullopt;
  Parted made{0, std::vector<bool>(a.size(), false)};
  EXPECT_EQ(parted->contours.size(), a.size() + count);
  for (const FoundContour& contour : parted->contours) {
    EXPECT_EQ(contour.match != nullptr, contour.a.has_value() && contour.b.has_value());
    if (!contour.match) continue;
    ++made.paired;
    made.of_a[*contour.a] = true;
  }
  return made;
}

// Two boxes stay boxes, one becomes a needle across; the largest is the last to go, that is never.
TEST(Parted, ThoseWithLeastInCommonFirst) {
  const std::vector<CubicPath> a{box(0, 0, 20, 12), box(0, 15, 5, 5), box(12, 15, 5, 5)};
  const std::vector<CubicPath> b{box(0, 0, 20, 12), box(0, 15, 5, 5),
                                 polygon({{10, 14}, {20, 14.5}, {10, 15}})};
  EXPECT_EQ(part(a, b, 1)->of_a, (std::vector<bool>{true, true, false}));
  EXPECT_EQ(part(a, b, 2)->of_a, (std::vector<bool>{true, false, false}));
  EXPECT_FALSE(part(a, b, 3));
}

TEST(Parted, LinesStayTogether) {
  const std::vector<CubicPath> a{polygon({{0, 0}, {20, 0}}, false), polygon({{0, 6}, {20, 6}}, false)};
  const std::vector<CubicPath> b{polygon({{0, 0}, {20, 20}}, false), polygon({{0, 20}, {20, 0}}, false)};
  EXPECT_FALSE(part(a, b, 1));
}

TEST(Late, KeepsSmallForLonger) {
  const CubicPath whole = box(2, 2, 8, 4);
  const CubicPath start = point(whole, {4, 3});
  for (const bool born : {true, false}) {
    const std::vector<ContourEnds> ends{born ? ContourEnds{start, whole} : ContourEnds{whole, start}};
    StepBlend blend(BlendKind::affine, {}, ends);
    StepBlend late(BlendKind::affine, {}, ends);
    late.set_detour(0, {.late = true});
    StepBlend gentle(BlendKind::affine, {}, ends);
    gentle.set_detour(0, {.late = true});
    gentle.make_detours_gentle();
    EXPECT_FALSE(late.is_linear());
    const auto at = [&](const StepBlend& of, double s) {
      std::vector<double> points(of.size(0));
      of.at(born ? s : 1.0 - s, 0, points);
      return points;
    };
    EXPECT_EQ(at(late, 0.0), at(blend, 0.0));
    EXPECT_EQ(at(late, 1.0), at(blend, 1.0));
    EXPECT_NEAR(path_length(at(late, 0.5)), 0.25 * path_length(at(blend, 0.5)), 1e-9);
    EXPECT_NEAR(path_length(at(gentle, 0.5)), 0.5 * path_length(at(blend, 0.5)), 1e-9);
    // Where it is whole, a gentle one has the velocity that it has without.
    const double h = 1e-4;
    EXPECT_NEAR(path_length(at(gentle, 1.0 - h)), path_length(at(blend, 1.0 - h)), 1e-6);
  }
}

Score score(int faults, double blemish) {
  return {faults, 0.0, blemish};
}

// Each choice by what it decides.
TEST(TurnPrice, SmallTurnsAreNotSeen) {
  EXPECT_FALSE(turns_much(20.0));
  EXPECT_TRUE(turns_much(-32.0));
}

TEST(TurnPrice, ADetourIsWorthALittle) {
  EXPECT_TRUE(is_better_upright(score(0, 0.8), 0.0, score(0, 1.0)));
  EXPECT_FALSE(is_better_upright(score(0, 0.9), 0.0, score(0, 1.0)));
  EXPECT_TRUE(is_better_upright(score(0, 0.6), 0.05, score(0, 1.0)));
  EXPECT_FALSE(is_better_upright(score(0, 0.6), 0.12, score(0, 1.0)));
}

TEST(TurnPrice, OneFaultIsWorthATurnAndTwoAreNot) {
  EXPECT_TRUE(is_better_upright(score(1, 0.3), 0.0, score(0, 1.0)));
  EXPECT_FALSE(is_better_upright(score(1, 0.55), 0.0, score(0, 1.0)));
  EXPECT_FALSE(is_better_upright(score(2, 0.0), 0.0, score(0, 5.0)));
  EXPECT_TRUE(is_better_upright(score(3, 0.3), 0.0, score(4, 0.3)));
}

// A correspondence that is off by 2 % of the length costs about as much as a turn of 11 degrees.
TEST(Asymmetry, IsWeighedAgainstTurns) {
  const CubicPath a = polygon({{0, 0}, {20, 0}, {12, 14}});
  const CubicPath b = polygon({{0, 0}, {20, 0}, {3, 14}});
  const auto blemish = [&](double degrees, double asymmetry) {
    const std::vector<ContourEnds> ends{{a, b}};
    return Judge(25.0)
        .judge(StepBlend(BlendKind::affine, PlanarFrame({10, 5}, {10, 5}, degrees, 1.0), ends), {}, asymmetry)
        .blemish;
  };
  const double lost = blemish(0.0, 0.02) - blemish(0.0, 0.0);
  EXPECT_GE(lost, 0.08);
  EXPECT_LE(lost, 0.18);
}

}  // namespace
}  // namespace tandem
