#include "tandem/morph/align.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <vector>

#include "morph/test_shapes.h"
#include "tandem/error.h"
#include "tandem/match/match.h"

namespace tandem {
namespace {

using test::any_outline;
using test::apart;

CubicPath any_path() {
  return to_cubic_path(any_outline(), 1e-12);
}

Match matched(const CubicPath& a, const CubicPath& b) {
  MatchOptions options;
  options.samples = {24, 24};
  options.direction = Direction::forward;
  return match(to_curve(a), to_curve(b), options);
}

// Every piece is a piece of one segment: its points are the path's at evenly spread parameters.
TEST(Align, PiecesAreThePathsOwn) {
  EXPECT_TRUE(rc::check([] {
    const CubicPath a = any_path();
    const CubicPath b = any_path();
    const AlignedPaths aligned = align(a, b, matched(a, b).correspondence);
    RC_ASSERT(aligned.a.segment_count() == aligned.b.segment_count());
    RC_ASSERT(aligned.cuts.size() == aligned.a.segment_count() + 1);
    RC_ASSERT(aligned.a.is_closed() && aligned.b.is_closed());
    const Curve whole = to_curve(a);
    const Curve drawn = to_curve(aligned.a);
    for (std::size_t k = 0; k < aligned.a.segment_count(); ++k) {
      const double from = aligned.cuts[k];
      const double to = aligned.cuts[k + 1];
      RC_ASSERT(from <= to);
      RC_ASSERT(std::floor(from) >= std::ceil(to) - 1.0);  // no joint inside
      for (const double t : {0.0, 0.25, 0.5, 0.75}) {
        const double u = test::wrapped(from + t * (to - from), whole);
        RC_ASSERT(apart(drawn.evaluate(static_cast<double>(k) + t), whole.evaluate(u)) <= 1e-12);
      }
    }
  }));
}

// Without snapping all joints of both paths are there, and the correspondence runs through them.
TEST(Align, CarriesJointsOver) {
  EXPECT_TRUE(rc::check([] {
    const CubicPath a = any_path();
    const CubicPath b = any_path();
    const Correspondence c = matched(a, b).correspondence;
    const AlignedPaths aligned = align(a, b, c, {.snap = 0.0, .stray = 2.0});
    RC_ASSERT(aligned.a.segment_count() >= std::max(a.segment_count(), b.segment_count()));
    RC_ASSERT(aligned.a.segment_count() <= a.segment_count() + b.segment_count());
    const Curve second = to_curve(b);
    for (std::size_t k = 0; k < aligned.a.segment_count(); ++k) {
      const double v = c.v_at(aligned.cuts[k]);
      const auto joint = aligned.b.segment(k)[0];
      RC_ASSERT(apart(Point(joint.begin(), joint.end()), second.evaluate(test::wrapped(v, second))) <= 1e-5);
    }
    // Snapping takes joints away; straying adds some.
    RC_ASSERT(align(a, b, c, {.snap = 0.1, .stray = 2.0}).a.segment_count() <= aligned.a.segment_count());
    RC_ASSERT(align(a, b, c, {.snap = 0.0, .stray = 1e-3}).a.segment_count() >= aligned.a.segment_count());
  }));
}

TEST(Align, CopiesNeedNoNewSegments) {
  EXPECT_TRUE(rc::check([] {
    const CubicPath a = any_path();
    const AlignedPaths aligned = align(a, a, matched(a, a).correspondence);
    RC_ASSERT(aligned.a.segment_count() == a.segment_count());
    RC_ASSERT(aligned.a.control_points() == aligned.b.control_points());
  }));
}

TEST(Align, SaysWhatIsWrong) {
  const CubicPath a(Points({{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
  const CubicPath space(Points({{0, 0, 0}, {1, 0, 0}, {2, 0, 1}, {3, 0, 0}}));
  const Correspondence c{{{0, 0}, {1, 1}}, {0, 1}, {0, 1}, false, false};
  EXPECT_THROW((void)align(a, space, c), InvalidArgument);
  EXPECT_THROW((void)align(a, a, {{{0, 0}, {2, 1}}, {0, 2}, {0, 1}, false, false}), InvalidArgument);
  EXPECT_THROW((void)cut_at(a, {0.5}, false), InvalidArgument);
}

}  // namespace
}  // namespace tandem
