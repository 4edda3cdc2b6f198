#include "tandem/io/csv.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "io/paths.h"

namespace {

using tandem::Curve;
using tandem::parse_csv;
using tandem::Points;
using tandem::test::BadInput;

std::string number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

TEST(Csv, ReadsEverySeparator) {
  const Curve expected = parse_csv("0,1.5\n1,-2\n4,3\n9,1e1\n");
  EXPECT_EQ(expected.dim(), 2);
  EXPECT_EQ(expected.domain(), (tandem::Interval{0, 3}));
  for (const char* text :
       {"0;1.5\n1;-2\n4;3\n9;1e1", "0;1,5\n1;-2\n4;3\n9;1e1", "0\t1.5\n1\t-2\n4\t3\n9\t1e1\n",
        "0 1.5\n  1   -2 \n4 3\n9 1e1\n",
        "\xEF\xBB\xBF"
        "0,1.5\r\n1,-2\r\n\r\n4,3\r\n9,1e1\r\n\r\n",
        "0,1.5\r1,-2\r4,3\r9,1e1", "# a comment, with a comma\n0,1.5\n1,-2\n#\n4,3\n9,+1e1",
        "x,y\n0,1.5\n1,-2\n4,3\n9,10", "\"x\",\"y\"\n\"0\",\"1.5\"\n1,-2\n 4 , 3 \n9,10.\n"}) {
    EXPECT_EQ(parse_csv(text), expected) << text;
  }
}

TEST(Csv, TakesTheFirstColumnForTimeWhenItIsCalledSo) {
  for (const char* header : {"t,x", "time,x", "Time,x", "\"T\",x", " t , x ", "Time [s],x", "time_s,x"}) {
    const Curve curve = parse_csv(std::string(header) + "\n-1,5\n0,6\n2,7\n2.5,9\n");
    EXPECT_EQ(curve.dim(), 1) << header;
    EXPECT_EQ(curve.domain(), (tandem::Interval{-1, 2.5})) << header;
  }
  EXPECT_EQ(parse_csv("x,t\n-1,5\n0,6\n2,7\n2.5,9\n").dim(), 2);
}

TEST(Csv, LowersTheDegreeForFewRows) {
  EXPECT_EQ(parse_csv("0 1\n2 3").degree(), 1);
  EXPECT_EQ(parse_csv("0 1\n2 3\n4 9").degree(), 2);
  EXPECT_EQ(parse_csv("0 1\n2 3\n4 9\n1 1").degree(), 3);
}

/// Increasing times, unevenly spaced.
std::vector<double> any_times(int n) {
  std::vector<double> times = {*rc::gen::inRange(-1000, 1000) / 7.0};
  while (static_cast<int>(times.size()) < n)
    times.push_back(times.back() + *rc::gen::inRange(1, 1000) / 777.0);
  return times;
}

TEST(Csv, InterpolatesEveryRowTwiceDifferentiably) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<double> times = any_times(*rc::gen::inRange(2, 40));
    std::string text = "t,x,y\n";
    Points points(2, times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
      // Every other time the data stands still, or turns back.
      for (std::size_t k = 0; k < 2; ++k) points[i][k] = *rc::gen::inRange(-3, 4);
      text += number(times[i]) + "," + number(points[i][0]) + "," + number(points[i][1]) + "\n";
    }
    const Curve curve = parse_csv(text);
    double size = 1.0;
    for (const double x : curve.control_points().data()) size = std::max(size, std::fabs(x));
    for (std::size_t i = 0; i < times.size(); ++i) {
      const tandem::Point p = curve.evaluate(times[i]);
      for (std::size_t k = 0; k < 2; ++k) RC_ASSERT(std::fabs(p[k] - points[i][k]) <= 1e-12 * size);
      if (i == 0 || i + 1 == times.size()) continue;
      const Points left = curve.derivatives(times[i], 3, tandem::Side::left);
      const Points right = curve.derivatives(times[i], 3, tandem::Side::right);
      const double step = std::min(times[i] - times[i - 1], times[i + 1] - times[i]);
      for (std::size_t order = 1; order <= 3; ++order) {
        // Third derivatives jump, except at the second and the last but one row: that is "not a knot".
        if (order == 3 && i != 1 && i + 2 != times.size()) continue;
        const double rounding = 1e-12 * size / std::pow(step, order);
        for (std::size_t k = 0; k < 2; ++k)
          RC_ASSERT(std::fabs(left[order][k] - right[order][k]) <= rounding);
      }
    }
  }));
}

