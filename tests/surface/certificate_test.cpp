#include "tandem/surface/certificate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "cad_cases.h"
#include "planar_pairs.h"
#include "random_surfaces.h"
#include "tandem/curve/compatible.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"
#include "tandem/surface/edit.h"
#include "tandem/surface/ruled.h"
#include "tandem/surface/tessellate.h"

namespace tandem {
namespace {

using testing::CurvePair;
using testing::PlanarPairs;

// A witness as somebody would check it who does not know how it was found.
bool is_true(const Witness& witness, const CurvePair& pair) {
  const auto& places = witness.places;
  switch (witness.kind) {
    case WitnessKind::sign_change:
      return testing::jacobian(pair, places[0].u, places[0].v) *
                 testing::jacobian(pair, places[1].u, places[1].v) <
             0;
    case WitnessKind::zero:
      return std::abs(testing::jacobian(pair, places[0].u, places[0].v)) < 1e-15L;
    case WitnessKind::crossing: {
      const auto p = testing::ruled_point(pair, places[0].u, places[0].v);
      const auto q = testing::ruled_point(pair, places[1].u, places[1].v);
      const bool apart =
          std::abs(places[0].u - places[1].u) > 1e-6 || std::abs(places[0].v - places[1].v) > 1e-6;
      return apart && std::hypot(p[0] - q[0], p[1] - q[1]) < 1e-12L;
    }
    case WitnessKind::triangles:
      break;
  }
  return false;
}

TEST(Certificate, IsNeverWrongAndSeldomSilentOnRandomPairs) {
  PlanarPairs pairs(7);
  int free = 0;
  int certified = 0;
  int bad = 0;
  int violated = 0;
  for (int i = 0; i < 2000; ++i) {
    const CurvePair pair = pairs.next();
    const Certificate certificate = certify(pair.a, pair.b);
    const testing::DenseSamples samples = testing::sample_densely(pair, 1600);
    (samples.free() ? free : bad)++;
    if (certificate.verdict == Verdict::certified) {
      EXPECT_TRUE(samples.free()) << "pair " << i;
      if (samples.free()) ++certified;
    }
    if (certificate.verdict == Verdict::violated) {
      ASSERT_TRUE(certificate.witness) << "pair " << i;
      EXPECT_TRUE(is_true(*certificate.witness, pair))
          << "pair " << i << " kind " << static_cast<int>(certificate.witness->kind);
      if (!samples.free()) ++violated;
    }
  }
  EXPECT_GT(free, 400);
  EXPECT_GT(bad, 400);
  EXPECT_GE(certified, 0.95 * free);
  EXPECT_GE(violated, 0.90 * bad);
}

// A surface over the same curves, the general way and in space.
Surface ruled(const CurvePair& pair) {
  const std::vector<Curve> rows = with_common_denominator(std::vector<Curve>{pair.a, pair.b});
  return Surface::of_rows(rows, 1, {0, 0, 1, 1});
}

TEST(Certificate, OfASurfaceIsThatOfItsRails) {
  PlanarPairs pairs(8);
  int certified = 0;
  for (int i = 0; i < 100; ++i) {
    const CurvePair pair = pairs.next();
    const Certificate of_pair = certify(pair.a, pair.b);
    const Surface surface = ruled(pair);
    const Certificate of_rows = certify(surface);
    EXPECT_EQ(of_rows.verdict, of_pair.verdict) << i;
    // Degree 2 along v: no longer the case of ruled surfaces.
    const Surface higher = elevate_degree(surface, Along::v);
    const Certificate of_patches = certify(higher);
    EXPECT_EQ(of_patches.verdict, of_pair.verdict) << i;
    EXPECT_EQ(of_patches.regular, of_pair.regular) << i;
    EXPECT_EQ(of_patches.one_to_one, of_pair.one_to_one) << i;
    const Certificate across = certify(transpose(higher));
    EXPECT_EQ(across.verdict, of_pair.verdict) << i;
    if (of_patches.witness && of_patches.witness->kind == WitnessKind::sign_change) {
      EXPECT_TRUE(is_true(*of_patches.witness, pair)) << i;
    }
    if (of_pair.verdict == Verdict::certified) ++certified;
  }
  EXPECT_GT(certified, 20);
  EXPECT_LT(certified, 90);
}

// A pair that makes a good surface, and one that does not: rails that run apart.
CurvePair wavy_strip(double distance) {
  Points a(2, 12);
  Points b(2, 12);
  for (std::size_t i = 0; i < 12; ++i) {
    const auto t = static_cast<double>(i) / 11.0;
    a[i][0] = b[i][0] = 4.0 * t;
    a[i][1] = std::sin(5.0 * t);
    b[i][1] = a[i][1] + distance;
  }
  return {Curve::clamped_uniform(3, a), Curve::clamped_uniform(3, b)};
}

CurvePair folded_strip() {
  CurvePair pair = wavy_strip(0.7);
  Points points = pair.b.control_points();
  std::swap_ranges(points[3].begin(), points[3].end(), points[7].begin());
  return {std::move(pair.a), Curve(3, pair.b.knots(), points)};
}

CurvePair mapped(const CurvePair& pair, double factor, double shift) {
  const auto map = [&](const Curve& curve) {
    Points points = curve.control_points();
    for (double& x : points.data()) x = factor * x + shift;
    return Curve(curve.degree(), curve.knots(), points, curve.weights());
  };
  return {map(pair.a), map(pair.b)};
}

TEST(Certificate, DoesNotDependOnSizeOrPlace) {
  for (const auto& [factor, shift] : std::vector<std::array<double, 2>>{
           {1.0, 0.0}, {1e150, 0.0}, {1e-150, 0.0}, {1e300, 0.0}, {1e-300, 0.0}, {1.0, 1e8}, {1e-3, -1e6}}) {
    EXPECT_EQ(
        certify(mapped(wavy_strip(0.4), factor, shift).a, mapped(wavy_strip(0.4), factor, shift).b).verdict,
        Verdict::certified)
        << factor << ", " << shift;
    const CurvePair folded = mapped(folded_strip(), factor, shift);
    const Certificate certificate = certify(folded.a, folded.b);
    ASSERT_EQ(certificate.verdict, Verdict::violated) << factor << ", " << shift;
    EXPECT_TRUE(is_true(*certificate.witness, folded)) << factor << ", " << shift;
  }
}

TEST(Certificate, TellsNearlyTouchingFromTouching) {
  for (const double distance : {1e-2, 1e-4, 1e-6, 1e-10}) {
    const CurvePair pair = wavy_strip(distance);
    const Certificate certificate = certify(pair.a, pair.b);
    EXPECT_NE(certificate.verdict, Verdict::violated) << distance;
    if (distance >= 1e-6) {
      EXPECT_EQ(certificate.verdict, Verdict::certified) << distance;
    }
  }
  // The same curve twice: no surface at all.
  const CurvePair none = wavy_strip(0.0);
  EXPECT_EQ(certify(none.a, none.b).verdict, Verdict::violated);
}

// A strip that comes round and all but meets its own beginning, or does.
TEST(Certificate, FindsEndsThatOverlap) {
  for (const double gap : {1e-2, 1e-5, -1e-5, -1e-2}) {
    const auto arc = [&](double radius) {
      Points points(2, 40);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double turn = 1.1 * 6.283185307179586 * static_cast<double>(i) / 39.0;
        const double r = radius + (0.3 + gap) * turn / 6.283185307179586;
        points[i][0] = r * std::cos(turn);
        points[i][1] = r * std::sin(turn);
      }
      return Curve::clamped_uniform(1, points);
    };
    const CurvePair pair = {arc(1.0), arc(1.3)};
    const Certificate certificate = certify(pair.a, pair.b);
    EXPECT_EQ(certificate.regular, Verdict::certified) << gap;
    if (gap == 1e-2) {
      EXPECT_EQ(certificate.verdict, Verdict::certified);
    }
    if (gap > -1e-4) continue;
    ASSERT_EQ(certificate.one_to_one, Verdict::violated) << gap;
    EXPECT_EQ(certificate.witness->kind, WitnessKind::crossing);
    EXPECT_TRUE(is_true(*certificate.witness, pair)) << gap;
  }
}

// [C] Figure 4: no pairing of these curves makes a surface free of self-intersection. On the left a curve
// hides parts of itself from the other one, so that a ruling must become tangent to both; on the right the
// end regions overlap.
TEST(Certificate, IsNeverGivenWhereNoPairingExists) {
  const Points bulb({{-1, 0},
                     {-0.4, 0},
                     {-0.2, 0},
                     {-0.2, -0.4},
                     {-2, -0.8},
                     {-2, -2.5},
                     {2, -2.5},
                     {2, -0.8},
                     {0.2, -0.4},
                     {0.2, 0},
                     {0.4, 0},
                     {1, 0}});
  const Curve hidden = Curve::clamped_uniform(3, bulb);
  Points spiral(2, 24);
  Points outer(2, 24);
  for (std::size_t i = 0; i < 24; ++i) {
    const double turn = 8.0 * static_cast<double>(i) / 23.0;
    for (Points* points : {&spiral, &outer}) {
      const double r = (points == &spiral ? 1.0 : 1.4) + 0.02 * turn;
      (*points)[i][0] = r * std::cos(turn);
      (*points)[i][1] = r * std::sin(turn);
    }
  }
  testing::RandomCurves random(11);
  for (int i = 0; i < 60; ++i) {
    Points line(2, 9);
    double at = -1.2;
    for (std::size_t k = 0; k < line.size(); ++k) {
      line[k][0] = at;
      line[k][1] = 1.0;
      at += std::pow(10.0, random.uniform(-2.0, 0.0));
    }
    for (std::size_t k = 0; k < line.size(); ++k) line[k][0] = -1.2 + 2.4 * (line[k][0] + 1.2) / (at + 1.2);
    const CurvePair left = {hidden, Curve::clamped_uniform(2, line)};
    // As fast along the one as along the other, or not.
    std::vector<double> knots = {0, 0, 0, 0, 1, 1, 1, 1};
    for (int k = 0; k < 20; ++k) knots.push_back(std::pow(random.uniform(0.0, 1.0), 1.5));
    std::sort(knots.begin(), knots.end());
    const CurvePair right = {Curve::clamped_uniform(3, spiral), Curve(3, knots, outer)};
    for (const CurvePair& pair : {left, right}) {
      const Certificate certificate = certify(pair.a, pair.b);
      ASSERT_EQ(certificate.verdict, Verdict::violated) << i;
      EXPECT_TRUE(is_true(*certificate.witness, pair)) << i;
    }
  }
}

TEST(Certificate, OfTheUShapedCaseDependsOnThePairing) {
  const std::vector<Curve> curves = testing::cad_case("U_planar");
  const auto in_plane = [](const Curve& curve) {
    Points points(2, curve.size());
    for (std::size_t i = 0; i < curve.size(); ++i) {
      points[i][0] = curve.control_points()[i][0];
      points[i][1] = curve.control_points()[i][1];
    }
    return Curve(curve.degree(), curve.knots(), points, curve.weights());
  };
  const Certificate natural = certify(curves[0], curves[1]);
  ASSERT_EQ(natural.verdict, Verdict::violated);
  EXPECT_EQ(natural.regular, Verdict::violated);
  EXPECT_EQ(natural.one_to_one, Verdict::violated);
  const CurvePair pair = {in_plane(curves[0]), in_plane(curves[1])};
  EXPECT_TRUE(is_true(*natural.witness, pair));
  EXPECT_EQ(natural.witness->places[0].point.size(), 3U);
  // The place of the rarer sign comes first.
  const double sign = natural.witness->places[0].jacobian;
  EXPECT_LT(sign * natural.witness->places[1].jacobian, 0.0);
  EXPECT_NEAR(static_cast<double>(
                  testing::jacobian(pair, natural.witness->places[0].u, natural.witness->places[0].v)),
              sign, 1e-9 * std::abs(sign));

  const RuledSurface matched = rule(curves[0], curves[1]);
  const Certificate certificate = certify(matched.surface);
  EXPECT_EQ(certificate.verdict, Verdict::certified);
  EXPECT_EQ(certificate.regular, Verdict::certified);
  EXPECT_EQ(certificate.one_to_one, Verdict::certified);
  EXPECT_FALSE(certificate.witness);
}

TEST(Certificate, TakesCommonEndPoints) {
  const Points below({{0, 0}, {1, -1}, {2, -1}, {3, 0}});
  const Points above({{0, 0}, {1, 1}, {2, 1}, {3, 0}});
  const Curve a = Curve::bezier(below);
  EXPECT_EQ(certify(a, Curve::bezier(above)).verdict, Verdict::certified);
  // One end in common.
  const Points beside({{0, 0}, {1, 1}, {2, 1}, {3, 1}});
  EXPECT_EQ(certify(a, Curve::bezier(beside)).verdict, Verdict::certified);
  // Tangent to each other there: not proved, and not denied.
  const Points tangent({{0, 0}, {0.5, -0.5}, {2, 1}, {3, 1}});
  EXPECT_NE(certify(a, Curve::bezier(tangent)).verdict, Verdict::violated);
  // The end of one at the start of the other.
  const Points turned({{3, 0}, {2, 1}, {1, 1}, {0, 0}});
  EXPECT_EQ(certify(a, Curve::bezier(turned)).verdict, Verdict::violated);
}

TEST(Certificate, TakesKnotsAndControlPointsThatCoincide) {
  const CurvePair smooth = wavy_strip(0.4);
  // Knots of full multiplicity, and a span of 1e-13 of the domain.
  Curve a = insert_knot(insert_knot(smooth.a, 0.3, 3), 0.7, 2);
  const Curve b = insert_knot(insert_knot(smooth.b, 0.3 + 1e-13, 2), 0.5, 3);
  EXPECT_EQ(certify(a, b).verdict, Verdict::certified);
  // A corner where the rail stops for a moment: the Jacobian is zero there, and no harm is done otherwise.
  const Points stopping({{0, 0}, {1, 0}, {2, 0}, {2, 0}, {2, 0}, {3, 0.3}, {4, 0}});
  const std::vector<double> knots = {0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1};
  const Points running({{0, 1}, {1, 1}, {1.5, 1}, {2, 1}, {2.5, 1}, {3, 1}, {4, 1}});
  const CurvePair pair = {Curve(3, knots, stopping), Curve(3, knots, running)};
  const Certificate certificate = certify(pair.a, pair.b);
  EXPECT_EQ(certificate.regular, Verdict::violated);
  EXPECT_EQ(certificate.one_to_one, Verdict::certified);
  ASSERT_TRUE(certificate.witness);
  EXPECT_EQ(certificate.witness->kind, WitnessKind::zero);
  EXPECT_DOUBLE_EQ(certificate.witness->places[0].u, 0.5);
  // The same at an end, by a handle of length zero and with coordinates that are no round numbers.
  const Curve handle = Curve::bezier(Points({{0.1, 0.3}, {0.1, 0.3}, {0.7, 0.2}, {1.3, 0.7}}));
  const Certificate of_handle = certify(handle, Curve::bezier(Points({{-0.1, 1.1}, {0.3, 1.7}, {1.1, 1.3}})));
  EXPECT_EQ(of_handle.regular, Verdict::violated);
  EXPECT_EQ(of_handle.one_to_one, Verdict::certified);
  // A cusp that is no corner: there and back.
  const Curve cusp = Curve::bezier(Points({{0, 0}, {3, 0.5}, {0, 0.5}, {3, 0}}));
  EXPECT_NE(certify(cusp, Curve::bezier(Points({{0, 1}, {1, 1}, {2, 1}, {3, 1}}))).verdict,
            Verdict::certified);
}

TEST(Certificate, ClosesSeamsThatAreOpenByRounding) {
  const auto ring = [](double radius, double gap) {
    Points points(2, 21);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double turn = 6.283185307179586 * static_cast<double>(i % 20) / 20.0;
      points[i][0] = radius * std::cos(turn);
      points[i][1] = radius * std::sin(turn) + (i == 20 ? gap : 0.0);
    }
    return Curve::clamped_uniform(3, points);
  };
  for (const double gap : {0.0, 1e-15, 1e-11})
    EXPECT_EQ(certify(ring(1.0, gap), ring(0.6, -gap)).verdict, Verdict::certified) << gap;
  // An open seam that overlaps is no seam.
  EXPECT_EQ(certify(ring(1.0, 1e-3), ring(0.6, 1e-3)).verdict, Verdict::violated);
  // Beside each other rather than one in the other.
  const CurvePair beside = mapped({ring(1.0, 0.0), ring(0.6, 0.0)}, 1.0, 0.0);
  EXPECT_EQ(certify(beside.a, mapped(beside, 1.0, 3.0).b).verdict, Verdict::violated);
  // Closed one and open one.
  EXPECT_EQ(certify(ring(1.0, 0.0), Curve::bezier(Points({{2, -1}, {3, 0}, {2, 2}}))).verdict,
            Verdict::violated);
}

