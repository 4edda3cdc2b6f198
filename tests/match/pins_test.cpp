#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "match/brute_force.h"
#include "match/cubic_paths.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"
#include "tandem/match/elastic.h"
#include "tandem/match/match.h"
#include "tandem/match/rotation.h"

// MatchOptions::pins.

namespace tandem {
namespace {

Curve random_curve(std::mt19937& random, bool closed) {
  return to_curve(cubics::random_path(random, 2, 3, closed));
}

double distance(const Point& p, const Point& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1]);
}

/// Point of a curve, also beyond the ends of its domain.
Point at(const Curve& curve, double t) {
  const Interval d = curve.domain();
  if (curve.is_closed()) t -= std::floor((t - d.lo) / d.length()) * d.length();
  return curve.evaluate(d.clamp(t));
}

void expect_through_pins(const Curve& a, const Curve& b, const Match& match,
                         const std::vector<ParameterPair>& pins) {
  for (const ParameterPair& pin : pins) {
    const Interval d = match.correspondence.domain_u;
    const double u = a.is_closed() && !match.correspondence.closed
                         ? pin.u - std::floor((pin.u - d.lo) / d.length()) * d.length()
                         : pin.u;
    const double gap = match.correspondence.v_at(u) - pin.v;
    EXPECT_NEAR(b.is_closed() ? std::remainder(gap, b.domain().length()) : gap, 0.0, 1e-9);
    EXPECT_LT(distance(match.curve.evaluate(match.curve.domain().clamp(u)), at(b, pin.v)), 1e-8);
  }
}

/// The nodes at the pins; of the second curve as it was matched.
std::vector<Node> nodes_of(const Match& match, const std::vector<ParameterPair>& pins) {
  const auto nearest = [](const Samples& s, double t) {
    std::size_t best = 0;
    for (std::size_t k = 1; k < s.size(); ++k) {
      if (std::fabs(s.parameters[k] - t) < std::fabs(s.parameters[best] - t)) best = k;
    }
    EXPECT_NEAR(s.parameters[best], t, 1e-12);
    return static_cast<int>(best);
  };
  std::vector<Node> nodes;
  const Interval d = match.samples_b.domain;
  for (const ParameterPair& pin : pins) {
    const double v = match.report.direction == Direction::reversed ? d.lo + (d.hi - pin.v) : pin.v;
    nodes.push_back({nearest(match.samples_a, pin.u), nearest(match.samples_b, v)});
  }
  return nodes;
}

/// All paths from one node to another, step by step; those that miss a pin do not count.
template <typename Steps>
void all_through(const Steps& steps, Node node, Node end, const Node& laps, std::vector<Node> pins,
                 std::int64_t invalid, double cost, brute::Found& found) {
  std::erase_if(pins, [&](const Node& pin) {
    return (node.i - pin.i) % laps.i == 0 && (node.j - pin.j) % laps.j == 0;
  });
  if (node == end) {
    if (pins.empty()) found.offer(invalid, cost);
    return;
  }
  steps(node, [&](Node next, std::int64_t more_invalid, double more) {
    if (next.i > end.i || next.j > end.j) return;
    all_through(steps, next, end, laps, pins, invalid + more_invalid, cost + more, found);
  });
}