TEST(Csv, ReproducesCubicsExactly) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<double> times = any_times(*rc::gen::inRange(4, 30));
    const double middle = (times.front() + times.back()) / 2;
    const double half = (times.back() - times.front()) / 2;
    const auto cubic = [&](double t) {
      const double s = (t - middle) / half;
      return 1 + s * (-2 + s * (3 + s * 4));
    };
    std::string text = "time x\n";
    for (const double t : times) text += number(t) + " " + number(cubic(t)) + "\n";
    const Curve curve = parse_csv(text);
    for (int i = 0; i <= 50; ++i) {
      const double t = times.front() + (times.back() - times.front()) * i / 50;
      RC_ASSERT(std::fabs(curve.evaluate(t)[0] - cubic(t)) <= 1e-10);
    }
  }));
}

TEST(Csv, ConvergesWithTheFourthPower) {
  const auto error = [](int n) {
    std::string text = "t,x\n";
    for (int i = 0; i <= n; ++i) text += number(6.0 * i / n) + "," + number(std::sin(6.0 * i / n)) + "\n";
    const Curve curve = parse_csv(text);
    double worst = 0.0;
    for (int i = 0; i <= 1000; ++i) {
      worst = std::max(worst, std::fabs(curve.evaluate(6.0 * i / 1000)[0] - std::sin(6.0 * i / 1000)));
    }
    return worst;
  };
  EXPECT_GT(error(20) / error(40), 12.0);
  EXPECT_LT(error(40), 1e-4);
}

TEST(Csv, TakesThousandsOfRows) {
  std::string text = "t,x,y,z\n";
  for (int i = 0; i < 20000; ++i) text += std::to_string(i) + ",1,0,3\n";
  const Curve curve = parse_csv(text);
  EXPECT_EQ(curve.size(), 20000U);
  EXPECT_NEAR(curve.evaluate(12345.6)[2], 3.0, 1e-12);
}

const BadInput kBad[] = {
    {"", 1, 1, "there is no row in it"},
    {"# nothing\n\n", 1, 1, "there is no row in it"},
    {"x,y\n", 2, 1, "no row of numbers, a curve needs at least 2"},
    {"1,2", 1, 4, "1 row of numbers, a curve needs at least 2"},
    {"x,y\n1,2\n", 3, 1, "1 row of numbers"},
    {"1,2\n3\n", 2, 1, "a row of 1 columns, expected 2 as in the first row"},
    {"1,2\n3,4,\n", 2, 1, "a row of 3 columns, expected 2"},
    {"1,2\n3,x4\n", 2, 3, "column 2: expected a number, found 'x4'"},
    {"1,2\n\n# c\n3,\n", 4, 3, "column 2: expected a number, found ''"},
    {"1,2\n3,nan\n", 2, 3, "column 2: expected a number, found 'nan'"},
    {"1,2\n3,inf\n", 2, 3, "column 2: expected a number, found 'inf'"},
    {"1,2\n3,1e999\n", 2, 3, "column 2: expected a number, found '1e999'"},
    {"1,2\n3,1e301\n", 2, 3, "the number lies beyond 1e300"},
    {"1,2\n3,4 5\n", 2, 3, "column 2: expected a number, found '4 5'"},
    {"1,b\n3,4\n", 1, 3, "column 2: expected a number, found 'b'"},
    {"t,x\n0,1\n1,2\n1,3\n", 4, 1, "the time 1 does not come after 1, that of the row before"},
    {"t,x\n0,1\n-1,2\n", 3, 1, "the time -1 does not come after 0"},
    {"time\n0\n1\n", 1, 1, "a time column alone is no curve"},
    {"t,x\n0,1\n1e-300,2e300\n1,3\n2,4\n", 3, 8, "beyond 1e300"},
    {"t,x\n0,0\n1e-300,1e300\n1,3\n2,4\n", 1, 1, "too unevenly spaced"},
};

TEST(Csv, SaysWhatIsWrongAndWhere) {
  for (const BadInput& bad : kBad) {
    tandem::test::expect_refused(bad, [](const std::string& text) { (void)parse_csv(text); });
  }
}

}  // namespace
