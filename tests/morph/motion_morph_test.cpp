#include "tandem/morph/motion_morph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "tandem/curve/compose.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using Values = std::function<std::vector<double>(double t)>;

/// A cubic spline near f over [lo, hi]: its control points lie on f.
Curve spline_near(const Values& f, double lo, double hi, std::size_t count) {
  std::vector<double> knots(3, lo);
  for (std::size_t i = 0; i + 2 < count; ++i) {
    knots.push_back(lo + (hi - lo) * static_cast<double>(i) / static_cast<double>(count - 3));
  }
  knots.insert(knots.end(), 3, hi);
  Points points(static_cast<int>(f(lo).size()), count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<double> x = f((knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3.0);
    std::copy(x.begin(), x.end(), points[i].begin());
  }
  return Curve(3, std::move(knots), std::move(points));
}

/// Joint angles in degrees at a phase in cycles: hips, knees and arms of both sides.
std::vector<double> gait(double phase, double vigour) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  std::vector<double> angles;
  for (const double side : {0.0, 0.5}) {
    const double p = kTurn * (phase + side);
    angles.push_back((25 + 20 * vigour) * std::cos(p) + 5);
    angles.push_back(20 + 25 * vigour + (20 + 20 * vigour) * std::cos(p - 1.2) + 12 * std::cos(2 * p - 2.2));
    angles.push_back(-(15 + 25 * vigour) * std::cos(p));
  }
  return angles;
}

Curve walk() {
  return spline_near([](double t) { return gait(t / 1.1, 0.0); }, 0.0, 2.2, 120);
}

/// From [0, 1.4] onto [0, 2.2], slow first and fast then.
Curve warp() {
  return Curve(2, {0, 0, 0, 0.7, 1.4, 1.4, 1.4}, Points(1, std::vector<double>{0, 0.4, 1.3, 2.2}));
}

double inverse(const Curve& rising, double value) {
  double lo = rising.domain().lo;
  double hi = rising.domain().hi;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (lo + hi);
    (rising.evaluate(middle)[0] < value ? lo : hi) = middle;
  }
  return lo;
}

Curve scaled(const Curve& curve, std::size_t coordinate, double factor, double offset) {
  Points points = curve.control_points();
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i][coordinate] = factor * points[i][coordinate] + offset;
  return Curve(curve.degree(), curve.knots(), std::move(points));
}

TEST(MotionMorph, GraphHasTheTimeFirst) {
  const Curve motion = walk();
  const Curve graph = graph_of(motion);
  ASSERT_EQ(graph.dim(), 7);
  for (const double t : {0.0, 0.3, 1.7, 2.2}) {
    EXPECT_NEAR(graph.evaluate(t)[0], t, 1e-12);
    EXPECT_EQ(graph.evaluate(t)[3], motion.evaluate(t)[2]);
  }
}

// The same motion at other times: what happens stays as it is, only its times are blended.
TEST(MotionMorph, FindsTheTimingOfTheSameMotion) {
  const Curve a = walk();
  const Curve b = compose(a, warp());
  const MotionMorph morph(std::vector<Curve>{a, b});
  EXPECT_EQ(morph.match(0).report.direction, Direction::forward);
  for (const double s : {0.0, 0.3, 0.5, 1.0}) {
    const Curve graph = morph.graph(s);
    for (int i = 0; i <= 50; ++i) {
      const double u = 2.2 * i / 50;
      const Point p = graph.evaluate(u);
      EXPECT_NEAR(p[0], (1 - s) * u + s * inverse(warp(), u), 0.01) << s << " " << u;
      const Point x = a.evaluate(u);
      for (std::size_t c = 0; c < x.size(); ++c)
        EXPECT_NEAR(p[c + 1], x[c], 1.5) << s << " " << u << " " << c;
    }
  }
}