/// The least cost of a path through the pins, by trying all.
brute::Found brute_force(const Match& match, const MatchOptions& options, const std::vector<Node>& pins) {
  const Samples& a = match.samples_a;
  const Samples& b = match.samples_b;
  const Node laps{static_cast<int>(a.size()), static_cast<int>(b.size())};
  const bool paper = options.method == Method::paper;
  const NodeTable nodes = paper ? node_costs(a, b, options.norm, options.features)
                                : chord_costs(a, b, options.norm, options.features, RuledSign::positive);
  const EdgeTable edges = paper ? EdgeTable{} : edge_costs(a, b, nodes, options.elastic);
  const auto node_index = [&](Node n) {
    return nodes.index(static_cast<std::size_t>(n.i % laps.i), static_cast<std::size_t>(n.j % laps.j));
  };
  const auto steps = [&](Node from, const auto& go) {
    if (paper) {
      for (const Node step : {Node{1, 1}, Node{0, 1}, Node{1, 0}}) {
        const Node next{from.i + step.i, from.j + step.j};
        if (!a.cyclic && next.i >= laps.i) continue;
        if (!b.cyclic && next.j >= laps.j) continue;
        const std::size_t k = node_index(next);
        go(next, nodes.invalid[k], nodes.invalid[k] != 0 ? 0.0 : nodes.cost[k]);
      }
      return;
    }
    for (std::size_t s = 0; s < edges.steps.size(); ++s) {
      const Node next{from.i + edges.steps[s].a, from.j + edges.steps[s].b};
      if (!a.cyclic && next.i >= laps.i) continue;
      if (!b.cyclic && next.j >= laps.j) continue;
      const std::size_t k = edges.index(static_cast<std::size_t>(next.i % laps.i), s,
                                        static_cast<std::size_t>(next.j % laps.j));
      if (std::isfinite(edges.cost[k])) go(next, static_cast<std::int64_t>(edges.invalid[k]), edges.cost[k]);
    }
  };
  brute::Found found;
  for (int i = 0; i < (a.cyclic ? laps.i : 1); ++i) {
    for (int j = 0; j < (b.cyclic ? laps.j : 1); ++j) {
      const Node start{i, j};
      const Node end{i + laps.i - (a.cyclic ? 0 : 1), j + laps.j - (b.cyclic ? 0 : 1)};
      const bool torus = a.cyclic && b.cyclic;
      // A path may not stand still at a pin where a loop is cut.
      const auto stands_still = [&](const Node& pin) {
        return (a.cyclic && pin.i == i && pin.j > 0 && pin.j < laps.j - 1) ||
               (b.cyclic && pin.j == j && pin.i > 0 && pin.i < laps.i - 1);
      };
      if (!torus && std::any_of(pins.begin(), pins.end(), stands_still)) continue;
      const std::size_t k = node_index(start);
      const bool counted = paper && !torus;
      all_through(steps, start, end, laps, pins, counted ? nodes.invalid[k] : 0,
                  counted && nodes.invalid[k] == 0 ? nodes.cost[k] : 0.0, found);
    }
  }
  return found;
}

struct PinCase {
  Method method;
  bool closed_a;
  bool closed_b;
  Direction direction;
};

class PinnedOptimum : public testing::TestWithParam<PinCase> {};

TEST_P(PinnedOptimum, IsTheBestOfAllPathsThroughThePins) {
  const PinCase c = GetParam();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.05, 0.95);
  int compared = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const Curve a = random_curve(random, c.closed_a);
    const Curve b = random_curve(random, c.closed_b);
    MatchOptions options{.method = c.method, .samples = {5, 5}, .direction = c.direction};
    std::vector<double> u = {3.0 * share(random), 3.0 * share(random)};
    std::vector<double> v = {3.0 * share(random), 3.0 * share(random)};
    std::sort(u.begin(), u.end());
    std::sort(v.begin(), v.end());
    if (c.direction == Direction::reversed) std::swap(v[0], v[1]);
    const bool two = trial % 3 != 0;
    options.pins = {{u[0], v[0]}};
    if (two) options.pins.push_back({u[1], v[1]});
    const Match found = match(a, b, options);
    expect_through_pins(a, b, found, options.pins);
    if (found.samples_a.size() > 9 || found.samples_b.size() > 9) continue;  // too many paths
    ++compared;
    const brute::Found best = brute_force(found, options, nodes_of(found, options.pins));
    ASSERT_TRUE(std::isfinite(best.cost));
    if (c.method == Method::paper) {
      EXPECT_EQ(found.report.invalid_nodes, best.invalid);
      const double penalty = static_cast<double>(found.samples_a.size() + found.samples_b.size());
      EXPECT_NEAR(found.report.cost, best.cost + penalty * static_cast<double>(best.invalid), 1e-9);
    } else {
      EXPECT_NEAR(found.report.invalid_length, static_cast<double>(best.invalid) * kInvalidQuantum, 1e-15);
      EXPECT_NEAR(found.report.cost, best.cost, 1e-9);
    }
  }
  EXPECT_GE(compared, 10);
}

std::vector<PinCase> pin_cases() {
  std::vector<PinCase> cases;
  for (const Method method : {Method::elastic, Method::paper}) {
    for (const Direction direction : {Direction::forward, Direction::reversed}) {
      for (const bool closed_a : {false, true}) {
        for (const bool closed_b : {false, true}) cases.push_back({method, closed_a, closed_b, direction});
      }
    }
  }
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Pins, PinnedOptimum, testing::ValuesIn(pin_cases()));

