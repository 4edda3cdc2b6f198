#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "io/paths.h"
#include "tandem/io/json.h"
#include "tandem/shape/cubic_path.h"

namespace {

using tandem::Curve;
using tandem::format_json_curves;
using tandem::parse_json_curves;
using tandem::Points;
using tandem::test::BadInput;

Curve parse_one(const std::string& text) {
  const std::vector<Curve> curves = parse_json_curves(text);
  EXPECT_EQ(curves.size(), 1U);
  return curves.at(0);
}

TEST(JsonReader, ReadsBsplines) {
  const Curve curve = parse_one(R"({"type": "bspline", "degree": 2, "knots": [0, 0, 0, 0.25, 1, 1, 1],
      "points": [[0, 0, 1], [1, 2, 3], [3, 2, 1], [4, 0, -1e-3]], "weights": [1, 2, 0.5, 1], "note": {"x": []}})");
  EXPECT_EQ(curve, Curve(2, {0, 0, 0, 0.25, 1, 1, 1},
                         Points({{0, 0, 1}, {1, 2, 3}, {3, 2, 1}, {4, 0, -1e-3}}), {1, 2, 0.5, 1}));
}

TEST(JsonReader, FillsInWhatIsLeftOut) {
  const Points points({{0, 0}, {1, 2}, {3, 2}, {4, 0}, {5, 5}});
  const std::string body = R"("degree": 3, "points": [[0,0],[1,2],[3,2],[4,0],[5,5]])";
  const Curve expected = Curve::clamped_uniform(3, points);
  EXPECT_EQ(parse_one("{" + body + "}"), expected);
  EXPECT_EQ(parse_one(R"({"type": "bspline", )" + body + "}"), expected);
  EXPECT_EQ(parse_one("{" + body + R"(, "knots": null, "weights": null, "periodic": false})"), expected);
  EXPECT_EQ(parse_one(R"({"degree": 1, "points": [0, 1.5, 3]})"),
            Curve::clamped_uniform(1, Points({{0}, {1.5}, {3}})));
}

TEST(JsonReader, ReadsPeriodicCurves) {
  const Curve curve =
      parse_one(R"({"degree": 2, "points": [[0,0],[1,0],[1,1],[0,1],[0,0],[1,0]], "periodic": true})");
  EXPECT_TRUE(curve.is_periodic());
  EXPECT_TRUE(curve.is_closed());
  EXPECT_EQ(curve.domain(), (tandem::Interval{0.0, 1.0}));
  EXPECT_EQ(parse_one(format_json_curves(std::vector<Curve>{curve})), curve);
}

TEST(JsonReader, ReadsBezierPaths) {
  const Points open({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 2, 0}, {2, 3, 0}, {1, 3, 0}, {0, 2, 9}});
  EXPECT_EQ(parse_one(R"({"type": "bezier_path",
      "points": [[0,0,0],[1,0,0],[2,1,0],[2,2,0],[2,3,0],[1,3,0],[0,2,9]]})"),
            to_curve(tandem::CubicPath(open)));
  // Ends that meet but for rounding are made one point.
  const Curve closed = parse_one(R"({"type": "bezier_path", "closed": true,
      "points": [[0,0],[1,0],[2,1],[2,2],[2,3],[1,3],[1e-12,-1e-12]]})");
  EXPECT_TRUE(closed.is_closed());
  EXPECT_EQ(closed.control_points().back()[0], 0.0);
  EXPECT_EQ(closed.control_points().back()[1], 0.0);
}

TEST(JsonReader, ReadsOneCurveArraysAndLists) {
  const std::string line = R"({"degree": 1, "points": [[0],[1]]})";
  EXPECT_EQ(parse_json_curves(line).size(), 1U);
  EXPECT_EQ(parse_json_curves("[" + line + "," + line + "]").size(), 2U);
  EXPECT_EQ(parse_json_curves(R"({"note": "x", "curves": [)" + line + "]}").size(), 1U);
  EXPECT_EQ(parse_json_curves("\xEF\xBB\xBF \n" + line).size(), 1U);
}