TEST(Certificate, InSpaceIsOfRegularityAndTheTessellation) {
  const auto rail = [](double height, double turn) {
    Points points(3, 14);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double angle = 5.0 * static_cast<double>(i) / 13.0 + turn;
      points[i][0] = std::cos(angle);
      points[i][1] = std::sin(angle);
      points[i][2] = height + 0.1 * angle;
    }
    return Curve::clamped_uniform(3, points);
  };
  const Surface good = Surface::of_rows(std::array{rail(0, 0), rail(1, 0.5)}, 1, {0, 0, 1, 1});
  const Certificate certificate = certify(good, tessellate(good));
  EXPECT_EQ(certificate.verdict, Verdict::certified);
  EXPECT_EQ(certificate.regular, Verdict::certified);
  EXPECT_EQ(certificate.tessellation_simple, Verdict::certified);
  EXPECT_FALSE(certificate.one_to_one);
  // Turned by half a turn all rulings meet in the axis: regular, but one point many times.
  const Surface twisted = Surface::of_rows(std::array{rail(0, 0), rail(1, 3.4)}, 1, {0, 0, 1, 1});
  const Certificate of_twisted = certify(twisted, tessellate(twisted));
  EXPECT_EQ(of_twisted.verdict, Verdict::violated);
  EXPECT_EQ(of_twisted.tessellation_simple, Verdict::violated);
  EXPECT_EQ(of_twisted.witness->kind, WitnessKind::triangles);
  // Whitney's umbrella (x, x y, y^2): not regular at (0, 0).
  const Surface umbrella(
      {1, 2}, {std::vector<double>{-1, -1, 2, 2}, {-1, -1, -1, 1.5, 1.5, 1.5}},
      Points({{-1, 1, 1}, {-1, -0.25, -1.5}, {-1, -1.5, 2.25}, {2, -2, 1}, {2, 0.5, -1.5}, {2, 3, 2.25}}));
  const Certificate of_umbrella = certify(umbrella);
  EXPECT_EQ(of_umbrella.regular, Verdict::violated);
  ASSERT_TRUE(of_umbrella.witness);
  EXPECT_EQ(of_umbrella.witness->kind, WitnessKind::zero);
  EXPECT_NEAR(of_umbrella.witness->places[0].u, 0.0, 3e-6);
  EXPECT_NEAR(of_umbrella.witness->places[0].v, 0.0, 2.5e-6);
  // A cone to its tip, which is one point.
  Points tip(3, 14);
  for (std::size_t i = 0; i < tip.size(); ++i) tip[i][2] = 2.0;
  const Surface cone =
      Surface::of_rows(std::array{rail(0, 0), Curve::clamped_uniform(3, tip)}, 1, {0, 0, 1, 1});
  EXPECT_EQ(certify(cone).regular, Verdict::certified);
}

