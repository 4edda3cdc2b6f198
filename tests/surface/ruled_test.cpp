#include "tandem/surface/ruled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "cad_cases.h"
#include "curve/random_curves.h"
#include "surface/measure_rulings.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"
#include "tandem/error.h"
#include "tandem/surface/developable.h"
#include "tandem/surface/edit.h"

namespace tandem {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Largest distance of two curves over one domain, relative to the size.
double gap(const Curve& a, const Curve& b) {
  double most = 0.0;
  for (int i = 0; i <= 500; ++i) {
    const double u = a.domain().lo + a.domain().length() * i / 500;
    const Point p = a.evaluate(u);
    const Point q = b.evaluate(u);
    for (std::size_t c = 0; c < p.size(); ++c) most = std::max(most, std::fabs(p[c] - q[c]));
  }
  return most / a.extent();
}

/// Largest distance of points of `b` in step from the curve `b`, relative to the size: the geometry is kept.
double off_curve(const RuledSurface& ruled, const Curve& b) {
  double most = 0.0;
  const Reparametrization& r = ruled.match.reparametrization;
  const Curve edge = iso_curve(ruled.surface, Along::u, 1.0);
  for (int i = 0; i <= 500; ++i) {
    const double u = edge.domain().lo + edge.domain().length() * i / 500;
    double v = r.v.evaluate(u)[0];
    const Interval d = b.domain();
    v -= std::floor((v - d.lo) / d.length()) * (b.is_closed() ? d.length() : 0.0);
    if (r.reversed) v = d.lo + d.hi - v;
    const Point p = b.evaluate(v);
    const Point q = edge.evaluate(u);
    for (std::size_t c = 0; c < p.size(); ++c) most = std::max(most, std::fabs(p[c] - q[c]));
  }
  return most / b.extent();
}

/// Signs of the Jacobian of a planar surface (the third coordinate is left out) on a grid: the share of cells
/// with the rarer one.
double rarer_sign(const Surface& surface) {
  int signs[2] = {0, 0};
  const Interval u = surface.domain(Along::u);
  for (int i = 0; i < 1500; ++i) {
    for (int j = 0; j < 40; ++j) {
      const Points d = surface.derivatives(u.lo + u.length() * (i + 0.5) / 1500, (j + 0.5) / 40, 1);
      ++signs[d[1][0] * d[2][1] - d[1][1] * d[2][0] > 0.0 ? 1 : 0];
    }
  }
  return static_cast<double>(std::min(signs[0], signs[1])) / (signs[0] + signs[1]);
}

// Figures 1(a) and 7(a).
TEST(Ruled, UShapesDoNotFoldOver) {
  const std::vector<Curve> u = testing::cad_case("U_planar");
  const RuledSurface ruled = rule(u[0], u[1]);
  EXPECT_TRUE(ruled.report.planar);
  EXPECT_EQ(ruled.report.norm, "ruled");
  EXPECT_TRUE(ruled.report.validity.valid);
  EXPECT_EQ(ruled.report.wrong_sign_share, 0.0);
  EXPECT_EQ(rarer_sign(ruled.surface), 0.0);
  EXPECT_EQ(ruled.report.law.outcome, LawOutcome::as_asked);
  EXPECT_EQ(ruled.report.law.order, 4);
  EXPECT_LE(gap(iso_curve(ruled.surface, Along::u, 0.0), u[0]), 1e-12);
  EXPECT_LE(off_curve(ruled, u[1]), 1e-12);
}

/// The same of the area, of the surface's own partial derivatives.
double rarer_area(const Surface& surface) {
  double areas[2] = {0.0, 0.0};
  // Span by span: a law may run through much of its curve within a hair of the domain.
  const std::vector<Knot> knots = distinct_knots(surface.knots(Along::u));
  for (std::size_t span = 0; span + 1 < knots.size(); ++span) {
    const int places = 40 + 2000 / static_cast<int>(knots.size());
    const double step = (knots[span + 1].value - knots[span].value) / places;
    for (int i = 0; i < places; ++i) {
      for (int j = 0; j < 40; ++j) {
        const Points d = surface.derivatives(knots[span].value + (i + 0.5) * step, (j + 0.5) / 40, 1);
        const double jacobian = d[1][0] * d[2][1] - d[1][1] * d[2][0];
        areas[jacobian > 0.0 ? 1 : 0] += std::fabs(jacobian) * step;
      }
    }
  }
  return std::min(areas[0], areas[1]) / (areas[0] + areas[1]);
}

// The measure that the one above is held against. By parameter a quarter of the rulings has the wrong sign
// somewhere, and a tenth of the area.
TEST(Ruled, MeasuresTheWrongSign) {
  const std::vector<Curve> u = testing::cad_case("U_planar");
  const Surface naive = Surface::of_rows(u, 1, {0, 0, 1, 1});
  const double share = detail::wrong_sign_share(u[0], u[1]);
  EXPECT_GT(share, 0.1);
  EXPECT_NEAR(share, rarer_area(naive), 1e-3);
  EXPECT_EQ(detail::wrong_sign_share(u[0], rule(u[0], u[1]).match.curve), 0.0);
}

TEST(Ruled, MatchesInThePlaneThatTheCurvesLieIn) {
  const std::vector<Curve> u = testing::cad_case("U_planar");
  std::vector<Curve> tilted;
  for (const Curve& curve : u) {
    Points points = curve.control_points();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double x = points[i][0];
      points[i][0] = 0.8 * x + 7.0;
      points[i][2] = 0.6 * x - 3.0;
    }
    tilted.emplace_back(curve.degree(), curve.knots(), std::move(points));
  }
  const RuledSurface flat = rule(u[0], u[1]);
  const RuledSurface ruled = rule(tilted[0], tilted[1]);
  EXPECT_TRUE(ruled.report.planar);
  EXPECT_EQ(ruled.surface.dim(), 3);
  EXPECT_NEAR(ruled.report.validity.min_dot, flat.report.validity.min_dot, 1e-6);
  EXPECT_LE(off_curve(ruled, tilted[1]), 1e-12);
}

