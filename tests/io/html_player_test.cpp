#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/morphs.h"
#include "tandem/error.h"
#include "tandem/io/path_data.h"
#include "tandem/io/svg.h"
#include "tandem/shape/path_builder.h"

namespace tandem {
namespace {

PathMorph some_morph() {
  std::vector<Shape> keys;
  for (const double size : {10.0, 20.0, 15.0}) {
    PathBuilder builder;
    builder.move_to({0, 0});
    builder.line_to({size, 0});
    builder.cubic_to({size, size / 2}, {size / 2, size}, {0, size});
    builder.close();
    const std::vector<CubicPath> paths = builder.take();
    keys.push_back(to_shape(paths, FillRule::evenodd));
  }
  MorphOptions options;
  options.match.samples = {24, 24};  // how good the match is does not matter here
  return test::path_morph(keys, options);
}

std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t start = text.find(before) + before.size();
  return text.substr(start, text.find(after, start) - start);
}

TEST(HtmlPlayer, HoldsTheKeysAsNumbers) {
  const PathMorph morph = some_morph();
  const std::string page = format_html_player(morph, "Square to disc", {.duration = 1.5, .easing = "ease"});
  const nlohmann::json data =
      nlohmann::json::parse(between(page, "<script type=\"application/json\" id=\"data\">", "</script>"));
  EXPECT_EQ(data["keys"], nlohmann::json({0, 1, 2}));
  EXPECT_EQ(data["times"], nlohmann::json({0, 0.5, 1}));
  EXPECT_EQ(data["repeat"], true);
  EXPECT_EQ(data["rule"], "nonzero");  // nothing crosses, so the contours are wound for it
  EXPECT_EQ(data["duration"], 1.5);
  EXPECT_EQ(data["alternate"], true);
  EXPECT_EQ(data["easings"], nlohmann::json::array({{0.25, 0.1, 0.25, 1.0}}));
  ASSERT_EQ(data["contours"].size(), 1u);
  const nlohmann::json& contour = data["contours"][0];
  EXPECT_EQ(contour["closed"], true);
  const std::string commands = contour["commands"];
  EXPECT_EQ(commands.size(), morph.contours()[0].lines.size());
  EXPECT_NE(commands.find('L'), std::string::npos);
  EXPECT_NE(commands.find('C'), std::string::npos);
  std::size_t numbers = 2;
  for (const char c : commands) numbers += c == 'L' ? 2 : 6;
  ASSERT_EQ(contour["frames"].size(), 3u);
  for (std::size_t key = 0; key < 3; ++key) {
    ASSERT_EQ(contour["frames"][key].size(), numbers);
    const auto first = morph.contours()[0].keys[key].control_points()[0];
    EXPECT_NEAR(contour["frames"][key][0], first[0], 1e-3);
    EXPECT_NEAR(contour["frames"][key][1], first[1], 1e-3);
  }
}

TEST(HtmlPlayer, HoldsThePosesOfATurningFrame) {
  const auto data_of = [](const PathMorph& morph) {
    return nlohmann::json::parse(between(format_html_player(morph, "x"),
                                         "<script type=\"application/json\" id=\"data\">", "</script>"));
  };
  EXPECT_FALSE(data_of(some_morph()).contains("poses"));
  const Shape key = to_shape(parse_path_data("M0 0H9V2H3V5H0Z", "key", false));
  const std::vector<Shape> keys{key, to_shape(parse_path_data("M0 0V9H-2V3H-5V0Z", "turned", false))};
  const nlohmann::json data = data_of(test::path_morph(keys));
  ASSERT_EQ(data["poses"].size(), 2u);
  EXPECT_EQ(data["poses"][0][2], 0);
  EXPECT_NEAR(data["poses"][1][2], 90.0, 1e-5);
  // As the frame sees them both keys are the same.
  const auto& numbers = data["contours"][0]["frames"];
  ASSERT_EQ(numbers[0].size(), numbers[1].size());
  for (std::size_t i = 0; i < numbers[0].size(); ++i) {
    EXPECT_NEAR(double(numbers[0][i]), double(numbers[1][i]), 1e-3);
  }
}

TEST(HtmlPlayer, NeedsNoNetwork) {
  const std::string page = format_html_player(some_morph(), "x");
  for (const char* reach : {"http:", "https:", "src=", "@import", "url(", "fetch", "XMLHttp", "import("}) {
    // The SVG name space is an identifier, not an address that is asked.
    std::string rest = page;
    const std::string name_space = "http://www.w3.org/2000/svg";
    for (std::size_t at; (at = rest.find(name_space)) != std::string::npos;)
      rest.erase(at, name_space.size());
    EXPECT_EQ(rest.find(reach), std::string::npos) << reach;
  }
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

TEST(HtmlPlayer, EscapesTheTitle) {
  const std::string page =
      format_html_player(some_morph(), "<b>\"A\" & 'B'</b></title><script>alert(1)</script>");
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  EXPECT_NE(page.find("<title>&lt;b&gt;&quot;A&quot; &amp; &#39;B&#39;&lt;/b&gt;"), std::string::npos);
}

TEST(HtmlPlayer, RejectsNonsense) {
  EXPECT_THROW((void)format_html_player(some_morph(), "x", {.duration = -1.0}), InvalidArgument);
  EXPECT_THROW((void)format_html_player(some_morph(), "x", {.easing = "1 2"}), InvalidArgument);
}

}  // namespace
}  // namespace tandem
