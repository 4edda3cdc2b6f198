#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "io/paths.h"
#include "tandem/io/path_data.h"
#include "tandem/io/svg.h"

namespace {

using tandem::FillRule;
using tandem::parse_path_data;
using tandem::parse_svg;
using tandem::parse_svg_part;
using tandem::Shape;
using tandem::SvgElement;
using tandem::test::BadInput;

std::string wrapped(const std::string& body, const std::string& attributes = "viewBox=\"0 0 24 24\"") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + ">" + body + "</svg>";
}

Shape outline(const std::string& path_data, FillRule rule = FillRule::nonzero) {
  return tandem::to_shape(parse_path_data(path_data, "expected", false), rule);
}

struct Drawing {
  std::string svg;
  std::vector<std::string> outlines;  ///< one per drawable
};

void expect_drawn(const Drawing& drawing) {
  SCOPED_TRACE(drawing.svg);
  const std::vector<SvgElement> elements = parse_svg(drawing.svg);
  ASSERT_EQ(elements.size(), drawing.outlines.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    tandem::test::expect_same_shape(elements[i].shape, outline(drawing.outlines[i]), 1e-9,
                                    "element " + std::to_string(i));
  }
}

TEST(SvgReader, ReadsTheBasicShapes) {
  const std::string circle = "M15 10A5 5 0 0 1 10 15A5 5 0 0 1 5 10A5 5 0 0 1 10 5A5 5 0 0 1 15 10Z";
  const std::string ellipse = "M14 10A4 2 0 0 1 10 12A4 2 0 0 1 6 10A4 2 0 0 1 10 8A4 2 0 0 1 14 10Z";
  const Drawing drawings[] = {
      {wrapped("<path d='M1 2L3 4L5 0Z'/>"), {"M1 2L3 4L5 0Z"}},
      {wrapped("<rect x='1' y='2' width='3' height='4'/>"), {"M1 2H4V6H1Z"}},
      {wrapped("<rect width='3' height='4'/>"), {"M0 0H3V4H0Z"}},
      {wrapped("<rect width='10' height='8' rx='2' ry='1'/>"),
       {"M2 0H8A2 1 0 0 1 10 1V7A2 1 0 0 1 8 8H2A2 1 0 0 1 0 7V1A2 1 0 0 1 2 0Z"}},
      {wrapped("<rect width='10' height='8' rx='2'/>"),
       {"M2 0H8A2 2 0 0 1 10 2V6A2 2 0 0 1 8 8H2A2 2 0 0 1 0 6V2A2 2 0 0 1 2 0Z"}},
      {wrapped("<rect width='10' height='8' ry='2' rx='auto'/>"),
       {"M2 0H8A2 2 0 0 1 10 2V6A2 2 0 0 1 8 8H2A2 2 0 0 1 0 6V2A2 2 0 0 1 2 0Z"}},
      // Radii are cut to half of the sides, and the straight parts vanish.
      {wrapped("<rect width='10' height='8' rx='50' ry='50'/>"),
       {"M5 0A5 4 0 0 1 10 4A5 4 0 0 1 5 8A5 4 0 0 1 0 4A5 4 0 0 1 5 0Z"}},
      {wrapped("<rect width='10' height='8' rx='0' ry='2'/>"), {"M0 0H10V8H0Z"}},
      {wrapped("<circle cx='10' cy='10' r='5'/>"), {circle}},
      {wrapped("<ellipse cx='10' cy='10' rx='4' ry='2'/>"), {ellipse}},
      {wrapped("<ellipse cx='10' cy='10' rx='5'/>"), {circle}},
      {wrapped("<line x1='1' y1='2' x2='3' y2='4'/>"), {"M1 2L3 4"}},
      {wrapped("<polyline points='1,2 3,4 5,0'/>"), {"M1 2L3 4L5 0"}},
      {wrapped("<polyline points='1 2 3 4 5 0 1 2'/>"), {"M1 2L3 4L5 0Z"}},
      {wrapped("<polygon points='1-2,3.5.5 5,0'/>"), {"M1-2L3.5 0.5L5 0Z"}},
  };
  for (const Drawing& drawing : drawings) expect_drawn(drawing);
}

