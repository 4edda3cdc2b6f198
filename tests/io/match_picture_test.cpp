#include "tandem/io/match_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "io/match_picture_parts.h"
#include "tandem/io/path_data.h"
#include "tandem/shape/shape.h"

namespace tandem {
namespace {

using Polyline = std::vector<std::array<double, 2>>;

Curve drawn(const char* d) {
  return to_curve(parse_path_data(d).front());
}

Curve heart() {
  return drawn(
      "M12 21C6 16 2 12 2 8.5C2 5.4 4.4 3 7.5 3C9.2 3 10.9 3.8 12 5C13 3.8 14.7 3 16.5 3C19.6 3 22 5.4 22 8.5"
      "C22 12.3 18.6 15.4 12 21Z");
}
Curve star() {
  return drawn("M12 17L18 21L16.5 14L22 9.2L14.8 8.6L12 2L9.2 8.6L2 9.2L7.5 14L5.8 21L12 17Z");
}
Curve wave() {
  return drawn("M0 5C1 0 3 0 5 5S9 10 11 5 15 0 18 5");
}

// "M1 2L3 4M5 6" -> its points; moves begin no new line here, all pieces are wanted.
Polyline points_of(const std::string& d) {
  Polyline points;
  const char* at = d.c_str();
  while (*at != '\0') {
    char* end = nullptr;
    const double x = std::strtod(at + 1, &end);
    const double y = std::strtod(end, &end);
    points.push_back({x, y});
    at = end;
  }
  return points;
}

pugi::xml_document picture(const Curve& a, const Curve& b, const MatchOptions& options = {}) {
  const std::string text = format_match_picture(a, b, match(a, b, options), options);
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  EXPECT_TRUE(result) << result.description();
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf\""), std::string::npos);
  return document;
}

Polyline line_of(const pugi::xml_document& document, const char* name) {
  const std::string query = std::string("//path[@class='") + name + "']";
  return points_of(document.select_node(query.c_str()).node().attribute("d").value());
}

double distance(const std::array<double, 2>& p, const Polyline& line) {
  double best = 1e300;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double dx = line[i + 1][0] - line[i][0];
    const double dy = line[i + 1][1] - line[i][1];
    const double squared = dx * dx + dy * dy;
    double t = squared > 0 ? ((p[0] - line[i][0]) * dx + (p[1] - line[i][1]) * dy) / squared : 0.0;
    t = std::clamp(t, 0.0, 1.0);
    best = std::min(best, std::hypot(p[0] - line[i][0] - t * dx, p[1] - line[i][1] - t * dy));
  }
  return best;
}

// v(u) was fitted to the path, so it must lie over it: that checks the unrolling and both axes at once.
void expect_v_over_path(const pugi::xml_document& document, double pixels_apart) {
  const Polyline path = line_of(document, "path");
  const Polyline v = line_of(document, "v");
  ASSERT_GE(path.size(), 2u);
  ASSERT_GE(v.size(), 100u);
  double worst = 0.0;
  for (const auto& p : v) worst = std::max(worst, distance(p, path));
  EXPECT_LE(worst, pixels_apart);
  // From corner to corner, down and to the right.
  EXPECT_NEAR(path.back()[0] - path.front()[0], 480.0, 5.0);
  EXPECT_NEAR(path.back()[1] - path.front()[1], 480.0, 5.0);
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_GE(path[i][0], path[i - 1][0]);
    EXPECT_GE(path[i][1], path[i - 1][1]);
  }
}

TEST(MatchPicture, DrawsOpenCurves) {
  const pugi::xml_document document = picture(wave(), drawn("M0 5C3 -4 6 -2 9 5S11 11 14 9 16 3 18 6"));
  expect_v_over_path(document, 3.0);
}

TEST(MatchPicture, UnrollsClosedCurves) {
  expect_v_over_path(picture(heart(), star()), 3.0);
}

TEST(MatchPicture, DrawsReversedAndShiftedCurves) {
  const Curve back = drawn(
      "M22 8.5C22 5.4 19.6 3 16.5 3C14.7 3 13 3.8 12 5C10.9 3.8 9.2 3 7.5 3C4.4 3 2 5.4 2 8.5"
      "C2 12 6 16 12 21C18.6 15.4 22 12.3 22 8.5Z");
  const MatchOptions options;
  const Match found = match(heart(), back, options);
  EXPECT_EQ(found.report.direction, Direction::reversed);
  expect_v_over_path(picture(heart(), back), 3.0);
}

TEST(MatchPicture, DrawsTheCutOfAClosedCurve) {
  expect_v_over_path(picture(heart(), wave()), 3.0);
}

TEST(MatchPicture, DrawsThePapersTable) {
  MatchOptions options;
  options.method = Method::paper;
  // 20 coefficients follow the path as well as they can: a few nodes of a hundred.
  expect_v_over_path(picture(wave(), drawn("M0 5C3 -4 6 -2 9 5S11 11 14 9 16 3 18 6"), options), 24.0);
  expect_v_over_path(picture(heart(), star(), options), 24.0);
}

TEST(MatchPicture, LinksPointsThatBelongTogether) {
  // The same curve moved: every link is the same translation.
  const Curve a = wave();
  const Curve b = transform(a, Transform::translate(100, 30));
  const pugi::xml_document document = picture(a, b);
  int links = 0;
  Polyline first;
  for (const pugi::xpath_node& node : document.select_nodes("//g[@stroke-opacity='0.5']/path")) {
    const Polyline link = points_of(node.node().attribute("d").value());
    ASSERT_EQ(link.size(), 2u);
    if (first.empty()) first = link;
    EXPECT_NEAR(link[1][0] - link[0][0], first[1][0] - first[0][0], 0.5);
    EXPECT_NEAR(link[1][1] - link[0][1], first[1][1] - first[0][1], 0.5);
    ++links;
  }
  EXPECT_GE(links, 40);
}

TEST(MatchPicture, ScalesAnyCurve) {
  const Curve huge = transform(wave(), Transform::scale(1e200, 1e200));
  (void)picture(huge, wave());
  const Curve a = Curve::clamped_uniform(3, Points({{0, 0, 0}, {1, 2, 3}, {4, 1, 0}, {6, 6, 1}}));
  const Curve b = Curve::clamped_uniform(2, Points({{0, 1, 0}, {1, 2, 5}, {4, 3, 0}}));
  (void)picture(a, b);
  const Curve scalar = Curve::clamped_uniform(3, Points({{0}, {4}, {1}, {9}}));
  (void)picture(scalar, Curve::clamped_uniform(2, Points({{1}, {2}, {8}})));
  const Curve flat = drawn("M0 0H10");
  (void)picture(flat, flat);
}

TEST(MatchPicture, ThinsOutLargeTables) {
  MatchOptions options;
  options.samples = {400, 300};
  const Curve a = wave();
  const std::string text = format_match_picture(a, a, match(a, a, options), options);
  EXPECT_LE(text.size(), 600000u);
}

TEST(MatchPicture, MixesColours) {
  EXPECT_EQ(color(0.0, 0.5, 1.0), "#0080ff");
  EXPECT_EQ(color(-1.0, 2.0, 0.2), "#00ff33");
}

}  // namespace
}  // namespace tandem
