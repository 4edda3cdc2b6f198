#include "tandem/shape/cut.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shape/test_paths.h"
#include "tandem/curve/arc_length.h"
#include "tandem/curve/nearest_point.h"
#include "tandem/error.h"
#include "tandem/shape/intersections.h"
#include "tandem/shape/measures.h"

namespace tandem {
namespace {

using test::circle;
using test::polygon;

CubicPath square(double x, double y, double size) {
  return polygon({{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}});
}

std::vector<PieceTarget> equal(std::size_t count) {
  return std::vector<PieceTarget>(count);
}

double area_of(const CutPiece& piece) {
  return signed_area(piece.path);
}

double length_of(const CutPiece& piece, bool chords) {
  double sum = 0.0;
  for (std::size_t i = 0; i < piece.chords.size(); ++i) {
    if (piece.chords[i] != chords) continue;
    const auto p = piece.path.segment(i);
    Points points;
    for (const auto& control : p) points.push_back(control);
    sum += arc_length(to_curve(CubicPath(std::move(points))));
  }
  return sum;
}

// What holds for every cut of a simple contour: the pieces are simple, and together the contour.
void expect_whole(const CubicPath& contour, const std::vector<CutPiece>& pieces) {
  const double area = signed_area(contour);
  double sum = 0.0;
  double outline = 0.0;
  std::vector<CubicPath> paths;
  for (const CutPiece& piece : pieces) {
    RC_ASSERT(piece.path.is_closed());
    RC_ASSERT(piece.chords.size() == piece.path.segment_count());
    RC_ASSERT(area_of(piece) * area > 0.0);
    sum += area_of(piece);
    outline += length_of(piece, false);
    for (std::size_t i = 0; i < piece.chords.size(); ++i) {
      if (piece.chords[i]) RC_ASSERT(piece.path.is_line(i, 1e-12));
    }
    paths.push_back(piece.path);
  }
  RC_ASSERT(std::fabs(sum - area) <= 1e-12 * std::fabs(area));
  RC_ASSERT(std::fabs(outline - arc_length(to_curve(contour))) <= 1e-8 * outline);
  // Neighbours share chords and touch, but none crosses itself or another one.
  RC_ASSERT(is_simple(paths));
}

/// A star-shaped outline of lines and cubics about the origin.
CubicPath any_star() {
  const int n = *rc::gen::inRange(3, 14);
  std::vector<double> radii;
  for (int i = 0; i < n; ++i) radii.push_back(*rc::gen::inRange(20, 101) / 10.0);
  const auto at = [&](int i, double share) {
    const double angle = 2 * std::numbers::pi * (i + share) / n;
    const double r = radii[static_cast<std::size_t>(i % n)];
    return Vec2{r * std::cos(angle), r * std::sin(angle)};
  };
  std::vector<Vec2> controls{at(0, 0)};
  for (int i = 0; i < n; ++i) {
    const Vec2 p = at(i, 0);
    const Vec2 q = at(i + 1, 0);
    if (*rc::gen::arbitrary<bool>()) {
      controls.insert(controls.end(), {test::blend(p, q, 1.0 / 3), test::blend(p, q, 2.0 / 3)});
    } else {
      controls.insert(controls.end(), {at(i, 0.3), at(i + 1, -0.3)});
    }
    controls.push_back(i + 1 == n ? controls.front() : q);
  }
  return test::make_path(controls, true);
}

TEST(Cut, PiecesAreTheContour) {
  EXPECT_TRUE(rc::check([] {
    const CubicPath star = any_star();
    RC_PRE(is_simple(std::vector{star}));
    const CubicPath contour = *rc::gen::arbitrary<bool>() ? star : test::reversed(star);
    std::vector<PieceTarget> targets(*rc::gen::inRange<std::size_t>(1, 6));
    for (PieceTarget& target : targets) target.share = *rc::gen::inRange(1, 4);
    if (*rc::gen::arbitrary<bool>()) {
      for (PieceTarget& target : targets) {
        target.center = Vec2{*rc::gen::inRange(-60, 61) / 10.0, *rc::gen::inRange(-60, 61) / 10.0};
      }
    }
    const std::vector<CutPiece> pieces = cut_contour(contour, targets);
    RC_ASSERT(pieces.size() == targets.size());
    expect_whole(contour, pieces);
    std::size_t chords = 0;
    for (const CutPiece& piece : pieces) {
      chords += static_cast<std::size_t>(std::count(piece.chords.begin(), piece.chords.end(), true));
    }
    RC_ASSERT(chords >= 2 * (targets.size() - 1));
  }));
}

// When nothing else counts, the areas are as near to the wish as the places along the outline allow.
TEST(Cut, MeetsTheShares) {
  EXPECT_TRUE(rc::check([] {
    const CubicPath contour = any_star();
    RC_PRE(is_simple(std::vector{contour}));
    std::vector<PieceTarget> targets(2);
    targets[0].share = *rc::gen::inRange(1, 4);
    const std::vector<CutPiece> pieces =
        cut_contour(contour, targets, {}, {.length_weight = 0.0, .share_weight = 1.0, .center_weight = 0.0});
    const double share = targets[0].share / (targets[0].share + 1.0);
    RC_ASSERT(std::fabs(area_of(pieces[0]) / signed_area(contour) - share) <= 0.01);
  }));
}

TEST(Cut, TakesTheShortestWayWhereNothingElseCounts) {
  // A dumb-bell with a neck of 1.
  const CubicPath bell = polygon({{0, 0},
                                  {4, 0},
                                  {4, 1.5},
                                  {8, 1.5},
                                  {8, 0},
                                  {12, 0},
                                  {12, 4},
                                  {8, 4},
                                  {8, 2.5},
                                  {4, 2.5},
                                  {4, 4},
                                  {0, 4}});
  const auto pieces = cut_contour(bell, equal(2));
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_NEAR(length_of(pieces[0], true), 1.0, 1e-2);
  EXPECT_NEAR(area_of(pieces[0]), area_of(pieces[1]), 1.0);
  // An ell comes apart at its inner corner.
  const CubicPath ell = polygon({{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}});
  const auto arms = cut_contour(ell, std::vector<PieceTarget>{{3.0, {}}, {2.0, {}}});
  EXPECT_NEAR(length_of(arms[0], true), 2.0, 1e-2);
  EXPECT_NEAR(area_of(arms[0]), 12.0, 0.1);
  EXPECT_NEAR(area_of(arms[1]), 8.0, 0.1);
}

TEST(Cut, GivesEachTargetThePieceNearIt) {
  const CubicPath contour = square(0, 0, 4);
  const std::vector<Vec2> centers{{3, 3}, {1, 1}, {3, 1}, {1, 3}};
  std::vector<PieceTarget> targets;
  for (const Vec2 center : centers) targets.push_back({1.0, center});
  const auto pieces = cut_contour(contour, targets);
  ASSERT_EQ(pieces.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(area_of(pieces[i]), 4.0, 0.3) << i;
    Vec2 mean;
    for (const Vec2 p : test::controls_of(pieces[i].path)) {
      const double n = static_cast<double>(pieces[i].path.control_points().size());
      mean = {mean.x + p.x / n, mean.y + p.y / n};
    }
    EXPECT_NEAR(mean.x, centers[i].x, 0.4) << i;
    EXPECT_NEAR(mean.y, centers[i].y, 0.4) << i;
  }
}

TEST(Cut, StaysClearOfHoles) {
  const CubicPath contour = circle({0, 0}, 10);
  const std::vector<CubicPath> holes{circle({0, 0}, 2), square(3, 3, 2), circle({-5, 1}, 1.5)};
  for (const std::size_t count : {2u, 3u, 5u}) {
    const auto pieces = cut_contour(contour, equal(count), holes);
    ASSERT_EQ(pieces.size(), count);
    std::vector<CubicPath> paths(holes);
    double sum = 0.0;
    for (const CutPiece& piece : pieces) {
      paths.push_back(piece.path);
      sum += area_of(piece);
    }
    EXPECT_TRUE(is_simple(paths)) << count;
    EXPECT_NEAR(sum, signed_area(contour), 1e-9) << count;
  }
  // A hole that nearly fills the contour leaves room for a corner only; one that touches it all round, none.
  const CubicPath outer = square(0, 0, 10);
  const auto corner = cut_contour(outer, equal(2), std::vector{square(1, 1, 8)});
  ASSERT_EQ(corner.size(), 2u);
  EXPECT_NEAR(std::min(area_of(corner[0]), area_of(corner[1])), 4.0, 2.1);
  EXPECT_TRUE(cut_contour(outer, equal(2), std::vector{square(0, 0, 10)}).empty());
}

TEST(Cut, KeepsTheExactOutline) {
  const CubicPath contour = circle({0, 0}, 1);
  const auto pieces = cut_contour(contour, equal(3));
  for (const CutPiece& piece : pieces) {
    for (std::size_t i = 0; i < piece.chords.size(); ++i) {
      if (piece.chords[i]) continue;
      for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Vec2 p = test::at(piece.path, static_cast<double>(i) + t);
        // On the quarter circle's own cubic: its angle's parameter by bisection.
        const double quarter = std::floor(std::atan2(p.y, p.x) / (std::numbers::pi / 2));
        const double from = quarter < 0 ? quarter + 4 : quarter;
        double lo = std::min(from, 3.0);
        double hi = lo + 1;
        const Vec2 start = test::at(contour, lo);
        for (int k = 0; k < 60; ++k) {
          const double middle = 0.5 * (lo + hi);
          const Vec2 q = test::at(contour, middle);
          (start.x * q.x + start.y * q.y > start.x * p.x + start.y * p.y ? lo : hi) = middle;
        }
        const Vec2 q = test::at(contour, lo);
        EXPECT_NEAR(std::hypot(p.x - q.x, p.y - q.y), 0.0, 1e-7);
      }
    }
  }
}

// Pushed out onto the contour, one piece is all of it and the others are forth and back.
TEST(Cut, OutlinesDrawNothingButTheContour) {
  rc::check([] {
    const CubicPath contour = any_star();
    const auto count = *rc::gen::inRange<std::size_t>(2, 5);
    const std::vector<CutPiece> pieces = cut_contour(contour, equal(count), {}, {.outlines = true});
    RC_PRE(!pieces.empty());
    const double area = signed_area(contour);
    std::size_t whole = 0;
    for (const CutPiece& piece : pieces) {
      RC_ASSERT(piece.outline.has_value());
      RC_ASSERT(piece.outline->segment_count() == piece.path.segment_count());
      const double own = signed_area(*piece.outline);
      if (std::fabs(own - area) <= 1e-9 * std::fabs(area)) {
        ++whole;
        RC_ASSERT(std::fabs(arc_length(to_curve(*piece.outline)) - arc_length(to_curve(contour))) <=
                  1e-6 * 60);
      } else {
        RC_ASSERT(std::fabs(own) <= 1e-9 * std::fabs(area));
      }
      for (std::size_t i = 0; i < piece.path.segment_count(); ++i) {
        const auto p = piece.outline->segment(i)[0];
        RC_ASSERT(nearest_point(to_curve(contour), Point{p[0], p[1]}).distance <= 1e-7);
      }
    }
    RC_ASSERT(whole == std::size_t{1});
  });
}

TEST(Cut, ChordsArePushedAwayFromHoles) {
  const CubicPath bar = polygon({{0, 0}, {20, 0}, {20, 6}, {0, 6}});
  const std::vector<CubicPath> hole{square(14, 2, 2)};
  const std::vector<CutPiece> pieces =
      cut_contour(bar, std::vector<PieceTarget>{{1, Vec2{5, 3}}, {1, Vec2{15, 3}}}, hole, {.outlines = true});
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(signed_area(*pieces[0].outline), 0.0, 1e-9);
  EXPECT_NEAR(signed_area(*pieces[1].outline), 120.0, 1e-9);
  const std::vector<CubicPath> two{square(14, 2, 2), square(4, 2, 2)};
  for (const CutPiece& piece : cut_contour(bar, equal(2), two, {.outlines = true})) {
    EXPECT_EQ(*piece.outline, piece.path);  // there is nowhere to go
  }
}

TEST(Cut, OneTargetIsTheContourItself) {
  const CubicPath contour = circle({3, 4}, 2);
  const auto pieces = cut_contour(contour, equal(1));
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].path, contour);
  EXPECT_EQ(std::count(pieces[0].chords.begin(), pieces[0].chords.end(), true), 0);
}