TEST(SvgReader, SkipsWhatHasNoOutline) {
  const std::string shown = "<path d='M1 2L3 4L5 0Z'/>";
  for (const char* nothing : {"<path/>",
                              "<path d=''/>",
                              "<path d='M5 5'/>",
                              "<rect width='0' height='4'/>",
                              "<rect width='4'/>",
                              "<circle cx='3' cy='3'/>",
                              "<circle r='0'/>",
                              "<ellipse rx='3' ry='0'/>",
                              "<line x1='1' x2='1'/>",
                              "<polyline/>",
                              "<polygon points=''/>",
                              "<polygon points='1 1'/>",
                              "<text>M0 0L9 9</text>",
                              "<defs><path d='M0 0L1 1'/></defs>",
                              "<symbol><path d='M0 0L1 1'/></symbol>",
                              "<clipPath><path d='M0 0L1 1'/></clipPath>",
                              "<mask><path d='M0 0L1 1'/></mask>",
                              "<marker><path d='M0 0L1 1'/></marker>",
                              "<pattern><path d='M0 0L1 1'/></pattern>",
                              "<linearGradient><path d='M0 0L1 1'/></linearGradient>",
                              "<unknown><path d='M0 0L1 1'/></unknown>",
                              "<metadata><path d='M0 0L1 1'/></metadata>",
                              "<g display='none'><path d='M0 0L1 1'/></g>",
                              "<path style='display : none' d='M0 0L1 1'/>",
                              "<g visibility='hidden'><path d='M0 0L1 1'/></g>",
                              "<path visibility='collapse' d='M0 0L1 1'/>",
                              "<use href='#missing'/>",
                              "<use href='other.svg#a'/>",
                              "<use/>",
                              "<x:path xmlns:x='urn:other' d='M0 0L1 1'/>",
                              "<!-- <path d='M0 0L1 1'/> -->",
                              "<g transform='scale(0)'><path d='M0 0L1 1'/></g>",
                              "<svg width='0'><path d='M0 0L1 1'/></svg>",
                              "<svg viewBox='0 0 0 5'><path d='M0 0L1 1'/></svg>"}) {
    expect_drawn({wrapped(shown + nothing), {"M1 2L3 4L5 0Z"}});
    expect_drawn({wrapped(nothing + shown), {"M1 2L3 4L5 0Z"}});
  }
}

TEST(SvgReader, AppliesTransforms) {
  const double s = std::sqrt(0.5);
  const auto mapped = [](const tandem::Transform& map) {
    const auto paths = parse_path_data("M1 2L3 4L5 0Z", "expected", false, map);
    return tandem::format_path_data(paths);
  };
  const struct {
    std::string transform;
    tandem::Transform map;
  } cases[] = {
      {"translate(10)", {1, 0, 0, 1, 10, 0}},
      {"translate(10 20)", {1, 0, 0, 1, 10, 20}},
      {"translate(10,20)", {1, 0, 0, 1, 10, 20}},
      {" translate ( 10 , 20 ) ", {1, 0, 0, 1, 10, 20}},
      {"scale(2)", {2, 0, 0, 2, 0, 0}},
      {"scale(2-3)", {2, 0, 0, -3, 0, 0}},
      {"rotate(90)", {0, 1, -1, 0, 0, 0}},
      {"rotate(45)", {s, s, -s, s, 0, 0}},
      {"rotate(90 1 2)", {0, 1, -1, 0, 3, 1}},
      {"skewX(45)", {1, 0, 1, 1, 0, 0}},
      {"skewY(45)", {1, 1, 0, 1, 0, 0}},
      {"matrix(1 2 3 4 5 6)", {1, 2, 3, 4, 5, 6}},
      {"translate(10 20) scale(2)", {2, 0, 0, 2, 10, 20}},
      {"scale(2),translate(10 20)", {2, 0, 0, 2, 20, 40}},
      {"scale(2)translate(10 20)rotate(90)", {0, 2, -2, 0, 20, 40}},
      {"", {}},
      {"none", {}},
  };
  for (const auto& c : cases) {
    expect_drawn({wrapped("<path d='M1 2L3 4L5 0Z' transform='" + c.transform + "'/>"), {mapped(c.map)}});
  }
  expect_drawn({wrapped("<path d='M1 2L3 4L5 0Z' style='transform:translate(10px,20px) rotate(90deg)'/>"),
                {mapped({0, 1, -1, 0, 10, 20})}});
  // Groups: the outer one is applied last.
  expect_drawn({wrapped("<g transform='translate(10 20)'><a><g transform='scale(2)'>"
                        "<path transform='rotate(90)' d='M1 2L3 4L5 0Z'/></g></a></g>"),
                {mapped({0, 2, -2, 0, 10, 20})}});
}