// Figure 3: a wave and its own translation, whose tangents match perfectly.
TEST(Ruled, EqualTangentsAreNotEnough) {
  const auto wave = [](double dx, double dy) {
    Points points(2, 50);
    for (std::size_t i = 0; i < 50; ++i) {
      const double x = 4.0 * std::numbers::pi * static_cast<double>(i) / 49.0;
      points[i][0] = x + dx;
      points[i][1] = 3.0 * std::cos(x) + dy;
    }
    return Curve::clamped_uniform(3, std::move(points));
  };
  const Curve a = wave(0.0, 0.0);
  const Curve b = wave(2.0, 5.6);
  EXPECT_GT(match(a, b).report.validity.min_dot, 0.99);
  EXPECT_GT(detail::wrong_sign_share(a, match(a, b).curve), 1e-3);
  const RuledSurface ruled = rule(a, b);
  EXPECT_TRUE(ruled.report.validity.valid);
  EXPECT_EQ(rarer_area(ruled.surface), 0.0);
}

// Figure 10.
TEST(Ruled, LettersKeepTheirFeatures) {
  const std::vector<Curve> letters = testing::cad_case("letters_EF");
  const RuledSurface ruled = rule(letters[0], letters[1]);
  EXPECT_FALSE(ruled.report.planar);
  EXPECT_EQ(ruled.report.norm, "anti-twist");
  EXPECT_GE(ruled.report.tangents.valid_share, 1.0 - 0.002);
  EXPECT_LE(ruled.report.rulings.crease_angle, 1.0 * kDegree);
  EXPECT_LE(gap(iso_curve(ruled.surface, Along::u, 0.0), letters[0]), 1e-12);
  EXPECT_LE(off_curve(ruled, letters[1]), 1e-12);
  EXPECT_TRUE(ruled.surface.is_closed(Along::u));

  // The same by other samples: the figure must not hang on their places.
  RuleOptions options;
  options.match.samples = {200, 200};
  EXPECT_GE(rule(letters[0], letters[1], options).report.tangents.valid_share, 1.0 - 0.002);
}

// Either letter may come first: what stands still, for want of an arm, may be the first curve or the second.
TEST(Ruled, LettersMayBeExchanged) {
  const std::vector<Curve> letters = testing::cad_case("letters_EF");
  EXPECT_GE(rule(letters[1], letters[0]).report.tangents.valid_share, 0.998);
}

