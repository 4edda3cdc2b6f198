#include "tandem/surface/tessellate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "surface/grid_cell.h"
#include "surface/random_surfaces.h"
#include "surface/solids.h"
#include "tandem/error.h"
#include "tandem/surface/edit.h"

namespace tandem {
namespace {

using detail::Vector3;
using detail::operator+;
using detail::operator*;
using std::numbers::pi;
using testing::RandomSurfaces;

Vector3 vertex(const TriangleMesh& mesh, std::uint32_t k) {
  return {mesh.vertices[k][0], mesh.vertices[k][1], mesh.vertices[k][2]};
}

/// Of the point at (u, v) from the triangles of its cell.
double distance_to_mesh(const Surface& surface, const TriangleMesh& mesh, double u, double v) {
  const Point at = surface.evaluate(u, v);
  const Vector3 p = {at[0], at[1], at.size() == 3 ? at[2] : 0.0};
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles) {
    const auto lies_beside = [&](std::size_t k, double x) {
      const auto [lo, hi] =
          std::minmax({mesh.parameters[t[0]][k], mesh.parameters[t[1]][k], mesh.parameters[t[2]][k]});
      return x < lo || x > hi;
    };
    if (lies_beside(0, u) || lies_beside(1, v)) continue;
    least = std::min(
        least, detail::distance_to_triangle(p, {vertex(mesh, t[0]), vertex(mesh, t[1]), vertex(mesh, t[2])}));
  }
  return least;
}

/// The largest over samples that fall between the lines of the grid.
double deviation(const Surface& surface, const TriangleMesh& mesh) {
  constexpr int kSamples = 29;
  double most = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    for (int j = 0; j <= kSamples; ++j) {
      const Interval u = surface.domain(Along::u);
      const Interval v = surface.domain(Along::v);
      most = std::max(most, distance_to_mesh(surface, mesh, u.lo + u.length() * i / kSamples,
                                             v.lo + v.length() * j / kSamples));
    }
  }
  return most;
}

/// Of the middles of the mesh's boundary from that of the surface.
double boundary_deviation(const Surface& surface, const TriangleMesh& mesh) {
  constexpr int kSamples = 64;
  double most = 0.0;
  for (const auto& [from, to] : boundary_edges(mesh)) {
    const Vector3 middle = 0.5 * (vertex(mesh, from) + vertex(mesh, to));
    double least = std::numeric_limits<double>::infinity();
    Vector3 last = vertex(mesh, from);
    for (int i = 1; i <= kSamples; ++i) {
      const auto between = [&](std::size_t k) {
        return mesh.parameters[from][k] + (mesh.parameters[to][k] - mesh.parameters[from][k]) * i / kSamples;
      };
      Point p = surface.evaluate(between(0), between(1));
      p.resize(3);
      const Vector3 next = {p[0], p[1], p[2]};
      least = std::min(least, detail::distance_to_triangle(middle, {last, next, next}));
      last = next;
    }
    most = std::max(most, least);
  }
  return most;
}

TEST(Tessellate, ClosedSurfacesAreWatertightAndEncloseTheirVolume) {
  struct Case {
    Surface surface;
    double volume;
    double area;
  };
  const std::vector<Case> cases = {
      {testing::sphere(), 4.0 / 3.0 * pi, 4.0 * pi},
      {testing::torus(0.3), 2.0 * pi * pi * 0.09, 4.0 * pi * pi * 0.3},
      {testing::can(), 2.0 * pi, 6.0 * pi},
  };
  for (const Case& c : cases) {
    for (const double chord : {1e-2, 1e-3}) {
      const TriangleMesh mesh = tessellate(c.surface, {.chord = chord, .angle = 1.0});
      EXPECT_TRUE(is_watertight(mesh));
      // The mesh is inside by no more than the chord distance, all over its area.
      EXPECT_NEAR(volume(mesh), c.volume, chord * c.surface.extent() * c.area);
      EXPECT_LT(volume(mesh), c.volume);
      EXPECT_LT(area(mesh), c.area);
      EXPECT_GT(area(mesh), 0.9 * c.area);
    }
  }
}

