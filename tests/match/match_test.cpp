#include "tandem/match/match.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "match/random_curves.h"
#include "match/truth.h"
#include "tandem/curve/arc_length.h"
#include "tandem/curve/compose.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using testing_curves::closed_curve;
using testing_curves::moved;
using testing_curves::open_curve;
using testing_curves::uniform;

/// Whether the other direction is worse by more than 1e-6 (spec C12: near-ties make correspondences jump).
bool direction_is_clear(const Curve& a, const Curve& b, MatchOptions options) {
  options.direction = Direction::forward;
  const MatchReport forward = match(a, b, options).report;
  options.direction = Direction::reversed;
  const MatchReport reversed = match(a, b, options).report;
  return std::fabs(forward.invalid_length - reversed.invalid_length) > 1e-6 ||
         std::fabs(forward.cost - reversed.cost) > 1e-6;
}

class BothMethods : public ::testing::TestWithParam<Method> {
 protected:
  [[nodiscard]] MatchOptions options() const { return {.method = GetParam(), .samples = {60, 60}}; }
};

TEST_P(BothMethods, TheComposedCurveIsTheSecondCurveReparametrised) {
  std::mt19937 random(1);
  for (int n = 0; n < 20; ++n) {
    const Curve a = open_curve(random);
    const Curve b = open_curve(random);
    const Match m = match(a, b, options());
    EXPECT_EQ(m.curve.domain(), a.domain());
    const Curve second = m.reparametrization.reversed ? reverse(b) : b;
    for (int k = 0; k <= 100; ++k) {
      const double u = k / 100.0;
      const double v = m.reparametrization.v.evaluate(u)[0];
      const Point p = m.curve.evaluate(u);
      const Point q = second.evaluate(v);
      EXPECT_NEAR(p[0], q[0], 1e-11);
      EXPECT_NEAR(p[1], q[1], 1e-11);
    }
  }
}

TEST_P(BothMethods, TranslationChangesNothing) {
  std::mt19937 random(2);
  for (int n = 0; n < 20; ++n) {
    const Curve a = open_curve(random);
    const Curve b = open_curve(random);
    const MatchReport here = match(a, b, options()).report;
    const MatchReport there = match(a, moved(b, {64.0, -32.0}), options()).report;
    EXPECT_NEAR(here.cost, there.cost, 1e-9);
    EXPECT_EQ(here.invalid_nodes, there.invalid_nodes);
  }
}