// |S_u x S_v| / (|S_u| |S_v|).
double sine_of_parameters(const Surface& surface, double u, double v) {
  const Points d = surface.derivatives(u, v, 1);
  const double x = d[1][1] * d[2][2] - d[1][2] * d[2][1];
  const double y = d[1][2] * d[2][0] - d[1][0] * d[2][2];
  const double z = d[1][0] * d[2][1] - d[1][1] * d[2][0];
  return std::hypot(x, y, z) /
         (std::hypot(d[1][0], d[1][1], d[1][2]) * std::hypot(d[2][0], d[2][1], d[2][2]));
}

// Moved into a plane that is tilted, with all the rounding that comes of it.
Surface tilted(const Surface& flat, double a, double b, double shift) {
  Points points(3, flat.control_points().size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto p = flat.control_points()[i];
    const std::array<double, 3> q = {p[0] * std::cos(a), p[0] * std::sin(a), p[1]};
    points[i][0] = q[0] + shift;
    points[i][1] = q[1] * std::cos(b) - q[2] * std::sin(b) - 2 * shift;
    points[i][2] = q[1] * std::sin(b) + q[2] * std::cos(b) + 0.3 * shift;
  }
  return Surface({flat.degree(Along::u), flat.degree(Along::v)}, {flat.knots(Along::u), flat.knots(Along::v)},
                 points, flat.weights());
}