TEST(Ruled, PiecewiseLinearLawsCreaseAndTheReportSaysSo) {
  const std::vector<Curve> letters = testing::cad_case("letters_EF");
  RuleOptions options;
  options.law.order = 2;
  options.largest_crease = std::numbers::pi;
  const RuledSurface ruled = rule(letters[0], letters[1], options);
  EXPECT_EQ(ruled.report.law.order, 2);
  EXPECT_GT(ruled.report.rulings.crease_angle, 5.0 * kDegree);
  const double u = ruled.report.rulings.crease_u;
  double seen = 0.0;
  for (int j = 0; j <= 20; ++j) {
    const Point left = ruled.surface.normal(u, j / 20.0, {Side::left, Side::right});
    const Point right = ruled.surface.normal(u, j / 20.0, {Side::right, Side::right});
    seen = std::max(seen,
                    std::acos(std::min(1.0, left[0] * right[0] + left[1] * right[1] + left[2] * right[2])));
  }
  EXPECT_NEAR(seen, ruled.report.rulings.crease_angle, 0.02);
}

// Figure 4, left: mutual tangency. Both products of (6) change their sign there, and stay positive together.
TEST(Ruled, CurvesThatTouchAndCrossAreInvalid) {
  const Curve a = Curve::bezier({{-3, -3}, {-1, 3}, {1, -3}, {3, 3}});
  const Curve b = Curve::bezier({{-3, 0}, {3, 0}});
  const RuledSurface ruled = rule(a, b);
  EXPECT_FALSE(ruled.report.validity.valid);
  EXPECT_GT(ruled.report.wrong_sign_share, 0.1);
}

// Figure 4: curves that cross cannot be joined without folding over.
TEST(Ruled, CurvesThatCrossAreInvalid) {
  const Curve a = Curve::bezier({{0, 0}, {2, 3}, {4, 3}, {6, 0}});
  const Curve b = Curve::bezier({{0, 2}, {2, -1}, {4, 0}, {6, 3}});
  const RuledSurface ruled = rule(a, b);
  EXPECT_FALSE(ruled.report.validity.valid);
  EXPECT_GT(ruled.report.wrong_sign_share, 0.01);
  EXPECT_NEAR(ruled.report.wrong_sign_share, rarer_area(ruled.surface), 2e-3);
}

TEST(Ruled, RationalCurvesAreExactToo) {
  testing::RandomCurves random(7);
  for (int round = 0; round < 6; ++round) {
    const Curve a = random.curve(2, 3, 3, true, true);
    const Curve b = random.curve(3, 3, 3, round % 2 == 0, true);
    const RuledSurface ruled = rule(a, b);
    EXPECT_LE(gap(iso_curve(ruled.surface, Along::u, 0.0), a), 1e-11) << round;
    EXPECT_LE(off_curve(ruled, b), 1e-11) << round;
  }
}

TEST(Ruled, AReversedCurveGivesTheSameSurface) {
  const std::vector<Curve> u = testing::cad_case("U_planar");
  const RuledSurface forward = rule(u[0], u[1]);
  const RuledSurface backward = rule(u[0], reverse(u[1]));
  EXPECT_TRUE(backward.match.reparametrization.reversed);
  EXPECT_LE(gap(iso_curve(forward.surface, Along::u, 0.5), iso_curve(backward.surface, Along::u, 0.5)), 1e-6);
}

