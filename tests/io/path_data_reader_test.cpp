#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <string>
#include <vector>

#include "io/paths.h"
#include "tandem/io/path_data.h"
#include "tandem/shape/path_builder.h"

namespace {

using tandem::CubicPath;
using tandem::parse_path_data;
using tandem::Points;
using tandem::test::BadInput;
using tandem::test::expect_same_paths;

std::vector<CubicPath> parse(const std::string& text) {
  return parse_path_data(text, "path data", false);
}

TEST(PathDataReader, ReadsAbsoluteCubics) {
  const auto paths = parse("M 1 2 C 3 4 5 6 7 8");
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(paths[0].control_points(), Points({{1, 2}, {3, 4}, {5, 6}, {7, 8}}));
  EXPECT_FALSE(paths[0].is_closed());
}

TEST(PathDataReader, PutsTheHandlesOfLinesAtTheThirds) {
  const auto paths = parse("M0 0L3 6");
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(paths[0].control_points(), Points({{0, 0}, {1, 2}, {2, 4}, {3, 6}}));
}

TEST(PathDataReader, RaisesQuadraticsExactly) {
  const auto paths = parse("M0 0Q3 6 6 0");
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(paths[0].control_points(), Points({{0, 0}, {2, 4}, {4, 4}, {6, 0}}));
}

struct Equal {
  std::string text;
  std::string expected;  ///< absolute M, L, C, Q, A and Z with blanks everywhere
};

// Every production of the grammar of SVG 2, section 9.3.9, in the forms that minifiers write.
const Equal kEqual[] = {
    // moveto and its implicit lineto
    {"M1 2 3 4 5 6", "M 1 2 L 3 4 L 5 6"},
    {"m1 2 3 4 5 6", "M 1 2 L 4 6 L 9 12"},
    {"M1 2m3 4 5 6", "M 4 6 L 9 12"},
    {"M1 2L3 4m1 1l1 1", "M 1 2 L 3 4 M 4 5 L 5 6"},
    {"M 0 0 L 1 0 M 5 5", "M 0 0 L 1 0"},
    // lines
    {"M1 2l3 4 5 6", "M 1 2 L 4 6 L 9 12"},
    {"M1 2H5 6V7 8", "M 1 2 L 5 2 L 6 2 L 6 7 L 6 8"},
    {"M1 2h5 6v7 8", "M 1 2 L 6 2 L 12 2 L 12 9 L 12 17"},
    // curves
    {"M1 2c1 2 3 4 5 6 7 8 9 10 11 12", "M 1 2 C 2 4 4 6 6 8 C 13 16 15 18 17 20"},
    {"M1 2q1 2 3 4", "M 1 2 Q 2 4 4 6"},
    {"M0 0C1 1 2 2 3 0S6 1 7 0", "M 0 0 C 1 1 2 2 3 0 C 4 -2 6 1 7 0"},
    {"M0 0c1 1 2 2 3 0s3 1 4 0 1 1 2 0", "M 0 0 C 1 1 2 2 3 0 C 4 -2 6 1 7 0 C 8 -1 8 1 9 0"},
    {"M0 0S1 1 2 0", "M 0 0 C 0 0 1 1 2 0"},
    {"M0 0Q1 1 2 0S3 1 4 0", "M 0 0 Q 1 1 2 0 C 2 0 3 1 4 0"},
    {"M0 0Q1 1 2 0T4 0 6 0", "M 0 0 Q 1 1 2 0 Q 3 -1 4 0 Q 5 1 6 0"},
    {"M0 0Q1 1 2 0t2 0", "M 0 0 Q 1 1 2 0 Q 3 -1 4 0"},
    {"M0 0T4 2", "M 0 0 Q 0 0 4 2"},
    {"M0 0C1 1 2 2 3 0T4 2", "M 0 0 C 1 1 2 2 3 0 Q 3 0 4 2"},
    {"M0 0L3 0T4 2", "M 0 0 L 3 0 Q 3 0 4 2"},
    // arcs, with flags that run into what follows
    {"M0 0a1 1 0 012 3", "M 0 0 A 1 1 0 0 1 2 3"},
    {"M0 0a1 1 0 01-2 3", "M 0 0 A 1 1 0 0 1 -2 3"},
    {"M0 0a1 1 0 00.5.5", "M 0 0 A 1 1 0 0 0 0.5 0.5"},
    {"M0 0a1,1,30,1,1,2,3,1 1 0 102 3", "M 0 0 A 1 1 30 1 1 2 3 A 1 1 0 1 0 4 6"},
    {"M0 0A0 5 0 0 1 3 4", "M 0 0 L 3 4"},
    {"M0 0A-5 5 0 0 1 3 4", "M 0 0 A 5 5 0 0 1 3 4"},
    {"M0 0A5 5 0 0 1 0 0L1 1", "M 0 0 L 1 1"},
    // closing, and what comes after it
    {"M1 1H2V2z", "M 1 1 L 2 1 L 2 2 L 1 1 Z"},
    {"M1 1H2V2zl5 5", "M 1 1 L 2 1 L 2 2 Z M 1 1 L 6 6"},
    {"M1 1H2V2Zm1 1h1", "M 1 1 L 2 1 L 2 2 Z M 2 2 L 3 2"},
    {"M1 1H2V2ZZ", "M 1 1 L 2 1 L 2 2 Z"},
    {"M0 0C1 1 2 2 3 0ZS1 1 2 2", "M 0 0 C 1 1 2 2 3 0 Z M 0 0 C 0 0 1 1 2 2"},
    // numbers and separators
    {"M1.5.5L-.5e-1-2", "M 1.5 0.5 L -0.05 -2"},
    {"M+1+2L1.e1 1E+1", "M 1 2 L 10 10"},
    {"M1-2L3.0,-4", "M 1 -2 L 3 -4"},
    {"\n M\t1\f,\r2 ,\n3 , 4 ", "M 1 2 L 3 4"},
    {"M0 0L1 1,2 2", "M 0 0 L 1 1 L 2 2"},
    {"M00 01", "M 5 5"},  // draws nothing either way
    {"M0 0L0001 0.10e1", "M 0 0 L 1 1"},
    {"", ""},
    {"  \n ", ""},
    {"M1 2Z", ""},
    {"M1 2L1 2", ""},
    {"M1 2L1 2 1 2 3 4", "M 1 2 L 3 4"},
};

TEST(PathDataReader, ReadsTheWholeGrammar) {
  for (const Equal& equal : kEqual) {
    expect_same_paths(parse(equal.text), parse(equal.expected), 1e-12, equal.text);
  }
}

const BadInput kBad[] = {
    {"L1 2", 1, 1, "expected M or m, with which path data starts, found 'L'"},
    {"1 2", 1, 1, "expected M or m"},
    {"M", 1, 2, "expected a number (x of M), found the end"},
    {"M1", 1, 3, "expected a number (y of M), found the end"},
    {"M1 2 3", 1, 7, "expected a number (y of L), found the end"},
    {"M,1 2", 1, 2, "expected a number (x of M), found ','"},
    {"M1 2,", 1, 6, "expected a number (x of L), found the end"},
    {"M1 2,L3 4", 1, 6, "expected a number (x of L), found 'L'"},
    {"M1,,2", 1, 4, "expected a number (y of M), found ','"},
    {"M1 2\nL3 4\n  C1 2 x", 3, 8, "expected a number (x2 of C), found 'x'"},
    {"M1 2\r\nL3 4\r\nX", 3, 1, "expected a command"},
    {"M1 2\rL3 z", 2, 4, "expected a number (y of L), found 'z'"},
    {"M1 2 \xC3\xA9 L", 1, 6, "expected a command (one of MLHVCSQTAZ, or lower case), found '\xC3\xA9'"},
    {"M\xC3\xA9", 1, 2, "found '\xC3\xA9'"},
    {"M1 2z3", 1, 6, "expected a command"},
    {"M1 2L3 4;", 1, 9, "expected a command"},
    {"M1 2 l 3 e", 1, 10, "expected a number (y of l), found 'e'"},
    {"M1 2L.e1 2", 1, 6, "expected a number (x of L), found '.'"},
    {"M1 2L- 2", 1, 6, "expected a number (x of L), found '-'"},
    {"M1 2LNaN 2", 1, 6, "expected a number (x of L), found 'N'"},
    {"M1 2Linf 2", 1, 6, "expected a number (x of L), found 'i'"},
    {"M1 2L0x10 2", 1, 7, "expected a number (y of L), found 'x'"},
    {"M1e999 2", 1, 2, "out of range"},
    {"M1 2L-1e400 0", 1, 6, "out of range"},
    {"M1e300 2l1e300 0", 1, 10, "beyond the largest coordinate"},
    {"M1e301 2", 1, 2, "beyond the largest coordinate"},
    {"M0 0a1 1 0 2 1 3 4", 1, 12, "expected the large-arc flag of a (0 or 1), found '2'"},
    {"M0 0a1 1 0 0 5 3 4", 1, 14, "expected the sweep flag of a (0 or 1), found '5'"},
    {"M0 0a1 1 0 0", 1, 13, "expected the sweep flag of a (0 or 1), found the end"},
    {"M0 0A1e308 1 0 0 1 3 4", 1, 6, "beyond the largest coordinate"},
    {"M0 1e300A6 1 30 0 1 99 13", 1, 26, "an arc reaches beyond the largest coordinate"},
    {std::string("M1 2\0L3 4", 9), 1, 5, "found byte 0x00"},
};

TEST(PathDataReader, SaysWhatIsWrongAndWhere) {
  for (const BadInput& bad : kBad) tandem::test::expect_refused(bad, parse);
}

TEST(PathDataReader, AppliesTheTransform) {
  const tandem::Transform map{2, 1, -1, 3, 10, 20};
  const auto paths = parse_path_data("M1 2l3 4h1", "path data", false, map);
  expect_same_paths(paths, parse("M 10 27 L 12 42 L 14 43"), 1e-12, "transform");
}

TEST(PathDataReader, RefusesImagesOutOfRange) {
  EXPECT_THROW((void)parse_path_data("M1e200 0L1 1", "d", false, tandem::Transform::scale(1e200, 1)),
               tandem::ParseError);
}

TEST(PathDataReader, ClosesFilledSubpathsWhoseEndsMeet) {
  // The diagonal is 5: ends count as meeting when they are within 0.005.
  const auto close = [](const std::string& end) { return parse_path_data("M0 0L4 0L4 3L" + end, "d", true); };
  const auto exact = close("0 0");
  ASSERT_EQ(exact.size(), 1U);
  EXPECT_TRUE(exact[0].is_closed());
  EXPECT_EQ(exact[0].segment_count(), 3U);
  const auto near = close("0 0.0049");
  EXPECT_TRUE(near[0].is_closed());
  EXPECT_EQ(near[0].segment_count(), 4U);
  EXPECT_EQ(near[0].control_points().back()[1], 0.0);
  EXPECT_TRUE(near[0].is_line(3, 1e-12));
  const auto far = close("0 0.0051");
  EXPECT_FALSE(far[0].is_closed());
  EXPECT_FALSE(parse_path_data("M0 0L4 0L4 3L0 0", "d", false)[0].is_closed());
}

TEST(PathDataReader, MeasuresTheOutlineNotItsHandles) {
  // The handles reach to 1000, the curve to about 289: gaps of 0.5 and 0.7 lie between 1e-3 of the two
  // diagonals.
  const auto paths = parse_path_data("M0 0C0 1000 1 -1000 0.5 0", "d", true);
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_TRUE(paths[0].is_closed());
  EXPECT_FALSE(parse_path_data("M0 0C0 1000 1 -1000 0.7 0", "d", true)[0].is_closed());
}

TEST(PathDataReader, TakesCoordinatesNearBothEndsOfTheRange) {
  const auto huge = parse_path_data("M-1e300 0L1e300 0L1e300 1e300Z");
  ASSERT_EQ(huge.size(), 1U);
  EXPECT_TRUE(huge[0].is_closed());
  const auto tiny = parse_path_data("M0 0L4e-300 0L4e-300 3e-300L0 1e-302");
  ASSERT_EQ(tiny.size(), 1U);
  EXPECT_FALSE(tiny[0].is_closed());
  const auto met = parse_path_data("M0 0L4e-300 0L4e-300 3e-300L0 1e-303");
  ASSERT_EQ(met.size(), 1U);
  EXPECT_TRUE(met[0].is_closed());
}

/// Coordinates of one path are of one size: a closed path whose ends differ by less than rounding at its size
/// is snapped shut, and does not read back point by point.
double coordinate(int kind) {
  const double mantissa = *rc::gen::inRange(-1000000, 1000001);
  switch (kind) {
    case 0:
      return std::floor(mantissa / 1e5);
    case 1:
      return mantissa * 1e290;
    case 2:
      return mantissa * 1e-300;
    default:
      return mantissa / 3e3;
  }
}

TEST(PathDataReader, ReadsBackWhatIsWritten) {
  EXPECT_TRUE(rc::check([] {
    tandem::PathBuilder builder;
    const int kind = *rc::gen::inRange(0, 6);
    const auto point = [kind] { return tandem::Vec2{coordinate(kind), coordinate(kind)}; };
    const int subpaths = *rc::gen::inRange(1, 4);
    for (int i = 0; i < subpaths; ++i) {
      builder.move_to(point());
      const int segments = *rc::gen::inRange(1, 6);
      for (int k = 0; k < segments; ++k) {
        if (*rc::gen::inRange(0, 2) == 0) {
          builder.line_to(point());
        } else {
          builder.cubic_to(point(), point(), point());
        }
      }
      if (*rc::gen::inRange(0, 2) == 0) builder.close();
    }
    const std::vector<CubicPath> paths = builder.take();
    const std::string text = tandem::format_path_data(paths);
    RC_LOG() << text;
    RC_ASSERT(parse(text) == paths);
  }));
}

TEST(PathDataReader, RelativeIsAbsoluteMovedAlong) {
  EXPECT_TRUE(rc::check([] {
    // Small integers: sums are exact, so both forms must agree bit for bit.
    const auto number = [] { return *rc::gen::inRange(-50, 51); };
    int x = number();
    int y = number();
    std::string absolute = "M" + std::to_string(x) + " " + std::to_string(y);
    std::string relative = "m" + std::to_string(x) + " " + std::to_string(y);
    const int count = *rc::gen::inRange(1, 10);
    for (int i = 0; i < count; ++i) {
      const std::string letters = "LHVCSQTA";
      const char letter = letters[static_cast<std::size_t>(*rc::gen::inRange(0, 8))];
      absolute += letter;
      relative += static_cast<char>(letter + 32);
      int dx = 0;
      int dy = 0;
      const int points = letter == 'C' ? 3 : (letter == 'S' || letter == 'Q') ? 2 : 1;
      if (letter == 'A') {
        const std::string head = std::to_string(*rc::gen::inRange(0, 20)) + " " +
                                 std::to_string(*rc::gen::inRange(0, 20)) + " " + std::to_string(number()) +
                                 " " + std::to_string(*rc::gen::inRange(0, 2)) +
                                 std::to_string(*rc::gen::inRange(0, 2)) + " ";
        absolute += head;
        relative += head;
      }
      for (int k = 0; k < points; ++k) {
        dx = letter == 'V' ? 0 : number();
        dy = letter == 'H' ? 0 : number();
        if (letter != 'V') absolute += " " + std::to_string(x + dx);
        if (letter != 'V') relative += " " + std::to_string(dx);
        if (letter != 'H') absolute += " " + std::to_string(y + dy);
        if (letter != 'H') relative += " " + std::to_string(dy);
      }
      x += dx;
      y += dy;
    }
    RC_LOG() << absolute << "\n" << relative;
    RC_ASSERT(parse(absolute) == parse(relative));
  }));
}

}  // namespace
