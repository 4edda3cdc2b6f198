#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "match/cubic_paths.h"
#include "match/plain_segments.h"
#include "tandem/error.h"
#include "tandem/match/match.h"
#include "tandem/match/segments.h"

// Pins of the segments method: pairs of points that a match must go through.

namespace tandem {
namespace {

using cubics::backwards;
using cubics::largest_difference;
using cubics::random_path;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A path split at some of its parameters by de Casteljau; where its joints and its pins are then.
struct Split {
  CubicPath path;
  std::vector<int> pins;  ///< joints
};

Split split_at(const CubicPath& path, const std::vector<double>& pins) {
  std::vector<double> inside;
  for (const double pin : pins) {
    if (pin != std::floor(pin)) inside.push_back(pin);
  }
  std::sort(inside.begin(), inside.end());
  inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
  Points points;
  points.push_back(path.control_points()[0]);
  for (std::size_t i = 0; i < path.segment_count(); ++i) {
    plain::Cubic rest = plain::segment(path, static_cast<int>(i));
    double from = static_cast<double>(i);
    const auto append = [&](const plain::Cubic& piece) {
      for (std::size_t k = 1; k < 4; ++k) points.push_back(piece[k]);
    };
    for (const double pin : inside) {
      if (pin < from || pin > static_cast<double>(i) + 1.0) continue;
      const auto [head, tail] = plain::halves(rest, (pin - from) / (static_cast<double>(i) + 1.0 - from));
      append(head);
      rest = tail;
      from = pin;
    }
    append(rest);
  }
  Split split{CubicPath(std::move(points), path.is_closed()), {}};
  for (const double pin : pins) {
    const auto before = std::count_if(inside.begin(), inside.end(), [&](double p) { return p < pin; });
    split.pins.push_back(static_cast<int>(std::floor(pin)) + static_cast<int>(before) +
                         (pin != std::floor(pin) ? 1 : 0));
  }
  return split;
}

/// Every path of arcs; the best of those that go through all pins.
class EveryPath {
 public:
  EveryPath(const Split& a, const Split& b, const SegmentOptions& options)
      : a_(a), b_(b), options_(options) {}

  double best() {
    const int m = static_cast<int>(a_.path.segment_count());
    const int n = static_cast<int>(b_.path.segment_count());
    double least = kInfinity;
    for (int i = 0; i < (a_.path.is_closed() ? m : 1); ++i) {
      for (int j = 0; j < (b_.path.is_closed() ? n : 1); ++j) {
        nodes_ = {{i, j}};
        least = std::min(least, from_here({i + m, j + n}, 0.0));
      }
    }
    return least;
  }

 private:
  double from_here(Node end, double cost) {
    const Node at = nodes_.back();
    if (at == end) return meets_all() ? cost : kInfinity;
    double least = kInfinity;
    const auto offer = [&](Node next) {
      if (next.i > end.i || next.j > end.j) return;
      nodes_.push_back(next);
      least =
          std::min(least, from_here(end, cost + plain::node_to_node(a_.path, b_.path, at, next, options_)));
      nodes_.pop_back();
    };
    for (int k = 1; at.j + k <= end.j; ++k) offer({at.i + 1, at.j + k});
    for (int k = 2; at.i + k <= end.i; ++k) offer({at.i + k, at.j + 1});
    return least;
  }

  [[nodiscard]] bool meets_all() const {
    for (std::size_t k = 0; k < a_.pins.size(); ++k) {
      const auto meets = [&](const Node& node) {
        const auto same = [](int x, int pin, const CubicPath& path) {
          return path.is_closed() ? (x - pin) % static_cast<int>(path.segment_count()) == 0 : x == pin;
        };
        return same(node.i, a_.pins[k], a_.path) && same(node.j, b_.pins[k], b_.path);
      };
      if (std::none_of(nodes_.begin(), nodes_.end(), meets)) return false;
    }
    return true;
  }

