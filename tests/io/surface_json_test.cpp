#include "tandem/io/surface_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "surface/random_surfaces.h"
#include "surface/solids.h"
#include "tandem/error.h"
#include "tandem/io/files.h"
#include "tandem/io/json.h"
#include "tandem/io/load_surface.h"

namespace tandem {
namespace {

TEST(SurfaceJson, ReadsBackEqual) {
  testing::RandomSurfaces random(8);
  for (int k = 0; k < 40; ++k) {
    const Surface surface = random.any(1 + k % 4);
    EXPECT_EQ(parse_json_surface(format_json_surface(surface)), surface);
  }
  const Surface nasty({1, 1}, {std::vector<double>{0, 0, 1, 1}, {-1e-300, -1e-300, 5e-324, 5e-324}},
                      Points({{0.1, -0.0}, {1e300, 5e-324}, {1.0 / 3.0, 2}, {-1e-17, 3}}));
  const Surface back = parse_json_surface(format_json_surface(nasty));
  EXPECT_EQ(back, nasty);
  EXPECT_TRUE(std::signbit(back.control_points()[0][1]));
}

TEST(SurfaceJson, OtherMembersArePassedOver) {
  const Surface surface = testing::sphere();
  const std::string text = format_json_surface(surface, R"("report": {"valid": true, "points": [1]})");
  EXPECT_NE(text.find("\"report\""), std::string::npos);
  EXPECT_EQ(parse_json_surface(text), surface);
}

TEST(SurfaceJson, KnotsAndWeightsMayBeLeftOut) {
  const Surface surface = parse_json_surface(R"({"type": "bspline_surface", "degree": [2, 1],
                             "points": [[[0, 0], [0, 1]], [[1, 0], [1, 1]], [[2, 0], [2, 1]], [[3, 0], [3, 1]]]})");
  EXPECT_EQ(surface.knots(Along::u), (std::vector<double>{0, 0, 0, 0.5, 1, 1, 1}));
  EXPECT_EQ(surface.knots(Along::v), (std::vector<double>{0, 0, 1, 1}));
  EXPECT_EQ(surface.control_point(2, 1)[0], 2.0);
  EXPECT_FALSE(surface.is_rational());
}

TEST(SurfaceJson, SaysWhatIsWrongAndWhere) {
  const auto message = [](const std::string& rest) -> std::string {
    try {
      static_cast<void>(parse_json_surface("{\"type\": \"bspline_surface\",\n " + rest + "}", "s.json"));
    } catch (const ParseError& error) {
      return error.what();
    }
    return "";
  };
  const std::string points = "\"points\": [[[0, 0], [0, 1]], [[1, 0], [1, 1]]]";
  EXPECT_EQ(message(points), "s.json:1:1: surface: \"degree\" is missing");
  EXPECT_EQ(message("\"degree\": 3, " + points),
            "s.json:2:12: surface: \"degree\": expected an array, found a number");
  EXPECT_EQ(message("\"degree\": [1], " + points),
            "s.json:2:12: surface: \"degree\" has 1 entries, expected 2");
  EXPECT_EQ(message("\"degree\": [1, 0.5], " + points),
            "s.json:2:16: surface: the degree along v is 0.5, expected a whole number from 1 to 1000");
  EXPECT_EQ(message("\"degree\": [1, 1], \"points\": []"), "s.json:2:30: surface: \"points\" is empty");
  EXPECT_EQ(message("\"degree\": [1, 1], \"points\": [[[0, 0], [0, 1]], [[1, 0]]]"),
            "s.json:2:49: surface: row 1 has 1 points, row 0 has 2");
  EXPECT_EQ(message("\"degree\": [1, 1], \"points\": [[[0, 0], [0, 1]], [[1, 0], [1]]]"),
            "s.json:2:58: surface: point (1, 1) has 1 coordinates, point (0, 0) has 2");
  EXPECT_EQ(message("\"degree\": [1, 1], \"points\": [[[0, 0], [0, 1]], [[1, 0], [1, \"x\"]]]"),
            "s.json:2:62: surface: point (1, 1), coordinate 1: expected a number, found a string");
  EXPECT_EQ(message("\"degree\": [1, 1], " + points + ", \"knots\": [[0, 0, 1, 1], [0, 0, 1, 0]]"),
            "s.json:1:1: surface: along v: knot 3 is 0, before knot 2 (1)");
  EXPECT_EQ(message("\"degree\": [1, 1], " + points + ", \"weights\": [[1, 1], [1]]"),
            "s.json:2:88: surface: row 1 has 1 weights, expected 2");
  EXPECT_EQ(message("\"degree\": [1, 1], " + points + ", \"weights\": [[1, 1]]"),
            "s.json:1:1: surface: 2 weights for 4 control points, expected one each");
}

TEST(SurfaceJson, KnowsASurfaceFromCurves) {
  EXPECT_TRUE(is_json_surface(format_json_surface(testing::torus(0.2))));
  EXPECT_FALSE(is_json_surface(R"({"type": "bspline", "degree": 1, "points": [[0, 0], [1, 1]]})"));
  EXPECT_FALSE(is_json_surface("{\"type\": "));
  EXPECT_THROW(static_cast<void>(parse_json_surface("[1, 2]")), ParseError);
  EXPECT_THROW(static_cast<void>(parse_json_curves(format_json_surface(testing::torus(0.2)))), ParseError);
}

TEST(SurfaceJson, LoadsFiles) {
  const std::string directory = ::testing::TempDir();
  const std::string name = directory + "tandem_surface.json";
  const std::string curve = directory + "tandem_curve.json";
  write_file(name, format_json_surface(testing::sphere()));
  write_file(curve, R"({"type": "bspline", "degree": 1, "points": [[0, 0], [1, 1]]})");
  EXPECT_EQ(load_surface(name), testing::sphere());
  EXPECT_THROW(static_cast<void>(load_surface(curve)), ParseError);
  EXPECT_THROW(static_cast<void>(load_shape(name)), ParseError);
  EXPECT_TRUE(std::holds_alternative<Shape>(load_shape_or_surface(curve)));
  EXPECT_THROW(static_cast<void>(load_surface(directory + "tandem_missing.json")), IoError);
}

}  // namespace
}  // namespace tandem