TEST(Certificate, InATiltedPlaneIsThatOfThePlane) {
  PlanarPairs pairs(11);
  int certified = 0;
  int violated = 0;
  for (int i = 0; i < 100; ++i) {
    const Surface flat = ruled(pairs.next());
    const Verdict expected = certify(flat).verdict;
    const Surface surface = tilted(flat, 0.1 * i, 1.0 + 0.37 * i, i % 2 == 0 ? 0.0 : 0.7);
    const Certificate certificate = certify(surface);
    EXPECT_TRUE(certificate.one_to_one) << i;
    EXPECT_EQ(certificate.verdict, expected) << i;
    if (certificate.verdict == Verdict::certified) ++certified;
    if (certificate.verdict != Verdict::violated) continue;
    ++violated;
    ASSERT_TRUE(certificate.witness) << i;
    const Witness& witness = *certificate.witness;
    if (witness.kind != WitnessKind::sign_change) continue;
    // The normals at both places are opposite.
    const Point n = surface.normal(witness.places[0].u, witness.places[0].v);
    const Point m = surface.normal(witness.places[1].u, witness.places[1].v);
    EXPECT_LT(n[0] * m[0] + n[1] * m[1] + n[2] * m[2], -0.99) << i;
    EXPECT_LT(witness.places[0].jacobian * witness.places[1].jacobian, 0.0) << i;
  }
  EXPECT_GT(certified, 20);
  EXPECT_GT(violated, 10);
}

