#include "tandem/surface/certificate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "planar_pairs.h"
#include "tandem/curve/compatible.h"
#include "tandem/error.h"
#include "tandem/surface/edit.h"

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
    if (std::getenv("CERT_LOG") != nullptr && (certificate.verdict == Verdict::undecided ||
                                               (certificate.verdict == Verdict::certified) != samples.free()))
      printf("pair %d: verdict %d regular %d one %d; samples sign %d crosses %d closed %d\n", i,
             (int)certificate.verdict, (int)certificate.regular, (int)*certificate.one_to_one,
             samples.sign_changes, samples.boundary_crosses, pair.a.is_closed());
  }
  RecordProperty("free", free);
  printf("free %d certified %d; bad %d violated %d\n", free, certified, bad, violated);
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

}  // namespace
}  // namespace tandem