/// A circle of `radius` about (x, y) at height z, as a rational quadratic of four quarters.
Curve circle(double radius, double x, double y, double z) {
  const double w = std::sqrt(0.5);
  Points points(3, 9);
  std::vector<double> weights;
  const double at[9][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
  for (std::size_t i = 0; i < 9; ++i) {
    points[i][0] = x + radius * at[i][0];
    points[i][1] = y + radius * at[i][1];
    points[i][2] = z;
    weights.push_back(i % 2 == 0 ? 1.0 : w);
  }
  return Curve(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, std::move(points), std::move(weights));
}

/// What pairing by arc length alone would give: the mean warp.
double mean_warp_by_length(const Curve& a, const Curve& b) {
  RuleOptions options;
  options.norm = UserNorm([](const NormArguments&) { return NormValue{}; });
  return rule(a, b, options).report.rulings.mean_warp_angle;
}

// A cylinder cut off askew: the rulings are parallel to its axis.
TEST(Developable, FindsTheRulingsOfACylinder) {
  const auto arc = [](double low, double slope, double bend) {
    Points points(3, 31);
    for (std::size_t i = 0; i < 31; ++i) {
      const double t = 0.1 * static_cast<double>(i);
      points[i][0] = 3.0 * std::cos(t);
      points[i][1] = 2.0 * std::sin(t);
      points[i][2] = low + slope * points[i][0] + bend * std::sin(2.0 * t);
    }
    return Curve::clamped_uniform(3, std::move(points));
  };
  const Curve a = arc(0.0, 0.0, 0.0);
  const Curve b = arc(4.0, 1.5, 0.7);
  RuleOptions options;
  options.developable = true;
  const RuledSurface ruled = rule(a, b, options);
  EXPECT_EQ(ruled.report.norm, "developable");
  EXPECT_LT(ruled.report.rulings.mean_warp_angle, 0.3 * kDegree);
  EXPECT_LT(ruled.report.rulings.warp_angle, 2.0 * kDegree);
  EXPECT_GT(mean_warp_by_length(a, b), 10.0 * ruled.report.rulings.mean_warp_angle);
  // Along the axis: x and y of a point and its partner agree.
  for (double u = 0.1; u < 1.0; u += 0.1) {
    const Point p = ruled.surface.evaluate(u, 0.0);
    const Point q = ruled.surface.evaluate(u, 1.0);
    EXPECT_NEAR(p[0], q[0], 0.02);
    EXPECT_NEAR(p[1], q[1], 0.02);
  }
}

// Two circles about shifted centres lie on an oblique cone.
TEST(Developable, FindsTheRulingsOfAnObliqueCone) {
  const Curve a = circle(3.0, 0.0, 0.0, 0.0);
  const Curve b = circle(1.0, 2.5, 1.0, 4.0);
  RuleOptions options;
  options.developable = true;
  const RuledSurface ruled = rule(a, b, options);
  EXPECT_LT(ruled.report.rulings.warp_angle, 1.0 * kDegree);
}

/// On the tangent surface of a helix, at a distance from it that swings about `near`.
Curve on_tangent_surface(double near, double swing) {
  Points points(3, 41);
  for (std::size_t i = 0; i < 41; ++i) {
    const double t = 0.05 * static_cast<double>(i);
    const double r = near + swing * std::sin(3.0 * t);
    points[i][0] = std::cos(t) - r * std::sin(t);
    points[i][1] = std::sin(t) + r * std::cos(t);
    points[i][2] = 0.6 * t + 0.6 * r;
  }
  return Curve::clamped_uniform(3, std::move(points));
}

TEST(Developable, FindsTheRulingsOfATangentSurface) {
  const Curve a = on_tangent_surface(1.0, 0.0);
  const Curve b = on_tangent_surface(2.5, 0.5);
  RuleOptions options;
  options.developable = true;
  const RuledSurface ruled = rule(a, b, options);
  EXPECT_LT(ruled.report.rulings.mean_warp_angle, 0.5 * kDegree);
  EXPECT_GT(mean_warp_by_length(a, b), 5.0 * ruled.report.rulings.mean_warp_angle);
}

TEST(Developable, KeepsRulingsFromLeaning) {
  const Curve a = on_tangent_surface(1.0, 0.0);
  const Curve b = on_tangent_surface(2.5, 0.5);
  RuleOptions options;
  options.developable = true;
  const RuledSurface free = rule(a, b, options);
  options.largest_inclination = 0.8 * free.report.rulings.mean_inclination;
  const RuledSurface held = rule(a, b, options);
  EXPECT_LT(held.report.rulings.mean_inclination, free.report.rulings.mean_inclination);
  EXPECT_GT(held.report.rulings.mean_warp_angle, free.report.rulings.mean_warp_angle);
}

TEST(Developable, MeasuresOneRuling) {
  const Point along_x = {1, 0, 0};
  const Point turned = {std::cos(0.3), std::sin(0.3), 0};
  const Point origin = {0, 0, 0};
  const Point above = {0, 0, 2};
  EXPECT_NEAR(ruling_of({along_x, turned, origin, above}).warp, 0.3, 1e-15);
  EXPECT_NEAR(ruling_of({along_x, turned, origin, above}).inclination, 0.0, 1e-15);
  const Point askew = {1, 0, 1};
  EXPECT_NEAR(ruling_of({along_x, along_x, origin, askew}).warp, 0.0, 1e-15);
  EXPECT_NEAR(ruling_of({along_x, along_x, origin, askew}).inclination, 45 * kDegree, 1e-15);
  EXPECT_EQ(ruling_of({along_x, turned, origin, origin}).warp, 0.0);
}

std::string message_of(const Curve& a, const Curve& b, const RuleOptions& options = {}) {
  try {
    static_cast<void>(rule(a, b, options));
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "nothing thrown";
}

// However the outline is run through, it is the same one; one that only shares most of it is not.
TEST(Ruled, RefusesOneOutlineTwice) {
  for (const char* name : {"letters_EF", "U_planar"}) {
    const Curve curve = testing::cad_case(name)[0];
    std::vector<Curve> same = {reverse(curve), insert_knot(elevate_degree(curve), 0.37)};
    if (curve.is_closed()) {
      for (const double seam : {0.11, 0.5, 0.73}) same.push_back(move_seam(curve, seam));
    }
    for (const Curve& other : same)
      EXPECT_NE(message_of(curve, other).find("coincide"), std::string::npos) << name;
    Points points = curve.control_points();
    points[points.size() / 2][0] += 1e-3 * curve.extent();
    const Curve near(curve.degree(), curve.knots(), points, curve.weights());
    EXPECT_EQ(message_of(curve, near).find("coincide"), std::string::npos) << name;
  }
}

// Between a curve and nearly itself, slopes far from the mean are wanted: the law cannot follow, and says so.
TEST(Ruled, SaysThatALawIsNotAsAsked) {
  // The second curve hurries through the first half of its way.
  const Curve a = Curve::bezier({{0, 0}, {1, 0}, {2, 0}, {3, 0}});
  const Curve b(1, {0, 0, 1e-4, 1, 1}, Points({{0, 1}, {1.5, 1}, {3, 1}}));
  RuleOptions options;
  options.law.min_slope = 0.5;
  const RuledSurface slow = rule(a, b, options);
  EXPECT_GT(slow.report.law.max_deviation, options.law.tolerance);
  EXPECT_EQ(slow.report.law.outcome, LawOutcome::beyond_tolerance);
  const RuledSurface free = rule(a, b, {.law = {.min_slope = 1e-6}});
  EXPECT_LE(free.report.law.max_deviation, options.law.tolerance);
  EXPECT_EQ(free.report.law.outcome, LawOutcome::as_asked);
}

TEST(Ruled, CanBeCancelledBetweenLaws) {
  // Not while it is matched, but once that is done.
  int after = 0;
  RuleOptions options;
  options.match.progress = [&](double fraction) { return fraction < 1.0 || ++after < 2; };
  const std::vector<Curve> letters = testing::cad_case("letters_EF");
  EXPECT_TRUE(rule(letters[0], letters[1], options).match.report.cancelled);
}

TEST(Ruled, SaysWhatIsWrongWithItsInput) {
  const Curve line = Curve::bezier({{0, 0, 0}, {1, 0, 0}});
  const Curve further = Curve::bezier({{2, 0, 0}, {5, 0, 0}});
  const Curve planar = Curve::bezier({{0, 0}, {1, 1}});
  const Curve scalar = Curve::bezier({{0}, {1}});
  const std::vector<Curve> letters = testing::cad_case("letters_EF");
  EXPECT_NE(message_of(line, planar).find("different dimensions"), std::string::npos);
  EXPECT_NE(message_of(scalar, scalar).find("dimension 1"), std::string::npos);
  EXPECT_NE(message_of(line, further).find("on one line"), std::string::npos);
  EXPECT_NE(message_of(letters[0], line).find("first curve is closed, the second open"), std::string::npos);
  EXPECT_NE(message_of(letters[0], letters[0]).find("coincide"), std::string::npos);
  RuleOptions options;
  options.planar = true;
  EXPECT_NE(message_of(letters[0], letters[1], options).find("one plane"), std::string::npos);
  options = {};
  options.largest_inclination = 0.5;
  EXPECT_NE(message_of(letters[0], letters[1], options).find("inclination"), std::string::npos);
}

}  // namespace
}  // namespace tandem
