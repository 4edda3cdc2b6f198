#include "tandem/morph/morph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "morph/chosen_times.h"
#include "morph/hermite_functions.h"
#include "morph/in_step.h"
#include "morph/length_center.h"
#include "morph/settle_blend.h"
#include "tandem/curve/compatible.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"
#include "tandem/shape/cubic_path.h"

namespace tandem {
inline namespace v0 {
namespace {

void check_keys(std::span<const Shape> keys) {
  if (keys.size() < 2) {
    throw InvalidArgument(fmt::format("morph: {} key shapes, expected at least 2", keys.size()));
  }
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].contours.empty()) throw InvalidArgument(fmt::format("morph: key {} has no contours", i));
    for (std::size_t c = 0; c < keys[i].contours.size(); ++c) {
      const int dim = keys[i].contours[c].dim();
      if (dim != keys[0].dim()) {
        throw InvalidArgument(
            fmt::format("morph: contour {} of key {} has dimension {}, expected {} as in key 0", c, i, dim,
                        keys[0].dim()));
      }
    }
  }
}

// Shapes of the even-odd rule look wrong under the nonzero rule whenever their contours run all one way,
// those of the nonzero rule look wrong under the other one only where contours of one direction overlap.
FillRule common_fill_rule(std::span<const Shape> keys) {
  const bool any = std::any_of(keys.begin(), keys.end(),
                               [](const Shape& key) { return key.fill_rule == FillRule::evenodd; });
  return any ? FillRule::evenodd : FillRule::nonzero;
}

constexpr bool is_known(BlendKind kind) {
  return kind == BlendKind::automatic || kind == BlendKind::affine || kind == BlendKind::bezier ||
         kind == BlendKind::hermite;
}

/// A contour's keys in Bezier form: the same segments, since they have the same knots.
std::vector<CubicPath> to_cubics(std::span<const Curve> keys, std::size_t contour) {
  const bool closed = std::all_of(keys.begin(), keys.end(), [](const Curve& c) { return c.is_closed(); });
  std::vector<CubicPath> paths;
  for (const Curve& key : keys) {
    if (key.degree() > 3 || key.is_rational()) {
      throw InvalidArgument(
          fmt::format("morph: contour {} has degree {}{}; the hermite blend wants cubics without weights",
                      contour, key.degree(), key.is_rational() ? " and weights" : ""));
    }
    // Exact, so that no tolerance is missed.
    const CubicPath path = to_cubic_path(key, std::max(key.extent(), std::numeric_limits<double>::min()));
    paths.emplace_back(path.control_points(), closed);
  }
  return paths;
}

MovingFrame frame_between(std::span<const Curve> a, std::span<const Curve> b, const Rotation& rotation) {
  if (rotation.is_identity()) return MovingFrame(rotation.dim());
  return {length_center(a), length_center(b), rotation};
}

void add(std::span<double> points, double factor, std::span<const double> other) {
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += factor * other[i];
}

// Velocity per step at its start or its end, of points_at(local).
template <class PointsAt>
Points velocity(bool end, const PointsAt& points_at) {
  const double difference = end ? -detail::kDifference : detail::kDifference;
  Points velocity;
  for (std::size_t j = 0; j < detail::kStencil.size(); ++j) {
    const Points at = points_at((end ? 1.0 : 0.0) + static_cast<double>(j) * difference);
    if (j == 0) velocity = Points(at.dim(), at.size());
    add(velocity.data(), detail::kStencil[j] / difference, at.data());
  }
  return velocity;
}

}  // namespace

Morph::Morph(std::span<const Shape> keys, const MorphOptions& options) : key_count_(keys.size()) {
  check_keys(keys);
  const BlendKind blend = detail::settle_blend(options);
  if (!is_known(blend)) {
    throw InvalidArgument("morph: curves in space blend by affine, bezier and hermite only");
  }
  times_ = detail::chosen_times(options.times, keys.size());
  fill_rule_ = common_fill_rule(keys);
  InStep in_step = put_in_step(keys, fill_rule_ == FillRule::nonzero, options);
  cancelled_ = in_step.cancelled;
  if (cancelled_) return;
  for (std::size_t key = 0; key + 1 < keys.size(); ++key) {
    const Rotation turn =
        blend == BlendKind::bezier ? Rotation(keys[key].dim()) : std::move(in_step.rotations[key]);
    frames_.push_back(frame_between(keys[key].contours, keys[key + 1].contours, turn));
  }
  contours_ = std::move(in_step.contours);
  matches_ = std::move(in_step.matches);
  if (blend == BlendKind::hermite) blend_by_hermite();
  if (options.smooth && key_count_ > 2) bend_steps();
}

