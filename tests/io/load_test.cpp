#include "tandem/io/load.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <vector>

#include "io/paths.h"
#include "io/scratch_directory.h"
#include "io/tiny_font.h"
#include "tandem/io/json.h"

namespace {

using tandem::FillRule;
using tandem::load_shape;
using tandem::Shape;

constexpr const char* kSvg =
    "<svg viewBox='0 0 9 9'><g id='g'><path id='a' d='M0 0L3 0L3 3Z'/><rect width='1' height='2'/></g>"
    "<path id='3' fill-rule='evenodd' d='M5 5H9V9H5ZM6 6H7V7H6Z'/><circle id='c#d' r='1'/></svg>";
constexpr const char* kJson =
    R"({"curves": [{"degree": 1, "points": [[0,0],[1,0]]}, {"degree": 1, "points": [[0,0],[2,0]]}]})";
constexpr const char* kItd = "[OBJECT A [CURVE BEZIER 2 E2 [0 0] [1 1]] [CURVE BEZIER 2 E2 [0 0] [2 2]]]";

class Load : public tandem::test::ScratchDirectory {
 protected:
  static Shape outline(const std::string& path_data, FillRule rule = FillRule::nonzero) {
    return tandem::to_shape(tandem::parse_path_data(path_data), rule);
  }

