#include "tandem/error.h"

#include <gtest/gtest.h>

TEST(ParseError, MessageStartsWithThePlaceAsFarAsItIsKnown) {
  EXPECT_STREQ(tandem::ParseError("a.svg", 3, 14, "expected a number").what(),
               "a.svg:3:14: expected a number");
  EXPECT_STREQ(tandem::ParseError("a.svg", 3, 0, "expected a number").what(), "a.svg:3: expected a number");
  EXPECT_STREQ(tandem::ParseError("a.ttf", 0, 0, "no such glyph").what(), "a.ttf: no such glyph");
}

TEST(Error, EveryErrorIsAnError) {
  EXPECT_THROW(throw tandem::ParseError("x", 1, 1, ""), tandem::Error);
  EXPECT_THROW(throw tandem::InvalidArgument(""), tandem::Error);
  EXPECT_THROW(throw tandem::IoError(""), tandem::Error);
}
