#include "surface/joint_matching.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curve/evaluator.h"
#include "curve/norm.h"
#include "match/path_correspondence.h"
#include "tandem/curve/arc_length.h"
#include "tandem/match/elastic.h"
#include "tandem/match/programme.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Nodes per section where the options do not say: those of match().
constexpr int kOpenNodes = 100;
constexpr int kClosedNodes = 128;
/// Of the arc lengths between nodes, relative: costs need no more.
constexpr double kLengthAccuracy = 1e-6;

/// The samples of a curve at parameters that are given.
Samples samples_at(const Curve& curve, const Samples& like) {
  Samples s;
  s.cyclic = like.cyclic;
  s.parameters = like.parameters;
  s.period = like.period;
  s.domain = like.domain;
  const std::size_t n = s.size();
  const auto dim = static_cast<std::size_t>(curve.dim());
  const ArcLength arc(curve, kLengthAccuracy);
  const auto length_to = [&](double t) {
    return t > s.domain.hi ? arc.length() + arc.length_to(t - s.period) : arc.length_to(t);
  };
  s.length = arc.length();
  s.positions = Points(curve.dim(), n);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = s.parameters[i] > s.domain.hi ? s.parameters[i] - s.period : s.parameters[i];
    const Point p = curve.evaluate(t);
    std::copy(p.begin(), p.end(), s.positions[i].begin());
  }
  const std::size_t chords = s.cyclic ? n : n - 1;
  s.chord_tangents = Points(curve.dim(), chords);
  for (std::size_t k = 0; k < chords; ++k) {
    const bool around = k + 1 == n;
    const auto tangent = s.chord_tangents[k];
    for (std::size_t c = 0; c < dim; ++c) tangent[c] = s.positions[around ? 0 : k + 1][c] - s.positions[k][c];
    const double chord = scaled_norm(tangent);
    for (double& x : tangent) x = chord > 0.0 ? x / chord : 0.0;
    const double next = around ? s.parameters[0] + s.period : s.parameters[k + 1];
    s.chord_lengths.push_back((length_to(next) - length_to(s.parameters[k])) / s.length);
  }
  // Nodes of this curve at which the other one has a corner are corners of the pair, too.
  s.corners = like.corners;
  s.curvatures.assign(chords, 0.0);
  s.tangents_in = s.positions;
  s.tangents_out = s.positions;
  s.speeds.assign(n, 1.0);
  return s;
}

SampleOptions sample_options(const MatchOptions& options, std::size_t side, bool cyclic) {
  SampleOptions how;
  how.count = options.samples[side] > 0 ? options.samples[side] : cyclic ? kClosedNodes : kOpenNodes;
  how.sampling = options.sampling.value_or(Sampling::arc);
  how.cyclic = cyclic;
  how.corner_angle = options.corner_angle;
  how.low_pass = options.low_pass;
  return how;
}

void add(EdgeTable& sum, const EdgeTable& table) {
  for (std::size_t i = 0; i < sum.cost.size(); ++i) {
    sum.cost[i] += table.cost[i];
    sum.invalid[i] += table.invalid[i];
  }
}

}  // namespace

std::vector<SectionPath> match_between(const Curve& section, const SectionPath& path,
                                       std::span<const Curve> neighbours, const MatchOptions& options) {
  const bool cyclic = path.correspondence.closed;
  const Samples nodes = sample(neighbours.front(), sample_options(options, 0, cyclic));
  Samples own = sample(section, sample_options(options, 1, cyclic));
  std::vector<double> corners;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own.corners[i]) corners.push_back(own.parameters[i]);
  }
  if (path.correspondence.reversed) own = reversed(own);

  const FeatureOptions features{
      .position_weight = options.features.position_weight, .lenient = options.features.lenient};
  EdgeTable table;
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    const Samples at = samples_at(neighbours[k], nodes);
    EdgeTable costs = edge_costs(at, own, chord_costs(at, own, options.norm, features), options.elastic);
    if (k == 0) {
      table = std::move(costs);
    } else {
      add(table, costs);
    }
  }
  const Path found = cyclic ? closed_path(table) : open_path(table);
  if (found.nodes.empty() || found.cancelled) return {};
  SectionPath better{
      path_parameters(nodes, own, found.nodes, path.correspondence.reversed, cyclic, true).correspondence, {}, {}};
  for (const double v : corners) better.corners.push_back(better.correspondence.u_at(v));
  return {std::move(better)};
}

std::vector<SectionPath> spread_round(const std::vector<SectionPath>& paths, const SectionPath& once_round) {
  const Correspondence& round = once_round.correspondence;
  // Of all turns of a loop the one that has the least left over.
  double mean = 0.0;
  for (const ParameterPair& point : round.points) mean += (point.v - point.u) / static_cast<double>(round.points.size());
  const double period = round.domain_u.length();
  const double turns = round.closed ? std::round(mean / period) * period : 0.0;

  std::vector<SectionPath> spread{paths.front()};
  for (std::size_t k = 1; k < paths.size(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(paths.size());
    Correspondence back;
    back.domain_u = round.domain_u;
    back.domain_v = round.domain_u;
    back.closed = round.closed;
    for (const ParameterPair& point : round.points) {
      const double there = point.v - turns;
      back.points.push_back({there, (1.0 - share) * there + share * point.u});
    }
    SectionPath moved = paths[k];
    for (ParameterPair& point : moved.correspondence.points) point.u = back.u_at(point.u);
    for (double& corner : moved.corners) corner = back.u_at(corner);
    spread.push_back(std::move(moved));
  }
  return spread;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
