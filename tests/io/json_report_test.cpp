#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tandem/io/json.h"
#include "tandem/version.h"

namespace {

using nlohmann::ordered_json;
using tandem::Curve;
using tandem::Points;

tandem::Match example() {
  const Curve curve = Curve::bezier(Points({{0, 0}, {1, 2}, {3, 0.1}}));
  const Curve v = Curve::clamped_uniform(1, Points({{0}, {0.4}, {1}}));
  tandem::Correspondence correspondence;
  correspondence.points = {{0, 0}, {0.5, 0.4}, {1, 1}};
  tandem::MatchReport report;
  report.method = tandem::Method::paper;
  report.norm = "tangent";
  report.sampling = tandem::Sampling::parameter;
  report.samples = {3, 4};
  report.cost = 12.5;
  report.mean_cost = 0.25;
  report.invalid_nodes = 2;
  report.invalid_length = 0.125;
  report.validity = {true, 0.31, 0.9, 1.0, 0.5};
  report.direction = tandem::Direction::reversed;
  report.shift = 7;
  report.path = {{0, 0}, {1, 2}, {2, 3}};
  report.seconds = {0.001, 0.002, 0.003, 0.004};
  return {correspondence, {v, 0.004, true}, curve, report, {}, {}};
}

TEST(JsonReport, HasTheFieldsInOrder) {
  const ordered_json report = ordered_json::parse(tandem::format_json_report(example()));
  std::vector<std::string> keys;
  for (const auto& [key, value] : report.items()) keys.push_back(key);
  EXPECT_EQ(keys, (std::vector<std::string>{
                      "tandem",   "method",    "norm",           "samples",           "sampling",
                      "cost",     "mean_cost", "exact",          "invalid_nodes",     "invalid_length",
                      "valid",    "min_dot",   "valid_share",    "direction",         "shift",
                      "rotation", "path",      "correspondence", "reparametrization", "curve",
                      "seconds"}));
}

TEST(JsonReport, SaysWhatWasFound) {
  const ordered_json report = ordered_json::parse(tandem::format_json_report(example()));
  EXPECT_EQ(report["tandem"], std::string(tandem::version()));
  EXPECT_EQ(report["method"], "paper");
  EXPECT_EQ(report["norm"], "tangent");
  EXPECT_EQ(report["samples"], ordered_json({3, 4}));
  EXPECT_EQ(report["sampling"], "parameter");
  EXPECT_EQ(report["cost"], 12.5);
  EXPECT_EQ(report["mean_cost"], 0.25);
  EXPECT_EQ(report["exact"], true);
  EXPECT_EQ(report["invalid_nodes"], 2);
  EXPECT_EQ(report["invalid_length"], 0.125);
  EXPECT_EQ(report["valid"], true);
  EXPECT_EQ(report["min_dot"], 0.31);
  EXPECT_EQ(report["valid_share"], 1.0);
  EXPECT_EQ(report["direction"], "reversed");
  EXPECT_EQ(report["shift"], 7);
  EXPECT_EQ(report["rotation"], ordered_json({1.0, 0.0}));
  EXPECT_EQ(report["path"], ordered_json::parse("[[0,0],[1,2],[2,3]]"));
  EXPECT_EQ(report["correspondence"], ordered_json::parse("[[0,0],[0.5,0.4],[1,1]]"));
  EXPECT_EQ(
      report["reparametrization"],
      ordered_json::parse(
          R"({"degree": 1, "knots": [0,0,0.5,1,1], "points": [[0],[0.4],[1]], "max_deviation": 0.004})"));
  EXPECT_EQ(report["seconds"],
            ordered_json::parse(R"({"sample": 0.001, "match": 0.002, "fit": 0.003, "compose": 0.004})"));
  EXPECT_EQ(tandem::parse_json_curves(report["curve"].dump()), std::vector<Curve>{example().curve});
}

TEST(JsonReport, WritesRotationsByDimension) {
  const auto rotation = [](tandem::Match match) {
    return ordered_json::parse(tandem::format_json_report(match))["rotation"];
  };
  tandem::Match match = example();
  match.report.rotation = {0.6, 0.8};
  EXPECT_EQ(rotation(match), ordered_json({0.6, 0.8}));
  match.curve = Curve::bezier(Points({{0, 0, 0}, {1, 1, 1}}));
  match.report.rotation.clear();
  EXPECT_EQ(rotation(match), ordered_json::parse("[[1,0,0],[0,1,0],[0,0,1]]"));
  match.report.rotation = {0, 1, 0, -1, 0, 0, 0, 0, 1};
  EXPECT_EQ(rotation(match), ordered_json::parse("[[0,1,0],[-1,0,0],[0,0,1]]"));
}

TEST(JsonReport, HasNullWhereThereIsNoNumber) {
  tandem::Match match = example();
  match.report.validity.min_dot = std::numeric_limits<double>::quiet_NaN();
  match.report.cost = std::numeric_limits<double>::infinity();
  const ordered_json report = ordered_json::parse(tandem::format_json_report(match));
  EXPECT_TRUE(report["min_dot"].is_null());
  EXPECT_TRUE(report["cost"].is_null());
}

}  // namespace