// Off its plane by more than rounding it is a surface in space.
TEST(Certificate, OfWhatIsNotQuiteFlatIsThatOfSpace) {
  Surface flat = ruled(wavy_strip(0.4));
  const auto lifted = [&](double height) {
    Points points(3, flat.control_points().size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i][0] = flat.control_points()[i][0];
      points[i][1] = flat.control_points()[i][1];
      points[i][2] = 0.5 * points[i][0] + (i == 7 ? height : 0.0);
    }
    return Surface({flat.degree(Along::u), flat.degree(Along::v)},
                   {flat.knots(Along::u), flat.knots(Along::v)}, points, flat.weights());
  };
  EXPECT_TRUE(certify(lifted(1e-12)).one_to_one);
  EXPECT_FALSE(certify(lifted(1e-7)).one_to_one);
  EXPECT_EQ(certify(lifted(1e-7)).regular, Verdict::certified);
}

TEST(Certificate, InSpaceIsNeverWrongOnRandomSurfaces) {
  testing::RandomSurfaces surfaces(21);
  int certified = 0;
  for (int i = 0; i < 150; ++i) {
    const bool rational = i % 3 == 0;
    const int p = surfaces.curves().integer(1, 3);
    const int q = surfaces.curves().integer(1, 3);
    const Surface random = surfaces.surface(p, q, 3, rational, i % 2 == 0);
    // A bumpy sheet: from smooth ones to ones that fold over.
    Points points = random.control_points();
    const double bump = surfaces.curves().uniform(0.0, 0.35);
    for (std::size_t k = 0; k < random.size(Along::u); ++k) {
      for (std::size_t l = 0; l < random.size(Along::v); ++l) {
        auto at = points[k * random.size(Along::v) + l];
        at[0] = bump * at[0] + static_cast<double>(k);
        at[1] = bump * at[1] + static_cast<double>(l);
      }
    }
    const Surface surface({p, q}, {random.knots(Along::u), random.knots(Along::v)}, points, random.weights());
    const Certificate certificate = certify(surface);
    if (certificate.regular != Verdict::certified) continue;
    ++certified;
    for (const double u : testing::probes(surface, Along::u, 20)) {
      for (const double v : testing::probes(surface, Along::v, 20)) {
        const Points d = surface.derivatives(u, v, 1);
        const double x = d[1][1] * d[2][2] - d[1][2] * d[2][1];
        const double y = d[1][2] * d[2][0] - d[1][0] * d[2][2];
        const double z = d[1][0] * d[2][1] - d[1][1] * d[2][0];
        ASSERT_GT(std::hypot(x, y, z), 1e-12) << i;
      }
    }
  }
  EXPECT_GT(certified, 100);
}

