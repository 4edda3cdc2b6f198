#include "tandem/surface/surface.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "random_surfaces.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"
#include "tandem/surface/edit.h"

namespace tandem {
namespace {

using testing::RandomSurfaces;

// A quarter of a torus of radii 3 and 1 in both parameters: rational, with known points, normals and
// curvature.
Surface quarter_torus() {
  const double w = std::sqrt(0.5);
  const std::array<std::array<double, 2>, 3> arc = {{{1, 0}, {1, 1}, {0, 1}}};
  const std::array<double, 3> weight = {1, w, 1};
  Points points(3, 9);
  std::vector<double> weights;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double r = 3.0 + arc[j][0];
      const std::array<double, 3> p = {r * arc[i][0], r * arc[i][1], arc[j][1]};
      std::copy(p.begin(), p.end(), points[i * 3 + j].begin());
      weights.push_back(weight[i] * weight[j]);
    }
  }
  return Surface({2, 2}, {std::vector<double>{0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}}, points, weights);
}

TEST(Surface, LiesOnTheTorusThatItIsMadeOf) {
  const Surface torus = quarter_torus();
  for (double u = 0.0; u <= 1.0; u += 0.125) {
    for (double v = 0.0; v <= 1.0; v += 0.125) {
      const Point p = torus.evaluate(u, v);
      const double r = std::hypot(p[0], p[1]);
      EXPECT_NEAR(std::hypot(r - 3.0, p[2]), 1.0, 1e-14);
      const Point n = torus.normal(u, v);
      const Point outward = {p[0] * (r - 3.0) / r, p[1] * (r - 3.0) / r, p[2]};
      EXPECT_NEAR(n[0] * outward[0] + n[1] * outward[1] + n[2] * outward[2], 1.0, 1e-13);
    }
  }
}

// Curves along u of the surface, blended along v, are an evaluation that shares only the curve's code.
TEST(Surface, IsTheCurveOfItsCurves) {
  RandomSurfaces random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Surface s = random.any(random.curves().integer(1, 4));
    const std::size_t n = s.size(Along::v);
    for (const double u : testing::probes(s, Along::u, 3)) {
      for (const double v : testing::probes(s, Along::v, 3)) {
        Points row(s.dim(), n);
        std::vector<double> weights;
        for (std::size_t j = 0; j < n; ++j) {
          Points column(s.dim() + 1, s.size(Along::u));  // premultiplied
          for (std::size_t i = 0; i < column.size(); ++i) {
            const double w = s.is_rational() ? s.weights()[i * n + j] : 1.0;
            for (int c = 0; c < s.dim(); ++c)
              column[i][static_cast<std::size_t>(c)] = w * s.control_point(i, j)[static_cast<std::size_t>(c)];
            column[i].back() = w;
          }
          const Point p = Curve(s.degree(Along::u), s.knots(Along::u), column).evaluate(u);
          weights.push_back(p.back());
          for (int c = 0; c < s.dim(); ++c)
            row[j][static_cast<std::size_t>(c)] = p[static_cast<std::size_t>(c)] / p.back();
        }
        const Curve across(s.degree(Along::v), s.knots(Along::v), row, weights);
        EXPECT_LE(testing::distance(across.evaluate(v), s.evaluate(u, v)), 1e-13 * s.extent());
      }
    }
  }
}

TEST(Surface, DerivativesAgreeWithDifferences) {
  RandomSurfaces random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Surface s = random.any(3);
    // Away from knots, where differences would look across them.
    const BezierPatches patches = bezier_patches(s);
    const Surface& patch = patches.patches[static_cast<std::size_t>(trial) % patches.patches.size()];
    const Interval du = patch.domain(Along::u);
    const Interval dv = patch.domain(Along::v);
    const double u = du.lo + 0.4 * du.length();
    const double v = dv.lo + 0.6 * dv.length();
    const double hu = 1e-4 * du.length();
    const double hv = 1e-4 * dv.length();
    const Points d = s.derivatives(u, v, 3);
    const Points eu = s.derivatives(u + hu, v, 2);
    const Points wu = s.derivatives(u - hu, v, 2);
    const Points ev = s.derivatives(u, v + hv, 2);
    const Points wv = s.derivatives(u, v - hv, 2);
    // Row of D_u^k D_v^l and of its derivatives by u and by v.
    for (std::size_t n = 0; n < 3; ++n) {
      for (std::size_t l = 0; l <= n; ++l) {
        const std::size_t row = n * (n + 1) / 2 + l;
        const std::size_t by_u = (n + 1) * (n + 2) / 2 + l;
        double size_u = s.extent() / du.length();
        double size_v = s.extent() / dv.length();
        for (std::size_t c = 0; c < 3; ++c) {
          size_u = std::max({size_u, std::abs(d[by_u][c]), std::abs(d[row][c]) / du.length()});
          size_v = std::max({size_v, std::abs(d[by_u + 1][c]), std::abs(d[row][c]) / dv.length()});
        }
        for (std::size_t c = 0; c < 3; ++c) {
          // The error of a central difference is of the order h^2 of two derivatives more, which may be large
          // for rational surfaces of high degree.
          EXPECT_NEAR((eu[row][c] - wu[row][c]) / (2 * hu), d[by_u][c], 1e-4 * size_u) << trial << " " << row;
          EXPECT_NEAR((ev[row][c] - wv[row][c]) / (2 * hv), d[by_u + 1][c], 1e-4 * size_v)
              << trial << " " << row;
        }
      }
    }
  }
}