TEST(Cut, OfNothingIsEmpty) {
  EXPECT_TRUE(cut_contour(polygon({{1, 1}, {1, 1}}), equal(2)).empty());
  EXPECT_TRUE(cut_contour(polygon({{1, 1}, {2, 2}}), equal(2)).empty());
}

TEST(Cut, AtEverySize) {
  for (const double size : {1e-150, 1e-3, 1e150}) {
    const auto pieces = cut_contour(square(-size, 3 * size, size), equal(2));
    ASSERT_EQ(pieces.size(), 2u) << size;
    EXPECT_NEAR(area_of(pieces[0]) / (size * size), 0.5, 1e-2) << size;
  }
}

TEST(Cut, RefusesWhatCannotBeMeant) {
  const CubicPath contour = square(0, 0, 1);
  EXPECT_THROW((void)cut_contour(contour, {}), InvalidArgument);
  EXPECT_THROW((void)cut_contour(test::polyline({{0, 0}, {1, 0}}), equal(2)), InvalidArgument);
  EXPECT_THROW((void)cut_contour(contour, std::vector<PieceTarget>{{0.0, {}}}), InvalidArgument);
  EXPECT_THROW((void)cut_contour(contour, equal(2), std::vector{test::polyline({{0, 0}, {1, 0}})}),
               InvalidArgument);
  EXPECT_THROW((void)cut_contour(contour, equal(2), {}, {.length_weight = -1.0}), InvalidArgument);
  const CubicPath space(Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}}, true);
  EXPECT_THROW((void)cut_contour(space, equal(2)), InvalidArgument);
}

}  // namespace
}  // namespace tandem