TEST(SvgReader, KeepsTheUserUnitsOfTheRoot) {
  expect_drawn({wrapped("<path d='M1 2L3 4L5 0Z'/>", "viewBox='10 20 512 512' width='24' height='24'"),
                {"M1 2L3 4L5 0Z"}});
}

TEST(SvgReader, PlacesNestedViewports) {
  const std::string path = "<path d='M0 0L10 0L10 20Z'/></svg>";
  const Drawing drawings[] = {
      {wrapped("<svg x='1' y='2'>" + path), {"M1 2L11 2L11 22Z"}},
      {wrapped("<svg x='1' y='2' width='20' height='20' viewBox='0 0 10 10'>" + path), {"M1 2L21 2L21 42Z"}},
      {wrapped("<svg width='20' height='20' viewBox='5 5 10 10'>" + path), {"M-10-10L10-10L10 30Z"}},
      // meet: the smaller scale, and the rest spread as said
      {wrapped("<svg width='20' height='40' viewBox='0 0 10 10'>" + path), {"M0 10L20 10L20 50Z"}},
      {wrapped("<svg width='20' height='40' viewBox='0 0 10 10' preserveAspectRatio='xMinYMin'>" + path),
       {"M0 0L20 0L20 40Z"}},
      {wrapped("<svg width='40' height='20' viewBox='0 0 10 10' preserveAspectRatio='xMaxYMid meet'>" + path),
       {"M20 0L40 0L40 40Z"}},
      {wrapped("<svg width='20' height='40' viewBox='0 0 10 10' preserveAspectRatio='xMaxYMax slice'>" +
               path),
       {"M-20 0L20 0L20 80Z"}},
      {wrapped("<svg width='20' height='40' viewBox='0 0 10 10' preserveAspectRatio='none'>" + path),
       {"M0 0L20 0L20 80Z"}},
      // 100 % by default, and shares of the outer viewBox
      {wrapped("<svg viewBox='0 0 12 12'>" + path), {"M0 0L20 0L20 40Z"}},
      {wrapped("<svg width='50%' height='25%' viewBox='0 0 12 6'>" + path), {"M0 0L10 0L10 20Z"}},
      // of no known size: its own
      {wrapped("<svg viewBox='0 0 12 12'>" + path, ""), {"M0 0L10 0L10 20Z"}},
  };
  for (const Drawing& drawing : drawings) expect_drawn(drawing);
}

TEST(SvgReader, UnderstandsUnits) {
  const auto line = [](const std::string& length) { return "<line x2='" + length + "' y2='0'/>"; };
  const struct {
    std::string length;
    double pixels;
  } cases[] = {{"3", 3},    {"3px", 3},  {"3e0px", 3},      {" 3 ", 3},     {"3pt", 4},
               {"1pc", 16}, {"1in", 96}, {"2.54cm", 96},    {"25.4mm", 96}, {"101.6Q", 96},
               {"2em", 32}, {"1ex", 8},  {"50%", 0.5 * 24}, {"-.5e1", -5}};
  for (const auto& c : cases) {
    const std::vector<SvgElement> elements = parse_svg(wrapped(line(c.length)));
    ASSERT_EQ(elements.size(), 1U) << c.length;
    EXPECT_NEAR(elements[0].shape.contours[0].control_points().back()[0], c.pixels, 1e-12) << c.length;
  }
  // Without a viewBox the size counts; radii refer to the diagonal over sqrt(2).
  const auto circle = parse_svg(wrapped("<circle r='10%'/>", "width='30mm' height='40mm'"));
  EXPECT_NEAR(circle[0].shape.contours[0].control_points().front()[0], std::sqrt(12.5) * 96.0 / 25.4, 1e-9);
}

