#include "tandem/match/samples.h"

#include <algorithm>
#include <cmath>

#include "curve/evaluator.h"
#include "match/node_placement.h"
#include "match/tangent.h"
#include "match/vector.h"
#include "tandem/curve/arc_length.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

namespace {

using detail::PlacedNode;

/// Curves far from size 1 are sampled after scaling by a power of two (exact), so that squares stay in range.
constexpr double kLargestExtent = 1e100;

Curve scaled(const Curve& curve, double factor) {
  Points points = curve.control_points();
  for (double& c : points.data()) c *= factor;
  return Curve(curve.degree(), curve.knots(), std::move(points), curve.weights());
}

/// Both lists, which are increasing; where two are one but for rounding, that of the second.
std::vector<double> merged(const std::vector<double>& x, const std::vector<double>& y,
                           const Interval& domain) {
  const double rounding = 1e-13 * domain.length();
  std::vector<double> all = y;
  for (double t : x) {
    const auto next = std::lower_bound(y.begin(), y.end(), t);
    const bool near =
        (next != y.end() && *next - t <= rounding) || (next != y.begin() && t - *(next - 1) <= rounding);
    if (!near) all.push_back(t);
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<PlacedNode> place_by_parameter(const Curve& curve, const SampleOptions& options) {
  const Interval domain = curve.domain();
  const int intervals = options.cyclic ? options.count : options.count - 1;
  std::vector<PlacedNode> nodes;
  std::vector<double> uniform;
  for (int i = 0; i < options.count; ++i) {
    uniform.push_back(i == intervals ? domain.hi : domain.lo + domain.length() * i / intervals);
  }
  for (double t : merged(uniform, options.nodes, domain)) nodes.push_back({t, 0.0});
  return nodes;
}

/// Positions, tangents and speeds at the parameters.
void evaluate_nodes(const Curve& curve, Samples& s) {
  const detail::Evaluator evaluator(curve);
  const std::size_t n = s.parameters.size();
  const int dim = curve.dim();
  const double extent = curve.extent();
  const double angle_tolerance = 1e-6;  // rad; tangents that agree so well are no corner
  s.positions = Points(dim, n);
  s.tangents_in = Points(dim, n);
  s.tangents_out = Points(dim, n);
  s.speeds.resize(n);
  s.corners.assign(n, false);
  const std::vector<double>& knots = curve.knots();
  for (std::size_t i = 0; i < n; ++i) {
    const double t = s.parameters[i];
    evaluator.point(t, s.positions[i]);
    const double speed = detail::one_sided_tangent(evaluator, t, Side::right, extent, s.tangents_out[i]);
    s.speeds[i] = speed * s.domain.length() / extent;
    const bool at_seam = s.cyclic && t == s.domain.lo;
    const bool at_end = !s.cyclic && (i == 0 || i + 1 == n);
    const bool at_knot = at_seam || std::binary_search(knots.begin(), knots.end(), t) || speed == 0.0;
    if (at_end || !at_knot) {
      std::copy(s.tangents_out[i].begin(), s.tangents_out[i].end(), s.tangents_in[i].begin());
      continue;
    }
    detail::one_sided_tangent(evaluator, at_seam ? s.domain.hi : t, Side::left, extent, s.tangents_in[i]);
    s.corners[i] = detail::distance(s.tangents_in[i], s.tangents_out[i]) > angle_tolerance;
  }
}

/// Smooths the positions with a triweight kernel of standard deviation `sigma` over the normalised length
/// (close to a Gaussian, of finite support, and without library functions). Open curves are reflected at
/// their ends, which stay where they are.
Points low_passed(const Samples& s, double sigma) {
  const std::size_t n = s.size();
  const auto dim = static_cast<std::size_t>(s.dim());
  const double reach = 3.0 * sigma;
  std::vector<double> at(n);
  for (std::size_t i = 1; i < n; ++i) at[i] = at[i - 1] + s.chord_lengths[i - 1];
  // A node stands for half of the chords beside it.
  std::vector<double> share(n);
  for (std::size_t k = 0; k < s.chords(); ++k) {
    share[k] += 0.5 * s.chord_lengths[k];
    share[(k + 1) % n] += 0.5 * s.chord_lengths[k];
  }
  Points smooth(s.dim(), n);
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<double> sum(dim);
    double weight = 0.0;
    const auto add = [&](std::size_t j, double offset, int mirror) {
      const double x = offset / reach;
      if (x <= -1.0 || x >= 1.0) return;
      const double base = 1.0 - x * x;
      const double w = base * base * base * share[j];
      weight += w;
      for (std::size_t c = 0; c < dim; ++c) {
        const double p = s.positions[j][c];
        const double image = mirror == 0 ? p : 2.0 * s.positions[mirror < 0 ? 0 : n - 1][c] - p;
        sum[c] += w * image;
      }
    };
    for (std::size_t j = 0; j < n; ++j) {
      add(j, at[j] - at[i], 0);
      if (s.cyclic) {
        add(j, at[j] - at[i] + 1.0, 0);
        add(j, at[j] - at[i] - 1.0, 0);
      } else {
        add(j, -at[j] - at[i], -1);
        add(j, 2.0 - at[j] - at[i], 1);
      }
    }
    for (std::size_t c = 0; c < dim; ++c) smooth[i][c] = weight > 0.0 ? sum[c] / weight : s.positions[i][c];
  }
  return smooth;
}

/// Chord tangents and, where the placement did not know them, chord lengths (of the polygon of nodes).
void measure_chords(Samples& s, const std::vector<PlacedNode>& nodes, bool known_lengths) {
  const std::size_t n = s.size();
  const std::size_t chords = s.cyclic ? n : n - 1;
  s.chord_tangents = Points(s.dim(), chords);
  s.chord_lengths.resize(chords);
  double total = 0.0;
  for (std::size_t k = 0; k < chords; ++k) {
    const auto from = s.positions[k];
    const auto to = s.positions[(k + 1) % n];
    const auto tangent = s.chord_tangents[k];
    for (std::size_t c = 0; c < tangent.size(); ++c) tangent[c] = to[c] - from[c];
    const double length = detail::normalize(tangent);
    s.chord_lengths[k] = known_lengths ? nodes[k].chord : length;
    total += s.chord_lengths[k];
  }
  if (!known_lengths) s.length = total;
  for (double& length : s.chord_lengths) length /= s.length;
}

/// Turning per unit of length over each chord, from its two neighbours.
void measure_curvature(Samples& s) {
  const std::size_t chords = s.chords();
  s.curvatures.assign(chords, 0.0);
  for (std::size_t k = 0; k < chords; ++k) {
    if (!s.cyclic && (k == 0 || k + 1 == chords)) continue;
    const auto before = s.chord_tangents[(k + chords - 1) % chords];
    const auto after = s.chord_tangents[(k + 1) % chords];
    const double length = s.chord_lengths[k] + 0.5 * (s.chord_lengths[(k + chords - 1) % chords] +
                                                      s.chord_lengths[(k + 1) % chords]);
    if (!(length > 0.0)) continue;
    const double cosine = detail::dot(before, after);
    const double sine =
        s.dim() == 2 ? detail::cross(before, after) : std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    // 2 tan(angle / 2), the angle to second order; capped where the chords nearly reverse.
    s.curvatures[k] = 2.0 * sine / std::max(1.0 + cosine, 0.1) / length;
  }
}

}  // namespace

Samples sample(const Curve& original, const SampleOptions& options) {
  if (options.count < (options.cyclic ? 3 : 2)) {
    throw InvalidArgument("a curve needs at least 2 samples, a loop 3; asked for " +
                          std::to_string(options.count));
  }
  if (options.cyclic && !original.is_closed())
    throw InvalidArgument("an open curve cannot be sampled as a loop");
  if (!(options.low_pass >= 0.0 && options.low_pass <= 0.5)) {
    throw InvalidArgument("the low-pass width must lie in [0, 0.5] of the length");
  }
  const double extent = original.extent();
  if (!(extent > 0.0)) throw InvalidArgument("the curve is a single point: it has no direction to match");
  const bool rescale = extent > kLargestExtent || extent < 1.0 / kLargestExtent;
  const double factor = rescale ? std::scalbn(1.0, -std::ilogb(extent)) : 1.0;
  if (rescale && !std::isfinite(factor))
    throw InvalidArgument("the curve is smaller than a double can resolve");
  const Curve& curve = rescale ? scaled(original, factor) : original;

  Samples s;
  s.cyclic = options.cyclic;
  s.domain = curve.domain();
  s.period = s.domain.length();
  std::vector<PlacedNode> nodes;
  const bool by_length = options.sampling != Sampling::parameter;
  if (by_length) {
    const ArcLength arc(curve);
    s.length = arc.length();
    if (!(s.length > 0.0)) throw InvalidArgument("the curve has no length: it has no direction to match");
    const std::vector<double> corners =
        detail::find_corners(curve, options.corner_angle, options.cyclic, options.count);
    nodes = detail::place_by_length(curve, arc, merged(corners, options.nodes, curve.domain()), options);
  } else {
    nodes = place_by_parameter(curve, options);
  }
  s.parameters.reserve(nodes.size());
  for (const PlacedNode& node : nodes) s.parameters.push_back(node.parameter);
  evaluate_nodes(curve, s);
  measure_chords(s, nodes, by_length);
  if (!(s.length > 0.0)) throw InvalidArgument("the curve does not move between its samples");
  if (options.low_pass > 0.0) {
    s.positions = low_passed(s, options.low_pass);
    const std::vector<double> lengths = s.chord_lengths;
    const double length = s.length;
    measure_chords(s, nodes, by_length);
    s.chord_lengths = lengths;
    s.length = length;
    const std::size_t chords = s.chords();
    for (std::size_t i = 0; i < s.size(); ++i) {
      const auto before = s.chord_tangents[s.cyclic ? (i + chords - 1) % chords : (i == 0 ? 0 : i - 1)];
      const auto after = s.chord_tangents[std::min(i, chords - 1)];
      std::copy(before.begin(), before.end(), s.tangents_in[i].begin());
      std::copy(after.begin(), after.end(), s.tangents_out[i].begin());
    }
  }
  measure_curvature(s);
  if (rescale) {
    for (double& c : s.positions.data()) c /= factor;
    s.length /= factor;
  }
  return s;
}

Samples reversed(const Samples& s) {
  const std::size_t n = s.size();
  const std::size_t chords = s.chords();
  Samples r;
  r.cyclic = s.cyclic;
  r.domain = s.domain;
  r.period = s.period;
  r.length = s.length;
  r.positions = Points(s.dim(), n);
  r.tangents_in = Points(s.dim(), n);
  r.tangents_out = Points(s.dim(), n);
  r.chord_tangents = Points(s.dim(), chords);
  const auto negate = [](std::span<const double> from, std::span<double> to) {
    for (std::size_t c = 0; c < to.size(); ++c) to[c] = -from[c];
  };
  // A node on the seam stays node 0 of a loop.
  const bool keep_first = s.cyclic && s.parameters.front() == s.domain.lo;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = keep_first ? (n - i) % n : n - 1 - i;
    r.parameters.push_back(keep_first && i == 0 ? s.domain.lo
                                                : s.domain.lo + (s.domain.hi - s.parameters[k]));
    r.speeds.push_back(s.speeds[k]);
    r.corners.push_back(s.corners[k]);
    std::copy(s.positions[k].begin(), s.positions[k].end(), r.positions[i].begin());
    negate(s.tangents_out[k], r.tangents_in[i]);
    negate(s.tangents_in[k], r.tangents_out[i]);
    if (i >= chords) continue;
    // Chord i of the result leads from node k to the node before it.
    const std::size_t chord = (k + chords - 1) % chords;
    r.chord_lengths.push_back(s.chord_lengths[chord]);
    r.curvatures.push_back(s.dim() == 2 ? -s.curvatures[chord] : s.curvatures[chord]);
    negate(s.chord_tangents[chord], r.chord_tangents[i]);
  }
  return r;
}

}  // namespace v0
}  // namespace tandem
