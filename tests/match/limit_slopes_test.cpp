#include "match/limit_slopes.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "match/simplify.h"

namespace tandem::detail {
namespace {

struct Data {
  std::vector<double> x;
  std::vector<double> y;
};

Data random_data(std::size_t least, std::size_t most) {
  const auto n = *rc::gen::inRange<std::size_t>(least, most + 1);
  Data data;
  double x = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    data.x.push_back(x);
    data.y.push_back(*rc::gen::inRange(-20, 21) / 10.0);
    x += *rc::gen::element(0.1, 0.2, 1.0, 1e-3, 1e-9);
  }
  return data;
}

void expect_slopes_within(const std::vector<double>& x, const std::vector<double>& y,
                          const SlopeRange& range) {
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double dx = x[i] - x[i - 1];
    RC_ASSERT(y[i] - y[i - 1] >= range.lo * dx - 1e-13);
    RC_ASSERT(y[i] - y[i - 1] <= range.hi * dx + 1e-13);
  }
}

TEST(LimitSlopes, KeepsWhatIsAdmissible) {
  const std::vector<double> x{0, 0.1, 0.7, 1};
  const std::vector<double> y{0, 0.3, 0.31, 1};
  const std::size_t ends[] = {0, 3};
  EXPECT_EQ(limit_slopes(x, y, ends, {1e-3, 1e3}), y);
}

TEST(LimitSlopes, MovesByHalfTheExcess) {
  const std::vector<double> x{0, 1, 2, 3};
  const std::vector<double> y{0, 2, 1, 3};
  const std::vector<double> z = limit_slopes(x, y, {}, {0.5, 2.0});
  // From 2 down to 1 where at least 0.5 up is wanted: 1.5 too much, half of it each.
  EXPECT_DOUBLE_EQ(z[1], 1.25);
  EXPECT_DOUBLE_EQ(z[2], 1.75);
}

TEST(LimitSlopes, MovesAsLittleAsPossible) {
  EXPECT_TRUE(rc::check([] {
    const Data data = random_data(2, 20);
    const SlopeRange range{*rc::gen::element(1e-3, 0.5, 1.0), *rc::gen::element(1.0, 2.0, 1e3)};
    const std::vector<double> z = limit_slopes(data.x, data.y, {}, range);
    expect_slopes_within(data.x, z, range);
    double moved = 0.0;
    double needed = 0.0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      moved = std::max(moved, std::abs(z[i] - data.y[i]));
      for (std::size_t j = i + 1; j < z.size(); ++j) {
        const double dx = data.x[j] - data.x[i];
        const double dy = data.y[j] - data.y[i];
        needed = std::max({needed, 0.5 * (range.lo * dx - dy), 0.5 * (dy - range.hi * dx)});
      }
    }
    RC_ASSERT(moved <= needed + 1e-13);
  }));
}

TEST(LimitSlopes, KeepsTheFixedValues) {
  EXPECT_TRUE(rc::check([] {
    Data data = random_data(3, 20);
    const SlopeRange range{1e-3, 1e3};
    // Ends and one more, on a line of slope 1.
    const auto middle = *rc::gen::inRange<std::size_t>(1, data.x.size() - 1);
    const std::vector<std::size_t> fixed{0, middle, data.x.size() - 1};
    for (const std::size_t i : fixed) data.y[i] = data.x[i];
    const std::vector<double> z = limit_slopes(data.x, data.y, fixed, range);
    for (const std::size_t i : fixed) RC_ASSERT(z[i] == data.y[i]);
    expect_slopes_within(data.x, z, range);
  }));
}

TEST(LimitSlopes, UsesTheRoomOfIntervals) {
  EXPECT_TRUE(rc::check([] {
    const Data data = random_data(2, 20);
    const SlopeRange range{0.1, 10.0};
    // Intervals around an admissible function: nothing need leave them.
    std::vector<double> low;
    std::vector<double> high;
    std::vector<double> middle;
    for (std::size_t i = 0; i < data.x.size(); ++i) {
      low.push_back(data.x[i] - *rc::gen::element(0.0, 0.1, 2.0));
      high.push_back(data.x[i] + *rc::gen::element(0.0, 0.1, 2.0));
      middle.push_back(0.5 * (low[i] + high[i]));
    }
    const std::vector<double> z = limit_slopes(data.x, middle, low, high, {}, range);
    expect_slopes_within(data.x, z, range);
    for (std::size_t i = 0; i < z.size(); ++i) {
      RC_ASSERT(z[i] >= low[i] - 1e-13);
      RC_ASSERT(z[i] <= high[i] + 1e-13);
    }
  }));
}

/// Does the polyline through the vertices stay within the windows, made wider by `slack`?
bool passes(const Data& data, const std::vector<double>& low, const std::vector<double>& high,
            const std::vector<std::size_t>& vertices, double slack) {
  for (std::size_t k = 1; k < vertices.size(); ++k) {
    const std::size_t a = vertices[k - 1];
    const std::size_t b = vertices[k];
    for (std::size_t i = a + 1; i < b; ++i) {
      const double y =
          data.y[a] + (data.y[b] - data.y[a]) * ((data.x[i] - data.x[a]) / (data.x[b] - data.x[a]));
      if (y < low[i] - slack || y > high[i] + slack) return false;
    }
  }
  return true;
}

TEST(FewestVertices, EqualsBruteForce) {
  EXPECT_TRUE(rc::check([] {
    const Data data = random_data(2, 10);
    const std::size_t n = data.x.size();
    std::vector<double> low;
    std::vector<double> high;
    for (const double y : data.y) {
      low.push_back(y - *rc::gen::element(0.05, 0.33, 1.21));
      high.push_back(y + *rc::gen::element(0.05, 0.33, 1.21));
    }
    const std::vector<std::size_t> found = fewest_vertices(data.x, data.y, low, high);
    RC_ASSERT(found.front() == 0u);
    RC_ASSERT(found.back() == n - 1);
    RC_ASSERT(passes(data, low, high, found, 1e-12));
    for (unsigned subset = 0; subset < (1u << (n - 2)); ++subset) {
      std::vector<std::size_t> vertices{0};
      for (std::size_t i = 1; i + 1 < n; ++i) {
        if (subset >> (i - 1) & 1u) vertices.push_back(i);
      }
      vertices.push_back(n - 1);
      // Touching a window's edge is a matter of rounding: fewer vertices must not pass clear of them.
      if (vertices.size() < found.size()) RC_ASSERT(!passes(data, low, high, vertices, -1e-12));
    }
  }));
}

TEST(FewestVertices, NeedsTwoForALine) {
  std::vector<double> x;
  std::vector<double> low;
  std::vector<double> high;
  for (int i = 0; i < 1000; ++i) {
    x.push_back(i / 999.0);
    low.push_back(x.back() - 1e-9);
    high.push_back(x.back() + 1e-9);
  }
  EXPECT_EQ(fewest_vertices(x, x, low, high), (std::vector<std::size_t>{0, 999}));
}

}  // namespace
}  // namespace tandem::detail
