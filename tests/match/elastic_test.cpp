#include "tandem/match/elastic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "match/brute_force.h"
#include "match/instruction_sets.h"
#include "match/random_curves.h"
#include "match/search_near.h"
#include "tandem/curve/arc_length.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"
#include "tandem/match/match.h"

namespace tandem {
namespace {

using brute::Found;
using testing_curves::closed_curve;
using testing_curves::open_curve;
using testing_curves::uniform;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The programme as a textbook has it, from one start; tables that are too large for all paths.
Found plain_from(const EdgeTable& t, int k, int l, int rows, int cols) {
  std::vector<Found> cells(static_cast<std::size_t>((rows + 1) * (cols + 1)));
  const auto cell = [&](int i, int j) -> Found& {
    return cells[static_cast<std::size_t>(i * (cols + 1) + j)];
  };
  cell(0, 0).offer(0, 0.0);
  for (int i = 1; i <= rows; ++i) {
    for (int j = 1; j <= cols; ++j) {
      for (std::size_t s = 0; s < t.steps.size(); ++s) {
        const Step step = t.steps[s];
        if (step.a > i || step.b > j) continue;
        const Found& from = cell(i - step.a, j - step.b);
        const std::size_t e =
            t.index(static_cast<std::size_t>(k + i) % t.rows, s, static_cast<std::size_t>(l + j) % t.cols);
        if (from.cost == kInfinity || t.cost[e] == kInfinity) continue;
        cell(i, j).offer(from.invalid + static_cast<std::int64_t>(t.invalid[e]), from.cost + t.cost[e]);
      }
    }
  }
  return cell(rows, cols);
}

Found plain(const EdgeTable& t) {
  const int rows = static_cast<int>(t.rows) - (t.rows_cyclic ? 0 : 1);
  const int cols = static_cast<int>(t.cols) - (t.cols_cyclic ? 0 : 1);
  Found best;
  for (int k = 0; k < (t.rows_cyclic ? rows : 1); ++k) {
    for (int l = 0; l < (t.cols_cyclic ? std::min(cols, 6) : 1); ++l) {
      const Found found = plain_from(t, k, l, rows, cols);
      best.offer(found.invalid, found.cost);
    }
  }
  return best;
}

Path programme(const EdgeTable& t) {
  if (t.cols_cyclic) return closed_path(t);
  return t.rows_cyclic ? cut_path(t) : open_path(t);
}

/// The path's own sums, in units of the table.
Found sums_along(const EdgeTable& t, const Path& path) {
  Found sum{0, 0.0};
  for (std::size_t n = 1; n < path.nodes.size(); ++n) {
    const Node from = path.nodes[n - 1];
    const Node to = path.nodes[n];
    const auto step = std::find(t.steps.begin(), t.steps.end(), Step{to.i - from.i, to.j - from.j});
    if (step == t.steps.end()) return {};
    const std::size_t e =
        t.index(static_cast<std::size_t>(to.i) % t.rows, static_cast<std::size_t>(step - t.steps.begin()),
                static_cast<std::size_t>(to.j) % t.cols);
    sum.invalid += static_cast<std::int64_t>(t.invalid[e]);
    sum.cost += t.cost[e];
  }
  return sum;
}

EdgeTable random_edges(std::mt19937& random, int layout, int most) {
  EdgeTable t;
  t.rows = 2 + random() % static_cast<unsigned>(most - 1);
  t.cols = 2 + random() % static_cast<unsigned>(most - 1);
  t.rows_cyclic = layout > 0;
  t.cols_cyclic = layout > 1;
  t.steps = coprime_steps(1 + static_cast<int>(random() % 6));
  // Eighths: sums are exact. Few levels: ties and plateaus; many: none.
  const unsigned levels = 1 + random() % (random() % 2 == 0 ? 6 : 4096);
  const unsigned invalid_odds = random() % 4;
  const unsigned barred_odds = random() % 3;
  for (std::size_t k = 0; k < t.rows * t.cols * t.steps.size(); ++k) {
    t.cost.push_back(random() % 8 < barred_odds ? kInfinity : static_cast<double>(random() % levels) / 8.0);
    t.invalid.push_back(random() % 8 < invalid_odds ? static_cast<double>(1 + random() % 3) : 0.0);
  }
  return t;
}

void expect_optimal(const EdgeTable& t, const Path& path, const Found& best, double tolerance) {
  ASSERT_EQ(path.nodes.empty(), best.cost == kInfinity);
  if (path.nodes.empty()) return;
  const Found along = sums_along(t, path);
  ASSERT_EQ(path.invalid, best.invalid);
  ASSERT_EQ(along.invalid, best.invalid);
  ASSERT_NEAR(path.cost, best.cost, tolerance * best.cost);
  ASSERT_NEAR(along.cost, path.cost, tolerance * best.cost);
}

TEST(ElasticProgramme, EqualsThePlainProgrammeOnTables) {
  std::mt19937 random(31);
  for (int n = 0; n < 12000; ++n) {
    const EdgeTable t = random_edges(random, n % 3, n % 40 == 0 ? 21 : 9);
    expect_optimal(t, programme(t), plain(t), 0.0);
  }
}

/// A loop or an open curve with corners, straight parts and repeated shapes, or none of them.
Curve any_curve(std::mt19937& random, bool closed) {
  if (random() % 2 == 0) return closed ? closed_curve(random) : open_curve(random);
  const std::size_t corners = 3 + random() % 5;
  Points points(2, 0);
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle = 6.283185307179586 * static_cast<double>(k) / static_cast<double>(corners);
    const double radius = k % 2 == 0 ? 1.0 : static_cast<double>(1 + random() % 3);
    points.push_back(std::vector<double>{radius * std::cos(angle), radius * std::sin(angle)});
  }
  if (closed) points.push_back(std::vector<double>(points[0].begin(), points[0].end()));
  std::vector<double> knots = {0.0};
  for (std::size_t k = 0; k < points.size(); ++k) knots.push_back(static_cast<double>(k));
  knots.push_back(knots.back());
  return Curve(1, std::move(knots), std::move(points));
}

struct Edges {
  Samples a;
  Samples b;
  EdgeTable table;
};

Edges edges_of_curves(std::mt19937& random, int layout, int most, Sampling sampling) {
  const auto samples = [&](bool closed) {
    return sample(any_curve(random, closed),
                  {.count = 5 + static_cast<int>(random() % static_cast<unsigned>(most - 4)),
                   .sampling = sampling,
                   .cyclic = closed});
  };
  Edges e{samples(layout > 0), samples(layout > 1), {}};
  e.table = edge_costs(e.a, e.b, chord_costs(e.a, e.b, NormKind::tangent));
  return e;
}

TEST(ElasticProgramme, EqualsThePlainProgrammeOnCurves) {
  std::mt19937 random(32);
  for (int n = 0; n < 3000; ++n) {
    const Edges e = edges_of_curves(random, n % 3, n % 30 < 3 ? 27 : 12,
                                    n % 2 == 0 ? Sampling::arc : Sampling::parameter);
    expect_optimal(e.table, programme(e.table), plain(e.table), 1e-12);
  }
}

/// The integral of one edge from its definition: cells from the breakpoints of both curves.
struct Integral {
  double cost = 0.0;
  double invalid = 0.0;
};
Integral integrate(const Edges& e, const NodeTable& chords, int i, int j, Step step) {
  const auto chord_of = [](const Samples& s, int k) {
    const int n = static_cast<int>(s.chords());
    return static_cast<std::size_t>((k % n + n) % n);
  };
  std::vector<double> at_a = {0.0};
  std::vector<double> at_b = {0.0};
  for (int k = i - step.a; k < i; ++k) at_a.push_back(at_a.back() + e.a.chord_lengths[chord_of(e.a, k)]);
  for (int k = j - step.b; k < j; ++k) at_b.push_back(at_b.back() + e.b.chord_lengths[chord_of(e.b, k)]);
  const double length = at_a.back() + at_b.back();
  const double difference = at_a.back() - at_b.back();
  Integral sum{0.02 * difference * difference / length, 0.0};
  for (int p = 0; p < step.a; ++p) {
    for (int q = 0; q < step.b; ++q) {
      const auto share = [](const std::vector<double>& at, int k) {
        return at[static_cast<std::size_t>(k)] / at.back();
      };
      const double overlap =
          std::min(share(at_a, p + 1), share(at_b, q + 1)) - std::max(share(at_a, p), share(at_b, q));
      if (overlap < 1e-12) continue;
      const std::size_t k = chords.index(chord_of(e.a, i - step.a + p), chord_of(e.b, j - step.b + q));
      sum.cost += overlap * 0.5 * length * chords.cost[k];
      sum.invalid += overlap * 0.5 * length * chords.invalid[k];
    }
  }
  return sum;
}

TEST(EdgeCosts, AreTheIntegralsOfTheirDefinition) {
  std::mt19937 random(33);
  for (int n = 0; n < 120; ++n) {
    const Edges e = edges_of_curves(random, n % 3, 40, n % 2 == 0 ? Sampling::arc : Sampling::parameter);
    const EdgeTable& t = e.table;
    const NodeTable chords = chord_costs(e.a, e.b, NormKind::tangent);
    for (int i = 0; i < static_cast<int>(t.rows); ++i) {
      for (std::size_t s = 0; s < t.steps.size(); ++s) {
        for (int j = 0; j < static_cast<int>(t.cols); ++j) {
          const std::size_t k = t.index(static_cast<std::size_t>(i), s, static_cast<std::size_t>(j));
          if ((!t.rows_cyclic && t.steps[s].a > i) || (!t.cols_cyclic && t.steps[s].b > j)) {
            ASSERT_EQ(t.cost[k], kInfinity);
            continue;
          }
          const Integral expected = integrate(e, chords, i, j, t.steps[s]);
          ASSERT_NEAR(t.cost[k], expected.cost, 1e-14);
          ASSERT_NEAR(t.invalid[k] * kInvalidQuantum, expected.invalid, 0.51 * kInvalidQuantum);
          ASSERT_EQ(t.invalid[k] > 0.0, expected.invalid > 0.0);
          ASSERT_EQ(t.invalid[k], std::floor(t.invalid[k]));
        }
      }
    }
  }
}

/// What match() runs computes edges as it goes; it must find what the programme finds in the table of them
/// all.
TEST(ElasticProgramme, NeedsNoTableOfAllEdges) {
  std::mt19937 random(34);
  for (int n = 0; n < 300; ++n) {
    const Edges e = edges_of_curves(random, n % 3, 60, Sampling::arc);
    const Path from_table = programme(e.table);
    const Path direct = elastic_path(e.a, e.b, chord_costs(e.a, e.b, NormKind::tangent));
    ASSERT_EQ(direct.nodes.empty(), from_table.nodes.empty());
    if (direct.nodes.empty()) continue;
    EXPECT_EQ(direct.invalid, from_table.invalid);
    EXPECT_NEAR(direct.cost, from_table.cost, 1e-13);
  }
}

/// Everything a path of the elastic programme says, as bits.
bool same(const Path& x, const Path& y) {
  return x.nodes == y.nodes && x.cost == y.cost && x.invalid == y.invalid;
}

TEST(ElasticProgramme, EveryInstructionSetAndThreadCountGivesTheSameBits) {
  struct Case {
    Samples a;
    Samples b;
    detail::SamplePair coarse;
    detail::Layout layout;
    Path path;
    Path fast;
    EdgeTable table;
  };
  std::mt19937 random(35);
  std::vector<Case> cases;
  for (int n = 0; n < 24; ++n) {
    const bool closed = n % 2 == 0;
    const Curve a = any_curve(random, closed);
    const Curve b = any_curve(random, closed);
    const auto samples = [&](const Curve& c, int count) {
      return sample(c, {.count = count, .cyclic = closed});
    };
    const int m1 = 40 + static_cast<int>(random() % 60);
    const int m2 = 40 + static_cast<int>(random() % 60);
    Case c{samples(a, m1),
           samples(b, m2),
           {samples(a, m1 / 4), samples(b, m2 / 4)},
           closed ? detail::Layout::toroidal : detail::Layout::open,
           {},
           {},
           {}};
    c.path = detail::search(c.a, c.b, {.threads = 1}, c.layout).path;
    c.fast = detail::search_near(c.coarse, {c.a, c.b}, {.threads = 1}, c.layout).path;
    c.table = edge_costs(c.a, c.b, chord_costs(c.a, c.b, NormKind::tangent));
    cases.push_back(std::move(c));
  }
  int sets = 0;
  for_each_instruction_set([&](const char* name) {
    ++sets;
    for (const Case& c : cases) {
      for (const int threads : {1, 2, 4}) {
        EXPECT_TRUE(same(detail::search(c.a, c.b, {.threads = threads}, c.layout).path, c.path))
            << name << ", " << threads << " threads";
      }
      EXPECT_TRUE(same(detail::search_near(c.coarse, {c.a, c.b}, {.threads = 2}, c.layout).path, c.fast))
          << name;
      const EdgeTable table = edge_costs(c.a, c.b, chord_costs(c.a, c.b, NormKind::tangent));
      EXPECT_EQ(table.cost, c.table.cost) << name;
      EXPECT_EQ(table.invalid, c.table.invalid) << name;
    }
  });
  EXPECT_GE(sets, 1);
}

/// The samples of a loop, begun `by` nodes later.
Samples rotated(const Samples& s, std::size_t by) {
  Samples r = s;
  const auto turn = [by](auto& values) {
    std::rotate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(by), values.end());
  };
  turn(r.parameters);
  for (std::size_t k = s.size() - by; k < s.size(); ++k) r.parameters[k] += s.period;
  turn(r.speeds);
  turn(r.corners);
  turn(r.chord_lengths);
  turn(r.curvatures);
  for (const auto& [from, to] :
       {std::pair{&s.positions, &r.positions}, std::pair{&s.tangents_in, &r.tangents_in},
        std::pair{&s.tangents_out, &r.tangents_out}, std::pair{&s.chord_tangents, &r.chord_tangents}}) {
    for (std::size_t k = 0; k < s.size(); ++k) {
      const auto source = (*from)[(k + by) % s.size()];
      std::copy(source.begin(), source.end(), (*to)[k].begin());
    }
  }
  return r;
}

