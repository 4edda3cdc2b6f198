#include "tandem/surface/skin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "cad_cases.h"
#include "tandem/error.h"
#include "tandem/surface/edit.h"

namespace tandem {
namespace {

using testing::cad_case;

// Heights (z) of a row of samples along u.
struct Ridge {
  double height = 0.0;
  int peaks = 0;
};

Ridge ridge_at(const Surface& surface, double v) {
  const Curve c = iso_curve(surface, Along::u, v);
  constexpr int n = 2000;
  std::vector<double> z;
  for (int i = 0; i <= n; ++i) z.push_back(c.evaluate(c.domain().lo + c.domain().length() * i / n)[2]);
  Ridge ridge;
  ridge.height = *std::max_element(z.begin(), z.end());
  for (int i = 1; i < n; ++i) ridge.peaks += z[i] > 1e-6 * ridge.height && z[i] > z[i - 1] && z[i] >= z[i + 1] ? 1 : 0;
  return ridge;
}

struct Bells {
  double worst_ratio = 1e300;
  double best_ratio = 0.0;
  int most_peaks = 0;
};

// In-between heights against the linear blend of the neighbouring sections' heights.
Bells measure_bells(const Surface& surface, const std::vector<double>& v) {
  Bells bells;
  for (std::size_t j = 0; j + 1 < v.size(); ++j) {
    const double h0 = ridge_at(surface, v[j]).height;
    const double h1 = ridge_at(surface, v[j + 1]).height;
    for (int k = 0; k <= 16; ++k) {
      const double s = k / 16.0;
      const Ridge r = ridge_at(surface, (1.0 - s) * v[j] + s * v[j + 1]);
      const double ratio = r.height / ((1.0 - s) * h0 + s * h1);
      bells.worst_ratio = std::min(bells.worst_ratio, ratio);
      bells.best_ratio = std::max(bells.best_ratio, ratio);
      bells.most_peaks = std::max(bells.most_peaks, r.peaks);
    }
  }
  return bells;
}

// [C] Figure 14: a bell that wanders from section to section stays one bell of the same height.
TEST(Skin, KeepsTheBellsOfFigure14) {
  const std::vector<Curve> sections = cad_case("bells_5");
  const SkinnedSurface skinned = skin(sections);
  const Bells bells = measure_bells(skinned.surface, skinned.parameters);
  const Loft plain = loft(sections);
  const Bells naive = measure_bells(plain.surface, plain.parameters);
  std::printf("heights %.5f .. %.5f, %d peaks; by parameter %.3f, %d peaks; %zu x %zu, degree %d\n",
              bells.worst_ratio, bells.best_ratio, bells.most_peaks, naive.worst_ratio, naive.most_peaks,
              skinned.surface.size(Along::u), skinned.surface.size(Along::v), skinned.surface.degree(Along::u));
  std::printf("valid %d crease %g law %g interpolation %g cost %g\n", skinned.report.valid,
              skinned.report.crease_angle, skinned.report.law_deviation, skinned.report.interpolation_error,
              skinned.report.total_cost);
  EXPECT_GE(bells.worst_ratio, 0.995);
  EXPECT_LE(bells.best_ratio, 1.005);
  EXPECT_EQ(bells.most_peaks, 1);
  EXPECT_LE(naive.worst_ratio, 0.8);
  EXPECT_LE(skinned.report.crease_angle, std::numbers::pi / 180.0);
  EXPECT_LE(skinned.report.interpolation_error, 1e-9);
}

TEST(Skin, PutsLettersInStep) {
  const SkinnedSurface skinned = skin(cad_case("letters_EF"));
  std::printf("letters: valid %d, crease %g, min dot %g share %g, %zu control points\n", skinned.report.valid,
              skinned.report.crease_angle, skinned.report.pairs[0].validity.min_dot,
              skinned.report.pairs[0].validity.valid_share, skinned.surface.size(Along::u));
  EXPECT_LE(skinned.report.crease_angle, std::numbers::pi / 180.0);
  EXPECT_GE(skinned.report.pairs[0].validity.valid_share, 0.998);
  EXPECT_TRUE(skinned.surface.is_closed(Along::u));
}

}  // namespace
}  // namespace tandem
