#include "tandem/surface/simple_mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <random>
#include <vector>

#include "surface/orientation.h"
#include "surface/triangle_pair.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using detail::SpacePoint;
using detail::Triangle;

__extension__ using Wide = __int128;  // holds the determinants of coordinates below 2^40
using Grid = std::array<std::int64_t, 3>;

SpacePoint scaled(const Grid& p, double unit) {
  return {static_cast<double>(p[0]) * unit, static_cast<double>(p[1]) * unit,
          static_cast<double>(p[2]) * unit};
}

int sign(Wide x) {
  return x > 0 ? 1 : (x < 0 ? -1 : 0);
}

int exact_orientation(const Grid& a, const Grid& b, const Grid& c, const Grid& d) {
  std::array<std::array<Wide, 3>, 3> m{};
  for (std::size_t k = 0; k < 3; ++k) m[0][k] = a[k] - d[k], m[1][k] = b[k] - d[k], m[2][k] = c[k] - d[k];
  return sign(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
              m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
              m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
}

TEST(Orientation, IsExactOnNearlyFlatTetrahedra) {
  std::mt19937 random(3);
  const auto number = [&](std::int64_t below) {
    return static_cast<std::int64_t>(random() * (1ULL << 20) + random()) % below;
  };
  std::array<int, 3> seen{};
  for (int i = 0; i < 20000; ++i) {
    std::array<Grid, 4> p{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t c = 0; c < 3; ++c) p[c][k] = number(std::int64_t{1} << 39);
    }
    // In the plane of the others or one step beside it: plain arithmetic cannot tell.
    const std::int64_t s = number(5) - 2;
    const std::int64_t t = number(5) - 2;
    for (std::size_t k = 0; k < 3; ++k)
      p[3][k] = p[0][k] + s * (p[1][k] - p[0][k]) / 4 + t * (p[2][k] - p[0][k]) / 4;
    if (i % 3 == 0)
      p[3] = {p[1][0] + p[2][0] - p[0][0], p[1][1] + p[2][1] - p[0][1], p[1][2] + p[2][2] - p[0][2]};
    if (i % 6 == 3) p[3][2] += 1;
    const int expected = exact_orientation(p[0], p[1], p[2], p[3]);
    seen[static_cast<std::size_t>(expected + 1)]++;
    for (const double unit : {1.0, 0x1p-70, 0x1p240}) {
      ASSERT_EQ(
          detail::orientation(scaled(p[0], unit), scaled(p[1], unit), scaled(p[2], unit), scaled(p[3], unit)),
          expected)
          << i;
    }
    const Wide left = Wide(p[0][0] - p[2][0]) * (p[3][1] - p[2][1]);
    const Wide right = Wide(p[0][1] - p[2][1]) * (p[3][0] - p[2][0]);
    ASSERT_EQ(detail::orientation(scaled(p[0], 1), scaled(p[3], 1), scaled(p[2], 1), 0, 1),
              sign(left - right))
        << i;
  }
  for (const int count : seen) EXPECT_GT(count, 1000);
}

// Exact fractions for the oracle below; the numbers stay small.
struct Fraction {
  Wide top = 0;
  Wide bottom = 1;

  Fraction(Wide t, Wide b = 1) : top(b < 0 ? -t : t), bottom(b < 0 ? -b : b) {}  // NOLINT
  Fraction() = default;
  friend Fraction operator+(const Fraction& a, const Fraction& b) {
    return reduced(a.top * b.bottom + b.top * a.bottom, a.bottom * b.bottom);
  }
  friend Fraction operator-(const Fraction& a, const Fraction& b) { return a + Fraction(-b.top, b.bottom); }
  friend Fraction operator*(const Fraction& a, const Fraction& b) {
    return reduced(a.top * b.top, a.bottom * b.bottom);
  }
  friend Fraction operator/(const Fraction& a, const Fraction& b) {
    return reduced(a.top * b.bottom, a.bottom * b.top);
  }
  friend bool operator==(const Fraction& a, const Fraction& b) {
    return a.top * b.bottom == b.top * a.bottom;
  }
  [[nodiscard]] int sign() const { return top > 0 ? 1 : (top < 0 ? -1 : 0); }
  static Fraction reduced(Wide t, Wide b) {
    Wide x = t < 0 ? -t : t;
    Wide y = b < 0 ? -b : b;
    while (y != 0) {
      const Wide rest = x % y;
      x = y;
      y = rest;
    }
    return x == 0 ? Fraction() : Fraction(t / x, b / x);
  }
};
using Exact = std::array<Fraction, 3>;