/// The pairs of a closed path, each once, in the order of the first curve, with this offset of both.
std::vector<std::pair<std::size_t, std::size_t>> pairs_of(const Path& path, const Samples& a,
                                                          const Samples& b, std::size_t offset_a,
                                                          std::size_t offset_b) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t n = 1; n < path.nodes.size(); ++n) {
    pairs.emplace_back((static_cast<std::size_t>(path.nodes[n].i) + offset_a) % a.size(),
                       (static_cast<std::size_t>(path.nodes[n].j) + offset_b) % b.size());
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(StartPoint, OfTheSamplesDoesNotMatter) {
  std::mt19937 random(36);
  for (int n = 0; n < 24; ++n) {
    const Samples a = sample(closed_curve(random), {.count = 48, .cyclic = true});
    const Samples b = sample(closed_curve(random), {.count = 40 + n, .cyclic = true});
    for (const Method method : {Method::elastic, Method::paper}) {
      const MatchOptions options{.method = method, .threads = 1};
      const detail::SearchResult plain = detail::search(a, b, options, detail::Layout::toroidal);
      const std::size_t by_a = 1 + random() % (a.size() - 1);
      const std::size_t by_b = 1 + random() % (b.size() - 1);
      const Samples other_a = rotated(a, by_a);
      const Samples other_b = rotated(b, by_b);
      const detail::SearchResult turned = detail::search(other_a, other_b, options, detail::Layout::toroidal);
      EXPECT_NEAR(turned.path.cost, plain.path.cost, 1e-12 * std::max(1.0, plain.path.cost));
      EXPECT_EQ(turned.path.invalid, plain.path.invalid);
      ASSERT_EQ(turned.reversed, plain.reversed);
      // Node k of the reversed samples is node -k, or -k - 1, of b: a place in b tells which.
      const auto node_of = [&](std::size_t k) {
        std::size_t nearest = 0;
        double least = kInfinity;
        for (std::size_t j = 0; j < b.size(); ++j) {
          double d = 0.0;
          for (std::size_t c = 0; c < 2; ++c) {
            d += std::fabs(turned.samples_b.positions[k][c] - plain.samples_b.positions[j][c]);
          }
          if (d < least) {
            least = d;
            nearest = j;
          }
        }
        return nearest;
      };
      auto there = pairs_of(turned.path, a, b, by_a, 0);
      for (auto& pair : there) pair.second = node_of(pair.second);
      std::sort(there.begin(), there.end());
      EXPECT_EQ(there, pairs_of(plain.path, a, b, 0, 0));
    }
  }
}

/// Correspondences of two curves and of the same with their seams moved, apart at most by this share of the
/// second one's length.
double moved_by(const Curve& a, const Curve& b, std::mt19937& random, const MatchOptions& options) {
  const double seam_a = uniform(random, 0.1, 0.9);
  const double seam_b = uniform(random, 0.1, 0.9);
  const Match plain = match(a, b, options);
  const Match moved = match(move_seam(a, seam_a), move_seam(b, seam_b), options);
  EXPECT_EQ(plain.report.direction, moved.report.direction);
  const ArcLength arc(b);
  const auto length_at = [&](double v) { return arc.length_to(v - std::floor(v)) / arc.length(); };
  double worst = 0.0;
  for (int k = 0; k < 200; ++k) {
    const double u = seam_a + k / 200.0;
    const double d =
        std::fabs(length_at(plain.correspondence.v_at(u)) - length_at(moved.correspondence.v_at(u)));
    worst = std::max(worst, std::min(d, 1.0 - d));
  }
  return worst;
}

TEST(StartPoint, OfTheCurvesDoesNotMatter) {
  std::mt19937 random(37);
  int compared = 0;
  for (int n = 0; n < 20; ++n) {
    const Curve a = closed_curve(random);
    const Curve b = closed_curve(random);
    for (const Method method : {Method::elastic, Method::paper}) {
      MatchOptions options{.method = method, .sampling = Sampling::arc, .threads = 1};
      // Only where the other direction is clearly worse.
      options.direction = Direction::forward;
      const double forward = match(a, b, options).report.cost;
      options.direction = Direction::reversed;
      const double reversed = match(a, b, options).report.cost;
      options.direction = Direction::automatic;
      if (std::fabs(forward - reversed) <= 1e-6 * forward) continue;
      ++compared;
      EXPECT_LE(moved_by(a, b, random, options), 0.005);
    }
  }
  EXPECT_GE(compared, 30);
}

TEST(EdgeCosts, SayWhatIsWrong) {
  std::mt19937 random(38);
  const Samples a = sample(open_curve(random), {.count = 10});
  const NodeTable chords = chord_costs(a, a, NormKind::tangent);
  EXPECT_THROW((void)edge_costs(a, a, chords, {.lambda = -1.0}), InvalidArgument);
  EXPECT_THROW((void)edge_costs(a, a, chords, {.longest_step = 0}), InvalidArgument);
  EXPECT_THROW((void)edge_costs(a, sample(open_curve(random), {.count = 11}), chords), InvalidArgument);
  const Samples loop = sample(closed_curve(random), {.count = 9, .cyclic = true});
  EXPECT_THROW((void)elastic_path(a, loop, chord_costs(a, loop, NormKind::tangent)), InvalidArgument);
}

}  // namespace
}  // namespace tandem
