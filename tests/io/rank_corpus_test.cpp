#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "io/scratch_directory.h"
#include "io/tiny_font.h"
#include "tandem/error.h"
#include "tandem/io/corpus.h"
#include "tandem/io/tdx.h"

namespace {

using tandem::Candidate;
using tandem::Corpus;
using tandem::ShapeDescriptor;

constexpr const char* kSquare = "<svg><path d='M0 0H4V4H0Z'/></svg>";

class RankCorpus : public tandem::test::ScratchDirectory {
 protected:
  /// "name|label" of every shape; "name!" of what cannot be described.
  static std::vector<std::string> contents(const std::vector<std::string>& names) {
    Corpus corpus(names, {.samples = 12});
    std::vector<std::string> found;
    double fraction = 0.0;
    while (const std::optional<Candidate> candidate = corpus.next()) {
      try {
        const ShapeDescriptor shape = candidate->describe();
        found.push_back(shape.name() + "|" + shape.label());
      } catch (const tandem::Error&) {
        found.push_back(candidate->name + (candidate->required ? "!!" : "!"));
      }
      EXPECT_GE(corpus.fraction(), fraction);
      fraction = corpus.fraction();
    }
    EXPECT_EQ(corpus.fraction(), 1.0);
    EXPECT_FALSE(corpus.next());
    return found;
  }
  std::string put_below(const std::string& directory, const std::string& name,
                        std::string_view content) const {
    std::filesystem::create_directories(directory_ / directory);
    return put(directory + "/" + name, content);
  }
};

TEST_F(RankCorpus, ADirectoryIsAllItsShapesInOrder) {
  const std::string b = put_below("dir", "b.svg", kSquare);
  const std::string a = put_below("dir/cats", "a.svg", kSquare);
  const std::string broken = put_below("dir", "c.json", "{");
  put_below("dir", "readme.txt", "no shape");
  put_below("dir", "model.step", "no shape that can be read");
  EXPECT_EQ(contents({path("dir")}), (std::vector<std::string>{b + "|", broken + "!", a + "|cats"}));
  EXPECT_EQ(contents({path("dir") + "/"}).size(), 3U);
  EXPECT_EQ(contents({broken, b}), (std::vector<std::string>{broken + "!!", b + "|"}));
}

TEST_F(RankCorpus, AFontIsAllItsGlyphsWithAnOutline) {
  const std::string font = put("f.ttf", tandem::test::tiny_font());
  EXPECT_EQ(contents({font}),
            (std::vector<std::string>{font + "#.notdef|", font + "#A|A", font + "#ring|\xC3\xA9"}));
  EXPECT_EQ(contents({font + "#A"}), (std::vector<std::string>{font + "#A|A"}));
  // The same shape, turned to y down, as the glyph by its name.
  Corpus all({font});
  (void)all.next();
  const ShapeDescriptor of_all = all.next()->describe();
  EXPECT_EQ(of_all, Corpus({font + "#A"}).next()->describe());
}

TEST_F(RankCorpus, ABrokenFontEndsTheRunOnlyWhenItWasNamed) {
  const std::string font = put_below("dir", "f.ttf", "no font");
  EXPECT_EQ(contents({path("dir")}), std::vector<std::string>{font + "!"});
  Corpus named({font});
  EXPECT_THROW((void)named.next(), tandem::ParseError);
}

TEST_F(RankCorpus, JsonLines) {
  const std::string lines = put("a.jsonl",
                                "{\"degree\": 1, \"points\": [[0,0],[1,0],[1,1]], \"name\": \"hook\", "
                                "\"label\": \"h\"}\r\n\n  \n"
                                "{\"degree\": 1, \"points\": [[0,0],[1,0],[1,1]]}\n"
                                "{\"degree\": 1, \"points\": [[0,0],[1,0]], \"name\": 5}\n"
                                "[{\"degree\": 1, \"points\": [[0,0],[1,0]]}]");
  EXPECT_EQ(contents({lines}),
            (std::vector<std::string>{"hook|h", lines + "#1|", lines + "#2!", lines + "#3|"}));
  try {
    Corpus corpus({lines});
    (void)corpus.next();
    (void)corpus.next();
    (void)corpus.next()->describe();
    FAIL();
  } catch (const tandem::ParseError& error) {
    EXPECT_EQ(error.line(), 5);
    EXPECT_EQ(std::string(error.what()), lines + ":5:" + std::to_string(error.column()) +
                                             ": \"name\": expected a string, found a number");
  }
}

TEST_F(RankCorpus, AnIndexHoldsTheSameShapes) {
  const std::string font = put("f.ttf", tandem::test::tiny_font());
  Corpus corpus({font}, {.samples = 20});
  std::vector<ShapeDescriptor> shapes;
  while (const std::optional<Candidate> candidate = corpus.next()) shapes.push_back(candidate->describe());
  const std::string index = put("f.tdx", tandem::format_tdx(shapes));
  Corpus again({index, index + "#1", index + "#" + font + "#ring"}, {.samples = 99});
  for (const ShapeDescriptor& shape : shapes) EXPECT_EQ(again.next()->describe(), shape);
  EXPECT_EQ(again.next()->describe(), shapes[1]);
  EXPECT_EQ(again.next()->describe(), shapes[2]);
  EXPECT_FALSE(again.next());
  EXPECT_THROW((void)Corpus({index + "#3"}).next()->describe(), tandem::ParseError);
}

}  // namespace