Exact minus(const Exact& a, const Exact& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Exact cross(const Exact& a, const Exact& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Fraction dot(const Exact& a, const Exact& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

using ExactTriangle = std::array<Exact, 3>;

bool holds(const ExactTriangle& t, const Exact& p) {
  const Exact n = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  if (dot(n, minus(p, t[0])).sign() != 0) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (dot(n, cross(minus(t[(i + 1) % 3], t[i]), minus(p, t[i]))).sign() < 0) return false;
  }
  return true;
}

// The slow way: what two triangles have in common is convex, and its corners are corners of one of them or
// points where an edge meets the other's plane or, in one plane, an edge of the other.
bool slow_do_meet(const std::vector<Grid>& points, const Triangle& s, const Triangle& t) {
  std::array<ExactTriangle, 2> both;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      both[0][i][k] = Fraction(points[s[i]][k]);
      both[1][i][k] = Fraction(points[t[i]][k]);
    }
  }
  std::vector<Exact> candidates;
  for (const std::size_t which : {0U, 1U}) {
    const ExactTriangle& a = both[which];
    const ExactTriangle& b = both[1 - which];
    const Exact n = cross(minus(b[1], b[0]), minus(b[2], b[0]));
    for (std::size_t i = 0; i < 3; ++i) {
      candidates.push_back(a[i]);
      const Exact d = minus(a[(i + 1) % 3], a[i]);
      const auto at = [&](const Fraction& share) {
        return Exact{a[i][0] + share * d[0], a[i][1] + share * d[1], a[i][2] + share * d[2]};
      };
      if (dot(n, d).sign() != 0) {
        candidates.push_back(at(dot(n, minus(b[0], a[i])) / dot(n, d)));
        continue;
      }
      for (std::size_t j = 0; j < 3; ++j) {
        const Exact across = cross(n, minus(b[(j + 1) % 3], b[j]));
        if (dot(across, d).sign() != 0)
          candidates.push_back(at(dot(across, minus(b[j], a[i])) / dot(across, d)));
      }
    }
  }
  for (const Exact& p : candidates) {
    if (!holds(both[0], p) || !holds(both[1], p)) continue;
    bool shared = false;
    for (const std::uint32_t i : s) {
      for (const std::uint32_t j : t) {
        if (i == j && p == Exact{Fraction(points[i][0]), Fraction(points[i][1]), Fraction(points[i][2])})
          shared = true;
      }
    }
    if (!shared) return true;
  }
  return std::is_permutation(s.begin(), s.end(), t.begin());
}

TEST(TrianglePair, MeetsAsTheSlowExactTestSays) {
  std::mt19937 random(5);
  std::array<std::array<int, 2>, 4> seen{};
  for (int i = 0; i < 6000; ++i) {
    // A coarse grid, so that touching, common corners and common planes are frequent.
    const int size = i % 2 == 0 ? 3 : 6;
    const bool planar = i % 5 == 0;
    std::vector<Grid> points;
    while (points.size() < 6) {
      Grid p{};
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = static_cast<std::int64_t>(random() % static_cast<unsigned>(size));
      if (planar) p[2] = p[0] + 2 * p[1];
      if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
    }
    std::vector<SpacePoint> real;
    for (const Grid& p : points) real.push_back(scaled(p, 0.125));
    const std::uint32_t shared = random() % 4;
    const Triangle s = {0, 1, 2};
    Triangle t = {3, 4, 5};
    for (std::uint32_t k = 0; k < shared; ++k) t[k] = k;
    std::shuffle(t.begin(), t.end(), random);
    const auto flat = [&](const Triangle& f) { return detail::is_flat(real[f[0]], real[f[1]], real[f[2]]); };
    if (flat(s) || flat(t)) continue;
    const bool expected = slow_do_meet(points, s, t);
    seen[shared][expected ? 1 : 0]++;
    ASSERT_EQ(detail::do_meet(real, s, t), expected) << i << ", " << shared << " common corners";
    ASSERT_EQ(detail::do_meet(real, t, s), expected) << i;
  }
  for (std::size_t shared = 0; shared < 3; ++shared) {
    EXPECT_GT(seen[shared][0], 100) << shared;
    EXPECT_GT(seen[shared][1], 100) << shared;
  }
}

// A grid of m x n cells over [0,1]^2, two triangles each, every cell row with vertices of its own where
// `torn`.
TriangleMesh grid_mesh(std::uint32_t m, std::uint32_t n,
                       const std::function<SpacePoint(double, double)>& surface) {
  TriangleMesh mesh;
  mesh.vertices = Points(3, std::size_t{m + 1} * (n + 1));
  for (std::uint32_t i = 0; i <= m; ++i) {
    for (std::uint32_t j = 0; j <= n; ++j) {
      const SpacePoint p = surface(static_cast<double>(i % m) / m, static_cast<double>(j) / n);
      // The last row repeats the first one's places, not its indices.
      const SpacePoint last = surface(1.0, static_cast<double>(j) / n);
      const SpacePoint first = surface(0.0, static_cast<double>(j) / n);
      const bool closed = std::hypot(last[0] - first[0], last[1] - first[1], last[2] - first[2]) < 1e-9;
      const SpacePoint q = i == m && !closed ? last : p;
      std::copy(q.begin(), q.end(), mesh.vertices[i * (n + 1) + j].begin());
    }
  }
  for (std::uint32_t i = 0; i < m; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t at = i * (n + 1) + j;
      mesh.triangles.push_back({at, at + n + 1, at + 1});
      mesh.triangles.push_back({at + 1, at + n + 1, at + n + 2});
    }
  }
  return mesh;
}

