#include "match/make_report.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tandem/match/norm.h"
#include "tandem/match/programme.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

std::string name_of(const Norm& norm) {
  const auto* kind = std::get_if<NormKind>(&norm);
  if (kind == nullptr) return "user";
  switch (*kind) {
    case NormKind::ruled:
      return "ruled";
    case NormKind::distance:
      return "distance";
    case NormKind::bottleneck:
      return "bottleneck";
    case NormKind::tangent:
      break;
  }
  return "tangent";
}

std::vector<double> identity_rotation(int dim) {
  if (dim == 2) return {1.0, 0.0};
  std::vector<double> matrix(static_cast<std::size_t>(dim) * static_cast<std::size_t>(dim), 0.0);
  for (std::size_t k = 0; k < static_cast<std::size_t>(dim); ++k)
    matrix[k * static_cast<std::size_t>(dim) + k] = 1.0;
  return matrix;
}

/// What the paper's test calls invalid of its paths.
void add_invalid(MatchReport& report, const Samples& a, const Samples& b, const Path& path) {
  report.invalid_nodes = static_cast<int>(path.invalid);
  if (path.invalid == 0) return;
  // Each step's length, the mean of both curves', is shared by the nodes at its ends.
  const auto step_length = [](const Samples& s, int from, int to) {
    return from == to ? 0.0 : s.chord_lengths[static_cast<std::size_t>(from) % s.chords()];
  };
  for (std::size_t n = 1; n < path.nodes.size(); ++n) {
    const Node& from = path.nodes[n - 1];
    const Node& to = path.nodes[n];
    const double length = 0.5 * (step_length(a, from.i, to.i) + step_length(b, from.j, to.j));
    report.invalid_length += 0.5 * length * (path.invalid_nodes[n - 1] + path.invalid_nodes[n]);
  }
}

}  // namespace

// Samples of b between the starts of the two curves, in [0, m2).
int shift_of(const Node& first, int m1, int m2) {
  const int along = static_cast<int>(std::floor(static_cast<double>(first.i) * m2 / m1 + 0.5));
  return ((first.j - along) % m2 + m2) % m2;
}

MatchReport make_report(const Samples& a, const SearchResult& found, const MatchOptions& options,
                        Layout layout) {
  MatchReport report;
  const Samples& b = found.samples_b;
  const bool closed = is_closed_layout(layout);
  report.method = options.method;
  report.norm = name_of(options.norm);
  report.sampling =
      options.sampling.value_or(options.method == Method::paper ? Sampling::parameter : Sampling::arc);
  report.samples = {static_cast<int>(a.size()), static_cast<int>(b.size())};
  report.direction = found.reversed ? Direction::reversed : Direction::forward;
  report.rotation = identity_rotation(a.dim());
  report.exact = !options.coarse_to_fine;
  report.path = found.path.nodes;
  if (options.method == Method::elastic) {
    report.invalid_length = static_cast<double>(found.path.invalid) * kInvalidQuantum;
  } else {
    add_invalid(report, a, b, found.path);
  }
  report.cost = found.path.cost;
  report.mean_cost = report.cost;
  if (options.method == Method::paper) {
    report.cost += static_cast<double>(report.samples[0] + report.samples[1]) * report.invalid_nodes;
    const std::size_t counted = found.path.nodes.size() - (closed ? 1 : 0);
    report.mean_cost = report.cost / static_cast<double>(std::max<std::size_t>(counted, 1));
  }
  if (layout != Layout::open) {
    report.shift = shift_of(found.path.nodes.front(), report.samples[0], report.samples[1]);
  }
  return report;
}

int count_invalid_nodes(const std::vector<Node>& path, const Samples& a, const Samples& b,
                        const MatchOptions& options, bool closed) {
  const NodeTable chords = chord_costs(a, b, options.norm, options.features, RuledSign::product);
  // A node is invalid when the chords on one side of it are: the same from both ends.
  const auto invalid = [&](int i, int j) {
    const int rows = static_cast<int>(a.chords());
    const int cols = static_cast<int>(b.chords());
    if (a.cyclic) i = (i + rows) % rows;
    if (b.cyclic) j = (j + cols) % cols;
    if (i < 0 || i >= rows || j < 0 || j >= cols) return false;
    return chords.invalid[chords.index(static_cast<std::size_t>(i), static_cast<std::size_t>(j))] != 0;
  };
  int count = 0;
  for (std::size_t n = closed ? 1 : 0; n < path.size(); ++n) {
    const Node& node = path[n];
    if (invalid(node.i, node.j) || invalid(node.i - 1, node.j - 1)) ++count;
  }
  return count;
}

MatchReport make_report(const SegmentMatch& found, int dim, const MatchOptions& options) {
  MatchReport report;
  report.method = Method::segments;
  report.norm = options.segments.cost == SegmentCost::paper ? "paper" : "derivative";
  report.sampling = Sampling::parameter;
  const Node first = found.path.front();
  const Node last = found.path.back();
  // A loop's joints are distinct, an open path has one more than segments.
  const int ends = found.correspondence.closed ? 0 : 1;
  report.samples = {last.i - first.i + ends, last.j - first.j + ends};
  report.direction = found.direction;
  report.shift = found.shift;
  report.rotation = options.rotation.empty() ? identity_rotation(dim) : options.rotation;
  report.path = found.path;
  report.cost = found.cost;
  report.mean_cost = found.cost / static_cast<double>(found.a.segment_count());
  return report;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