  template <typename Error>
  static std::string error_of(const std::string& name) {
    try {
      (void)load_shape(name);
    } catch (const Error& error) {
      return error.what();
    } catch (const tandem::Error& error) {
      return std::string("another error: ") + error.what();
    }
    return "no error";
  }
};

TEST_F(Load, ReadsPathData) {
  EXPECT_EQ(load_shape("M 0 0 L 3 0 L 3 3 Z"), outline("M0 0L3 0L3 3Z"));
  EXPECT_EQ(load_shape("  m0 0 3 0 0 3z"), outline("M0 0L3 0L3 3Z"));
  EXPECT_EQ(load_shape("M0 0L3 0L3 3Z", {.fill_rule = FillRule::evenodd}).fill_rule, FillRule::evenodd);
  EXPECT_TRUE(load_shape("M0 0L3 0L3 3L0 0.001").contours[0].is_closed());
  EXPECT_EQ(error_of<tandem::ParseError>("M 0 0 L x"),
            "path data:1:9: expected a number (x of L), found 'x'");
  EXPECT_EQ(error_of<tandem::ParseError>("M, 0 0"), "path data:1:2: expected a number (x of M), found ','");
  EXPECT_EQ(error_of<tandem::ParseError>("M 0 0"), "path data: draws nothing");
  EXPECT_EQ(
      error_of<tandem::ParseError>("M1e17 1e17h2v1z"),
      "path data: draws nothing: at coordinates of 1e+17 numbers are 16 apart, and its points fall together");
}

TEST_F(Load, ReadsSvgAndItsParts) {
  const std::string file = put("a.svg", kSvg);
  const Shape all = load_shape(file);
  EXPECT_EQ(all.contours.size(), 5U);
  EXPECT_EQ(all.fill_rule, FillRule::evenodd);
  EXPECT_EQ(load_shape(file + "#a"), outline("M0 0L3 0L3 3Z"));
  EXPECT_EQ(load_shape(file + "#g").contours.size(), 2U);
  EXPECT_EQ(load_shape(file + "#1"), outline("M0 0H1V2H0Z"));
  EXPECT_EQ(load_shape(file + "#3"),
            outline("M5 5H9V9H5ZM6 6H7V7H6Z", FillRule::evenodd));  // an id, first of all
  EXPECT_EQ(load_shape(file + "#2"), load_shape(file + "#3"));
  EXPECT_EQ(load_shape(file + "#c#d").contours.size(), 1U);
  EXPECT_EQ(error_of<tandem::ParseError>(file + "#4"),
            file + ": there is no drawable #4; it has 4 (#0 to #3)");
  EXPECT_EQ(error_of<tandem::ParseError>(file + "#x"), file + ":1:1: there is no element with the id \"x\"");
}

TEST_F(Load, ReadsCurveFilesAndTheirParts) {
  for (const std::string& file : {put("a.json", kJson), put("a.itd", kItd)}) {
    EXPECT_EQ(load_shape(file).contours.size(), 2U);
    const Shape second = load_shape(file + "#1");
    ASSERT_EQ(second.contours.size(), 1U);
    EXPECT_EQ(second.contours[0].control_points()[1][0], 2.0);
    EXPECT_EQ(error_of<tandem::ParseError>(file + "#2"),
              file + ": there is no curve #2; it has 2 (#0 to #1)");
    EXPECT_EQ(error_of<tandem::ParseError>(file + "#x"),
              file + ": there is no curve #x; it has 2 (#0 to #1)");
  }
  const std::string mixed =
      put("m.json", R"([{"degree":1,"points":[[0],[1]]},{"degree":1,"points":[[0,0],[1,1]]}])");
  EXPECT_EQ(load_shape(mixed + "#1").dim(), 2);
  EXPECT_NE(error_of<tandem::ParseError>(mixed).find("curve 0 is of dimension 1, curve 1 of dimension 2"),
            std::string::npos);
  const std::string table = put("a.csv", "t,x\n0,1\n1,2\n");
  EXPECT_EQ(load_shape(table).dim(), 1);
  EXPECT_EQ(error_of<tandem::ParseError>(table + "#1"),
            table + ": is a table, which has no parts; '#1' names none");
}

TEST_F(Load, TurnsGlyphsToPointDown) {
  const std::string font = put("f.TTF", tandem::test::tiny_font());
  tandem::test::expect_same_shape(load_shape(font + "#A"), outline("M0 0L250-700L500 0Z"), 1e-9, "A");
  EXPECT_EQ(load_shape(font + "#uni00E9"), load_shape(font + "#ring"));
  EXPECT_EQ(error_of<tandem::ParseError>(font), font + ": is a font, expected a glyph of it: FONT.ttf#A");
  EXPECT_EQ(error_of<tandem::ParseError>(font + "##"), font + ": has no glyph for '#' (U+0023)");
}

TEST_F(Load, LooksAtExtensionsWithoutCaseAndAtContentsWithoutExtension) {
  EXPECT_EQ(load_shape(put("a.SVG", kSvg)).contours.size(), 5U);
  EXPECT_EQ(
      load_shape(put("svg", std::string("\xEF\xBB\xBF \n<?xml version='1.0'?>") + kSvg)).contours.size(), 5U);
  EXPECT_EQ(load_shape(put("b.txt", kJson)).contours.size(), 2U);
  EXPECT_EQ(load_shape(put("c.txt", "[{\"degree\":1,\"points\":[[0],[1]]}]")).contours.size(), 1U);
  EXPECT_EQ(load_shape(put("d.dat", kItd)).contours.size(), 2U);
  EXPECT_EQ(load_shape(put("e.dat", std::string("A header\n") + kItd)).contours.size(), 2U);
  EXPECT_EQ(load_shape(put("f.txt", "\xEF\xBB\xBF\nM 0 0\nL 3 0 3 3 Z\n")), outline("M0 0L3 0L3 3Z"));
  EXPECT_EQ(load_shape(put("g", "1,2\n3,4\n")).dim(), 2);
  EXPECT_EQ(load_shape(put("h", tandem::test::tiny_font()) + "#A").contours.size(), 1U);
}

TEST_F(Load, PrefersExistingFiles) {
  const std::string file = put("a#b.svg", kSvg);
  EXPECT_EQ(load_shape(file).contours.size(), 5U);
  EXPECT_EQ(load_shape(file + "#a").contours.size(), 1U);
  // A file by the name of path data.
  ASSERT_EQ(chdir(directory_.c_str()), 0);
  put("M 0 0 L 1 1", "M0 0L3 0L3 3Z");
  EXPECT_EQ(load_shape("M 0 0 L 1 1"), outline("M0 0L3 0L3 3Z"));
  ASSERT_EQ(chdir("/"), 0);
}

TEST_F(Load, SaysWhatItCannotRead) {
  EXPECT_EQ(error_of<tandem::InvalidArgument>("hello"),
            "'hello' is neither a file nor path data (M or m, and a number)");
  EXPECT_EQ(error_of<tandem::InvalidArgument>(""),
            "'' is neither a file nor path data (M or m, and a number)");
  EXPECT_EQ(error_of<tandem::InvalidArgument>("Mx"),
            "'Mx' is neither a file nor path data (M or m, and a number)");
  EXPECT_EQ(error_of<tandem::IoError>("missing.svg"), "cannot read missing.svg: there is no such file");
  EXPECT_EQ(error_of<tandem::IoError>("missing.svg#a"), "cannot read missing.svg#a: there is no such file");
  EXPECT_EQ(error_of<tandem::IoError>("m1.svg"), "cannot read m1.svg: there is no such file");
  EXPECT_EQ(error_of<tandem::IoError>("no/where"), "cannot read no/where: there is no such file");
  EXPECT_EQ(error_of<tandem::IoError>(path("")), "cannot read " + path("") + ": Is a directory");
  for (const char* name : {"empty.svg", "empty.json", "empty.itd", "empty.csv", "empty"}) {
    const std::string file = put(name, "");
    EXPECT_EQ(error_of<tandem::ParseError>(file), file + ": is empty");
  }
  const std::string unknown = put("u", "hello");
  EXPECT_EQ(error_of<tandem::ParseError>(unknown),
            unknown + ": is of no known kind: expected SVG, JSON, ITD, CSV, path data or a font");
  const std::string packed = put("a.svgz", "\x1F\x8B");
  EXPECT_EQ(error_of<tandem::ParseError>(packed),
            packed + ": is compressed, expected plain text (gunzip it first)");
  for (const char* name : {"a.step", "a.STP", "a.iges", "a.igs", "a.brep"}) {
    const std::string file = put(name, "x");
    // The CAD component lies beside the program, not beside this test.
    EXPECT_EQ(error_of<tandem::InvalidArgument>(file).rfind("STEP, IGES and BREP need the CAD component", 0),
              0U);
  }
}

TEST_F(Load, ReadsStandardInput) {
  const auto load = [this](const std::string& content, const std::string& name) {
    const std::string file = put("input", content);
    if (std::freopen(file.c_str(), "r", stdin) == nullptr) return Shape{};
    return load_shape(name);
  };
  EXPECT_EQ(load(kSvg, "-").contours.size(), 5U);
  EXPECT_EQ(load(kJson, "-").contours.size(), 2U);
  EXPECT_EQ(load(kJson, "-#1").contours.size(), 1U);
  EXPECT_EQ(load(kItd, "-").contours.size(), 2U);
  EXPECT_EQ(load("M0 0L3 0L3 3Z", "-"), outline("M0 0L3 0L3 3Z"));
  EXPECT_THROW((void)load("", "-"), tandem::ParseError);
  EXPECT_THROW((void)load("hello", "-"), tandem::ParseError);
}

}  // namespace
