#include "match/rotation_candidates.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <complex>
#include <vector>

#include "match/nearest_rotation.h"

namespace tandem {
namespace {

using detail::planar_rotation_candidates;
using detail::PlanarCandidate;
using detail::rotation_candidates;
using detail::RotationCandidate;

constexpr double kPi = 3.14159265358979323846;

/// Numbers in [-1, 1], of RapidCheck's making.
std::vector<double> numbers(std::size_t count) {
  std::vector<double> x;
  for (std::size_t k = 0; k < count; ++k) x.push_back(*rc::gen::inRange(-1000, 1001) / 1000.0);
  return x;
}

Rotation random_rotation(int dim) {
  return detail::nearest_rotation(numbers(static_cast<std::size_t>(dim) * static_cast<std::size_t>(dim)), dim)
      .rotation;
}

/// b(i + shift) = R a(i), plane by plane.
std::vector<double> turned(const std::vector<double>& a, const Rotation& r, std::size_t shift) {
  const auto n = static_cast<std::size_t>(r.dim());
  const std::size_t m = a.size() / n;
  std::vector<double> b(a.size());
  std::vector<double> x(n);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t c = 0; c < n; ++c) x[c] = a[c * m + i];
    r.apply(x, x);
    for (std::size_t c = 0; c < n; ++c) b[c * m + (i + shift) % m] = x[c];
  }
  return b;
}

double largest_difference(const std::vector<double>& x, const std::vector<double>& y) {
  double most = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) most = std::max(most, std::abs(x[k] - y[k]));
  return most;
}

TEST(RotationCandidates, EqualBruteForceInThePlane) {
  EXPECT_TRUE(rc::check([] {
    const auto m = static_cast<std::size_t>(*rc::gen::inRange(1, 40));
    const std::vector<double> a = numbers(2 * m);
    const std::vector<double> b = numbers(2 * m);
    const std::span<const double> sa(a);
    const std::span<const double> sb(b);
    const std::vector<PlanarCandidate> found =
        planar_rotation_candidates(sa.first(m), sa.last(m), sb.first(m), sb.last(m), true, 1000);
    std::vector<std::complex<double>> x(m);
    double most = 0.0;
    for (std::size_t k = 0; k < m; ++k) {
      for (std::size_t i = 0; i < m; ++i) {
        const std::size_t j = (i + k) % m;
        x[k] += std::conj(std::complex(a[i], a[m + i])) * std::complex(b[j], b[m + j]);
      }
      most = std::max(most, std::abs(x[k]));
    }
    RC_PRE(most > 1e-6);
    RC_ASSERT(!found.empty());
    RC_ASSERT(std::abs(found.front().score * static_cast<double>(m) - most) <= 1e-12 * most);
    for (const PlanarCandidate& c : found) {
      const std::complex<double> value = x[static_cast<std::size_t>(c.shift)];
      RC_ASSERT(std::abs(value - c.score * static_cast<double>(m) * std::complex(c.cosine, c.sine)) < 1e-10);
      RC_ASSERT(std::abs(value) >= std::abs(x[(static_cast<std::size_t>(c.shift) + 1) % m]) - 1e-8);
    }
  }));
}

TEST(RotationCandidates, FindTheTurnAndTheShift) {
  for (const int dim : {1, 2, 3, 4, 5}) {
    EXPECT_TRUE(rc::check([dim] {
      const auto m = static_cast<std::size_t>(*rc::gen::inRange(12, 40));
      const std::vector<double> a = numbers(static_cast<std::size_t>(dim) * m);
      const Rotation r = random_rotation(dim);
      const std::size_t shift = *rc::gen::inRange<std::size_t>(0, m);
      const std::vector<double> b = turned(a, r, shift);
      const std::vector<RotationCandidate> found = rotation_candidates(a, b, dim, true, 3);
      RC_ASSERT(!found.empty());
      double squares = 0.0;
      for (const double x : a) squares += x * x;
      RC_PRE(squares > 0.1);
      RC_ASSERT(std::abs(found.front().score * static_cast<double>(m) - squares) < 1e-9 * squares);
      // Random rows have no symmetry, but few directions in many dimensions leave the turn open.
      RC_ASSERT(found.front().shift == static_cast<int>(shift));
      RC_ASSERT(largest_difference(turned(a, found.front().rotation, shift), b) < 1e-6);
    })) << dim;
  }
}

TEST(RotationCandidates, OpenRowsHaveOneAlignment) {
  EXPECT_TRUE(rc::check([] {
    const std::size_t m = 20;
    const std::vector<double> a = numbers(3 * m);
    const Rotation r = random_rotation(3);
    const std::vector<RotationCandidate> found = rotation_candidates(a, turned(a, r, 0), 3, false, 9);
    RC_ASSERT(found.size() == 1U);
    RC_ASSERT(found.front().shift == 0);
    RC_ASSERT(largest_difference(found.front().rotation.values(), r.values()) < 1e-6);
  }));
}

TEST(RotationCandidates, PreferTheSmallerTurnAmongEquals) {
  // A regular polygon of 8 sides, three tangents on each, turned by 80 degrees: -10, 35, -55, ... fit as
  // well.
  std::vector<double> x, y, tx, ty;
  for (int k = 0; k < 24; ++k) {
    const double angle = 2.0 * kPi * (k / 3) / 8.0;
    x.push_back(std::cos(angle));
    y.push_back(std::sin(angle));
    tx.push_back(std::cos(angle + 80.0 / 180.0 * kPi));
    ty.push_back(std::sin(angle + 80.0 / 180.0 * kPi));
  }
  const auto found = planar_rotation_candidates(x, y, tx, ty, true, 3);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_NEAR(std::atan2(found[0].sine, found[0].cosine) * 180.0 / kPi, -10.0, 1e-9);
  EXPECT_NEAR(std::atan2(found[1].sine, found[1].cosine) * 180.0 / kPi, 35.0, 1e-9);
  EXPECT_NEAR(std::atan2(found[2].sine, found[2].cosine) * 180.0 / kPi, -55.0, 1e-9);
}

TEST(RotationCandidates, FindNoneWhereThereAreNoTangents) {
  const std::vector<double> zero(10, 0.0);
  EXPECT_TRUE(planar_rotation_candidates(zero, zero, zero, zero, true, 5).empty());
  EXPECT_TRUE(planar_rotation_candidates({}, {}, {}, {}, true, 5).empty());
}

}  // namespace
}  // namespace tandem