TEST(SvgReader, DrawsUses) {
  const std::string defs =
      "<defs><path id='p' d='M0 0L10 0L10 20Z'/><g id='g' transform='scale(2)'><use href='#p' x='1'/></g>"
      "<symbol id='s' viewBox='0 0 10 20'><path d='M0 0L10 0L10 20Z'/></symbol>"
      "<svg id='v' width='5' height='5' viewBox='0 0 10 10'><path d='M0 0L10 0L10 20Z'/></svg></defs>";
  const Drawing drawings[] = {
      {wrapped(defs + "<use href='#p'/>"), {"M0 0L10 0L10 20Z"}},
      {wrapped(defs + "<use xlink:href='#p' x='1' y='2'/>"), {"M1 2L11 2L11 22Z"}},
      {wrapped(defs + "<use href='#p' x='1' transform='scale(2)'/>"), {"M2 0L22 0L22 40Z"}},
      {wrapped("<use href='#p'/>" + defs), {"M0 0L10 0L10 20Z"}},
      {wrapped(defs + "<use href='#g' y='1'/>"), {"M2 1L22 1L22 41Z"}},
      {wrapped(defs + "<use href='#s' width='20' height='40'/>"), {"M0 0L20 0L20 40Z"}},
      {wrapped(defs + "<use href='#s' width='20' height='20'/>"), {"M5 0L15 0L15 20Z"}},
      {wrapped(defs + "<use href='#s'/>", ""), {"M0 0L10 0L10 20Z"}},
      {wrapped(defs + "<use href='#v'/>"), {"M0 0L5 0L5 10Z"}},
      {wrapped(defs + "<use href='#v' width='10' height='10'/>"), {"M0 0L10 0L10 20Z"}},
      {wrapped(defs + "<use href='#p'/><use href='#p' x='1'/>"), {"M0 0L10 0L10 20Z", "M1 0L11 0L11 20Z"}},
  };
  for (const Drawing& drawing : drawings) expect_drawn(drawing);
}

FillRule rule_of(const std::string& svg) {
  return parse_svg(svg)[0].shape.fill_rule;
}

TEST(SvgReader, TakesTheFillRuleFromAttributeStyleAndSheet) {
  const std::string d = "d='M0 0H9V9H0ZM1 1H2V2H1Z'";
  EXPECT_EQ(rule_of(wrapped("<path " + d + "/>")), FillRule::nonzero);
  EXPECT_EQ(rule_of(wrapped("<path fill-rule='evenodd' " + d + "/>")), FillRule::evenodd);
  EXPECT_EQ(rule_of(wrapped("<path style='fill : red;Fill-Rule: EvenOdd ;' " + d + "/>")), FillRule::evenodd);
  EXPECT_EQ(rule_of(wrapped("<g fill-rule='evenodd'><path " + d + "/></g>")), FillRule::evenodd);
  EXPECT_EQ(rule_of(wrapped("<g fill-rule='evenodd'><path fill-rule='inherit' " + d + "/></g>")),
            FillRule::evenodd);
  EXPECT_EQ(rule_of(wrapped("<g fill-rule='evenodd'><path style='fill-rule:nonzero' " + d + "/></g>")),
            FillRule::nonzero);
  EXPECT_EQ(rule_of(wrapped("<path " + d + "/>", "fill-rule='evenodd'")), FillRule::evenodd);
  const auto sheet = [&d](const std::string& css, const std::string& attributes) {
    return rule_of(wrapped("<style>" + css + "</style><path " + attributes + " " + d + "/>"));
  };
  EXPECT_EQ(sheet(".a{fill-rule:evenodd}", "class='b a'"), FillRule::evenodd);
  EXPECT_EQ(sheet(".a{fill-rule:evenodd}", "class='b'"), FillRule::nonzero);
  EXPECT_EQ(sheet("path{fill-rule:evenodd}", ""), FillRule::evenodd);
  EXPECT_EQ(sheet("*{fill-rule:evenodd}", "fill-rule='nonzero'"), FillRule::evenodd);
  EXPECT_EQ(sheet("#x{fill-rule:evenodd}.a{fill-rule:nonzero}", "id='x' class='a'"), FillRule::evenodd);
  EXPECT_EQ(sheet(".a{fill-rule:nonzero}.a,.b{fill-rule:evenodd}", "class='a'"), FillRule::evenodd);
  EXPECT_EQ(sheet(".b{fill-rule:evenodd}.a{fill-rule:nonzero}", "class='a b'"), FillRule::nonzero);
  EXPECT_EQ(sheet("path.a{fill-rule:evenodd}.a{fill-rule:nonzero}", "class='a'"), FillRule::evenodd);
  EXPECT_EQ(sheet(".a{fill-rule:evenodd}", "class='a' style='fill-rule:nonzero'"), FillRule::nonzero);
  EXPECT_EQ(sheet(".a{fill-rule:evenodd !important}", "class='a' style='fill-rule:nonzero'"),
            FillRule::evenodd);
  EXPECT_EQ(
      sheet("/* .a{} */@import 'x';@media print{.a{fill-rule:nonzero}} .a{fill-rule:evenodd}", "class='a'"),
      FillRule::evenodd);
  EXPECT_EQ(sheet("g .a{fill-rule:evenodd}", "class='a'"), FillRule::nonzero);
}