TEST(MotionMorph, LastsBetweenBoth) {
  const Curve a = walk();
  const Curve b = spline_near([](double t) { return gait(t / 0.7, 1.0); }, 3.0, 4.4, 80);
  const MotionMorph morph(std::vector<Curve>{a, b});
  EXPECT_NEAR(morph.duration(0.0).hi, 2.2, 1e-12);
  EXPECT_NEAR(morph.duration(1.0).lo, 3.0, 1e-12);
  EXPECT_NEAR(morph.duration(0.25).lo, 0.75, 1e-12);
  EXPECT_NEAR(morph.duration(0.25).length(), 2.0, 1e-12);
  const Points rows = morph.rows(0.0, 45);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double t = 2.2 * static_cast<double>(i) / 44;
    EXPECT_NEAR(rows[i][0], t, 1e-12);
    for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(rows[i][c + 1], a.evaluate(t)[c], 1e-9);
  }
  const Points last = morph.rows(1.0, 45);
  for (std::size_t i = 0; i < last.size(); ++i) {
    for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(last[i][c + 1], b.evaluate(last[i][0])[c], 1e-9);
  }
  // Amplitudes are between: a hip that swings by 25 and by 45 degrees swings by 35.
  double highest = 0.0;
  const Points half = morph.rows(0.5, 200);
  for (std::size_t i = 0; i < half.size(); ++i) highest = std::max(highest, half[i][1]);
  EXPECT_NEAR(highest, 5 + 35, 1.0);
}

TEST(MotionMorph, UnitsDoNotMatter) {
  const Curve a = walk();
  const Curve b =
      spline_near([](double t) { return gait(t / 0.7 + 0.05 * std::sin(9 * t), 1.0); }, 0.0, 1.4, 80);
  const MotionMorph degrees(std::vector<Curve>{a, b});
  const MotionMorph other(std::vector<Curve>{scaled(a, 1, 1000.0, 5.0), scaled(b, 1, 1000.0, 5.0)});
  for (const double u : {0.2, 0.9, 1.6}) {
    const Point p = degrees.graph(0.5).evaluate(u);
    const Point q = other.graph(0.5).evaluate(u);
    EXPECT_NEAR(p[0], q[0], 1e-6);
    EXPECT_NEAR(1000.0 * p[2] + 5.0, q[2], 1e-3);
  }
  // Unless one says what counts: a coordinate without weight has no say.
  const Curve silly = scaled(b, 0, -3.0, 0.0);
  const MotionOptions without{.weights = {0, 1, 1, 1, 1, 1}};
  const MotionMorph first(std::vector<Curve>{a, b}, without);
  const MotionMorph second(std::vector<Curve>{a, silly}, without);
  EXPECT_EQ(first.match(0).report.path, second.match(0).report.path);
}

// Spec C18: values may stand still. The in-between rests for half as long.
TEST(MotionMorph, PausesAreBlended) {
  const auto with_pause = [](double pause) {
    return spline_near(
        [pause](double t) {
          const double phase = t < 1.0 ? t : std::max(1.0, t - pause);
          // At rest when the pause begins and when it ends.
          return gait(phase - std::sin(2 * std::numbers::pi * phase) / (2 * std::numbers::pi), 0.0);
        },
        0.0, 2.0 + pause, 160);
  };
  const auto rest = [](const Points& rows) {
    double seconds = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      double moved = 0.0;
      for (std::size_t c = 1; c < rows[i].size(); ++c) moved += std::fabs(rows[i][c] - rows[i - 1][c]);
      const double step = rows[i][0] - rows[i - 1][0];
      if (moved < 20.0 * step) seconds += step;  // degrees a second, of hundreds
    }
    return seconds;
  };
  const MotionMorph morph(std::vector<Curve>{with_pause(0.0), with_pause(1.0)});
  const double none = rest(morph.rows(0.0, 400));
  const double whole = rest(morph.rows(1.0, 400));
  EXPECT_NEAR(whole - none, 1.0, 0.1);
  EXPECT_NEAR(rest(morph.rows(0.5, 400)), 0.5 * (none + whole), 0.15);
  // Nothing that moves at all is legal, too.
  const Curve still = spline_near([](double) { return gait(0.3, 0.0); }, 0.0, 1.0, 10);
  EXPECT_NEAR(MotionMorph(std::vector<Curve>{still, with_pause(1.0)}).duration(0.5).length(), 2.0, 1e-12);
}