const BadInput kBad[] = {
    // syntax
    {"", 1, 1, "unexpected end of input"},
    {"   ", 1, 4, "unexpected end of input"},
    {"{", 1, 2, "unexpected end of input"},
    {"[{\"degree\": 1, \"points\": [[0],[1]]}", 1, 36, "unexpected end of input"},
    {"{\n  \"degree\": 3,\n  \"points\": [[0,0],,[1,2]]}", 3, 20, "unexpected ','"},
    {"{\"degree\": NaN}", 1, 12, "invalid literal"},
    {"{\"degree\": 1, \"points\": [[0],[Infinity]]}", 1, 31, "invalid literal"},
    {"{\"degree\": 1, \"points\": [[0],[1]]} x", 1, 36, "expected end of input"},
    {"{\"degree\": 1, \"points\": [[0],[1e999]]}", 1, 31, "number overflow"},
    {"{\"\xFF\": 1}", 1, 3, "ill-formed UTF-8"},
    {std::string(100, '['), 1, 65, "nested more than 64 levels"},
    // meaning
    {"3", 1, 1, "expected a curve, an array of curves"},
    {"{}", 1, 1, "expected a curve, an array of curves"},
    {"[]", 1, 1, "there is no curve in the list"},
    {"{\"curves\": 3}", 1, 12, "\"curves\": expected an array, found a number"},
    {"{\"curves\": []}", 1, 12, "there is no curve in the list"},
    {"[1]", 1, 2, "curve 0: expected an object, found a number"},
    {"[{\"degree\":1,\"points\":[[0],[1]]},\n {\"points\":[[0],[1]]}]", 2, 2,
     "curve 1: has neither \"type\" nor \"degree\""},
    {"{\"type\": 3}", 1, 10, "curve 0: \"type\": expected a string, found a number"},
    {"{\"type\": \"bspline_surface\"}", 1, 1, "curve 0: is a surface"},
    {"{\"type\": \"circle\"}", 1, 1, "unknown type \"circle\"; expected \"bspline\" or \"bezier_path\""},
    {"{\"type\": \"bspline\"}", 1, 1, "\"degree\" is missing"},
    {"{\"degree\": 2}", 1, 1, "\"points\" is missing"},
    {"{\"degree\": \"2\"}", 1, 12, "\"degree\": expected a number, found a string"},
    {"{\"degree\": 0, \"points\": [[0],[1]]}", 1, 12,
     "\"degree\" is 0, expected a whole number from 1 to 1000"},
    {"{\"degree\": -1, \"points\": [[0],[1]]}", 1, 12, "\"degree\" is -1, expected"},
    {"{\"degree\": 1.5, \"points\": [[0],[1]]}", 1, 12, "\"degree\" is 1.5, expected"},
    {"{\"degree\": 1e18, \"points\": [[0],[1]]}", 1, 12, "\"degree\" is 1e+18, expected"},
    {"{\"degree\": 1, \"points\": []}", 1, 25, "\"points\" is empty"},
    {"{\"degree\": 1, \"points\": {}}", 1, 25, "\"points\": expected an array, found an object"},
    {"{\"degree\": 1, \"points\": [[]]}", 1, 26, "point 0 has no coordinates"},
    {"{\"degree\": 1, \"points\": [[0,1],\n[1]]}", 2, 1, "point 1 has 1 coordinates, point 0 has 2"},
    {"{\"degree\": 1, \"points\": [[0,1],[1,null]]}", 1, 35,
     "a coordinate of point 1: expected a number, found null"},
    {"{\"degree\": 1, \"points\": [[0],[-1e301]]}", 1, 31, "a coordinate of point 1 is -1e+301, beyond"},
    {"{\"degree\": 1, \"points\": [[0],[1]], \"knots\": [0,0,1]}", 1, 1, "curve 0: "},
    {"{\"degree\": 1, \"points\": [[0],[1]], \"knots\": [0,0,1,\"1\"]}", 1, 52,
     "knot 3: expected a number, found a string"},
    {"{\"degree\": 1, \"points\": [[0],[1],[2]], \"knots\": [0,0.5,0.4,1,1]}", 1, 1,
     "knot 2 is 0.4, before knot 1 (0.5)"},
    {"{\"degree\": 1, \"points\": [[0],[1]], \"weights\": [1,0]}", 1, 1, "weight"},
    {"{\"degree\": 1, \"points\": [[0],[1]], \"weights\": [1]}", 1, 1, "weight"},
    {"{\"degree\": 1, \"points\": [[0],[1]], \"weights\": []}", 1, 47, "\"weights\" is empty"},
    {"{\"degree\": 3, \"points\": [[0],[1]]}", 1, 1, "curve 0: "},
    {"{\"degree\": 1, \"points\": [[0],[1]], \"periodic\": 1}", 1, 48,
     "\"periodic\": expected true or false, found a number"},
    {"{\"degree\": 2, \"points\": [[0],[1],[2],[3]], \"periodic\": true}", 1, 1,
     "is not periodic: its last 2 points"},
    {"{\"degree\": 2, \"points\": [[0],[1]], \"periodic\": true}", 1, 1,
     "has 2 points, degree 2 needs at least 3"},
    {"{\"type\": \"bezier_path\", \"points\": [[0],[1],[2],[3],[4]]}", 1, 1,
     "has 5 points, a path of k cubics needs 3 k + 1"},
    {"{\"type\": \"bezier_path\", \"points\": [[0]]}", 1, 1, "has 1 points"},
    {"{\"type\": \"bezier_path\", \"closed\": true, \"points\": [[0],[1],[2],[3]]}", 1, 1,
     "is closed, but its last point is not its first"},
};

