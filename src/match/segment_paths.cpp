#include "match/segment_paths.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "match/pinned_path.h"
#include "shape/cubic_fit.h"
#include "tandem/match/rotation.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Curves that are no cubics are met within this share of their size.
constexpr double kFitTolerance = 1e-6;

/// Loops of fewer segments get nodes at their thirds, too: samples know no smaller loop, and between the
/// joints of a single segment it does not get on.
constexpr std::size_t kSmallestLoop = 3;

double tolerance_for(const Curve& curve) {
  const double size = curve.extent();
  return size > 0.0 ? kFitTolerance * size : kFitTolerance;
}

/// The curve's parameter that belongs to the path's; both run on past the end of a loop.
double parameter_at(const std::vector<double>& breaks, double x) {
  const auto n = static_cast<double>(breaks.size() - 1);
  double lap = 0.0;
  if (x < 0.0 || x > n) lap = std::floor(x / n);
  x -= lap * n;
  const auto i = static_cast<std::size_t>(std::clamp(std::floor(x), 0.0, n - 1.0));
  const double local = x - static_cast<double>(i);
  const double t = (1.0 - local) * breaks[i] + local * breaks[i + 1];
  return lap == 0.0 ? t : t + lap * (breaks.back() - breaks.front());
}

/// The path's parameter that belongs to the curve's, inside of its domain.
double path_parameter_at(const std::vector<double>& breaks, double t) {
  const auto next = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, t);
  const double lo = *(next - 1);
  return static_cast<double>(next - 1 - breaks.begin()) + (t - lo) / (*next - lo);
}

/// A curve as a path with joints at its pins.
struct JointedPath {
  CubicPath path;
  std::vector<double> breaks;  ///< the curve's parameters at the joints
  std::vector<double> pins;    ///< joints
};

JointedPath jointed_path(const Curve& curve, const std::vector<double>& pins, bool loop) {
  const CubicPath path = to_cubic_path(curve, tolerance_for(curve));
  const std::vector<double> breaks = cubic_breaks(curve, tolerance_for(curve));
  std::vector<double> at;
  at.reserve(pins.size());
  for (const double pin : pins) at.push_back(path_parameter_at(breaks, pin));
  PinnedPath split = split_at_pins(path, at, loop);
  JointedPath result{std::move(split.path), {}, {}};
  for (const double joint : split.joints) result.breaks.push_back(parameter_at(breaks, joint));
  for (std::size_t k = 0; k < pins.size(); ++k) {
    const std::size_t joint = split.pins[k];
    // Split where it was asked for, to the bit.
    if (split.joints[joint] == at[k]) result.breaks[joint] = pins[k];
    result.pins.push_back(static_cast<double>(joint));
  }
  return result;
}

/// Nodes at the joints of the path, by the curve's parameters.
Samples sample_joints(const CubicPath& path, const std::vector<double>& breaks, bool loop) {
  const std::size_t segments = path.segment_count();
  const std::size_t parts = path.is_closed() && segments < kSmallestLoop ? 3 : 1;
  SampleOptions options;
  options.cyclic = loop;
  options.count = static_cast<int>(parts * segments) + (loop ? 0 : 1);
  options.sampling = Sampling::parameter;
  Samples samples = sample(to_curve(path), options);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    samples.parameters[k] = parameter_at(breaks, static_cast<double>(k) / static_cast<double>(parts));
  }
  samples.domain = {breaks.front(), breaks.back()};
  samples.period = loop ? samples.domain.length() : 0.0;
  return samples;
}

Interval interval_at(const std::vector<double>& breaks, const Interval& x) {
  return {parameter_at(breaks, x.lo), parameter_at(breaks, x.hi)};
}

}  // namespace

SegmentPaths segment_paths(const Curve& a, const Curve& b, Layout layout,
                           std::span<const ParameterPair> pins) {
  const bool loop_a = layout == Layout::toroidal || layout == Layout::cut_a;
  const bool loop_b = layout == Layout::toroidal || layout == Layout::cut_b;
  std::vector<double> on_a;
  std::vector<double> on_b;
  for (const ParameterPair& pin : pins) {
    on_a.push_back(pin.u);
    on_b.push_back(pin.v);
  }
  JointedPath first = jointed_path(a, on_a, loop_a);
  JointedPath second = jointed_path(b, on_b, loop_b);
  std::vector<ParameterPair> joints;
  for (std::size_t k = 0; k < pins.size(); ++k) joints.push_back({first.pins[k], second.pins[k]});
  SamplePair samples{sample_joints(first.path, first.breaks, loop_a),
                     sample_joints(second.path, second.breaks, loop_b)};
  return {std::move(first.path),    std::move(second.path), std::move(first.breaks),
          std::move(second.breaks), std::move(joints),      std::move(samples)};
}

SegmentMatch match_segment_paths(const SegmentPaths& paths, const MatchOptions& options) {
  const SegmentOptions own{.split = options.segments.split,
                           .cost = options.segments.cost,
                           .direction = options.direction,
                           .closed = options.closed,
                           .pins = paths.pins,
                           .progress = options.progress};
  const Rotation turn =
      options.rotation.empty() ? Rotation(paths.a.dim()) : Rotation(paths.a.dim(), options.rotation);
  if (turn.is_identity()) return match_segments(paths.a, paths.b, own);
  return match_segments(paths.a, CubicPath(turn.inverse()(paths.b.control_points()), paths.b.is_closed()),
                        own);
}

PathParameters path_parameters(const SegmentMatch& match, const SegmentPaths& paths) {
  PathParameters result;
  Correspondence& c = result.correspondence;
  c = match.correspondence;
  c.domain_u = interval_at(paths.breaks_a, c.domain_u);
  c.domain_v = interval_at(paths.breaks_b, c.domain_v);
  for (ParameterPair& point : c.points) {
    point = {parameter_at(paths.breaks_a, point.u), parameter_at(paths.breaks_b, point.v)};
    result.corners.push_back(c.closed && point.u >= c.domain_u.hi ? point.u - c.domain_u.length() : point.u);
  }
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
