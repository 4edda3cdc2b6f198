#include "match/path_correspondence.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Shares of an edge closer than this are one: two nodes meant to fall together, apart by rounding.
constexpr double kSameShare = 1e-12;

/// Unrolled access to the samples of one curve.
class Unrolled {
 public:
  explicit Unrolled(const Samples& samples) : samples_(samples), size_(static_cast<int>(samples.size())) {}

  [[nodiscard]] double parameter(int i) const {
    const int lap = i / size_;
    const double t = samples_.parameters[static_cast<std::size_t>(i - lap * size_)];
    return lap == 0 ? t : t + lap * samples_.period;
  }
  [[nodiscard]] bool corner(int i) const { return samples_.corners[static_cast<std::size_t>(i % size_)]; }

  /// Shares of the length between nodes i and j at which nodes stand, from 0 to 1; equal where it is none.
  [[nodiscard]] std::vector<double> shares(int i, int j) const {
    std::vector<double> at = {0.0};
    for (int k = i; k < j; ++k) {
      at.push_back(at.back() + samples_.chord_lengths[static_cast<std::size_t>(k % size_)]);
    }
    const double total = at.back();
    for (std::size_t k = 0; k < at.size(); ++k) {
      at[k] = total > 0.0 ? at[k] / total : static_cast<double>(k) / static_cast<double>(at.size() - 1);
    }
    at.back() = 1.0;
    return at;
  }

  /// The parameter at `share` of the way from node i on, given the nodes' shares; within a chord the
  /// parameter is taken as linear in the length.
  [[nodiscard]] double parameter_at(int i, const std::vector<double>& shares, double share) const {
    std::size_t k = 0;
    while (k + 2 < shares.size() && shares[k + 1] <= share) ++k;
    const double width = shares[k + 1] - shares[k];
    const double local = width > 0.0 ? (share - shares[k]) / width : 0.0;
    const double from = parameter(i + static_cast<int>(k));
    const double to = parameter(i + static_cast<int>(k) + 1);
    return from + std::clamp(local, 0.0, 1.0) * (to - from);
  }

 private:
  const Samples& samples_;
  int size_;
};

class PathWalk {
 public:
  PathWalk(const Samples& a, const Samples& b) : a_(a), b_(b) {}

  void add_node(Node node) {
    add({a_.parameter(node.i), b_.parameter(node.j)}, a_.corner(node.i) || b_.corner(node.j));
  }

  /// The points inside the edge from one node to the next.
  void add_edge(Node from, Node to) {
    const std::vector<double> at_a = a_.shares(from.i, to.i);
    const std::vector<double> at_b = b_.shares(from.j, to.j);
    std::size_t p = 1;
    std::size_t q = 1;
    while (p + 1 < at_a.size() || q + 1 < at_b.size()) {
      const double difference = at_a[p] - at_b[q];
      const bool same = difference <= kSameShare && difference >= -kSameShare;
      const bool on_a = same || difference < 0.0;
      const bool on_b = same || difference > 0.0;
      const int i = from.i + static_cast<int>(p);
      const int j = from.j + static_cast<int>(q);
      const double u = on_a ? a_.parameter(i) : a_.parameter_at(from.i, at_a, at_b[q]);
      const double v = on_b ? b_.parameter(j) : b_.parameter_at(from.j, at_b, at_a[p]);
      // Where one curve's last node falls within rounding of the edge's end, the end itself follows.
      if (i < to.i || j < to.j) add({u, v}, (on_a && a_.corner(i)) || (on_b && b_.corner(j)));
      if (on_a && p + 1 < at_a.size()) ++p;
      if (on_b && q + 1 < at_b.size()) ++q;
    }
  }

  std::vector<ParameterPair> points;
  std::vector<double> corners;

 private:
  void add(ParameterPair pair, bool corner) {
    points.push_back(pair);
    if (corner) corners.push_back(pair.u);
  }

  Unrolled a_;
  Unrolled b_;
};

Interval span_of(const std::vector<ParameterPair>& points, double ParameterPair::*member) {
  const double first = points.front().*member;
  const double last = points.back().*member;
  return {std::min(first, last), std::max(first, last)};
}

}  // namespace

PathParameters path_parameters(const Samples& a, const Samples& b, const std::vector<Node>& nodes,
                               bool reversed, bool closed, bool elastic) {
  PathWalk walk(a, b);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (n > 0 && elastic) walk.add_edge(nodes[n - 1], nodes[n]);
    walk.add_node(nodes[n]);
  }
  PathParameters result;
  Correspondence& c = result.correspondence;
  c.points = std::move(walk.points);
  c.closed = closed;
  c.reversed = reversed;
  if (reversed) {
    for (ParameterPair& pair : c.points) pair.v = b.domain.lo + (b.domain.hi - pair.v);
  }
  // A loop that was cut open has the domain that the cut gave it.
  c.domain_u = closed || !a.cyclic ? a.domain : span_of(c.points, &ParameterPair::u);
  c.domain_v = closed || !b.cyclic ? b.domain : span_of(c.points, &ParameterPair::v);
  for (double u : walk.corners) {
    result.corners.push_back(closed && u >= a.domain.hi ? u - a.period : u);
  }
  return result;
}

void keep_pins(PathParameters& path, const std::vector<ParameterPair>& pins) {
  Correspondence& c = path.correspondence;
  // Within this share of a domain two parameters are one; a cut moves them by roundings.
  constexpr double kSameShare = 1e-12;
  const auto same = [](double x, double y, const Interval& domain) {
    const double gap = std::remainder(x - y, domain.length());
    return std::fabs(gap) <= kSameShare * domain.length();
  };
  // An open curve's two ends are not the same: one is a remainder away from the other.
  const auto at = [&](const ParameterPair& p, const ParameterPair& pin) {
    return same(p.u, pin.u, c.domain_u) && same(p.v, pin.v, c.domain_v);
  };
  std::vector<ParameterPair> kept;
  const std::size_t n = c.points.size();
  for (std::size_t k = 0; k < n; ++k) {
    const ParameterPair& point = c.points[k];
    bool is_pin = false;
    bool beside = false;
    for (const ParameterPair& pin : pins) {
      if (at(point, pin)) {
        is_pin = true;
        path.corners.push_back(c.closed && point.u >= c.domain_u.hi ? point.u - c.domain_u.length()
                                                                    : point.u);
      } else if (k > 0 && k + 1 < n) {
        beside = beside || same(point.u, pin.u, c.domain_u) || same(point.v, pin.v, c.domain_v);
      }
    }
    if (is_pin || !beside) kept.push_back(point);
  }
  c.points = std::move(kept);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
