#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <set>
#include <string>
#include <vector>

#include "io/morphs.h"
#include "io/svg_parts.h"
#include "tandem/error.h"
#include "tandem/io/path_data.h"
#include "tandem/io/svg.h"
#include "tandem/shape/path_builder.h"
#include "tandem/shape/transform.h"

namespace tandem {
namespace {

Shape outline(double size) {
  PathBuilder builder;
  builder.move_to({0, 0});
  builder.line_to({size, 0});
  builder.cubic_to({size, size / 2}, {size / 2, size}, {0, size});
  builder.close();
  builder.move_to({size, size});
  builder.quad_to({1.2 * size, 1.5 * size}, {1.5 * size, size});
  const std::vector<CubicPath> paths = builder.take();
  return to_shape(paths, FillRule::evenodd);
}

PathMorph some_morph(std::size_t key_count = 2) {
  std::vector<Shape> keys;
  for (std::size_t i = 0; i < key_count; ++i) keys.push_back(outline(10.0 + 5.0 * static_cast<double>(i)));
  MorphOptions options;
  options.match.samples = {24, 24};  // how good the match is does not matter here
  return test::path_morph(keys, options);
}

pugi::xml_document parsed(const std::string& text) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size(), pugi::parse_full);
  EXPECT_TRUE(result) << result.description() << " at " << result.offset << " of\n" << text;
  return document;
}

pugi::xml_node moving(const pugi::xml_document& document) {
  return document.child("svg").child("g");
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t at = 0;
  for (std::size_t next; (next = text.find(separator, at)) != std::string::npos; at = next + 1) {
    parts.push_back(text.substr(at, next - at));
  }
  parts.push_back(text.substr(at));
  return parts;
}

std::string commands(const std::string& d) {
  std::string letters;
  for (char c : d) {
    if (std::isalpha(static_cast<unsigned char>(c)) && c != 'e') letters += c;
  }
  return letters;
}

TEST(SvgParts, ViewsHaveAMarginAndAreNeverEmpty) {
  Box box;
  box.include(std::vector<double>{0, 0});
  box.include(std::vector<double>{100, 50});
  const View view = view_of(box);
  EXPECT_EQ(view.x, -5);
  EXPECT_EQ(view.y, -5);
  EXPECT_EQ(view.width, 110);
  EXPECT_EQ(view.height, 60);
  EXPECT_EQ(view_of(Box{}).width, 1);
  Box point;
  point.include(std::vector<double>{3, 3});
  EXPECT_EQ(view_of(point).width, 1);
  EXPECT_EQ(view_of(point).x, 2.5);
}

TEST(SvgParts, DecimalsFollowTheSize) {
  EXPECT_EQ(decimals_for(1.0), 5);
  EXPECT_EQ(decimals_for(24.0), 4);
  EXPECT_EQ(decimals_for(1000.0), 2);
  EXPECT_EQ(decimals_for(1e9), 0);
  EXPECT_EQ(decimals_for(1e300), 0);
  EXPECT_EQ(decimals_for(1e-300), -1);
  EXPECT_EQ(decimals_for(0.0), -1);
}

TEST(SvgWriter, FillsWhatIsClosedAndStrokesTheRest) {
  const pugi::xml_document document = parsed(format_svg(outline(10)));
  const pugi::xml_node svg = document.child("svg");
  EXPECT_STREQ(svg.attribute("xmlns").value(), "http://www.w3.org/2000/svg");
  std::vector<pugi::xml_node> paths;
  for (const pugi::xml_node& path : svg.children("path")) paths.push_back(path);
  ASSERT_EQ(paths.size(), 2u);
  EXPECT_STREQ(paths[0].attribute("fill-rule").value(), "evenodd");
  EXPECT_STREQ(paths[0].attribute("d").value(), "M0 0L10 0C10 5 5 10 0 10L0 0Z");
  EXPECT_STREQ(paths[1].attribute("fill").value(), "none");
  EXPECT_EQ(commands(paths[1].attribute("d").value()), "MC");
}