TEST(SvgReader, LeavesStrokedLinesOpen) {
  const auto is_open_path = [](const std::string& svg) {
    return !parse_svg(svg)[0].shape.contours[0].is_closed();
  };
  // A contour whose ends meet exactly is a closed curve whatever its element says.
  const std::string gap = "d='M0 0L9 0L9 0.001L0 0.001'";
  EXPECT_FALSE(is_open_path(wrapped("<path " + gap + "/>")));
  EXPECT_TRUE(is_open_path(wrapped("<path fill='none' stroke='red' " + gap + "/>")));
  EXPECT_TRUE(is_open_path(wrapped("<path style='fill:none;stroke:red' " + gap + "/>")));
  EXPECT_TRUE(is_open_path(wrapped("<g fill='none' stroke='red'><path " + gap + "/></g>")));
  EXPECT_TRUE(is_open_path(wrapped("<path stroke='red' " + gap + "/>", "fill='none'")));
  EXPECT_TRUE(
      is_open_path(wrapped("<style>.a{fill:none}</style><path class='a' stroke='red' " + gap + "/>")));
  EXPECT_TRUE(is_open_path(wrapped("<polyline points='0 0 9 0 9 .001 0 .001' fill='none' stroke='red'/>")));
  EXPECT_FALSE(is_open_path(wrapped("<polygon points='0 0 9 0 9 9' fill='none' stroke='red'/>")));
  EXPECT_FALSE(is_open_path(wrapped("<path fill='none' stroke='red' d='M0 0L9 0L9 9Z'/>")));
}

// Outlines of stroked icon sets end where they started, but for rounding: they look closed, and should move
// so.
TEST(SvgReader, ClosesStrokedOutlinesWhoseEndsMeet) {
  const auto is_closed = [](const std::string& shape) {
    return parse_svg(wrapped(shape, "fill='none' stroke='red'"))[0].shape.contours[0].is_closed();
  };
  EXPECT_TRUE(is_closed("<path d='M0 0L9 0L9 9L0 0.001'/>"));
  EXPECT_TRUE(
      is_closed("<path d='M19.5 12.572l-7.5 7.428l-7.5 -7.428a5 5 0 1 1 7.5 -6.566a5 5 0 1 1 7.5 6.572'/>"));
  EXPECT_TRUE(is_closed("<polyline points='0 0 9 0 9 9 0 .001'/>"));
  EXPECT_FALSE(is_closed("<path d='M0 0L9 0L9 9L0 0.1'/>"));
  EXPECT_FALSE(is_closed("<path d='M3 3h.01'/>"));
}

TEST(SvgReader, LeavesOutWhatIsNotPaintedBesideWhatIs) {
  const std::string frame = "<path d='M0 0h24v24H0z' fill='none'/>";
  expect_drawn({wrapped(frame + "<path d='M1 2L3 4L5 0Z'/>"), {"M1 2L3 4L5 0Z"}});
  expect_drawn({wrapped(frame), {"M0 0H24V24H0Z"}});
  expect_drawn({wrapped("<path d='M0 0h24v24H0z' stroke='none'/><path d='M1 2L3 4L5 0Z'/>",
                        "fill='none' stroke='red'"),
                {"M1 2L3 4L5 0Z"}});
  expect_drawn(
      {wrapped(frame + "<g fill='none' stroke='red'><path d='M1 2L3 4L5 0Z'/></g>"), {"M1 2L3 4L5 0Z"}});
  expect_drawn({wrapped("<line x2='3'/><path d='M1 2L3 4L5 0Z'/>"), {"M0 0L3 0", "M1 2L3 4L5 0Z"}});
}

TEST(SvgReader, ShowsVisibleChildrenOfHiddenGroups) {
  expect_drawn(
      {wrapped(
           "<g visibility='hidden'><path d='M0 0L1 1'/><path visibility='visible' d='M1 2L3 4L5 0Z'/></g>"),
       {"M1 2L3 4L5 0Z"}});
}

