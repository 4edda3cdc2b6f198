#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/morphs.h"
#include "tandem/io/path_data.h"
#include "tandem/io/svg.h"

namespace tandem {
namespace {

using test::commands;

std::vector<double> numbers(const std::string& d) {
  std::vector<double> found;
  std::string spaced;
  for (const char c : d) spaced += (c >= 'A' && c <= 'Z') ? ' ' : c;
  for (const std::string& word : test::split(spaced, ' ')) {
    if (!word.empty()) found.push_back(std::stod(word));
  }
  return found;
}

// What a program does that knows nothing but the two strings.
void expect_blends_like(const PathMorph& morph, double tolerance) {
  const std::vector<std::string> keys = format_key_paths(morph);
  ASSERT_EQ(keys.size(), morph.key_count());
  EXPECT_FALSE(commands(keys[0]).empty());
  for (std::size_t key = 0; key + 1 < keys.size(); ++key) {
    EXPECT_EQ(commands(keys[key]), commands(keys[key + 1]));
    const std::vector<double> a = numbers(keys[key]);
    const std::vector<double> b = numbers(keys[key + 1]);
    for (const double share : {0.0, 0.3, 0.5, 1.0}) {
      const double s = (static_cast<double>(key) + share) / static_cast<double>(keys.size() - 1);
      const std::vector<double> wanted = numbers(format_path_data(morph, s));
      ASSERT_EQ(a.size(), wanted.size());
      ASSERT_EQ(b.size(), wanted.size());
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_NEAR((1 - share) * a[i] + share * b[i], wanted[i], tolerance) << "number " << i << " at " << s;
      }
    }
  }
}

TEST(KeyPaths, BlendNumberByNumber) {
  expect_blends_like(test::box_to_disc(), 2e-4);
  expect_blends_like(test::mixed(), 2e-4);
  expect_blends_like(test::morph_of({"M0 0H9V9H0Z", "M0 0H5V9H0Z", "M0 0H7V7H0Z"}), 2e-4);
  expect_blends_like(test::morph_of({"M0 0H9e6V9e6H0Z", "M0 0H5e6V9e6H0Z"}), 200.0);
}

TEST(KeyPaths, LieWhereTheyAreDrawn) {
  const PathMorph morph = test::turning();
  ASSERT_TRUE(morph.turns());
  const std::vector<std::string> keys = format_key_paths(morph);
  ASSERT_EQ(keys.size(), 2u);
  const std::vector<double> last = numbers(keys[1]);
  const std::vector<double> wanted = numbers(format_path_data(morph, 1.0));
  ASSERT_EQ(last.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(last[i], wanted[i], 2e-4);
}

TEST(KeyPaths, KeepAsManyDecimalsAsAsked) {
  const PathMorph morph = test::box_to_disc();
  for (const double x : numbers(format_key_paths(morph, 1)[1])) {
    EXPECT_NEAR(10 * x, std::round(10 * x), 1e-9);
  }
  EXPECT_NE(format_key_paths(morph, 1), format_key_paths(morph, 6));
}

TEST(KeysSvg, HasOneElementPerKey) {
  const std::string svg = format_keys_svg(test::mixed());
  ASSERT_EQ(parse_svg(svg).size(), 2u);
  const Box box = bounding_box(parse_svg_part(svg, "b").front().shape);
  EXPECT_NEAR(box.hi[0], 18.0, 1e-3);
  EXPECT_NEAR(box.hi[1], 9.0, 1e-3);
  // One with an open contour is stroked, others are not.
  EXPECT_NE(svg.find("stroke="), std::string::npos);
  EXPECT_EQ(format_keys_svg(test::box_to_disc()).find("stroke="), std::string::npos);
}

TEST(KeysSvg, FillsByTheRule) {
  const std::vector<std::string> keys{"M0 0H9V9H0ZM3 3L6 6V3L3 5Z",
                                      "M0 0H9V9H0ZM2 2L7 7V2L2 6Z"};  // they cross
  EXPECT_NE(format_keys_svg(test::morph_of(keys, FillRule::evenodd)).find("fill-rule=\"evenodd\""),
            std::string::npos);
}

TEST(KeysSvg, HasLettersForTheFirstKeys) {
  const std::vector<std::string> keys(28, "M0 0H9V9H0Z");
  const std::string svg = format_keys_svg(test::morph_of(keys));
  EXPECT_EQ(parse_svg(svg).size(), 28u);
  EXPECT_EQ(parse_svg_part(svg, "z").size(), 1u);
  EXPECT_EQ(parse_svg(svg).back().id, "");
}

}  // namespace
}  // namespace tandem
