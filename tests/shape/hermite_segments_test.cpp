#include "tandem/shape/hermite_segments.h"

#include <gtest/gtest.h>

#include <limits>

#include "tandem/error.h"

namespace tandem {
namespace {

TEST(HermiteSegments, HaveTheEndsAndDerivativesOfTheCurve) {
  const CubicPath path(
      Points({{0, 0, 1}, {1, 3, 2}, {2, -1, 0}, {3, 3, 5}, {4, 0, 2}, {6, 1, 1}, {8, 8, 8}}));
  const Curve curve = to_curve(path);
  const std::vector<HermiteSegment> segments = to_hermite_segments(path);
  ASSERT_EQ(segments.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto t = static_cast<double>(i);
    const Points start = curve.derivatives(t, 1, Side::right);
    const Points end = curve.derivatives(t + 1.0, 1, Side::left);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(segments[i].start[k], start[0][k], 1e-14);
      EXPECT_NEAR(segments[i].start_tangent[k], start[1][k], 1e-13);
      EXPECT_NEAR(segments[i].end[k], end[0][k], 1e-14);
      EXPECT_NEAR(segments[i].end_tangent[k], end[1][k], 1e-13);
    }
  }
}

TEST(HermiteSegments, ComeBackAsTheyWere) {
  const CubicPath path(Points({{0, 0}, {1, 3}, {2, -1}, {3, 3}, {4, 0}, {6, 1}, {0, 0}}), true);
  const CubicPath back = from_hermite_segments(to_hermite_segments(path), true);
  EXPECT_TRUE(back.is_closed());
  ASSERT_EQ(back.control_points().size(), path.control_points().size());
  for (std::size_t k = 0; k < path.control_points().data().size(); ++k) {
    EXPECT_NEAR(back.control_points().data()[k], path.control_points().data()[k], 1e-15);
  }
}

TEST(HermiteSegments, SayWhatIsWrong) {
  EXPECT_THROW((void)from_hermite_segments({}), InvalidArgument);
  const HermiteSegment good{{0, 0}, {1, 0}, {1, 1}, {1, -1}};
  const HermiteSegment apart{{1, 0.5}, {2, 0}, {1, 1}, {1, -1}};
  const HermiteSegment flat{{1, 0}, {2, 0}, {1}, {1, -1}};
  const HermiteSegment broken{{1, 0}, {2, 0}, {std::numeric_limits<double>::infinity(), 1}, {1, -1}};
  EXPECT_THROW((void)from_hermite_segments(std::vector{good, apart}), InvalidArgument);
  EXPECT_THROW((void)from_hermite_segments(std::vector{good, flat}), InvalidArgument);
  EXPECT_THROW((void)from_hermite_segments(std::vector{good, broken}), InvalidArgument);
  EXPECT_THROW((void)from_hermite_segments(std::vector{good}, true), InvalidArgument);
}

}  // namespace
}  // namespace tandem