TEST(SvgReader, TakesTheFirstBranchOfASwitch) {
  expect_drawn({wrapped("<switch><foreignObject/><g requiredExtensions='x'><path d='M0 0L1 1'/></g>"
                        "<g><path d='M1 2L3 4L5 0Z'/></g><path d='M0 0L1 1'/></switch>"),
                {"M1 2L3 4L5 0Z"}});
}

TEST(SvgReader, KnowsPrefixesAndDeclarations) {
  expect_drawn(
      {"\xEF\xBB\xBF<?xml version='1.0' encoding='UTF-8'?>\n<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' "
       "'http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd' [ <!ENTITY ns_svg 'http://www.w3.org/2000/svg'> "
       "]>\n<svg xmlns='&ns_svg;'><path d='M1 2L3 4L5 0Z'/></svg>",
       {"M1 2L3 4L5 0Z"}});
  expect_drawn(
      {"<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:path d='M1 2L3 4L5 0Z'/></s:svg>", {"M1 2L3 4L5 0Z"}});
  expect_drawn({"<svg><path d='M1 2L3 4L5 0Z'/></svg>", {"M1 2L3 4L5 0Z"}});
  expect_drawn({wrapped("<path d='M1&#32;2&#x4c;3 4L5 0Z'/>"), {"M1 2L3 4L5 0Z"}});
}

TEST(SvgReader, KeepsIds) {
  const auto elements =
      parse_svg(wrapped("<path id='a' d='M0 0L1 1'/><path d='M0 0L1 1'/><rect id='r' width='1' "
                        "height='1'/>"));
  ASSERT_EQ(elements.size(), 3U);
  EXPECT_EQ(elements[0].id, "a");
  EXPECT_EQ(elements[1].id, "");
  EXPECT_EQ(elements[2].id, "r");
}

TEST(SvgReader, FindsParts) {
  const std::string svg = wrapped(
      "<defs><path id='p' d='M0 0L10 0L10 20Z'/><symbol id='s' viewBox='0 0 5 5'><path d='M1 2L3 4L5 "
      "0Z'/></symbol></defs>"
      "<g id='g' transform='translate(1 2)'><path id='a' d='M0 0L10 0L10 20Z'/><rect width='1' "
      "height='1'/></g>"
      "<use id='u' href='#p' x='5'/>");
  const auto expect_part = [&](const std::string& id, const std::vector<std::string>& outlines) {
    const auto elements = parse_svg_part(svg, id);
    ASSERT_EQ(elements.size(), outlines.size()) << id;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      tandem::test::expect_same_shape(elements[i].shape, outline(outlines[i]), 1e-12, id);
    }
  };
  expect_part("a", {"M1 2L11 2L11 22Z"});
  expect_part("g", {"M1 2L11 2L11 22Z", "M1 2H2V3H1Z"});
  expect_part("u", {"M5 0L15 0L15 20Z"});
  expect_part("p", {"M5 0L15 0L15 20Z"});  // where it is drawn
  expect_part("s", {"M1 2L3 4L5 0Z"});     // drawn nowhere: as it is
  tandem::test::expect_refused({svg, 1, 1, "no element with the id \"x\""},
                               [](const std::string& text) { (void)parse_svg_part(text, "x"); });
}

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

