#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "io/morphs.h"
#include "io/number.h"
#include "tandem/error.h"
#include "tandem/io/path_data.h"

namespace tandem {
namespace {

TEST(Number, IsPlainAndShort) {
  EXPECT_EQ(format_number(0.0), "0");
  EXPECT_EQ(format_number(-0.0), "0");
  EXPECT_EQ(format_number(0.5), "0.5");
  EXPECT_EQ(format_number(-0.25), "-0.25");
  EXPECT_EQ(format_number(100.0), "100");
  EXPECT_EQ(format_number(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(format_number(1.25e-5), "0.0000125");
  EXPECT_EQ(format_number(-1e-7), "-0.0000001");
  EXPECT_EQ(format_number(1e-8), "1e-08");
  EXPECT_EQ(format_number(1e17), "100000000000000000");
  EXPECT_EQ(format_number(-1.5e20), "-150000000000000000000");
  EXPECT_EQ(format_number(1e21), "1e+21");
  EXPECT_EQ(format_number(1e300), "1e+300");
}

TEST(Number, KeepsTheDecimalsAskedFor) {
  EXPECT_EQ(format_number(1.0 / 3.0, 3), "0.333");
  EXPECT_EQ(format_number(2.0, 3), "2");
  EXPECT_EQ(format_number(2.5, 3), "2.5");
  EXPECT_EQ(format_number(120.0, 0), "120");
  EXPECT_EQ(format_number(-0.0001, 3), "0");
  EXPECT_EQ(format_number(-0.6, 0), "-1");
  EXPECT_EQ(format_number(1e300, 3), "1e+300");
  EXPECT_EQ(format_number(0.1, 1000000), "0.100000000000000005551115123126");
}

// Decimals come from a quick way where that is sure; ties are the doubles' own, as in 0.125 and 1.005.
TEST(Number, IsRoundedExactly) {
  const auto expected = [](double x, int precision) {
    std::string text = fmt::format("{:.{}f}", x, precision);
    if (text.find('.') != std::string::npos) text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
  };
  for (const double x : {0.125, 0.375, 2.5, 3.5, 1.005, 0.0005, -0.0005, 0.0015, 999999999.5, 0.99995}) {
    for (int precision = 0; precision < 10; ++precision) {
      EXPECT_EQ(format_number(x, precision), expected(x, precision)) << x;
    }
  }
  EXPECT_TRUE(rc::check([&] {
    const int precision = *rc::gen::inRange(0, 12);
    const auto halves = *rc::gen::inRange(std::int64_t{-4000000000}, std::int64_t{4000000000});
    // Half-way between two texts, or next to it.
    const double tie = 0.5 * static_cast<double>(halves) / std::pow(10.0, *rc::gen::inRange(0, 12));
    const double x = std::nextafter(tie, *rc::gen::inRange(-1, 2) * 1e300);
    RC_ASSERT(format_number(x, precision) == expected(x, precision));
  }));
}

TEST(Number, AppendsWithoutTouchingWhatIsThere) {
  std::string text = "10.00";
  append_number(text, 20.0, 2);
  EXPECT_EQ(text, "10.0020");
}

TEST(Number, ShortestTextReadsBackEqual) {
  EXPECT_TRUE(rc::check([] {
    const auto mantissa = *rc::gen::inRange(std::int64_t{-1} << 53, std::int64_t{1} << 53);
    const double x = std::ldexp(static_cast<double>(mantissa), *rc::gen::inRange(-1100, 950));
    const std::string text = format_number(x);
    RC_ASSERT(std::strtod(text.c_str(), nullptr) == x);
    const double size = std::fabs(x);
    if (size >= 1e-7 && size < 1e21) RC_ASSERT(text.find('e') == std::string::npos);
  }));
}

TEST(PathDataWriter, WritesAbsoluteCommandsOnly) {
  const std::vector<CubicPath> paths{
      CubicPath(Points({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 2}, {2, 3}, {0, 0}}), true),
      CubicPath(Points({{-1, -1}, {-2, 0.75}, {0, 0}, {1, 1}}))};
  EXPECT_EQ(format_path_data(paths), "M0 0C1 0 2 0 3 0C3 2 2 3 0 0ZM-1 -1C-2 0.75 0 0 1 1");
  const std::vector<std::vector<bool>> lines{{true, false}};
  EXPECT_EQ(format_path_data(paths, lines), "M0 0L3 0C3 2 2 3 0 0ZM-1 -1C-2 0.75 0 0 1 1");
  EXPECT_EQ(format_path_data(paths, lines, 0), "M0 0L3 0C3 2 2 3 0 0ZM-1 -1C-2 1 0 0 1 1");
  EXPECT_EQ(format_path_data({}), "");
}

TEST(PathDataWriter, WritesFramesAsFormatPathDataDoes) {
  const PathMorph morph = test::mixed();
  std::vector<std::vector<bool>> lines;
  for (const PathContour& contour : morph.contours()) lines.push_back(contour.lines);
  PathDataWriter write(morph, 3);
  for (const double s : {0.0, 0.25, 0.5, 1.0}) {
    EXPECT_EQ(write(s), format_path_data(morph.at(s), lines, 3));
    EXPECT_EQ(write(s), format_path_data(morph, s, 3));
  }
}

// What is written is read back equal, whatever the numbers are.
TEST(PathDataWriter, ReadsBackEqual) {
  EXPECT_TRUE(rc::check([] {
    const auto number = [] {
      const auto mantissa = *rc::gen::inRange(-1000000, 1000001);
      return std::ldexp(static_cast<double>(mantissa), *rc::gen::inRange(-20, 1));
    };
    std::vector<CubicPath> paths;
    const int count = *rc::gen::inRange(1, 4);
    for (int i = 0; i < count; ++i) {
      const auto segments = static_cast<std::size_t>(*rc::gen::inRange(1, 6));
      Points points(2, 3 * segments + 1);
      for (std::size_t k = 0; k < points.size(); ++k) {  // no segment is a point, which would be left out
        points[k][0] = number() + static_cast<double>(k);
        points[k][1] = number();
      }
      const bool closed = *rc::gen::arbitrary<bool>();
      if (closed) std::copy_n(points.data().begin(), 2, points.data().end() - 2);
      paths.emplace_back(std::move(points), closed);
    }
    RC_ASSERT(parse_path_data(format_path_data(paths), "test", false) == paths);
  }));
}

TEST(PathDataWriter, LinesReadBackAsLines) {
  const std::vector<CubicPath> paths = parse_path_data("M0.1 0.2L7 0.3 5 11.7Z");
  const std::vector<std::vector<bool>> lines{{true, true, true}};
  const std::string text = format_path_data(paths, lines);
  EXPECT_EQ(text, "M0.1 0.2L7 0.3L5 11.7L0.1 0.2Z");
  EXPECT_EQ(parse_path_data(text), paths);
}

TEST(PathDataWriter, WantsThePlane) {
  const std::vector<CubicPath> paths{CubicPath(Points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}))};
  EXPECT_THROW((void)format_path_data(paths), InvalidArgument);
}

}  // namespace
}  // namespace tandem
