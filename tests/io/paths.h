#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tandem/error.h"
#include "tandem/io/path_data.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/shape.h"

namespace tandem::test {

/// Control points within `tolerance`, the same segments, the same ends closed.
inline void expect_same_paths(const std::vector<CubicPath>& actual, const std::vector<CubicPath>& expected,
                              double tolerance, const std::string& label) {
  ASSERT_EQ(actual.size(), expected.size()) << label;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_EQ(actual[i].is_closed(), expected[i].is_closed()) << label << ", path " << i;
    const auto a = actual[i].control_points().data();
    const auto e = expected[i].control_points().data();
    ASSERT_EQ(a.size(), e.size()) << label << ", path " << i;
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_NEAR(a[k], e[k], tolerance) << label << ", path " << i << ", point " << k / 2;
    }
  }
}

inline void expect_same_shape(const Shape& actual, const Shape& expected, double tolerance,
                              const std::string& label) {
  EXPECT_EQ(actual.fill_rule, expected.fill_rule) << label;
  ASSERT_EQ(actual.contours.size(), expected.contours.size()) << label;
  for (std::size_t i = 0; i < actual.contours.size(); ++i) {
    const Curve& a = actual.contours[i];
    const Curve& e = expected.contours[i];
    EXPECT_EQ(a.is_closed(), e.is_closed()) << label << ", contour " << i;
    ASSERT_EQ(a.knots(), e.knots()) << label << ", contour " << i;
    for (std::size_t k = 0; k < a.control_points().data().size(); ++k) {
      EXPECT_NEAR(a.control_points().data()[k], e.control_points().data()[k], tolerance)
          << label << ", contour " << i << ", point " << k / 2;
    }
  }
}

/// A text that must be refused: at which place, and with which words.
struct BadInput {
  std::string text;
  int line;
  int column;
  std::string message;
};

template <typename Parse>
void expect_refused(const BadInput& bad, Parse parse) {
  try {
    parse(bad.text);
    ADD_FAILURE() << "was accepted: " << bad.text.substr(0, 200);
  } catch (const ParseError& error) {
    EXPECT_EQ(error.line(), bad.line) << bad.text.substr(0, 200) << "\n" << error.what();
    EXPECT_EQ(error.column(), bad.column) << bad.text.substr(0, 200) << "\n" << error.what();
    EXPECT_NE(std::string(error.what()).find(bad.message), std::string::npos)
        << bad.text.substr(0, 200) << "\n  says: " << error.what() << "\n  expected: " << bad.message;
  }
}

}  // namespace tandem::test