TEST(Surface, TakesSidesAtCreases) {
  // A roof: degree 1 along u with a ridge at u = 1.
  const Surface roof({1, 1}, {std::vector<double>{0, 0, 1, 2, 2}, {0, 0, 1, 1}},
                     Points({{0, 0, 0}, {0, 1, 0}, {1, 0, 1}, {1, 1, 1}, {2, 0, 0}, {2, 1, 0}}));
  EXPECT_NEAR(roof.normal(1, 0.5, {Side::left, Side::right})[0], -std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(roof.normal(1, 0.5, {Side::right, Side::right})[0], std::sqrt(0.5), 1e-15);
  EXPECT_EQ(roof.derivatives(0, 0, 1, {Side::left, Side::left}), roof.derivatives(0, 0, 1));
}

TEST(Surface, HasANormalAtAPole) {
  // A cone: all of v = 1 is its tip.
  const Surface cone({2, 1}, {std::vector<double>{0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}},
                     Points({{1, 0, 0}, {0, 0, 1}, {1, 1, 0}, {0, 0, 1}, {0, 1, 0}, {0, 0, 1}}),
                     {1, 1, std::sqrt(0.5), std::sqrt(0.5), 1, 1});
  const Point tip = cone.normal(0.5, 1.0);
  const Point below = cone.normal(0.5, 0.5);
  EXPECT_LE(testing::distance(tip, below), 1e-5);
  // A surface that is a line has none.
  const Surface line({1, 1}, {std::vector<double>{0, 0, 1, 1}, {0, 0, 1, 1}},
                     Points({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}}));
  EXPECT_EQ(line.normal(0.5, 0.5), Point({0, 0, 0}));
}

TEST(Surface, KnowsWhatIsClosed) {
  const Surface torus = quarter_torus();
  EXPECT_FALSE(torus.is_closed(Along::u));
  const Curve loop = Curve::clamped_uniform(2, {{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {0, 0, 0}});
  Points up = loop.control_points();
  for (std::size_t i = 0; i < up.size(); ++i) up[i][2] = 1.0;
  const Curve rows[] = {loop, Curve(2, loop.knots(), up)};
  const Surface tube = Surface::of_rows(rows, 1, {0, 0, 1, 1});
  EXPECT_TRUE(tube.is_closed(Along::u));
  EXPECT_FALSE(tube.is_closed(Along::v));
}

TEST(Surface, OfRowsHasThemAsEdges) {
  RandomSurfaces random(3);
  const Curve a = random.curves().curve(3, 3, 4, true, true);
  const Curve b(3, a.knots(), random.curves().points(3, a.size()), random.curves().weights(a.size()));
  const Curve rows[] = {a, b};
  const Surface s = Surface::of_rows(rows, 1, {0, 0, 1, 1});
  EXPECT_LE(testing::largest_gap(iso_curve(s, Along::u, 0.0), a), 1e-14);
  EXPECT_LE(testing::largest_gap(iso_curve(s, Along::u, 1.0), b), 1e-14);
}

void expect_refused(const std::function<void()>& make, const std::string& part) {
  try {
    make();
    ADD_FAILURE() << "accepted, expected a message with: " << part;
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(Surface, SaysWhatIsWrong) {
  const std::vector<double> k{0, 0, 1, 1};
  const Points four({{0, 0}, {0, 1}, {1, 0}, {1, 1}});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused([&] { Surface({1, 0}, {k, k}, four); }, "the degree along v is 0");
  expect_refused([&] { Surface({1, 1}, {k, std::vector<double>{0, 0, 1}}, four); }, "3 knots along v");
  expect_refused(
      [&] {
        Surface({1, 1}, {std::vector<double>{0, 1, 0, 1}, k}, four);
      },
      "along u: knot 2 is 0");
  expect_refused([&] { Surface({1, 1}, {k, k}, Points({{0, 0}, {0, 1}, {1, 0}})); }, "3 control points");
  expect_refused([&] { Surface({1, 1}, {k, k}, four, {1, 1}); }, "2 weights for 4");
  expect_refused([&] { Surface({1, 1}, {k, k}, four, {1, 1, 0, 1}); }, "weight 2 is 0");
  expect_refused(
      [&] {
        Surface({1, 1}, {k, k}, Points({{0, 0}, {0, nan}, {1, 0}, {1, 1}}));
      },
      "control point 1");
  const Surface s({1, 1}, {k, k}, four);
  expect_refused([&] { (void)s.evaluate(nan, 0); }, "parameters");
  expect_refused([&] { (void)s.normal(0, 0); }, "dimension 2, expected 3");
}

}  // namespace
}  // namespace tandem