TEST_P(BothMethods, ReversalIsFound) {
  std::mt19937 random(3);
  for (int n = 0; n < 20; ++n) {
    const Curve a = open_curve(random);
    const Curve b = open_curve(random);
    if (!direction_is_clear(a, b, options())) continue;
    const Match plain = match(a, b, options());
    const Match turned = match(a, reverse(b), options());
    EXPECT_NE(plain.report.direction, turned.report.direction);
    EXPECT_NEAR(plain.report.cost, turned.report.cost, 1e-9);
    for (int k = 0; k <= 50; ++k) {
      const double u = k / 50.0;
      EXPECT_NEAR(plain.correspondence.v_at(u), 1.0 - turned.correspondence.v_at(u), 1e-7);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, BothMethods, ::testing::Values(Method::elastic, Method::paper),
                         [](const auto& test) {
                           return test.param == Method::elastic ? "elastic" : "paper";
                         });

void expect_symmetric(const Curve& a, const Curve& b, const MatchOptions& options) {
  const Match ab = match(a, b, options);
  const Match ba = match(b, a, options);
  EXPECT_NEAR(ab.report.cost, ba.report.cost, 1e-12 * ab.report.cost);
  EXPECT_EQ(ab.report.direction, ba.report.direction);
  if (!direction_is_clear(a, b, options)) return;
  const Correspondence inverse = ba.correspondence.inverse();
  const Interval u = a.domain();
  const double period = b.domain().length();
  for (int k = 0; k <= 200; ++k) {
    const double at = u.lo + u.length() * k / 200.0;
    double d = std::fabs(ab.correspondence.v_at(at) - inverse.v_at(at));
    if (ab.correspondence.closed) d -= period * std::floor(d / period + 0.5);
    EXPECT_NEAR(d, 0.0, 1e-9) << "u = " << at;
  }
}

TEST(Elastic, IsSymmetricOnOpenCurves) {
  std::mt19937 random(5);
  for (int n = 0; n < 20; ++n) expect_symmetric(open_curve(random), open_curve(random), {});
}

TEST(Elastic, IsSymmetricOnClosedCurves) {
  std::mt19937 random(6);
  for (int n = 0; n < 6; ++n)
    expect_symmetric(closed_curve(random), closed_curve(random), {.samples = {64, 64}});
}

TEST(Elastic, IsSymmetricInTheRuledNormInBothDirections) {
  std::mt19937 random(7);
  for (int n = 0; n < 8; ++n) {
    const Curve a = open_curve(random);
    const Curve b = moved(open_curve(random), {0.0, 6.0});
    expect_symmetric(a, b, {.norm = NormKind::ruled, .samples = {50, 50}});
    expect_symmetric(a, reverse(b), {.norm = NormKind::ruled, .samples = {50, 50}});
  }
}

TEST(Elastic, ClosedCurvesDoNotCareWhereTheyStart) {
  const MatchOptions options{.samples = {60, 60}};
  std::mt19937 random(4);
  for (int n = 0; n < 8; ++n) {
    const Curve a = closed_curve(random);
    const Curve b = closed_curve(random);
    const Match plain = match(a, b, options);
    const Curve other = with_domain(move_seam(b, uniform(random, 0.1, 0.9)), {0.0, 1.0});
    const Match moved_seam = match(a, other, options);
    EXPECT_NEAR(plain.report.cost, moved_seam.report.cost, 1e-8);
  }
}

TEST(Elastic, ReparametrisationMovesNothing) {
  std::mt19937 random(8);
  double worst = 0.0;
  for (int n = 0; n < 20; ++n) {
    const Curve a = open_curve(random);
    const Curve b = open_curve(random);
    if (!direction_is_clear(a, b, {})) continue;
    // u -> a quadratic law whose speed varies by a factor of up to 3.
    const double bend = uniform(random, 0.25, 0.75);
    const Curve law = Curve::bezier(Points({{0.0}, {bend}, {1.0}}));
    const Curve other = compose(a, law);
    const Match plain = match(a, b);
    const Match changed = match(other, b);
    EXPECT_NEAR(plain.report.cost, changed.report.cost, 1e-7);
    const ArcLength arc(b);
    for (int k = 0; k <= 200; ++k) {
      const double u = k / 200.0;
      const double here = arc.length_to(plain.correspondence.v_at(law.evaluate(u)[0]));
      const double there = arc.length_to(changed.correspondence.v_at(u));
      worst = std::max(worst, std::fabs(here - there) / arc.length());
    }
  }
  EXPECT_LE(worst, 0.005);
  RecordProperty("worst", std::to_string(worst));
}

// The features move by 45 % of the line: left alone (naive), the curves are 0.38 of their length out of step.
// Much farther, and the straight parts would have to stretch by more than the programme's longest step.
TEST(KnownTruth, WaveOfFigure12) {
  const Curve a = truth::wave(1.5);
  const Curve b = truth::wave(6.0);
  const double elastic =
      truth::rms_error(a, 1.5, b, 6.0, 2.0, match(a, b, {.samples = {100, 100}}).correspondence);
  const double paper = truth::rms_error(
      a, 1.5, b, 6.0, 2.0, match(a, b, {.method = Method::paper, .samples = {100, 100}}).correspondence);
  const Correspondence none{{{0.0, 0.0}, {1.0, 1.0}}, {0.0, 1.0}, {0.0, 1.0}, false, false};
  std::printf("RMS error in arc length: naive %.4f, paper %.4f, elastic %.4f\n",
              truth::rms_error(a, 1.5, b, 6.0, 2.0, none), paper, elastic);
  RecordProperty("elastic", std::to_string(elastic));
  RecordProperty("paper", std::to_string(paper));
  EXPECT_LE(elastic, 0.01);
  EXPECT_LT(elastic, paper);
}

TEST(KnownTruth, BellsOfFigure14) {
  for (const double to : {2.0, 3.5, 5.0, 6.0}) {
    const Curve a = truth::bell(1.5);
    const Curve b = truth::bell(to);
    const double error =
        truth::rms_error(a, 1.5, b, to, 2.0, match(a, b, {.samples = {50, 50}}).correspondence);
    std::printf("bell moved to %.1f: RMS error %.4f\n", to, error);
    EXPECT_LE(error, 0.01) << "bell moved to " << to;
  }
}

TEST(KnownTruth, ChainOfFiveBells) {
  const std::vector<double> starts = {1.5, 3.5, 6.0, 4.0, 5.5};
  std::vector<Curve> curves;
  for (double s : starts) curves.push_back(truth::bell(s));
  const std::vector<Match> chain = match_chain(curves, {.samples = {50, 50}});
  ASSERT_EQ(chain.size(), 4u);
  // Every curve of the chain runs over the first one's domain; where it is at u is read off its x = 10 v.
  for (std::size_t k = 0; k < chain.size(); ++k) {
    ASSERT_EQ(chain[k].curve.domain(), curves[0].domain());
    Correspondence c{{}, {0.0, 1.0}, {0.0, 1.0}, false, false};
    for (int n = 0; n <= 1000; ++n) {
      const double u = n / 1000.0;
      c.points.push_back({u, chain[k].curve.evaluate(u)[0] / 10.0});
    }
    const double error = truth::rms_error(curves[0], starts[0], curves[k + 1], starts[k + 1], 2.0, c);
    std::printf("curve %zu of the chain: RMS error %.4f\n", k + 1, error);
    EXPECT_LE(error, 0.012) << "curve " << k + 1;
  }
}

TEST(Match, ReportsThePapersCost) {
  std::mt19937 random(9);
  const Curve a = open_curve(random);
  const Curve b = reverse(open_curve(random));
  const Match m = match(a, b,
                        {.method = Method::paper,
                         .samples = {40, 40},
                         .direction = Direction::forward,
                         .closed = ClosedMode::no});
  const NodeTable nodes = node_costs(m.samples_a, m.samples_b, NormKind::tangent);
  EXPECT_GT(m.report.invalid_nodes, 0);
  EXPECT_NEAR(m.report.cost, accumulated_costs(nodes).back(), 1e-9);
  EXPECT_GE(m.report.cost, 80.0);
}

TEST(Match, OpenAgainstClosedCutsTheLoop) {
  std::mt19937 random(10);
  const Curve loop = closed_curve(random);
  const Curve open = open_curve(random);
  for (const Method method : {Method::elastic, Method::paper}) {
    const Match m = match(open, loop, {.method = method, .samples = {50, 60}});
    EXPECT_FALSE(m.correspondence.closed);
    EXPECT_EQ(m.curve.domain(), open.domain());
    EXPECT_NEAR(m.correspondence.domain_v.length(), 1.0, 1e-12);
    EXPECT_NEAR(arc_length(m.curve), arc_length(loop), 1e-6);
    const Match back = match(loop, open, {.method = method, .samples = {60, 50}});
    EXPECT_NEAR(back.report.cost, m.report.cost, 1e-9);
    EXPECT_NEAR(back.curve.domain().length(), 1.0, 1e-12);
  }
}

TEST(Match, ReversedLoopsThatAreCutKeepTheirOwnDomain) {
  std::mt19937 random(19);
  const Curve open = open_curve(random);
  const Curve loop = closed_curve(random);
  const Match m = match(open, loop, {.samples = {50, 60}, .direction = Direction::reversed});
  // v refers to the reversed loop, t -> lo + hi - t, running on past its end.
  const Interval d = loop.domain();
  for (int k = 0; k <= 50; ++k) {
    const double u = open.domain().lo + open.domain().length() * k / 50.0;
    double t = d.lo + d.hi - m.reparametrization.v.evaluate(u)[0];
    EXPECT_NEAR(std::remainder(t - m.correspondence.v_at(u), d.length()), 0.0, 5e-3);
    t -= d.length() * std::floor((t - d.lo) / d.length());
    EXPECT_NEAR(loop.evaluate(t)[0], m.curve.evaluate(u)[0], 1e-9);
    EXPECT_NEAR(loop.evaluate(t)[1], m.curve.evaluate(u)[1], 1e-9);
  }
}

TEST(Match, PinnedKeepsTheFirstSeam) {
  std::mt19937 random(11);
  const Curve a = closed_curve(random);
  const Curve b = closed_curve(random);
  for (const Method method : {Method::elastic, Method::paper}) {
    const Match toroidal = match(a, b, {.method = method, .samples = {48, 48}});
    const Match pinned = match(a, b, {.method = method, .samples = {48, 48}, .closed = ClosedMode::pinned});
    EXPECT_TRUE(pinned.correspondence.closed);
    EXPECT_EQ(pinned.report.path.front().i, 0);
    EXPECT_TRUE(pinned.curve.is_closed());
    EXPECT_TRUE(toroidal.curve.is_closed());
  }
}

TEST(Match, ClosedPathsRunRoundOnce) {
  std::mt19937 random(12);
  for (const Method method : {Method::elastic, Method::paper}) {
    for (int n = 0; n < 5; ++n) {
      const Match m =
          match(closed_curve(random), reverse(closed_curve(random)), {.method = method, .samples = {40, 50}});
      EXPECT_EQ(m.report.direction, Direction::reversed);
      const auto& path = m.report.path;
      EXPECT_GE(path.front().i, 0);
      EXPECT_LT(path.front().i, 40);
      EXPECT_GE(path.front().j, 0);
      EXPECT_LT(path.front().j, 50);
      EXPECT_EQ(path.back().i, path.front().i + m.report.samples[0]);
      EXPECT_EQ(path.back().j, path.front().j + m.report.samples[1]);
      const auto& points = m.correspondence.points;
      EXPECT_NEAR(points.back().u - points.front().u, 1.0, 1e-12);
      EXPECT_NEAR(points.back().v - points.front().v, -1.0, 1e-12);
    }
  }
}

TEST(Match, CoarseToFineFindsNearlyTheSame) {
  std::mt19937 random(13);
  for (int n = 0; n < 10; ++n) {
    const Curve a = open_curve(random);
    const Curve b = open_curve(random);
    const MatchReport exact = match(a, b).report;
    const MatchReport coarse = match(a, b, {.coarse_to_fine = true}).report;
    EXPECT_FALSE(coarse.exact);
    // The mask only takes paths away.
    if (coarse.direction == exact.direction && coarse.invalid_length == exact.invalid_length) {
      EXPECT_GE(coarse.cost, exact.cost - 1e-12);
    }
    EXPECT_LE(coarse.cost, 1.5 * exact.cost + 0.05);
  }
}

TEST(Match, ThreadsDoNotChangeTheResult) {
  std::mt19937 random(14);
  const Curve a = closed_curve(random);
  const Curve b = closed_curve(random);
  for (const Method method : {Method::elastic, Method::paper}) {
    const Match one = match(a, b, {.method = method, .threads = 1});
    for (const int threads : {2, 4, 0}) {
      const Match many = match(a, b, {.method = method, .threads = threads});
      EXPECT_EQ(one.report.path, many.report.path);
      EXPECT_EQ(one.correspondence.points, many.correspondence.points);
      EXPECT_EQ(one.curve, many.curve);
    }
  }
}

TEST(Match, CanBeCancelled) {
  std::mt19937 random(15);
  const Curve a = closed_curve(random);
  double last = 0.0;
  const Match all = match(a, a, {.progress = [&](double f) {
                            EXPECT_GE(f, last);
                            last = f;
                            return true;
                          }});
  EXPECT_FALSE(all.report.cancelled);
  EXPECT_GT(last, 0.0);
  EXPECT_TRUE(match(a, a, {.progress = [](double) { return false; }}).report.cancelled);
}

TEST(Match, KeepsCornersTogether) {
  // Two zigzags of four legs with different lengths: corner to corner is the only good answer.
  const Curve a(1, {0, 0, 1, 2, 3, 4, 4}, Points({{0, 0}, {1, 2}, {2, 0}, {3, 2}, {4, 0}}));
  const Curve b(1, {0, 0, 1, 2, 3, 4, 4}, Points({{0, 0}, {2, 4}, {3, 2}, {4, 4}, {7, -2}}));
  const Match m = match(a, b);
  for (const double corner : {1.0, 2.0, 3.0}) {
    EXPECT_NEAR(m.correspondence.v_at(corner), corner, 1e-12);
    EXPECT_NEAR(m.curve.evaluate(corner)[0], b.evaluate(corner)[0], 1e-12);
  }
  EXPECT_TRUE(m.report.validity.valid);
}

TEST(Match, HugeAndTinyCoordinates) {
  std::mt19937 random(16);
  const Curve a = open_curve(random);
  const Curve b = open_curve(random);
  const auto times = [](const Curve& c, double factor) {
    Points points = c.control_points();
    for (double& x : points.data()) x *= factor;
    return Curve(c.degree(), c.knots(), std::move(points));
  };
  for (const Method method : {Method::elastic, Method::paper}) {
    const MatchReport plain = match(a, b, {.method = method}).report;
    for (const auto& [fa, fb] : {std::pair{1e300, 1e300}, {1e-300, 1e-300}, {1e300, 1e-300}, {1e-300, 1.0}}) {
      const MatchReport scaled = match(times(a, fa), times(b, fb), {.method = method}).report;
      EXPECT_NEAR(scaled.cost, plain.cost, 1e-6) << fa << " " << fb;
      EXPECT_EQ(scaled.validity.valid, plain.validity.valid);
    }
    for (const NormKind norm : {NormKind::ruled, NormKind::distance, NormKind::bottleneck}) {
      const MatchReport scaled =
          match(times(a, 1e300), times(b, 1e300), {.method = method, .norm = norm}).report;
      EXPECT_TRUE(std::isfinite(scaled.cost));
    }
  }
}

TEST(Match, KnotsFarFromZero) {
  std::mt19937 random(17);
  const Curve a = open_curve(random);
  const Curve b = open_curve(random);
  const MatchReport plain = match(a, b).report;
  const Match far = match(with_domain(a, {1e6, 1e6 + 1.0}), with_domain(b, {-1e6, -1e6 + 3.0}));
  EXPECT_NEAR(far.report.cost, plain.cost, 1e-6);
  EXPECT_EQ(far.curve.domain(), (Interval{1e6, 1e6 + 1.0}));
}

TEST(Match, AnimationCurvesMayStandStillAndTurnBack) {
  // R^1 over time: up, a pause, down again; the other one pauses later.
  const Curve a(1, {0, 0, 1, 2, 3, 3}, Points({{0.0}, {1.0}, {1.0}, {0.0}}));
  const Curve b(1, {0, 0, 2, 2.5, 3, 3}, Points({{0.0}, {1.0}, {1.0}, {0.0}}));
  for (const Sampling sampling : {Sampling::parameter, Sampling::arc}) {
    const Match paper = match(a, b, {.method = Method::paper, .samples = {61, 61}, .sampling = sampling});
    EXPECT_EQ(paper.report.invalid_nodes, 0);
    const Match m = match(a, b, {.samples = {61, 61}, .sampling = sampling});
    EXPECT_EQ(m.report.direction, Direction::forward);
    EXPECT_EQ(m.report.invalid_length, 0.0);
    // The top is reached together. (The paper's programme does not mind: its nodes at rest cost nothing
    // anywhere.)
    EXPECT_NEAR(b.evaluate(m.correspondence.v_at(1.0))[0], 1.0, 0.1);
  }
}

TEST(Match, SaysWhatIsWrong) {
  std::mt19937 random(18);
  const Curve plane = open_curve(random, 2);
  const Curve space = open_curve(random, 3);
  const Curve point = Curve::bezier(Points({{1, 1}, {1, 1}}));
  const auto message = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const InvalidArgument& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(message([&] { (void)match(plane, space); }).find("different dimensions"), std::string::npos);
  EXPECT_NE(message([&] { (void)match(plane, point); }).find("the second curve cannot be sampled"),
            std::string::npos);
  EXPECT_NE(message([&] { (void)match(plane, plane, {.closed = ClosedMode::yes}); }).find("open"),
            std::string::npos);
  EXPECT_NE(message([&] {
              (void)match(plane, plane, {.samples = {100, 3}});
            }).find("steps"),
            std::string::npos);
  EXPECT_NE(message([&] {
              (void)match(plane, plane, {.samples = {1, 3}});
            }).find("samples"),
            std::string::npos);
}

}  // namespace
}  // namespace tandem
