#include "morph/clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tandem/shape/intersections.h"
#include "tandem/shape/path_builder.h"

namespace tandem {
namespace {

using detail::Clearance;
using detail::ContourDetour;
using detail::ContourEnds;
using detail::StepBlend;

CubicPath box(Vec2 center, double half, bool hole = false) {
  PathBuilder builder;
  const double h = hole ? -half : half;
  builder.move_to({center.x - half, center.y - h});
  builder.line_to({center.x + half, center.y - h});
  builder.line_to({center.x + half, center.y + h});
  builder.line_to({center.x - half, center.y + h});
  builder.close();
  return builder.take().front();
}

StepBlend still(const std::vector<CubicPath>& contours) {
  std::vector<ContourEnds> ends;
  for (const CubicPath& contour : contours) ends.push_back({contour, contour});
  return StepBlend(BlendKind::affine, {}, ends);
}

std::vector<CubicPath> at(const StepBlend& blend, double s) {
  std::vector<CubicPath> paths;
  for (std::size_t c = 0; c < blend.contour_count(); ++c) {
    Points points(2, blend.size(c) / 2);
    blend.at(s, c, points.data());
    paths.emplace_back(std::move(points), blend.is_closed(c));
  }
  return paths;
}

double size_of(const CubicPath& path) {
  double lo = path.control_points()[0][0];
  double hi = lo;
  for (std::size_t i = 0; i < path.control_points().size(); ++i) {
    lo = std::min(lo, path.control_points()[i][0]);
    hi = std::max(hi, path.control_points()[i][0]);
  }
  return hi - lo;
}

TEST(Clearance, LeavesAloneWhatIsInNobodysWay) {
  const StepBlend blend = still({box({0, 0}, 4), box({20, 0}, 1)});
  const ContourDetour detour = Clearance().find(blend, 1, 0.5);
  EXPECT_EQ(detour.offset, Vec2{});
  EXPECT_EQ(detour.shrink, 0.0);
}

TEST(Clearance, TakesASolidOutOfAnother) {
  StepBlend blend = still({box({0, 0}, 4), box({3.8, 0}, 1), box({30, 0}, 1)});
  EXPECT_FALSE(is_simple(at(blend, 0.5)));
  blend.set_detour(1, Clearance().find(blend, 1, 0.5));
  EXPECT_TRUE(is_simple(at(blend, 0.5)));
  EXPECT_LT(std::fabs(blend.detour(1).offset.x), 6.0);  // no further than needed
}

TEST(Clearance, TakesAHoleIntoWhatIsFilled) {
  StepBlend blend = still({box({0, 0}, 4), box({4, 1}, 0.5, true)});
  blend.set_detour(1, Clearance().find(blend, 1, 0.5));
  EXPECT_TRUE(is_simple(at(blend, 0.5)));
  EXPECT_LT(blend.detour(1).offset.x, 0.0);
}

TEST(Clearance, ShrinksWhatDoesNotFit) {
  StepBlend blend = still({box({0, 0}, 4), box({0, 0}, 6, true)});
  blend.set_detour(1, Clearance().find(blend, 1, 0.5));
  EXPECT_GT(blend.detour(1).shrink, 0.3);
  EXPECT_TRUE(is_simple(at(blend, 0.5)));
  EXPECT_LT(size_of(at(blend, 0.5)[1]), 8.0);
}

// The whole of the way aside is gone at the time asked for, and nothing of it at the ends.
TEST(Clearance, IsThereAtTheTimeAskedFor) {
  for (const double s : {0.3, 0.7}) {
    StepBlend blend = still({box({0, 0}, 4), box({3.8, 0}, 1), box({30, 0}, 1)});
    blend.set_detour(1, Clearance().find(blend, 1, s));
    EXPECT_TRUE(is_simple(at(blend, s)));
    EXPECT_EQ(at(blend, 0.0)[1], box({3.8, 0}, 1));
  }
}

TEST(Clearance, OpenContoursStayWhereTheyAre) {
  PathBuilder builder;
  builder.move_to({-9, 0});
  builder.line_to({9, 0});
  const StepBlend blend = still({box({0, 0}, 4), builder.take().front()});
  EXPECT_TRUE(Clearance().find(blend, 1, 0.5).is_none());
}

}  // namespace
}  // namespace tandem