TEST(SvgWriter, ReadsBackEqual) {
  const Shape shape = outline(10);
  const std::vector<SvgElement> elements = parse_svg(format_svg(shape));
  ASSERT_EQ(elements.size(), 2u);
  ASSERT_EQ(elements[0].shape.contours.size(), 1u);
  EXPECT_EQ(elements[0].shape.contours[0], shape.contours[0]);
  EXPECT_EQ(elements[0].shape.fill_rule, FillRule::evenodd);
  ASSERT_EQ(elements[1].shape.contours.size(), 1u);
  EXPECT_EQ(elements[1].shape.contours[0], shape.contours[1]);
}

TEST(SvgWriter, WantsThePlane) {
  EXPECT_THROW((void)format_svg(Shape{{Curve::bezier(Points({{0, 0, 0}, {1, 1, 1}}))}}), InvalidArgument);
  EXPECT_TRUE(parsed(format_svg(Shape{})).child("svg"));
}

TEST(SvgWriter, FramesShareTheirViewBox) {
  const PathMorph morph = some_morph();
  std::set<std::string> boxes;
  std::set<std::string> structures;
  for (const double s : {0.0, 0.25, 0.5, 1.0}) {
    const pugi::xml_document document = parsed(format_frame_svg(morph, s));
    boxes.insert(document.child("svg").attribute("viewBox").value());
    structures.insert(commands(document.child("svg").child("path").attribute("d").value()));
  }
  EXPECT_EQ(boxes.size(), 1u);
  EXPECT_EQ(structures.size(), 1u);
  // Beyond the keys the frame grows rather than cutting the shape off.
  const pugi::xml_document beyond = parsed(format_frame_svg(morph, 2.0));
  EXPECT_EQ(boxes.count(beyond.child("svg").attribute("viewBox").value()), 0u);
}

TEST(AnimatedSvg, LoopsThroughTheKeysAndBack) {
  const PathMorph morph = some_morph(3);
  const pugi::xml_document document = parsed(format_animated_svg(morph, {.duration = 3.0}));
  const pugi::xml_node path = moving(document).child("path");
  const pugi::xml_node animate = path.child("animate");
  EXPECT_STREQ(animate.attribute("attributeName").value(), "d");
  EXPECT_STREQ(animate.attribute("dur").value(), "6s");
  EXPECT_STREQ(animate.attribute("repeatCount").value(), "indefinite");
  EXPECT_STREQ(animate.attribute("keyTimes").value(), "0;0.25;0.5;0.75;1");
  EXPECT_STREQ(animate.attribute("calcMode").value(), "linear");
  const std::vector<std::string> values = split(animate.attribute("values").value(), ';');
  ASSERT_EQ(values.size(), 5u);
  EXPECT_EQ(values[0], path.attribute("d").value());
  EXPECT_EQ(values[0], values[4]);
  EXPECT_EQ(values[1], values[3]);
  EXPECT_NE(values[0], values[2]);
  for (const std::string& value : values) EXPECT_EQ(commands(value), commands(values[0]));
  // The open contour is animated beside it.
  EXPECT_TRUE(path.next_sibling("path").child("animate"));
}

TEST(AnimatedSvg, EasesFromKeyToKey) {
  const PathMorph morph = some_morph();
  const pugi::xml_document there =
      parsed(format_animated_svg(morph, {.duration = 1.0, .easing = "ease-in", .alternate = false}));
  const pugi::xml_node animate = moving(there).child("path").child("animate");
  EXPECT_STREQ(animate.attribute("calcMode").value(), "spline");
  EXPECT_STREQ(animate.attribute("keySplines").value(), "0.42 0 1 1");
  const pugi::xml_document back =
      parsed(format_animated_svg(morph, {.duration = 1.0, .easing = "0.1 0.2 0.5 1"}));
  EXPECT_STREQ(moving(back).child("path").child("animate").attribute("keySplines").value(),
               "0.1 0.2 0.5 1;0.5 0 0.9 0.8");
}

