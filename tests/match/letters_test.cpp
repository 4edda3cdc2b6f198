#include <gtest/gtest.h>

#include <cstdio>

#include "tandem/curve/edit.h"
#include "tandem/io/files.h"
#include "tandem/io/json.h"
#include "tandem/match/match.h"

namespace tandem {
namespace {

Curve letter(const char* name) {
  const std::string path = std::string(TANDEM_EXAMPLE_DATA) + "/letter_" + name + ".json";
  return parse_json_curves(read_file(path), path).front();
}

// [C] Figure 9: quadratic outlines of E (24 control points) and F (20).
TEST(Letters, EAndFAreInStep) {
  const Curve e = letter("e");
  const Curve f = letter("f");
  ASSERT_EQ(e.size(), 24u + 2u);
  ASSERT_EQ(f.size(), 20u + 2u);
  for (const Method method : {Method::elastic, Method::paper}) {
    const Match m = match(e, f, {.method = method});
    const Validity& v = m.report.validity;
    std::printf("%s: valid on %.2f %% of the length, mean <T1,T2> %.3f, least %.4f\n",
                method == Method::elastic ? "elastic" : "paper", 100.0 * v.valid_share, v.mean_dot,
                v.min_dot);
    EXPECT_GE(v.valid_share, 0.99);
    EXPECT_GE(v.mean_dot, 0.9);
    EXPECT_EQ(m.report.direction, Direction::forward);
  }
}

TEST(Letters, SeamsDoNotMatter) {
  const Curve e = letter("e");
  const Curve f = letter("f");
  const double here = match(e, f).report.cost;
  for (const double shift : {0.1, 0.37, 0.8}) {
    EXPECT_NEAR(match(e, with_domain(move_seam(f, shift), {0.0, 1.0})).report.cost, here, 1e-8);
    EXPECT_NEAR(match(with_domain(move_seam(e, shift), {0.0, 1.0}), f).report.cost, here, 1e-8);
  }
}

}  // namespace
}  // namespace tandem