constexpr double kTurn = 6.283185307179586;

SpacePoint tube(double radius, double around, double along) {
  return {std::cos(kTurn * around) * (2.0 + radius * std::cos(kTurn * along)),
          std::sin(kTurn * around) * (2.0 + radius * std::cos(kTurn * along)),
          radius * std::sin(kTurn * along)};
}

TEST(SimpleMesh, CertifiesWhatIsSimple) {
  EXPECT_EQ(find_simple(grid_mesh(60, 20, [](double u, double v) { return tube(0.7, u, 0.97 * v); })).verdict,
            Verdict::certified);
  // Flat, across no axis: all neighbours are coplanar up to rounding or exactly.
  EXPECT_EQ(find_simple(grid_mesh(40, 30,
                                  [](double u, double v) {
                                    return SpacePoint{u, v, 0.25 * u + 0.5 * v};
                                  }))
                .verdict,
            Verdict::certified);
  // A pole: one corner of the triangles at the tip is there twice.
  const auto cone = [](double u, double v) {
    return SpacePoint{v * std::cos(kTurn * u), v * std::sin(kTurn * u), v};
  };
  EXPECT_EQ(find_simple(grid_mesh(40, 10, cone)).verdict, Verdict::certified);
  EXPECT_EQ(find_simple(TriangleMesh{}).verdict, Verdict::certified);
}

TEST(SimpleMesh, FindsWhatMeets) {
  // A torus thicker than its ring.
  const TriangleMesh thick = grid_mesh(60, 20, [](double u, double v) { return tube(2.2, u, 0.97 * v); });
  const SimpleMesh found = find_simple(thick);
  ASSERT_EQ(found.verdict, Verdict::violated);
  std::vector<SpacePoint> points;
  for (std::size_t i = 0; i < thick.vertices.size(); ++i)
    points.push_back({thick.vertices[i][0], thick.vertices[i][1], thick.vertices[i][2]});
  EXPECT_TRUE(
      detail::do_meet(points, thick.triangles[found.triangles[0]], thick.triangles[found.triangles[1]]));
  // Folded back onto itself, flat.
  const auto folded = [](double u, double v) { return SpacePoint{u < 0.7 ? u : 1.4 - u, v, 0.0}; };
  EXPECT_EQ(find_simple(grid_mesh(10, 4, folded)).verdict, Verdict::violated);
}

TEST(SimpleMesh, AgreesWithAllPairsAtAnySize) {
  std::mt19937 random(9);
  int simple = 0;
  for (int i = 0; i < 60; ++i) {
    const double unit = i % 3 == 0 ? 1e150 : (i % 3 == 1 ? 1e-150 : 1.0);
    TriangleMesh mesh;
    std::vector<SpacePoint> points;
    const std::uint32_t count = 20;
    for (std::uint32_t t = 0; t < count; ++t) {
      SpacePoint center{};
      for (double& x : center) x = static_cast<double>(random() % 1000) / 100.0;
      for (std::uint32_t k = 0; k < 3; ++k) {
        SpacePoint p = center;
        for (double& x : p) x = unit * (x + static_cast<double>(random() % 1000) / 400.0);
        points.push_back(p);
        if (mesh.vertices.empty()) mesh.vertices = Points(3, 0);
        mesh.vertices.push_back(p);
      }
      mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    for (SpacePoint& p : points) {
      for (double& x : p) x /= unit;  // the oracle compares signs only
    }
    bool meets = false;
    for (std::uint32_t s = 0; s < count; ++s) {
      for (std::uint32_t t = 0; t < s; ++t)
        meets = meets || detail::do_meet(points, mesh.triangles[s], mesh.triangles[t]);
    }
    EXPECT_EQ(find_simple(mesh).verdict, meets ? Verdict::violated : Verdict::certified) << i;
    if (!meets) ++simple;
  }
  EXPECT_GT(simple, 10);
  EXPECT_LT(simple, 50);
}

TEST(SimpleMesh, IsUndecidedWhereItsArithmeticEnds) {
  TriangleMesh mesh;
  mesh.vertices = Points({{0, 0, 0}, {1, 0, 0}, {0, 1e-250, 0}});
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(find_simple(mesh).verdict, Verdict::undecided);
  mesh.vertices = Points({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}});
  EXPECT_EQ(find_simple(mesh).verdict, Verdict::undecided);
  mesh.triangles = {{0, 1, 3}};
  EXPECT_THROW((void)find_simple(mesh), InvalidArgument);
  mesh.vertices = Points({{0, 0, 0}, {1, 0, std::nan("")}, {3, 0, 0}, {0, 1, 0}});
  EXPECT_THROW((void)find_simple(mesh), InvalidArgument);
}

}  // namespace
}  // namespace tandem