// The browser turns the frame: groups that are moved and turned, with the keys inside as the frame sees them.
TEST(AnimatedSvg, TurnsTheFrame) {
  Shape turned = outline(10.0);
  for (Curve& curve : turned.contours) curve = transform(curve, Transform::rotate_degrees(60.0));
  const std::vector<Shape> keys{outline(10.0), turned};
  const PathMorph morph = test::path_morph(keys);
  ASSERT_TRUE(morph.turns());
  const pugi::xml_document document =
      parsed(format_animated_svg(morph, {.duration = 1.0, .alternate = false}));
  const pugi::xml_node moved = moving(document).child("g");
  const pugi::xml_node rotated = moved.child("g");
  const pugi::xml_node path = rotated.child("path");
  EXPECT_STREQ(moved.child("animateTransform").attribute("type").value(), "translate");
  EXPECT_STREQ(rotated.child("animateTransform").attribute("type").value(), "rotate");
  EXPECT_STREQ(rotated.child("animateTransform").attribute("values").value(), "0;60");
  for (const pugi::xml_node group : {moved, rotated}) {
    EXPECT_STREQ(group.child("animateTransform").attribute("keyTimes").value(), "0;1");
  }
  // What a viewer without animation shows is the first key.
  const std::string transforms =
      std::string(moved.attribute("transform").value()) + rotated.attribute("transform").value();
  const std::string still = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 9 9\"><g transform=\"" +
                            std::string(moved.attribute("transform").value()) + "\"><path d=\"" +
                            path.attribute("d").value() + "\"/></g></svg>";
  const Box drawn = bounding_box(parse_svg(still).front().shape);
  const Box wanted = bounding_box(keys[0].contours[0]);
  EXPECT_NE(transforms.find("rotate(0)"), std::string::npos);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(drawn.lo[k], wanted.lo[k], 1e-3);
    EXPECT_NEAR(drawn.hi[k], wanted.hi[k], 1e-3);
  }
}

TEST(AnimatedSvg, RestsAtTheEndWhereMotionIsUnwanted) {
  const PathMorph morph = some_morph(3);
  const std::string text = format_animated_svg(morph);
  const pugi::xml_document document = parsed(text);
  EXPECT_STREQ(moving(document).attribute("class").value(), "tandem-moving");
  const pugi::xml_node still = moving(document).next_sibling("g");
  EXPECT_STREQ(still.attribute("class").value(), "tandem-still");
  EXPECT_STREQ(still.attribute("display").value(), "none");
  EXPECT_NE(text.find("@media (prefers-reduced-motion: reduce)"), std::string::npos);
  const std::vector<std::string> values =
      split(moving(document).child("path").child("animate").attribute("values").value(), ';');
  EXPECT_EQ(still.child("path").attribute("d").value(), values[2]);
  // Elsewhere it is not there.
  EXPECT_EQ(parse_svg(text).size(), 2u);
}

TEST(AnimatedSvg, PlaysOnceAndStays) {
  const pugi::xml_document document =
      parsed(format_animated_svg(some_morph(), {.alternate = false, .repeat = false}));
  const pugi::xml_node animate = moving(document).child("path").child("animate");
  EXPECT_STREQ(animate.attribute("repeatCount").value(), "1");
  EXPECT_STREQ(animate.attribute("fill").value(), "freeze");
}

TEST(AnimatedSvg, KeepsAsManyDecimalsAsAsked) {
  const pugi::xml_document document = parsed(format_animated_svg(some_morph(), {.precision = 1}));
  const std::string d = moving(document).child("path").child("animate").attribute("values").value();
  EXPECT_NE(d.find('.'), std::string::npos);
  for (std::size_t at = 0; (at = d.find('.', at)) != std::string::npos; ++at) {
    EXPECT_FALSE(std::isdigit(static_cast<unsigned char>(d[at + 2]))) << d;
  }
}

TEST(AnimatedSvg, RejectsNonsense) {
  const PathMorph morph = some_morph();
  EXPECT_THROW((void)format_animated_svg(morph, {.duration = 0.0}), InvalidArgument);
  EXPECT_THROW((void)format_animated_svg(morph, {.easing = "bouncy"}), InvalidArgument);
}

}  // namespace
}  // namespace tandem