  const Split& a_;
  const Split& b_;
  const SegmentOptions& options_;
  std::vector<Node> nodes_;
};

struct Expected {
  double forward;
  double backward;
};

Expected by_every_path(const CubicPath& a, const CubicPath& b, const SegmentOptions& options) {
  std::vector<double> u;
  std::vector<double> v;
  std::vector<double> from_end;
  for (const ParameterPair& pin : options.pins) {
    u.push_back(pin.u);
    v.push_back(pin.v);
    from_end.push_back(static_cast<double>(b.segment_count()) - pin.v);
  }
  const Split split_a = split_at(a, u);
  const Split split_b = split_at(b, v);
  const Split split_back = split_at(backwards(b), from_end);
  return {EveryPath(split_a, split_b, options).best(), EveryPath(split_a, split_back, options).best()};
}

/// The correspondence has the pin, and the redrawn paths have a joint there.
void expect_met(const CubicPath& a, const CubicPath& b, const SegmentMatch& match, const ParameterPair& pin) {
  const auto same = [](double t, double at, const CubicPath& path) {
    const auto n = static_cast<double>(path.segment_count());
    const double laps = (t - at) / n;
    return std::fabs(path.is_closed() ? laps - std::round(laps) : laps) < 1e-12;
  };
  const auto& points = match.correspondence.points;
  EXPECT_TRUE(std::any_of(points.begin(), points.end(),
                          [&](const ParameterPair& p) { return same(p.u, pin.u, a) && same(p.v, pin.v, b); }))
      << pin.u << " = " << pin.v;
}

/// u of a joint or between joints.
double random_parameter(std::mt19937& random, std::size_t segments) {
  const auto at = static_cast<double>(random() % segments);
  return random() % 2 == 0 ? at : at + 0.25 * static_cast<double>(1 + random() % 3);
}

using Case = std::tuple<bool, bool, SegmentSplit, SegmentCost>;

class EveryPinnedPath : public testing::TestWithParam<Case> {};

TEST_P(EveryPinnedPath, CostsNoLessThanTheBest) {
  const auto [closed_a, closed_b, split, cost] = GetParam();
  std::mt19937 random(11);
  int met = 0;
  int refused = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const std::size_t m = 1 + random() % 3;
    const std::size_t n = 1 + random() % 3;
    const int dim = 2 + static_cast<int>(random() % 2);
    const CubicPath a = random_path(random, dim, m, closed_a);
    const CubicPath b = random_path(random, dim, n, closed_b);
    SegmentOptions options{.split = split, .cost = cost};
    const std::size_t pins = 1 + random() % 2;
    for (std::size_t k = 0; k < pins; ++k) {
      options.pins.push_back({random_parameter(random, m), random_parameter(random, n)});
    }
    const auto [forward, backward] = by_every_path(a, b, options);
    const double best = std::min(forward, backward);
    if (best == kInfinity) {
      EXPECT_THROW((void)match_segments(a, b, options), InvalidArgument);
      ++refused;
      continue;
    }
    const SegmentMatch match = match_segments(a, b, options);
    EXPECT_NEAR(match.cost, best, 1e-9 * best) << m << " against " << n;
    if (!(std::fabs(forward - backward) <= 1e-9 * best)) {
      EXPECT_EQ(match.direction == Direction::reversed, backward < forward);
    }
    for (const ParameterPair& pin : options.pins) expect_met(a, b, match, pin);
    // Exact parts of the inputs.
    for (std::size_t k = 0; k < match.a.segment_count(); ++k) {
      for (const auto& [drawn, path, piece] :
           {std::tuple(&match.a, &a, match.pieces_a[k]), std::tuple(&match.b, &b, match.pieces_b[k])}) {
        const Point p = to_curve(*drawn).evaluate(static_cast<double>(k) + 0.4);
        const Point q =
            to_curve(*path).evaluate(static_cast<double>(piece.segment) + 0.6 * piece.from + 0.4 * piece.to);
        for (std::size_t d = 0; d < p.size(); ++d) EXPECT_NEAR(p[d], q[d], 1e-12);
      }
    }
    // The same from the other side.
    SegmentOptions swapped = options;
    for (ParameterPair& pin : swapped.pins) std::swap(pin.u, pin.v);
    const SegmentMatch other = match_segments(b, a, swapped);
    EXPECT_EQ(other.cost, match.cost);
    ++met;
  }
  EXPECT_GT(met, 10);
  if (!closed_a && !closed_b) {
    EXPECT_GT(refused, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(SegmentPins, EveryPinnedPath,
                         testing::Combine(testing::Bool(), testing::Bool(),
                                          testing::Values(SegmentSplit::proportional, SegmentSplit::uniform),
                                          testing::Values(SegmentCost::derivative, SegmentCost::paper)));

// A pin that the best match goes through anyway changes nothing.
TEST(SegmentPins, ChangeNothingWhereTheMatchGoesAnyway) {
  std::mt19937 random(12);
  for (int trial = 0; trial < 20; ++trial) {
    const CubicPath a = random_path(random, 2, 5, trial % 2 == 0);
    const CubicPath b = random_path(random, 2, 4, trial % 2 == 0);
    const SegmentMatch free = match_segments(a, b);
    const Node node = free.path[free.path.size() / 2];
    double v = node.j % 4;
    if (trial % 2 == 1) v = node.j;
    if (free.direction == Direction::reversed) v = 4.0 - v;
    const SegmentMatch pinned = match_segments(a, b, {.pins = {{static_cast<double>(node.i % 5), v}}});
    EXPECT_NEAR(pinned.cost, free.cost, 1e-12 * free.cost);
    EXPECT_LT(largest_difference(pinned.a, free.a), 1e-12);
    EXPECT_LT(largest_difference(pinned.b, free.b), 1e-12);
  }
}

TEST(SegmentPins, MeanTheJointNextToThem) {
  std::mt19937 random(13);
  const CubicPath a = random_path(random, 2, 4, true);
  const CubicPath b = random_path(random, 2, 4, true);
  const SegmentMatch exact = match_segments(a, b, {.pins = {{2.0, 0.0}}});
  const SegmentMatch near = match_segments(a, b, {.pins = {{2.0 - 1e-8, 4.0 - 1e-9}}});
  EXPECT_EQ(near.cost, exact.cost);
  EXPECT_EQ(near.a, exact.a);
  EXPECT_EQ(near.b, exact.b);
}

TEST(SegmentPins, SayWhatIsWrong) {
  std::mt19937 random(14);
  const CubicPath a = random_path(random, 2, 4, false);
  for (const ParameterPair pin : {ParameterPair{5.0, 1.0}, {1.0, -0.1}, {1.0, NAN}}) {
    EXPECT_THROW((void)match_segments(a, a, {.pins = {pin}}), InvalidArgument);
  }
  // Of an open path the first joint is the end of a match, whichever way.
  EXPECT_THROW((void)match_segments(a, a, {.pins = {{0.0, 2.0}}}), InvalidArgument);
  EXPECT_THROW((void)match_segments(a, a, {.direction = Direction::forward, .pins = {{1, 3}, {2, 2}}}),
               InvalidArgument);
  const SegmentMatch reversed = match_segments(a, a, {.pins = {{1, 3}, {2, 2}}});
  EXPECT_EQ(reversed.direction, Direction::reversed);
}

// match() takes pins in the parameters of its curves, also of curves that are no cubics.
TEST(SegmentPins, HoldInMatch) {
  std::mt19937 random(15);
  for (int trial = 0; trial < 20; ++trial) {
    const CubicPath a = random_path(random, 2, 4, trial % 2 == 0);
    const CubicPath b = random_path(random, 2, 5, trial % 2 == 0);
    const ParameterPair pin{1.0 + 0.5 * (trial % 3), 2.3};
    const SegmentMatch segments = match_segments(a, b, {.pins = {pin}});
    const Match found = match(to_curve(a), to_curve(b), {.method = Method::segments, .pins = {pin}});
    EXPECT_EQ(found.report.cost, segments.cost);
    EXPECT_EQ(found.report.path, segments.path);
    const auto& points = found.correspondence.points;
    ASSERT_EQ(points.size(), segments.correspondence.points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      EXPECT_NEAR(points[k].u, segments.correspondence.points[k].u, 1e-12);
      EXPECT_NEAR(points[k].v, segments.correspondence.points[k].v, 1e-12);
    }
    expect_met(a, b, segments, pin);
    EXPECT_EQ(found.samples_a.size(), static_cast<std::size_t>(found.report.samples[0]));
  }
  const Curve quintic =
      Curve::clamped_uniform(5, Points({{0, 0}, {1, 2}, {2, -1}, {3, 3}, {4, 0}, {5, 1}, {6, 6}, {8, 0}}));
  const Match found = match(quintic, quintic, {.method = Method::segments, .pins = {{0.37, 0.52}}});
  const auto& points = found.correspondence.points;
  EXPECT_TRUE(std::any_of(points.begin(), points.end(), [](const ParameterPair& p) {
    return p == ParameterPair{0.37, 0.52};
  }));
  EXPECT_NEAR(found.reparametrization.v.evaluate(0.37)[0], 0.52, 1e-9);
}

TEST(SegmentPins, RulesOfThePaperReachMatch) {
  std::mt19937 random(16);
  const CubicPath a = random_path(random, 2, 3, false);
  const CubicPath b = random_path(random, 2, 7, false);
  const SegmentRules rules{SegmentSplit::uniform, SegmentCost::paper};
  const SegmentMatch segments = match_segments(a, b, {.split = rules.split, .cost = rules.cost});
  const Match found = match(to_curve(a), to_curve(b), {.method = Method::segments, .segments = rules});
  EXPECT_EQ(found.report.cost, segments.cost);
  EXPECT_EQ(found.report.norm, "paper");
  EXPECT_NE(found.report.cost, match_segments(a, b).cost);
}

}  // namespace
}  // namespace tandem
