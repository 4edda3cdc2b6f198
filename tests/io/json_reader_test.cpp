#include <gtest/gtest.h>

#include "tandem/io/json.h"

namespace {
TEST(JsonReader, ReadsWhatItWrote) {
  const auto curves = tandem::parse_json_curves(R"({"degree": 2, "points": [[0,0],[1,2],[3,-0.0]]})");
  const auto again = tandem::parse_json_curves(tandem::format_json_curves(curves));
  EXPECT_EQ(again, curves);
}
}  // namespace