TEST(Certificate, InSpaceFindsSingularPoints) {
  testing::RandomSurfaces surfaces(5);
  int certified = 0;
  int violated = 0;
  int undecided = 0;
  for (int i = 0; i < 60; ++i) {
    const bool rational = i % 3 == 0;
    const Surface surface = surfaces.surface(2, i % 2 + 1, 3, rational, true);
    const Certificate certificate = certify(surface);
    certified += certificate.regular == Verdict::certified ? 1 : 0;
    undecided += certificate.regular == Verdict::undecided ? 1 : 0;
    if (certificate.regular != Verdict::violated) continue;
    ++violated;
    ASSERT_EQ(certificate.witness->kind, WitnessKind::zero) << i;
    const SurfacePlace& place = certificate.witness->places[0];
    EXPECT_LT(sine_of_parameters(surface, place.u, place.v), 1e-4) << i;
    // Just beside it the surface is regular: it is a point.
    const double step = 1e-3 * surface.domain(Along::u).length();
    const double beside = place.u + step < surface.domain(Along::u).hi ? place.u + step : place.u - step;
    EXPECT_GT(sine_of_parameters(surface, beside, place.v), sine_of_parameters(surface, place.u, place.v))
        << i;
  }
  std::printf("random surfaces in space: %d certified, %d singular, %d undecided\n", certified, violated,
              undecided);
  EXPECT_GT(violated, 20);
  EXPECT_LE(undecided, 6);
}

TEST(Certificate, RefusesWhatHasNone) {
  const Curve a = Curve::bezier(Points({{0, 0}, {1, 0}}));
  EXPECT_THROW((void)certify(a, Curve::bezier(Points({{0, 0, 0}, {1, 0, 0}}))), InvalidArgument);
  EXPECT_THROW((void)certify(a, Curve::bezier(Points({{0, 1}, {1, 1}}), {}, {0, 2})), InvalidArgument);
  EXPECT_THROW((void)certify(Curve::bezier(Points({{0, 0, 0}, {1, 1, 1}})),
                             Curve::bezier(Points({{1, 0, 0}, {1, 3, 1}}))),
               InvalidArgument);
  EXPECT_THROW((void)certify(Curve::bezier(Points({{0}, {1}})), Curve::bezier(Points({{1}, {1}}))),
               InvalidArgument);
}

}  // namespace
}  // namespace tandem
