#include "tandem/io/motion_picture.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "tandem/error.h"
#include "tandem/io/csv.h"

namespace tandem {
namespace {

MotionMorph some_motions(const MotionOptions& options = {}) {
  std::string a = "t,x,y <mm>\n";
  std::string b = a;
  for (int i = 0; i <= 20; ++i) {
    a += std::to_string(i) + "," + std::to_string(i * (20 - i)) + ",5\n";
    b += std::to_string(2 * i) + "," + std::to_string(2 * i * (20 - i)) + ",7\n";
  }
  return MotionMorph(std::vector<Curve>{parse_csv(a), parse_csv(b), parse_csv(a)}, options);
}

const std::vector<std::string> kColumns = {"t", "x", "y <mm>"};

TEST(MotionPicture, PlotsEveryCoordinate) {
  const MotionMorph morph = some_motions();
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(
      format_motion_svg(morph, {.columns = kColumns, .title = "a & b", .in_betweens = {0.25}}).c_str()));
  const pugi::xml_node svg = document.child("svg");
  EXPECT_STREQ(svg.child("title").text().get(), "a & b");
  std::size_t plots = 0;
  for (const pugi::xml_node plot : svg.children("g")) {
    std::size_t lines = 0;
    for (const pugi::xml_node path : plot.children("path")) {
      lines += std::string(path.attribute("class").value()).rfind("motion", 0) == 0 ? 1 : 0;
    }
    EXPECT_EQ(lines, 4u);  // three motions and one between
    EXPECT_EQ(plot.find_child_by_attribute("text", "class", "name").text().get(), kColumns[++plots]);
  }
  EXPECT_EQ(plots, 2u);
}

TEST(MotionPicture, PageHoldsTheMotions) {
  for (const bool smooth : {false, true}) {
    const MotionMorph morph = some_motions({.times = {0, 0.4, 1}, .smooth = smooth});
    const std::string page = format_motion_html(
        morph, {.columns = kColumns, .title = "<b>", .in_betweens = {}}, {.duration = 1.5, .easing = "ease"});
    EXPECT_NE(page.find("&lt;b&gt;"), std::string::npos);
    const std::string head = "id=\"data\">";
    const std::size_t from = page.find(head) + head.size();
    const nlohmann::json data = nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
    EXPECT_EQ(data["duration"], 1.5);
    EXPECT_EQ(data["frames"].size(), smooth ? 17u : 3u);
    EXPECT_EQ(data["times"][data["keys"][1].get<std::size_t>()], 0.4);
    EXPECT_EQ(data["stretches"].size(), smooth ? 2u : 3u);
    ASSERT_EQ(data["frames"][0].size(), 3u);
    EXPECT_NEAR(data["frames"][0][0].back().get<double>(), 20.0, 1e-3);
    EXPECT_NEAR(data["frames"].back()[2].front().get<double>(), 5.0, 1e-3);
  }
}

TEST(MotionPicture, RefusesOtherNumbersOfNames) {
  const MotionMorph morph = some_motions();
  EXPECT_THROW((void)format_motion_svg(morph, {.columns = {"t", "x"}, .title = "", .in_betweens = {}}),
               InvalidArgument);
  EXPECT_THROW((void)format_motion_html(morph, {.columns = {"t"}, .title = "", .in_betweens = {}}),
               InvalidArgument);
  EXPECT_THROW((void)format_motion_html(morph, {.columns = kColumns, .title = "", .in_betweens = {}},
                                        {.duration = 0.0}),
               InvalidArgument);
}

TEST(CsvTable, HasNamesAndReadsBack) {
  const CsvTable table = parse_csv_table("Time [s];left;right\n0;1,5;2\n1;2;3\n3;4;8\n");
  EXPECT_EQ(table.columns, (std::vector<std::string>{"Time [s]", "left", "right"}));
  EXPECT_EQ(table.rows, 3u);
  EXPECT_EQ(parse_csv_table("1 2\n3 4\n").columns, (std::vector<std::string>{"t", "x1", "x2"}));
  EXPECT_EQ(parse_csv_table("a,b\n1,2\n3,4\n").columns, (std::vector<std::string>{"t", "a", "b"}));
  const Points rows({{0, 0.1}, {1, 1e-9}});
  const std::string text = format_csv(rows, std::vector<std::string>{"t", "left arm"});
  EXPECT_EQ(text.substr(0, 13), "t,\"left arm\"\n");
  const CsvTable back = parse_csv_table(text);
  EXPECT_EQ(back.columns[1], "left arm");
  EXPECT_EQ(back.curve.evaluate(1.0)[0], 1e-9);
  EXPECT_THROW((void)format_csv(rows, std::vector<std::string>{"t"}), InvalidArgument);
}

}  // namespace
}  // namespace tandem
