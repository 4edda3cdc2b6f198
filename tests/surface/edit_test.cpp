#include "tandem/surface/edit.h"

#include <gtest/gtest.h>

#include "random_surfaces.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using testing::largest_gap;
using testing::RandomSurfaces;

constexpr Along kBoth[] = {Along::u, Along::v};
// Of the size of the surface.
constexpr double kExact = 1e-12;

class EditSurface : public ::testing::TestWithParam<unsigned> {
 protected:
  RandomSurfaces random_{GetParam()};
  Surface s_ = random_.any(3);
  [[nodiscard]] double exact() const { return kExact * s_.extent(); }
};

TEST_P(EditSurface, InsertedKnotsMoveNothing) {
  for (const Along along : kBoth) {
    const Interval domain = s_.domain(along);
    const double t = domain.lo + 0.37 * domain.length();
    const Surface more = insert_knot(s_, along, t);
    EXPECT_EQ(more.size(along), s_.size(along) + 1);
    EXPECT_LE(largest_gap(s_, more), exact());
  }
}

TEST_P(EditSurface, HigherDegreesMoveNothing) {
  for (const Along along : kBoth) {
    const Surface higher = elevate_degree(s_, along, 2);
    EXPECT_EQ(higher.degree(along), s_.degree(along) + 2);
    EXPECT_LE(largest_gap(s_, higher), exact());
  }
}

TEST_P(EditSurface, PartsArePartsOfIt) {
  for (const Along along : kBoth) {
    const Interval domain = s_.domain(along);
    const Surface part =
        part_of(s_, along, {domain.lo + 0.2 * domain.length(), domain.hi - 0.1 * domain.length()});
    EXPECT_LE(largest_gap(part, s_), exact());
  }
  EXPECT_LE(largest_gap(clamp(s_), s_), exact());
}

TEST_P(EditSurface, ReversedAndTransposedRunAsTheySay) {
  const Interval u = s_.domain(Along::u);
  const Interval v = s_.domain(Along::v);
  const Surface back = reverse(s_, Along::u);
  const Surface other = transpose(s_);
  for (const double x : testing::probes(s_, Along::u)) {
    for (const double y : testing::probes(s_, Along::v)) {
      const Point p = s_.evaluate(x, y);
      EXPECT_LE(testing::distance(back.evaluate(u.lo + u.hi - x, y), p), 1e-11 * s_.extent());
      EXPECT_LE(testing::distance(other.evaluate(y, x), p), exact());
    }
  }
  const Surface wide = with_domain(s_, Along::v, {10, 20});
  EXPECT_LE(testing::distance(wide.evaluate(u.lo, 15), s_.evaluate(u.lo, 0.5 * (v.lo + v.hi))), exact());
}

TEST_P(EditSurface, IsoCurvesLieOnIt) {
  for (const double v : testing::probes(s_, Along::v)) {
    const Curve along_u = iso_curve(s_, Along::u, v);
    for (const double u : testing::probes(s_, Along::u))
      EXPECT_LE(testing::distance(along_u.evaluate(u), s_.evaluate(u, v)), exact());
  }
}

TEST_P(EditSurface, PatchesCoverIt) {
  const BezierPatches made = bezier_patches(s_);
  ASSERT_EQ(made.patches.size(), made.rows * made.columns);
  for (std::size_t i = 0; i < made.rows; ++i) {
    for (std::size_t j = 0; j < made.columns; ++j) {
      const Surface& patch = made.patches[i * made.columns + j];
      EXPECT_EQ(patch.size(Along::u), static_cast<std::size_t>(s_.degree(Along::u)) + 1);
      EXPECT_LE(largest_gap(patch, s_), exact());
      if (i > 0) {
        EXPECT_EQ(made.patches[(i - 1) * made.columns + j].domain(Along::u).hi, patch.domain(Along::u).lo);
      }
    }
  }
  EXPECT_EQ(made.patches.front().domain(Along::v).lo, s_.domain(Along::v).lo);
  EXPECT_EQ(made.patches.back().domain(Along::u).hi, s_.domain(Along::u).hi);
}

INSTANTIATE_TEST_SUITE_P(Random, EditSurface, ::testing::Range(0U, 40U));

TEST(EditSurfaceErrors, AreThoseOfCurves) {
  const Surface s({1, 1}, {std::vector<double>{0, 0, 1, 1}, {0, 0, 1, 1}},
                  Points({{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
  EXPECT_THROW((void)insert_knot(s, Along::u, 2.0), InvalidArgument);
  EXPECT_THROW((void)part_of(s, Along::v, {0.5, 0.5}), InvalidArgument);
  EXPECT_THROW((void)with_domain(s, Along::v, {1, 0}), InvalidArgument);
}

}  // namespace
}  // namespace tandem
