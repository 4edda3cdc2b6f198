#include "tandem/io/animated_vector.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "io/morphs.h"
#include "tandem/error.h"
#include "tandem/io/path_data.h"

namespace tandem {
namespace {

using test::commands;

pugi::xml_document parsed(const std::string& text) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  EXPECT_TRUE(result) << result.description();
  return document;
}

std::vector<pugi::xml_node> all(const pugi::xml_node& node, const std::string& name) {
  std::vector<pugi::xml_node> found;
  for (const pugi::xpath_node& each : node.select_nodes((".//" + name).c_str())) found.push_back(each.node());
  return found;
}

std::string value(const pugi::xml_node& node, const std::string& name) {
  return node.attribute(("android:" + name).c_str()).value();
}

TEST(AnimatedVector, RepeatsSingleAnimators) {
  const pugi::xml_document document = parsed(format_animated_vector(test::box_to_disc(), {.duration = 1.5}));
  const pugi::xml_node root = document.child("animated-vector");
  EXPECT_STREQ(root.attribute("xmlns:aapt").value(), "http://schemas.android.com/aapt");
  const pugi::xml_node vector = root.child("aapt:attr").child("vector");
  EXPECT_EQ(value(vector, "width"), "24dp");
  EXPECT_EQ(value(vector, "viewportWidth"), "22");
  const std::vector<pugi::xml_node> animators = all(document, "objectAnimator");
  ASSERT_EQ(animators.size(), 1u);
  EXPECT_EQ(value(animators[0], "propertyName"), "pathData");
  EXPECT_EQ(value(animators[0], "valueType"), "pathType");
  EXPECT_EQ(value(animators[0], "duration"), "1500");
  EXPECT_EQ(value(animators[0], "repeatCount"), "infinite");
  EXPECT_EQ(value(animators[0], "repeatMode"), "reverse");
  EXPECT_EQ(value(animators[0], "interpolator"), "@android:anim/linear_interpolator");
  EXPECT_EQ(value(all(document, "path")[0], "pathData"), value(animators[0], "valueFrom"));
  EXPECT_EQ(commands(value(animators[0], "valueFrom")), commands(value(animators[0], "valueTo")));
  // The drawing's corner is the viewport's: a margin of one unit, then the shape.
  Box box;
  for (const CubicPath& path : parse_path_data(value(animators[0], "valueTo")))
    box.include(bounding_box(to_curve(path)));
  EXPECT_NEAR(box.lo[0], 1.0, 1e-3);
  EXPECT_NEAR(box.hi[1], 21.0, 1e-3);
  const pugi::xml_document once =
      parsed(format_animated_vector(test::box_to_disc(), {.alternate = false, .repeat = false}));
  EXPECT_FALSE(all(once, "objectAnimator")[0].attribute("android:repeatCount"));
}

TEST(AnimatedVector, RunsThroughSeveralKeysInTurn) {
  const PathMorph morph = test::morph_of({"M0 0H9V9H0Z", "M0 0H5V9H0Z", "M0 0H7V7H0Z"});
  const pugi::xml_document document = parsed(format_animated_vector(morph, {.easing = "ease-in"}));
  const std::vector<pugi::xml_node> animators = all(document, "objectAnimator");
  ASSERT_EQ(animators.size(), 2u);
  EXPECT_EQ(value(animators[0], "startOffset"), "0");
  EXPECT_EQ(value(animators[1], "startOffset"), "1000");
  EXPECT_EQ(value(animators[1], "duration"), "1000");
  EXPECT_EQ(value(animators[0], "valueTo"), value(animators[1], "valueFrom"));
  for (const pugi::xml_node& animator : animators) {
    EXPECT_FALSE(animator.attribute("android:repeatCount"));  // each would repeat by itself
    EXPECT_FALSE(animator.attribute("android:interpolator"));
    const pugi::xml_node curve = animator.child("aapt:attr").child("pathInterpolator");
    EXPECT_EQ(value(curve, "controlX1"), "0.42");
    EXPECT_EQ(value(curve, "controlY2"), "1");
  }
}

TEST(AnimatedVector, TurnsAGroup) {
  const pugi::xml_document document = parsed(format_animated_vector(test::turning()));
  const std::vector<pugi::xml_node> groups = all(document, "group");
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(value(groups[0], "rotation"), "0");
  const std::vector<pugi::xml_node> targets = all(document, "target");
  ASSERT_EQ(targets.size(), 2u);
  EXPECT_EQ(value(targets[0], "name"), "frame");
  const std::vector<pugi::xml_node> animators = all(targets[0], "objectAnimator");
  ASSERT_EQ(animators.size(), 3u);
  EXPECT_EQ(value(animators[2], "propertyName"), "rotation");
  EXPECT_EQ(value(animators[2], "valueTo"), "90");
  EXPECT_EQ(value(targets[1], "name"), "filled");
}

TEST(AnimatedVector, FillsByTheRuleAndStrokesTheRest) {
  const PathMorph holes =
      test::morph_of({"M0 0H20V10H0ZM5 5L8 8V5L5 7Z", "M0 0H20V10H0ZM5 4L9 9V5L5 8Z"}, FillRule::evenodd);
  const pugi::xml_document document = parsed(format_animated_vector(holes));
  EXPECT_EQ(value(all(document, "path")[0], "fillType"), "evenOdd");
  const pugi::xml_document both = parsed(format_animated_vector(test::mixed()));
  const std::vector<pugi::xml_node> paths = all(both, "path");
  ASSERT_EQ(paths.size(), 2u);
  EXPECT_TRUE(paths[1].attribute("android:strokeColor"));
  EXPECT_FALSE(paths[1].attribute("android:fillColor"));
  EXPECT_EQ(all(both, "target").size(), 2u);
}

TEST(AnimatedVector, RejectsNonsense) {
  EXPECT_THROW((void)format_animated_vector(test::box_to_disc(), {.duration = 0.0}), InvalidArgument);
  EXPECT_THROW((void)format_animated_vector(test::box_to_disc(), {.easing = "x"}), InvalidArgument);
}

}  // namespace
}  // namespace tandem