void Morph::blend_by_hermite() {
  hermite_.resize(frames_.size());
  for (std::size_t c = 0; c < contours_.size(); ++c) {
    const std::vector<CubicPath> paths = to_cubics(contours_[c], c);
    for (std::size_t key = 0; key < frames_.size(); ++key) {
      const bool closed = paths[key].is_closed();
      hermite_[key].emplace_back(
          CubicPath(frames_[key].from_first(paths[key].control_points()), closed),
          CubicPath(frames_[key].from_second(paths[key + 1].control_points()), closed));
    }
    for (std::size_t key = 0; key < paths.size(); ++key) contours_[c][key] = to_curve(paths[key]);
  }
}

Morph Morph::in_step(std::span<const Curve> curves, const MorphOptions& options) {
  if (curves.size() < 2) {
    throw InvalidArgument(fmt::format("morph: {} curves, expected at least 2", curves.size()));
  }
  for (std::size_t i = 1; i < curves.size(); ++i) {
    const Interval domain = curves[i].domain();
    const Interval first = curves[0].domain();
    if (domain == first) continue;
    throw InvalidArgument(fmt::format("morph: curve {} is over [{}, {}], expected [{}, {}] as curve 0", i,
                                      domain.lo, domain.hi, first.lo, first.hi));
  }
  Morph morph;
  morph.key_count_ = curves.size();
  morph.times_ = detail::chosen_times(options.times, curves.size());
  morph.contours_.push_back(with_common_denominator(curves));
  morph.frames_.assign(curves.size() - 1, MovingFrame(curves[0].dim()));
  morph.matches_.assign(curves.size() - 1, std::vector<std::optional<Match>>(1));
  if (options.smooth && curves.size() > 2) morph.bend_steps();
  return morph;
}

Points Morph::step_points(std::size_t step, std::size_t contour, double local) const {
  if (!hermite_.empty()) {
    return frames_[step].place(hermite_[step][contour].at(local).control_points(), local);
  }
  const std::vector<Curve>& keys = contours_[contour];
  return affine_blend(frames_[step], keys[step].control_points(), keys[step + 1].control_points(), local);
}

void Morph::bend_steps() {
  for (std::size_t c = 0; c < contours_.size(); ++c) {
    const Points none(contours_[c].front().dim(), contours_[c].front().control_points().size());
    std::vector<Bend>& bends = bends_.emplace_back(frames_.size(), Bend{none, none});
    for (std::size_t k = 0; k + 1 < frames_.size(); ++k) {
      const auto velocity_of = [&](std::size_t step, bool end) {
        return velocity(end, [&](double local) { return step_points(step, c, local); });
      };
      const Points before = velocity_of(k, true);
      const Points after = velocity_of(k + 1, false);
      const double first = times_[k + 1] - times_[k];
      const double second = times_[k + 2] - times_[k + 1];
      const detail::KeyVelocity share(first, second);
      Points& end = bends[k].end;
      add(end.data(), first * share.before - 1.0, before.data());
      add(end.data(), first * share.after, after.data());
      Points& start = bends[k + 1].start;
      add(start.data(), second * share.before, before.data());
      add(start.data(), second * share.after - 1.0, after.data());
    }
  }
}

Morph::Morph(const Curve& a, const Curve& b, const Match& match) : key_count_(2) {
  if (a.dim() != b.dim()) {
    throw InvalidArgument(
        fmt::format("morph: the curves have dimensions {} and {}, expected one", a.dim(), b.dim()));
  }
  matches_.emplace_back(1, match);
  cancelled_ = match.report.cancelled;
  if (cancelled_) return;
  const Interval domain = match.curve.domain();
  const Curve moved = domain == a.domain() ? a : move_seam(a, domain.lo);
  const std::vector<Curve> pair{moved, match.curve};
  contours_.push_back(with_common_denominator(pair));
  frames_.push_back(frame_between({&a, 1}, {&b, 1}, Rotation(a.dim(), match.report.rotation)));
}

Shape Morph::at(double s) const {
  const auto [key, local] = locate_key(s, times_);
  Shape shape;
  shape.fill_rule = fill_rule_;
  shape.contours.reserve(contours_.size());
  for (std::size_t c = 0; c < contours_.size(); ++c) {
    const std::vector<Curve>& curves = contours_[c];
    const Curve& a = curves[key];
    const Curve& b = curves[key + 1];
    // At the keys themselves the products below would be exact as well, but for the sign of zero.
    if (local == 0.0 || local == 1.0) {
      shape.contours.push_back(local == 0.0 ? a : b);
      continue;
    }
    Points points = step_points(key, c, local);
    if (!bends_.empty() && local > 0.0 && local < 1.0) {
      add(points.data(), detail::at_start(local), bends_[c][key].start.data());
      add(points.data(), detail::at_end(local), bends_[c][key].end.data());
    }
    shape.contours.emplace_back(a.degree(), a.knots(), std::move(points), a.weights());
  }
  return shape;
}

}  // namespace v0
}  // namespace tandem