TEST(JsonReader, SaysWhatIsWrongAndWhere) {
  for (const BadInput& bad : kBad) {
    tandem::test::expect_refused(bad, [](const std::string& text) { (void)parse_json_curves(text); });
  }
}

/// A double out of any of its bits, but finite and within the readers' range.
double any_double() {
  for (;;) {
    const auto bits = *rc::gen::arbitrary<std::uint64_t>();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::fabs(value) <= 1e300) return *rc::gen::inRange(0, 8) == 0 ? 0.0 * value : value;
  }
}

TEST(JsonWriter, ReadsBackEqualBitForBit) {
  EXPECT_TRUE(rc::check([] {
    std::vector<Curve> curves;
    const int count = *rc::gen::inRange(1, 4);
    for (int c = 0; c < count; ++c) {
      const int degree = *rc::gen::inRange(1, 5);
      const int dim = *rc::gen::inRange(1, 5);
      const int n = degree + 1 + *rc::gen::inRange(0, 6);
      std::vector<double> coordinates;
      for (int i = 0; i < n * dim; ++i) coordinates.push_back(any_double());
      std::vector<double> weights;
      if (*rc::gen::inRange(0, 2) == 0) {
        for (int i = 0; i < n; ++i) weights.push_back(*rc::gen::inRange(1, 100000) / 777.0);
      }
      std::vector<double> knots(static_cast<std::size_t>(degree) + 1, -0.0);
      for (int i = degree + 1; i < n; ++i) knots.push_back(knots.back() + *rc::gen::inRange(1, 1000) / 777.0);
      knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, knots.back() + 0.1);
      curves.emplace_back(degree, knots, Points(dim, coordinates), weights);
    }
    const std::string text = format_json_curves(curves);
    RC_LOG() << text;
    const std::vector<Curve> again = parse_json_curves(text);
    RC_ASSERT(again == curves);
    for (std::size_t c = 0; c < curves.size(); ++c) {  // == does not tell -0.0 from 0.0
      const auto a = curves[c].control_points().data();
      const auto b = again[c].control_points().data();
      RC_ASSERT(std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
    }
  }));
}

TEST(JsonWriter, KeepsTheForm) {
  const Curve line = Curve::bezier(Points({{0, 0}, {1, -0.5}}));
  EXPECT_EQ(
      format_json_curves(std::vector<Curve>{line}),
      "{\"type\": \"bspline\", \"degree\": 1, \"knots\": [0, 0, 1, 1], \"points\": [[0, 0], [1, -0.5]]}\n");
  EXPECT_EQ(format_json_curves(std::vector<Curve>{}), "{\"curves\": [\n]}\n");
}

}  // namespace
