#include "tandem/io/lottie.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/morphs.h"
#include "tandem/error.h"

namespace tandem {
namespace {

using nlohmann::json;

json lottie(const PathMorph& morph, const AnimationOptions& options = {}) {
  return json::parse(format_lottie(morph, "title", options, 220));
}

// The key frames of every path, group by group.
std::vector<json> paths_of(const json& document) {
  std::vector<json> paths;
  for (const json& group : document["layers"][0]["shapes"]) {
    for (const json& item : group["it"]) {
      if (item["ty"] == "sh") paths.push_back(item["ks"]["k"]);
    }
  }
  return paths;
}

// What players rely on: times that ascend from the first frame to the last, one set of vertices.
void expect_sound(const json& document) {
  EXPECT_EQ(document["ip"], 0);
  EXPECT_EQ(document["layers"][0]["op"], document["op"]);
  for (const json& keys : paths_of(document)) {
    EXPECT_EQ(keys.front()["t"], 0);
    EXPECT_EQ(keys.back()["t"], document["op"]);
    double before = -1.0;
    for (const json& key : keys) {
      EXPECT_GT(key["t"].get<double>(), before);
      before = key["t"];
      EXPECT_EQ(key.contains("i"), &key != &keys.back());
      const json& shape = key["s"][0];
      const json& first = keys.front()["s"][0];
      EXPECT_EQ(shape["c"], first["c"]);
      for (const char* part : {"v", "i", "o"}) EXPECT_EQ(shape[part].size(), first["v"].size()) << part;
      EXPECT_GE(shape["v"].size(), 2u);
    }
  }
}

TEST(Lottie, HasOnePathPerContourAndFillsByTheRule) {
  const json document = lottie(
      test::morph_of({"M0 0H20V10H0ZM5 5L8 8V5L5 7Z", "M0 0H20V10H0ZM5 4L9 9V5L5 8Z"}, FillRule::evenodd));
  expect_sound(document);
  EXPECT_EQ(document["w"], 220);
  EXPECT_EQ(document["h"], 120);
  EXPECT_EQ(document["fr"], 60);
  EXPECT_EQ(document["op"], 240);  // 2 s there, 2 s back
  EXPECT_EQ(document["nm"], "title");
  ASSERT_EQ(document["layers"][0]["shapes"].size(), 1u);
  const json& items = document["layers"][0]["shapes"][0]["it"];
  ASSERT_EQ(items.size(), 4u);
  EXPECT_EQ(items[2]["ty"], "fl");
  EXPECT_EQ(items[2]["r"], 2);
  EXPECT_EQ(items[3]["ty"], "tr");
  EXPECT_EQ(lottie(test::box_to_disc())["layers"][0]["shapes"][0]["it"][1]["r"], 1);
}

TEST(Lottie, HoldsThePointsOfTheKeys) {
  const PathMorph morph = test::box_to_disc();
  const json document = lottie(morph, {.duration = 1.0});
  expect_sound(document);
  const std::vector<json> paths = paths_of(document);
  ASSERT_EQ(paths.size(), 1u);
  ASSERT_EQ(paths[0].size(), 3u);
  EXPECT_EQ(paths[0][0]["s"], paths[0][2]["s"]);
  EXPECT_EQ(paths[0][1]["t"], 60);
  // 20 units and a margin of 1 on both sides make 220 pixels.
  for (std::size_t key = 0; key < 2; ++key) {
    const Points& points = morph.contours()[0].keys[key].control_points();
    const json& shape = paths[0][key]["s"][0];
    ASSERT_EQ(shape["v"].size(), morph.contours()[0].lines.size());
    for (std::size_t i = 0; i < shape["v"].size(); ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        const double vertex = shape["v"][i][k];
        EXPECT_NEAR(vertex, 10 * points[3 * i][k] + 10, 2e-3);
        if (morph.contours()[0].lines[i]) {
          EXPECT_EQ(shape["o"][i][k], 0);
        } else {
          EXPECT_NEAR(vertex + shape["o"][i][k].get<double>(), 10 * points[3 * i + 1][k] + 10, 3e-3);
          const std::size_t next = (i + 1) % shape["v"].size();
          EXPECT_NEAR(shape["v"][next][k].get<double>() + shape["i"][next][k].get<double>(),
                      10 * points[3 * i + 2][k] + 10, 3e-3);
        }
      }
    }
  }
}

TEST(Lottie, StrokesOpenContours) {
  const json document = lottie(test::mixed(), {.alternate = false});
  expect_sound(document);
  EXPECT_EQ(document["op"], 120);
  const json& groups = document["layers"][0]["shapes"];
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0]["it"][1]["ty"], "st");
  EXPECT_EQ(groups[0]["it"][0]["ks"]["k"][0]["s"][0]["c"], false);
  EXPECT_EQ(groups[1]["it"][0]["ks"]["k"][0]["s"][0]["c"], true);
}

TEST(Lottie, TurnsTheLayer) {
  const json document = lottie(test::turning(), {.easing = "0.1 0.2 0.5 1"});
  expect_sound(document);
  const json& keys = document["layers"][0]["ks"]["r"]["k"];
  ASSERT_EQ(keys.size(), 3u);
  EXPECT_EQ(keys[0]["s"][0], 0);
  EXPECT_EQ(keys[1]["s"][0], 90);
  EXPECT_EQ(keys[0]["o"], json({{"x", {0.1}}, {"y", {0.2}}}));
  EXPECT_EQ(keys[0]["i"], json({{"x", {0.5}}, {"y", {1}}}));
  EXPECT_EQ(keys[1]["o"], json({{"x", {0.5}}, {"y", {0}}}));
  EXPECT_EQ(document["layers"][0]["ks"]["p"]["k"].size(), 3u);
}

TEST(Lottie, GivesLoopsASecondVertex) {
  const PathMorph morph = test::morph_of({"M0 0C9 9 -9 9 0 0Z", "M0 0C9 9 -9 9 0 0Z"});
  // Where the match leaves one segment, there would be one vertex.
  expect_sound(lottie(morph));
}

TEST(Lottie, EscapesTheTitle) {
  const json document = json::parse(format_lottie(test::box_to_disc(), "a \"b\"\n\xff", {}, 100));
  EXPECT_EQ(document["nm"], "a \"b\"\n\xef\xbf\xbd");
}

TEST(Lottie, RejectsNonsense) {
  const PathMorph morph = test::box_to_disc();
  EXPECT_THROW((void)format_lottie(morph, "", {.duration = -1.0}), InvalidArgument);
  EXPECT_THROW((void)format_lottie(morph, "", {.easing = "x"}), InvalidArgument);
  EXPECT_THROW((void)format_lottie(morph, "", {}, 0), InvalidArgument);
  EXPECT_THROW((void)format_lottie(morph, "", {}, 10'000), InvalidArgument);
}

}  // namespace
}  // namespace tandem