TEST(SvgReader, SaysWhatIsWrongAndWhere) {
  std::string laughs = "<svg><path id='l0' d='M0 0L1 1'/>\n";
  for (int i = 1; i < 12; ++i) {
    laughs += "<g id='l" + std::to_string(i) + "'>" +
              repeated("<use href='#l" + std::to_string(i - 1) + "'/>", 10) + "</g>";
  }
  laughs += "</svg>";
  const BadInput bad[] = {
      {"", 1, 1, "malformed XML"},
      {"hello", 1, 6, "malformed XML"},
      {"<svg><path d='M0 0L1 1'/>", 1, 25, "malformed XML"},
      {"<svg>\n<g>\n</svg>", 3, 3, "mismatch"},
      {"<html><body/></html>", 1, 1, "expected <svg>, found <html>"},
      {"\xFF\xFE<\0s\0", 1, 1, "UTF-16"},
      {"<svg/>", 1, 1, "nothing drawable"},
      {"<svg><g/><path d=''/></svg>", 1, 1, "nothing drawable"},
      {"<svg><symbol id='a'><path d='M0 0L1 1'/></symbol></svg>", 1, 1, "#ID"},
      {"<svg>\n  <path id='a'\n d='M0 0\nL1 x'/></svg>", 4, 4,
       "<path id=\"a\">, attribute d: expected a number (y of L), found 'x'"},
      {"<svg><path fill=\"red\" d = \"M0 0L1 \"/></svg>", 1, 35, "expected a number (y of L), found the end"},
      {"<svg><path d='M0&#32;&#x20;0 L1 x'/></svg>", 1, 33, "found 'x'"},
      {"<svg><path d='M0 0\r\nL1 x'/></svg>", 2, 4, "found 'x'"},
      {"<svg><path x='d' data-d='5' d='Z'/></svg>", 1, 32, "expected M or m"},
      {"<svg><rect width='1' height='-1'/></svg>", 1, 30, "attribute height: a size of -1 is negative"},
      {"<svg><rect width='1km' height='1'/></svg>", 1, 20, "the unit 'km' is not known"},
      {"<svg><rect width='1 1' height='1'/></svg>", 1, 21, "expected the end of the length"},
      {"<svg><rect width='' height='1'/></svg>", 1, 19, "expected a length, found the end"},
      {"<svg><circle r='50%'/></svg>", 1, 17, "a percentage needs a viewBox"},
      {"<svg><circle r='1e999'/></svg>", 1, 17, "out of range"},
      {"<svg><circle cx='1e300' r='1e300'/></svg>", 1, 6, "beyond the largest coordinate"},
      {"<svg><polygon points='1 2 3'/></svg>", 1, 28, "expected a number (y of a point), found the end"},
      {"<svg viewBox='0 0 24'><path d='M0 0L1 1'/></svg>", 1, 21, "expected four numbers"},
      {"<svg viewBox='0 0 -1 1'><path d='M0 0L1 1'/></svg>", 1, 19, "negative"},
      {"<svg><g transform='spin(3)'><path d='M0 0L1 1'/></g></svg>", 1, 20, "unknown transform 'spin'"},
      {"<svg><g transform='scale(1 2 3)'><path d='M0 0L1 1'/></g></svg>", 1, 20,
       "scale has 3 numbers, expected 1 or 2"},
      {"<svg><g transform='scale 2'><path d='M0 0L1 1'/></g></svg>", 1, 26,
       "expected '(' after scale, found '2'"},
      {"<svg><g transform='scale(2'><path d='M0 0L1 1'/></g></svg>", 1, 27, "expected a number of scale"},
      {"<svg><g transform='scale(1e200)scale(1e200)'><path d='M0 0L1 1'/></g></svg>", 1, 32,
       "beyond the range"},
      {"<svg><g transform='scale(1e200)'><path d='M0 0L1e200 1'/></g></svg>", 1, 48, "beyond the largest"},
      {"<svg><g id='a'><use href='#a'/></g></svg>", 1, 16, "<use> of \"a\" inside itself"},
      {"<svg>\n<use href='#a'/><defs><use id='a' href='#b'/>\n<use id='b' href='#a'/></defs></svg>", 3, 1,
       "inside itself"},
      {laughs, 2, 46, "more than 100000 elements"},
      {"<svg>" + repeated("<g>", 300) + repeated("</g>", 300) + "</svg>", 1, 774,
       "nested more than 256 levels"},
      {"<svg><svg viewBox='0 0 1 1' width='1' height='1' preserveAspectRatio='xMidy'><path d='M0 0L1 "
       "1'/></svg></svg>",
       1, 71, "xMidYMid"},
  };
  for (const BadInput& b : bad) {
    tandem::test::expect_refused(b, [](const std::string& text) { (void)parse_svg(text); });
  }
}

TEST(SvgReader, BoundsThePathDataThatUseRepeats) {
  const std::string data = "M0 0" + repeated("h1v1", 20000);
  const std::string svg =
      wrapped("<defs><path id='p' d='" + data + "'/></defs>" + repeated("<use href='#p'/>", 200));
  tandem::test::expect_refused({svg, 1, 67, "too many for a file of"},
                               [](const std::string& text) { (void)parse_svg(text); });
}

TEST(SvgReader, SurvivesDeepForeignXml) {
  // Not drawn, so not nested too deeply for us; nor may looking up prefixes take quadratic time.
  const std::string svg = wrapped("<metadata>" + repeated("<x:style>", 20000) +
                                  repeated("</x:style>", 20000) + "</metadata><path d='M1 2L3 4L5 0Z'/>");
  EXPECT_EQ(parse_svg(svg).size(), 1U);
}

}  // namespace