TEST(Tessellate, StaysWithinTheChordDistance) {
  RandomSurfaces random(11);
  for (int k = 0; k < 24; ++k) {
    const Surface surface = random.any(k % 3 == 0 ? 2 : 3);
    const double chord = k % 2 == 0 ? 1e-2 : 3e-3;
    const TriangleMesh mesh = tessellate(surface, {.chord = chord, .angle = 3.0, .joints = Joints::split});
    EXPECT_LE(deviation(surface, mesh), chord * surface.extent()) << k;
    EXPECT_LE(boundary_deviation(surface, mesh), chord * surface.extent()) << k;
  }
}

TEST(Tessellate, FinerMeansNearerAndMore) {
  const Surface surface = testing::torus(0.4);
  const TriangleMesh coarse = tessellate(surface, {.chord = 1e-2, .angle = 3.0});
  const TriangleMesh fine = tessellate(surface, {.chord = 1e-3, .angle = 3.0});
  EXPECT_GT(deviation(surface, coarse), 1e-3 * surface.extent());
  EXPECT_GT(fine.triangles.size(), 4 * coarse.triangles.size());
}

TEST(Tessellate, HoldsTheAngle) {
  for (const Surface& surface : {testing::sphere(), testing::torus(0.3), testing::can()}) {
    for (const double angle : {0.3, 0.08}) {
      const TriangleMesh mesh = tessellate(surface, {.chord = 0.1, .angle = angle, .joints = Joints::split});
      for (const auto& t : mesh.triangles) {
        const Vector3 n = facet_normal(mesh, t);
        for (const std::uint32_t k : t) {
          const auto m = mesh.normals[k];
          EXPECT_GE(n[0] * m[0] + n[1] * m[1] + n[2] * m[2], std::cos(angle) - 1e-12);
        }
      }
    }
  }
}

TEST(Tessellate, NormalsAreThoseOfTheSurface) {
  const TriangleMesh mesh = tessellate(testing::sphere());
  for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
    // On the unit sphere, outwards; at the poles the mean of limits, which are known to six digits.
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(mesh.normals[k][c], mesh.vertices[k][c], 1e-5);
  }
}

TEST(Tessellate, TrianglesTurnAsTheSurfaceDoes) {
  const Surface planar({1, 1}, {std::vector<double>{0, 0, 1, 1}, {0, 0, 1, 1}},
                       Points({{0, 0}, {0, 1}, {2, 0}, {1, 1}}));
  for (const auto& [surface, sign] : {std::pair{planar, 1.0}, std::pair{transpose(planar), -1.0}}) {
    const TriangleMesh mesh = tessellate(surface);
    ASSERT_FALSE(mesh.triangles.empty());
    for (const auto& t : mesh.triangles) EXPECT_EQ(facet_normal(mesh, t)[2], sign);
    for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
      EXPECT_EQ(mesh.vertices[k][2], 0.0);
      EXPECT_EQ(mesh.normals[k][2], sign);
    }
    EXPECT_NEAR(area(mesh), 1.5, 1e-12);
  }
}

TEST(Tessellate, HasNoTrianglesWithoutArea) {
  // Two sides of the last one are a point each.
  const Surface lens({2, 1}, {testing::quadratic_knots(1), std::vector<double>{0, 0, 1, 1}},
                     Points({{0, 0, 0}, {0, 0, 0}, {1, -1, 0}, {1, 1, 1}, {2, 0, 0}, {2, 0, 0}}));
  for (const Surface& surface : {testing::sphere(), testing::can(), lens}) {
    for (const Joints joints : {Joints::welded, Joints::split}) {
      const TriangleMesh mesh = tessellate(surface, {.joints = joints});
      for (const auto& t : mesh.triangles) EXPECT_NE(facet_normal(mesh, t), (Vector3{}));
    }
  }
  EXPECT_EQ(boundary_edges(tessellate(lens)).size() % 2, 0U);
}