TEST(MotionMorph, SignalsOfOneDimension) {
  const auto bumps = [](double first, double second, double width, double height) {
    return [=](double t) {
      const auto bump = [&](double at) { return std::exp(-(t - at) * (t - at) / (width * width)); };
      return std::vector<double>{height * bump(first) + 0.5 * bump(second)};
    };
  };
  const Curve a = spline_near(bumps(0.3, 0.7, 0.08, 1.0), 0.0, 1.0, 100);
  const Curve b = spline_near(bumps(0.6, 1.3, 0.1, 1.4), 0.0, 1.5, 90);
  const MotionMorph morph(std::vector<Curve>{a, b});
  const Points rows = morph.rows(0.5, 500);
  std::size_t top = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) top = rows[i][1] > rows[top][1] ? i : top;
  // The peaks are put in step: one peak between them in time, and in height.
  EXPECT_NEAR(rows[top][0], 0.45, 0.02);
  EXPECT_NEAR(rows[top][1], 1.2, 0.05);
}

TEST(MotionMorph, PinsForceMoments) {
  const Curve a = walk();
  const Curve b = spline_near([](double t) { return gait(t / 0.7, 1.0); }, 0.0, 1.4, 80);
  MotionOptions options;
  options.match.pins = {{1.0, 0.8}};
  const MotionMorph morph(std::vector<Curve>{a, b}, options);
  EXPECT_NEAR(morph.graph(1.0).evaluate(1.0)[0], 0.8, 1.4e-3);
  EXPECT_GT(std::fabs(MotionMorph(std::vector<Curve>{a, b}).graph(1.0).evaluate(1.0)[0] - 0.8), 0.05);
}

TEST(MotionMorph, GoesThroughSeveralMotions) {
  const std::vector<Curve> motions{walk(),
                                   spline_near([](double t) { return gait(t / 0.9, 0.4); }, 0.0, 1.8, 100),
                                   spline_near([](double t) { return gait(t / 0.7, 1.0); }, 0.0, 1.4, 80)};
  for (const bool smooth : {false, true}) {
    const MotionMorph morph(motions, {.times = {0, 0.3, 1}, .smooth = smooth});
    EXPECT_EQ(morph.is_smooth(), smooth);
    EXPECT_NEAR(morph.duration(0.3).hi, 1.8, 1e-12);
    const Points rows = morph.rows(0.3, 60);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t c = 0; c < 6; ++c)
        EXPECT_NEAR(rows[i][c + 1], motions[1].evaluate(rows[i][0])[c], 1e-9);
    }
    const auto hip = [&](double s) { return morph.graph(s).evaluate(0.9)[1]; };
    const double before = (hip(0.3) - hip(0.3 - 1e-4)) / 1e-4;
    const double behind = (hip(0.3 + 1e-4) - hip(0.3)) / 1e-4;
    EXPECT_EQ(std::fabs(before - behind) < 0.05 * std::fabs(before), smooth) << before << " " << behind;
  }
}

TEST(MotionMorph, RefusesWhatIsNone) {
  const Curve a = walk();
  const Curve other = spline_near([](double t) { return std::vector<double>{t, t * t}; }, 0.0, 1.0, 10);
  EXPECT_THROW((void)MotionMorph(std::vector<Curve>{a}), InvalidArgument);
  EXPECT_THROW((void)MotionMorph(std::vector<Curve>{a, other}), InvalidArgument);
  EXPECT_THROW((void)MotionMorph(std::vector<Curve>{a, a}, {.weights = {1, 1}}), InvalidArgument);
  EXPECT_THROW((void)MotionMorph(std::vector<Curve>{other, other}, {.weights = {1, -1}}), InvalidArgument);
  EXPECT_THROW((void)MotionMorph(std::vector<Curve>{a, a}, {.time_weight = std::nan("")}), InvalidArgument);
  MotionOptions backwards;
  backwards.match.direction = Direction::reversed;
  EXPECT_THROW((void)MotionMorph(std::vector<Curve>{a, a}, backwards), InvalidArgument);
  const Curve rational(1, {0, 0, 1, 1}, Points(1, std::vector<double>{0, 1}), {1, 2});
  EXPECT_THROW((void)graph_of(rational), InvalidArgument);
  const MotionMorph morph(std::vector<Curve>{a, compose(a, warp())});
  EXPECT_THROW((void)morph.rows(0.5, 1), InvalidArgument);
  EXPECT_THROW((void)morph.rows(20.0, 10), InvalidArgument);
}

}  // namespace
}  // namespace tandem
