#include "tandem/io/css.h"

#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "io/morphs.h"
#include "tandem/error.h"
#include "tandem/io/path_data.h"

namespace tandem {
namespace {

using test::box_to_disc;
using test::commands;
using test::mixed;
using test::turning;

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  std::vector<std::string> found;
  const std::regex expression(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it) {
    found.push_back((*it)[1]);
  }
  return found;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
  return found;
}

TEST(Css, RunsThroughTheKeys) {
  const std::string css = format_css(box_to_disc(), {.duration = 1.5});
  EXPECT_NE(css.find(".morph { fill: #1f2733; fill-rule: nonzero; d: path(\"M"), std::string::npos);
  EXPECT_NE(css.find("animation: morph 1.5s linear infinite alternate both"), std::string::npos);
  EXPECT_EQ(matches(css, R"(\n  ([0-9.]+)% )"), (std::vector<std::string>{"0", "100"}));
  EXPECT_EQ(count(css, "timing-function"), 0u);
  // The class itself, two key frames, and where motion is unwanted.
  const std::vector<std::string> paths = matches(css, R"re(d: path\("([^"]*)"\))re");
  ASSERT_EQ(paths.size(), 4u);
  EXPECT_EQ(paths[0], paths[1]);
  EXPECT_EQ(paths[2], paths[3]);
  EXPECT_EQ(commands(paths[0]), commands(paths[2]));
  EXPECT_NE(paths[0], paths[2]);
  EXPECT_LT(css.find("prefers-reduced-motion: reduce) { .morph { animation: none; d:"), css.size());
  EXPECT_EQ(count(css, "{"), count(css, "}"));
}

TEST(Css, SaysHowItIsPlayed) {
  const PathMorph morph = box_to_disc();
  EXPECT_NE(format_css(morph, {.alternate = false}).find("2s linear infinite both;"), std::string::npos);
  EXPECT_NE(format_css(morph, {.alternate = false, .repeat = false}).find("2s linear 1 both;"),
            std::string::npos);
  EXPECT_NE(format_css(morph, {.repeat = false}).find("2s linear 2 alternate both;"), std::string::npos);
  const std::string eased = format_css(morph, {.easing = "0.1 0.2 0.5 1"});
  EXPECT_EQ(count(eased, "animation-timing-function: cubic-bezier(0.1, 0.2, 0.5, 1);"), 1u);
}

TEST(Css, StrokesOpenContoursBesideTheOthers) {
  const std::string css = format_css(mixed(), {}, {.name = "x"});
  EXPECT_EQ(count(css, "<path class=\"x\"/><path class=\"x-stroke\"/>"), 1u);
  EXPECT_EQ(count(css, "@keyframes x {"), 1u);
  EXPECT_EQ(count(css, "@keyframes x-stroke {"), 1u);
  EXPECT_EQ(count(css, "fill: none; stroke: #1f2733; stroke-width: "), 1u);
}

TEST(Css, TurnsByTransformsOrBakes) {
  const std::string css = format_css(turning());
  EXPECT_EQ(matches(css, R"re(  ([0-9.]+)% \{ d)re").size(), 2u);
  const std::vector<std::string> turns = matches(css, R"re(rotate\(([^)]*)deg\))re");
  ASSERT_EQ(turns.size(), 4u);
  EXPECT_EQ(turns[1], "0");
  EXPECT_EQ(turns[2], "90");
  const std::string baked = format_css(turning(), {}, {.property = CssProperty::clip_path});
  EXPECT_EQ(baked.find("transform"), std::string::npos);
  EXPECT_GT(matches(baked, R"re(  ([0-9.]+)% \{ clip)re").size(), 8u);
}

TEST(Css, ClipsInPixels) {
  const PathMorph morph =
      test::morph_of({"M0 0H20V10H0ZM5 5L8 8V5L5 7Z", "M0 0H20V10H0ZM5 4L9 9V5L5 8Z"}, FillRule::evenodd);
  const std::string css =
      format_css(morph, {}, {.property = CssProperty::clip_path, .name = "clip", .size = 220});
  // The longer side has a margin of 5 % on both sides: 22 units.
  EXPECT_NE(css.find("width: 220px; height: 120px;"), std::string::npos);
  const std::vector<std::string> paths = matches(css, R"re(clip-path: path\(evenodd, "([^"]*)"\))re");
  ASSERT_EQ(paths.size(), 4u);
  Box box;
  for (const CubicPath& path : parse_path_data(paths[0])) box.include(bounding_box(to_curve(path)));
  EXPECT_NEAR(box.lo[0], 10.0, 1e-3);
  EXPECT_NEAR(box.hi[0], 210.0, 1e-3);
  EXPECT_NEAR(box.hi[1], 110.0, 1e-3);
}

TEST(Css, RejectsNonsense) {
  const PathMorph morph = box_to_disc();
  EXPECT_THROW((void)format_css(morph, {.duration = 0.0}), InvalidArgument);
  EXPECT_THROW((void)format_css(morph, {.easing = "fast"}), InvalidArgument);
  for (const char* name : {"", "1a", "a b", "a}", "-a", "\xc3\xa4"}) {
    EXPECT_THROW((void)format_css(morph, {}, {.name = name}), InvalidArgument) << name;
  }
  EXPECT_TRUE(is_css_name("a-1_B"));
  EXPECT_THROW((void)format_css(mixed(), {}, {.property = CssProperty::clip_path}), InvalidArgument);
  EXPECT_THROW((void)format_css(morph, {}, {.property = CssProperty::clip_path, .size = 0}), InvalidArgument);
}

}  // namespace
}  // namespace tandem