TEST(Tessellate, CreasesAreSplitWhereItIsAskedFor) {
  const TriangleMesh welded = tessellate(testing::can(), {.joints = Joints::welded});
  const TriangleMesh split = tessellate(testing::can(), {.joints = Joints::split});
  EXPECT_EQ(welded.triangles.size(), split.triangles.size());
  EXPECT_LT(welded.vertices.size(), split.vertices.size());
  EXPECT_FALSE(is_watertight(split));
  bool slanted = false;
  for (std::size_t k = 0; k < welded.vertices.size(); ++k) {
    slanted = slanted || std::fabs(std::fabs(welded.normals[k][2]) - std::sqrt(0.5)) < 1e-6;
  }
  EXPECT_TRUE(slanted) << "the mean of both sides";
  for (std::size_t k = 0; k < split.vertices.size(); ++k) {
    const double z = std::fabs(split.normals[k][2]);
    EXPECT_TRUE(z < 1e-6 || z > 1.0 - 1e-6) << "one side or the other: " << z;
  }
  // What is split lies at the same places to the last bit.
  for (std::size_t i = 0; i < split.vertices.size(); ++i) {
    bool found = false;
    for (std::size_t k = 0; k < welded.vertices.size() && !found; ++k) {
      found = std::equal(split.vertices[i].begin(), split.vertices[i].end(), welded.vertices[k].begin());
    }
    EXPECT_TRUE(found);
  }
}

TEST(Tessellate, FlatPiecesTakeTwoTriangles) {
  const Surface flat({1, 1}, {std::vector<double>{0, 0, 1, 1}, {0, 0, 1, 1}},
                     Points({{0, 0, 5}, {0, 1, 5}, {1, 0, 5}, {1, 1, 5}}));
  EXPECT_EQ(tessellate(flat).triangles.size(), 2U);
}

TEST(Tessellate, SizesDoNotMatter) {
  const Surface torus = testing::torus(0.3);
  const TriangleMesh one = tessellate(torus, {.chord = 1e-2});
  for (const double scale : {1e-150, 1e250}) {
    Points points = torus.control_points();
    for (double& x : points.data()) x *= scale;
    const Surface scaled({2, 2}, {torus.knots(Along::u), torus.knots(Along::v)}, points, torus.weights());
    const TriangleMesh mesh = tessellate(scaled, {.chord = 1e-2});
    EXPECT_EQ(mesh.triangles.size(), one.triangles.size());
    EXPECT_TRUE(is_watertight(mesh));
  }
}

TEST(Tessellate, SurfacesThatAreNoneMakeNoTriangles) {
  const Surface point({1, 1}, {std::vector<double>{0, 0, 1, 1}, {0, 0, 1, 1}},
                      Points({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}));
  EXPECT_TRUE(tessellate(point).triangles.empty());
}

TEST(Tessellate, RefusesWhatCannotBe) {
  RandomSurfaces random(3);
  EXPECT_THROW(static_cast<void>(tessellate(random.any(4))), InvalidArgument);
  EXPECT_THROW(static_cast<void>(tessellate(testing::sphere(), {.chord = 0.0})), InvalidArgument);
  EXPECT_THROW(static_cast<void>(tessellate(testing::sphere(), {.chord = NAN})), InvalidArgument);
  EXPECT_THROW(static_cast<void>(tessellate(testing::sphere(), {.angle = -1.0})), InvalidArgument);
}

TEST(Mesh, KnowsItsBoundary) {
  TriangleMesh mesh;
  EXPECT_FALSE(is_watertight(mesh));
  mesh.vertices = Points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}};
  // The triangle that is missing would run through them the other way.
  EXPECT_EQ(boundary_edges(mesh), (std::vector<std::array<std::uint32_t, 2>>{{0, 2}, {3, 0}, {2, 3}}));
  EXPECT_FALSE(is_watertight(mesh));
  mesh.triangles.push_back({0, 3, 2});
  EXPECT_TRUE(boundary_edges(mesh).empty());
  EXPECT_TRUE(is_watertight(mesh));
  EXPECT_NEAR(volume(mesh), 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(area(mesh), 1.5 + std::sqrt(0.75), 1e-15);
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  EXPECT_FALSE(is_watertight(mesh)) << "one triangle looks inwards";
}

}  // namespace
}  // namespace tandem