TEST(Pins, OnTheFreeOptimumChangeNothing) {
  int compared = 0;
  std::mt19937 random(6);
  for (const NormKind norm : {NormKind::tangent, NormKind::distance, NormKind::bottleneck}) {
    for (int trial = 0; trial < 8; ++trial) {
      const Curve a = random_curve(random, trial % 4 < 2);
      const Curve b = random_curve(random, trial % 4 < 2);
      // Samples by parameter, so that pins at nodes leave them where they are.
      MatchOptions options{.norm = norm, .samples = {24, 24}, .sampling = Sampling::parameter};
      const Match free = match(a, b, options);
      for (const double share : {0.2, 0.5, 0.8}) {
        const auto& path = free.report.path;
        const Node node = path[static_cast<std::size_t>(share * static_cast<double>(path.size()))];
        const auto n = static_cast<int>(free.samples_b.size());
        const double v = free.samples_b.parameters[static_cast<std::size_t>(node.j % n)];
        const Interval d = free.samples_b.domain;
        const bool reversed = free.report.direction == Direction::reversed;
        options.pins.push_back(
            {free.samples_a.parameters[static_cast<std::size_t>(node.i) % free.samples_a.size()],
             reversed ? d.lo + (d.hi - v) : v});
      }
      const Match pinned = match(a, b, options);
      if (pinned.samples_a.size() != free.samples_a.size() ||
          pinned.samples_b.size() != free.samples_b.size())
        continue;
      ++compared;
      EXPECT_NEAR(pinned.report.cost, free.report.cost, 1e-12 * std::max(1.0, free.report.cost));
      EXPECT_EQ(pinned.report.direction, free.report.direction);
      EXPECT_NEAR(pinned.report.invalid_length, free.report.invalid_length, 1e-12);
    }
  }
  EXPECT_GE(compared, 12);  // elsewhere the steps needed more nodes
}

TEST(Pins, BridgeStretchesOfVeryDifferentLengths) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 8; ++trial) {
    const Curve a = random_curve(random, trial % 4 < 2);
    const Curve b = random_curve(random, trial % 2 == 0);
    MatchOptions options;
    options.pins = {{0.1, 1.4}, {0.15, 1.9}, {2.9, 2.0}};
    const Match found = match(a, b, options);
    EXPECT_EQ(found.report.direction, Direction::forward);
    expect_through_pins(a, b, found, options.pins);
    options.rotate = true;
    const Match turned = match(a, b, options);
    expect_through_pins(a, b, turned, options.pins);
    options.rotation = {0.6, 0.8};
    expect_through_pins(a, b, match(a, b, options), options.pins);
  }
}

TEST(Pins, FixTheDirection) {
  std::mt19937 random(8);
  const Curve a = random_curve(random, true);
  const Curve b = random_curve(random, true);
  MatchOptions options;
  options.pins = {{2.5, 0.5}, {0.5, 2.5}, {1.5, 1.5}};
  const Match found = match(a, b, options);
  EXPECT_EQ(found.report.direction, Direction::reversed);
  expect_through_pins(a, b, found, options.pins);
  options.direction = Direction::forward;
  EXPECT_THROW((void)match(a, b, options), InvalidArgument);
}

TEST(Pins, SayWhichOfThemAreWrong) {
  std::mt19937 random(9);
  const Curve a = random_curve(random, false);
  const Curve b = random_curve(random, false);
  const auto message = [&](const MatchOptions& options) {
    try {
      (void)match(a, b, options);
    } catch (const InvalidArgument& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  EXPECT_NE(message({.pins = {{0.5, 0.5}, {1.5, 2.5}, {2.5, 1.5}}}).find("(u = 1.5, v = 2.5)"),
            std::string::npos);
  EXPECT_NE(message({.pins = {{3.5, 0.5}}}).find("outside the first curve's domain [0, 3]"),
            std::string::npos);
  EXPECT_NE(message({.pins = {{0.5, 0.5}, {0.5, 0.7}}}).find("cross"), std::string::npos);
  EXPECT_NE(message({.pins = {{0.0, 0.7}}}).find("cross"), std::string::npos);
  EXPECT_EQ(message({.pins = {{0.0, 0.0}, {1.0, 1.0}}}), "no error");
  EXPECT_NE(message({.method = Method::segments, .pins = {{0.0, 0.7}}}).find("cross"), std::string::npos);
  EXPECT_NE(
      message({.reduction = ReductionOptions{.coefficients = 20}, .pins = {{1, 1}}}).find("coefficients"),
      std::string::npos);
}

TEST(Pins, AreTheSameFromBothSides) {
  std::mt19937 random(10);
  for (int trial = 0; trial < 8; ++trial) {
    const Curve a = random_curve(random, trial % 4 < 2);
    const Curve b = random_curve(random, trial % 2 == 0);
    const Match one = match(a, b, {.pins = {{0.7, 1.2}, {1.9, 2.1}}});
    const Match other = match(b, a, {.pins = {{1.2, 0.7}, {2.1, 1.9}}});
    EXPECT_NEAR(one.report.cost, other.report.cost, 1e-9);
    EXPECT_EQ(one.report.direction, other.report.direction);
  }
}

}  // namespace
}  // namespace tandem
