#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/layers.h"
#include "io/morphs.h"
#include "io/svg_reader.h"
#include "tandem/error.h"
#include "tandem/io/load.h"
#include "tandem/io/look.h"
#include "tandem/io/svg.h"

namespace tandem {
namespace {

std::string wrapped(const std::string& attributes, const std::string& body) {
  return "<svg xmlns='http://www.w3.org/2000/svg' " + attributes + ">" + body + "</svg>";
}

Style style_of(const std::string& attributes, const std::string& body) {
  return parse_svg(wrapped(attributes, body)).front().style.value();
}

Drawing drawing_of(const std::string& attributes, const std::string& body) {
  return merge(read_svg(wrapped(attributes, body), "svg"));
}

Paint color(double red, double green, double blue, double opacity = 1.0) {
  return {Paint::Kind::color, {red, green, blue}, opacity};
}

const std::string kPath = "<path d='M1 1H9V9H1Z'/>";

TEST(SvgStyles, OutlineIconsInheritFromTheRoot) {
  const Style style = style_of(
      "fill='none' stroke='currentColor' stroke-width='2' stroke-linecap='round' stroke-linejoin='round'",
      kPath);
  EXPECT_EQ(style.fill.kind, Paint::Kind::none);
  EXPECT_EQ(style.stroke.kind, Paint::Kind::current);
  EXPECT_EQ(style.stroke_width, 2.0);
  EXPECT_EQ(style.line_cap, LineCap::round);
  EXPECT_EQ(style.line_join, LineJoin::round);
}

TEST(SvgStyles, InitialValuesAreThoseOfSvg) {
  EXPECT_EQ(style_of("", kPath), Style{});
  EXPECT_EQ(Style{}.fill.kind, Paint::Kind::automatic);
  EXPECT_EQ(style_of("stroke-miterlimit='2' stroke='red'", kPath).miter_limit, 2.0);
  EXPECT_EQ(style_of("stroke-linejoin='bevel' stroke-linecap='square' stroke='red'", kPath).line_join,
            LineJoin::bevel);
}

TEST(SvgStyles, ReadsColors) {
  const struct {
    const char* text;
    Paint paint;
  } paints[] = {
      {"red", color(255, 0, 0)},
      {"ReBeccaPurple", color(0x66, 0x33, 0x99)},
      {"#f80", color(255, 136, 0)},
      {"#f808", color(255, 136, 0, 136 / 255.0)},
      {"#DD2E44", color(0xdd, 0x2e, 0x44)},
      {"#dd2e4480", color(0xdd, 0x2e, 0x44, 128 / 255.0)},
      {"rgb(1, 2, 3)", color(1, 2, 3)},
      {"rgb(100% 0% 50% / 25%)", color(255, 0, 127.5, 0.25)},
      {"rgba(1,2,300,.5)", color(1, 2, 255, 0.5)},
      {"hsl(120deg 100% 50%)", color(0, 255, 0)},
      {"hsla(240, 100%, 25%, 0.5)", color(0, 0, 127.5, 0.5)},
      {"currentColor", {Paint::Kind::current, {}, 1.0}},
      {"url(#gone) blue", color(0, 0, 255)},
      {"url(#gone)", color(0, 0, 0)},
      // What is not valid does not count.
      {"#12", {Paint::Kind::automatic, {}, 1.0}},
      {"#ggg", {Paint::Kind::automatic, {}, 1.0}},
      {"rgb(1,2)", {Paint::Kind::automatic, {}, 1.0}},
      {"nonsense", {Paint::Kind::automatic, {}, 1.0}},
      {"", {Paint::Kind::automatic, {}, 1.0}},
  };
  for (const auto& [text, paint] : paints) {
    const Style style = style_of("", std::string("<path fill='") + text + "' d='M1 1H9V9H1Z'/>");
    EXPECT_EQ(style.fill.kind, paint.kind) << text;
    EXPECT_NEAR(style.fill.opacity, paint.opacity, 1e-12) << text;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(style.fill.rgb[k], paint.rgb[k], 1e-9) << text;
  }
}

TEST(SvgStyles, ColorAndOpacityAreAppliedOnTheWayDown) {
  EXPECT_EQ(style_of("color='lime'", "<g fill='currentColor'><path color='blue' d='M1 1H9V9H1Z'/></g>").fill,
            color(0, 0, 255));
  const Style style =
      style_of("opacity='0.5'", "<g opacity='50%' style='fill-opacity:.5; stroke: red'>" + kPath + "</g>");
  EXPECT_EQ(style.fill.opacity, 0.125);
  EXPECT_EQ(style.stroke.opacity, 0.25);
  // What cannot be seen is not painted; nor is a line without width.
  EXPECT_EQ(style_of("fill-opacity='0' stroke='red'", kPath).fill, Paint{});
  EXPECT_EQ(style_of("stroke='red' stroke-width='0'", kPath).stroke, Paint{});
}

TEST(SvgStyles, StyleSheetsAndAttributesCount) {
  EXPECT_EQ(
      style_of("", "<style>.a { stroke: red; stroke-width: 3px }</style><path class='a' d='M1 1H9V9H1Z'/>")
          .stroke_width,
      3.0);
  EXPECT_EQ(style_of("stroke='red' stroke-width='5'", "<path style='stroke-width:1' d='M1 1H9V9H1Z'/>")
                .stroke_width,
            1.0);
}

TEST(SvgStyles, WidthsAreInTheUnitsOfTheDrawing) {
  const std::string stroked = "<path stroke='red' stroke-width='2' d='M1 1H9V9H1Z'/>";
  EXPECT_NEAR(style_of("", "<g transform='rotate(30) scale(3)'>" + stroked + "</g>").stroke_width, 6.0,
              1e-12);
  EXPECT_NEAR(style_of("", "<g transform='scale(4 1)'>" + stroked + "</g>").stroke_width, 4.0, 1e-12);
  EXPECT_NEAR(
      style_of("viewBox='0 0 30 40'", "<path stroke='red' stroke-width='10%' d='M1 1H9'/>").stroke_width,
      0.1 * 25.0 * std::sqrt(2.0), 1e-9);
}

TEST(SvgStyles, GradientsGiveTheirFirstColor) {
  const std::string defs =
      "<defs><linearGradient id='a'><stop stop-color='#00ff00'/><stop stop-color='red'/></linearGradient>"
      "<linearGradient id='b' href='#a'/><linearGradient id='c' href='#c'/></defs>";
  for (const char* id : {"a", "b"}) {
    EXPECT_EQ(style_of("", defs + "<path fill='url(#" + id + ")' d='M1 1H9V9H1Z'/>").fill, color(0, 255, 0))
        << id;
  }
  EXPECT_EQ(style_of("", defs + "<path fill='url(#c)' d='M1 1H9V9H1Z'/>").fill, color(0, 0, 0));
}

TEST(Drawings, TakeTheStyleOfTheLargestArea) {
  const Drawing drawing =
      drawing_of("viewBox='0 0 24 24'",
                 "<path fill='red' d='M0 0H2V2H0Z'/><path fill='blue' d='M0 0H1V9H0Z'/>"
                 "<path fill='red' d='M3 3H6V6H3Z'/><path fill='none' stroke='lime' d='M0 0H5'/>");
  EXPECT_TRUE(drawing.several_styles);
  EXPECT_EQ(drawing.style->fill, color(255, 0, 0));  // 13 against 9 and 5
  EXPECT_EQ(drawing.shape.contours.size(), 4u);
  EXPECT_EQ(drawing.view_box, (ViewBox{0, 0, 24, 24}));
  EXPECT_FALSE(drawing_of("", kPath + kPath).several_styles);
}

TEST(Drawings, HaveTheViewBoxOfTheirFile) {
  EXPECT_EQ(drawing_of("width='20' height='10px'", kPath).view_box, (ViewBox{0, 0, 20, 10}));
  EXPECT_FALSE(drawing_of("", kPath).view_box);
  EXPECT_FALSE(drawing_of("viewBox='0 0 0 9'", kPath).view_box);
  const std::string sprite = wrapped("", "<symbol id='s' viewBox='-1 -1 7 8'>" + kPath + "</symbol>");
  EXPECT_EQ(merge(read_svg_part(sprite, "s", "svg")).view_box, (ViewBox{-1, -1, 7, 8}));
  // Lines without a stroke are drawn for want of anything else, but have no style.
  EXPECT_FALSE(drawing_of("", "<line x2='9' y2='9'/>").style);
  EXPECT_FALSE(load_drawing("M0 0H9V9Z").style);
}

TEST(Looks, JoinViewBoxesAndFillGaps) {
  const Drawing a = drawing_of("viewBox='0 0 24 24' fill='red'", kPath);
  const Drawing b = drawing_of("viewBox='-2 0 30 20' fill='blue'", kPath);
  const Drawing plain = load_drawing("M0 0H40V9Z");
  EXPECT_EQ(look_of(std::vector{a, a}).view_box, (ViewBox{0, 0, 24, 24}));
  EXPECT_EQ(look_of(std::vector{a, b}).view_box, (ViewBox{-2, 0, 30, 24}));
  EXPECT_EQ(look_of(std::vector{a, plain}).view_box, (ViewBox{0, 0, 40, 24}));
  const Look look = look_of(std::vector{plain, a, plain, b});
  ASSERT_EQ(look.styles.size(), 4u);
  EXPECT_EQ(look.styles[0], *a.style);
  EXPECT_EQ(look.styles[2], *a.style);
  EXPECT_EQ(look.styles[3], *b.style);
  const Look none = look_of(std::vector{plain, plain});
  EXPECT_TRUE(none.styles.empty());
  EXPECT_FALSE(none.view_box);
}

Style outline(double width) {
  Style style;
  style.fill = Paint{};
  style.stroke = Paint{Paint::Kind::current, {}, 1.0};
  style.stroke_width = width;
  style.line_cap = LineCap::round;
  return style;
}

std::vector<Layer> layers(const PathMorph& morph, const std::vector<Style>& styles) {
  return layers_of(morph, {styles, {}}, {0, 0, 10, 10}, ink_paint());
}

TEST(Layers, FillsFadeAndLinesThin) {
  const PathMorph morph = test::box_to_disc();
  Style filled;
  filled.fill = color(200, 100, 0);
  const std::vector<Layer> drawn = layers(morph, {outline(2.0), filled});
  ASSERT_EQ(drawn.size(), 1u);
  const Style half = style_at(drawn[0], morph.key_times(), 0.25);
  EXPECT_EQ(half.fill, color(200, 100, 0, 0.25));
  EXPECT_EQ(half.stroke, (Paint{Paint::Kind::current, {}, 1.0}));
  EXPECT_EQ(half.stroke_width, 1.5);
  EXPECT_EQ(half.line_cap, LineCap::round);
  Style blue;
  blue.fill = color(0, 0, 200, 0.5);
  EXPECT_EQ(style_at(layers(morph, {filled, blue})[0], morph.key_times(), 0.5).fill,
            color(100, 50, 100, 0.75));
  EXPECT_EQ(style_at(layers(morph, {filled, blue})[0], morph.key_times(), 1.5).fill, blue.fill);
  EXPECT_THROW((void)layers(morph, {filled}), InvalidArgument);
}

// A closed contour that is born from a point would draw a dot there as wide as the line.
TEST(Layers, LinesOfWhatIsBornStartThin) {
  const PathMorph morph = test::morph_of({"M0 0H20V20H0Z", "M0 0H20V20H0ZM30 0H40V10H30Z"});
  ASSERT_EQ(morph.contours().size(), 2u);
  const std::vector<Layer> drawn = layers(morph, {outline(2.0), outline(2.0)});
  ASSERT_EQ(drawn.size(), 2u);
  EXPECT_EQ(drawn[0].name, "stroked");
  EXPECT_EQ(drawn[1].name, "growing");
  EXPECT_EQ(drawn[1].contours, (std::vector<std::size_t>{1}));
  EXPECT_EQ(style_at(drawn[0], morph.key_times(), 0.0).stroke_width, 2.0);
  EXPECT_EQ(style_at(drawn[1], morph.key_times(), 0.0).stroke_width, 0.0);
  EXPECT_EQ(style_at(drawn[1], morph.key_times(), 0.5).stroke_width, 1.0);
  // What is filled is one path, lest holes fill.
  Style both = outline(2.0);
  both.fill = color(1, 2, 3);
  const std::vector<Layer> three = layers(morph, {both, both});
  ASSERT_EQ(three.size(), 3u);
  EXPECT_EQ(three[0].contours.size(), 2u);
  EXPECT_FALSE(three[0].strokes());
  EXPECT_FALSE(three[2].fills());
}

}  // namespace
}  // namespace tandem
