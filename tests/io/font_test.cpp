#include "tandem/io/font.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/paths.h"
#include "io/scratch_directory.h"
#include "io/tiny_font.h"

namespace {

using tandem::read_glyph;
using tandem::Shape;

class Font : public tandem::test::ScratchDirectory {
 protected:
  [[nodiscard]] std::string font() const { return put("tiny.ttf", tandem::test::tiny_font()); }

  static Shape outline(const std::string& path_data) {
    return tandem::to_shape(tandem::parse_path_data(path_data, "expected", false));
  }
  static std::string error_of(const std::string& path, const std::string& glyph) {
    try {
      (void)read_glyph(path, glyph);
    } catch (const tandem::ParseError& error) {
      return error.what();
    }
    return "no error";
  }
};

const std::string kTriangle = "M0 0L250 700L500 0Z";
const std::string kRing = "M0 300Q0 600 300 600Q600 600 600 300Q600 0 300 0Q0 0 0 300ZM200 200H400V400H200Z";

TEST_F(Font, ReadsOutlinesInFontUnits) {
  const std::string path = font();
  tandem::test::expect_same_shape(read_glyph(path, "A"), outline(kTriangle), 1e-9, "A");
  tandem::test::expect_same_shape(read_glyph(path, "\xC3\xA9"), outline(kRing), 1e-9, "e acute");
  EXPECT_EQ(read_glyph(path, "\xC3\xA9").contours[0].evaluate(0.5),
            (tandem::Point{75, 525}));  // on the parabola
}

TEST_F(Font, KnowsGlyphsByManyNames) {
  const std::string path = font();
  for (const char* name : {"A", "uni0041", "u0041", "u00041", "U+0041", "glyph1"}) {
    EXPECT_EQ(read_glyph(path, name), read_glyph(path, "A")) << name;
  }
  for (const char* name : {"ring", "uni00E9", "uni00e9", "u1F600", "\xF0\x9F\x98\x80"}) {
    EXPECT_EQ(read_glyph(path, name), read_glyph(path, "\xC3\xA9")) << name;
  }
  EXPECT_EQ(read_glyph(path, ".notdef").contours.size(), 1U);
}

TEST_F(Font, SaysWhatIsMissing) {
  const std::string path = font();
  EXPECT_EQ(error_of(path, "B"), path + ": has no glyph for 'B' (U+0042)");
  EXPECT_EQ(error_of(path, "uni0042"), path + ": has no glyph for U+0042");
  EXPECT_EQ(error_of(path, "bee"),
            path + ": has no glyph 'bee'; expected a character, uniXXXX, or a glyph name");
  EXPECT_EQ(error_of(path, "glyph4"),
            path + ": has no glyph 'glyph4'; expected a character, uniXXXX, or a glyph name");
  EXPECT_EQ(error_of(path, ""), path + ": has no glyph ''; expected a character, uniXXXX, or a glyph name");
  EXPECT_EQ(error_of(path, " "), path + ": the glyph ' ' has no outline");
  EXPECT_NE(error_of(put("empty.ttf", ""), "A").find("is no font that can be read"), std::string::npos);
  EXPECT_NE(error_of(put("text.ttf", "hello"), "A").find("is no font that can be read"), std::string::npos);
  EXPECT_THROW((void)read_glyph(this->path("none.ttf"), "A"), tandem::IoError);
}

TEST_F(Font, SurvivesCutAndDamagedFiles) {
  const std::string whole = tandem::test::tiny_font();
  const auto survives = [&](const std::string& content) {
    const std::string path = put("damaged.ttf", content);
    for (const char* glyph : {"A", "ring"}) {
      try {
        for (const tandem::Curve& contour : read_glyph(path, glyph).contours) EXPECT_EQ(contour.dim(), 2);
      } catch (const tandem::ParseError&) {
      }
    }
  };
  for (std::size_t size = 0; size < whole.size(); size += 13) survives(whole.substr(0, size));
  for (std::size_t i = 0; i < whole.size(); i += 9) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    survives(damaged);
  }
}

}  // namespace
