// In a hurry (coarse_to_fine) fewer candidates are tried, and most of them on few samples: what is chosen is
// mostly the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "morph/icons.h"
#include "tandem/morph/path_morph.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/shape.h"

namespace tandem {
namespace {

PathMorph morph_of(std::size_t a, std::size_t b, bool fast) {
  const std::vector<Shape> keys{to_shape(test::paths_of(test::kIcons[a])),
                                to_shape(test::paths_of(test::kIcons[b]))};
  MorphOptions options;
  options.match.coarse_to_fine = fast;
  return PathMorph(keys, options);
}

// The mean difference of v(u), as a share of the second outline's parameters.
double difference(const Correspondence& x, const Correspondence& y) {
  constexpr int kPlaces = 200;
  const double period = x.domain_v.length();
  double sum = 0.0;
  for (int k = 0; k < kPlaces; ++k) {
    const double u = x.domain_u.lo + x.domain_u.length() * k / kPlaces;
    const double apart = (x.v_at(u) - y.v_at(u)) / period;
    sum += std::fabs(apart - std::floor(apart + 0.5));
  }
  return sum / kPlaces;
}

TEST(FastMorph, ChoosesTheSameCorrespondence) {
  constexpr std::size_t kPairs = 8;
  std::size_t same = 0;
  for (std::size_t k = 0; k < kPairs; ++k) {
    const PathMorph exact = morph_of(k, k + 1, false);
    const PathMorph fast = morph_of(k, k + 1, true);
    const Match& of_exact = *exact.steps().front().contours.front().match;
    const Match& of_fast = *fast.steps().front().contours.front().match;
    EXPECT_TRUE(of_exact.report.exact);
    EXPECT_FALSE(of_fast.report.exact);
    if (difference(of_exact.correspondence, of_fast.correspondence) <= 0.02) ++same;
  }
  EXPECT_GE(same, kPairs - 1);  // 95 % of many pairs
}

}  // namespace
}  // namespace tandem
