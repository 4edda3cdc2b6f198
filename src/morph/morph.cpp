#include "tandem/morph/morph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

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

}  // namespace

Morph::Morph(std::span<const Shape> keys, const MorphOptions& options) : key_count_(keys.size()) {
  check_keys(keys);
  const BlendKind blend = detail::settle_blend(options);
  if (!is_known(blend)) {
    throw InvalidArgument("morph: curves in space blend by affine, bezier and hermite only");
  }
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
  const auto [key, local] = locate_key(s, key_count_);
  Shape shape;
  shape.fill_rule = fill_rule_;
  shape.contours.reserve(contours_.size());
  for (std::size_t c = 0; c < contours_.size(); ++c) {
    const Curve& a = contours_[c][key];
    const Curve& b = contours_[c][key + 1];
    // At the keys themselves the products below would be exact as well, but for the sign of zero.
    if (local == 0.0 || local == 1.0) {
      shape.contours.push_back(local == 0.0 ? a : b);
      continue;
    }
    Points points = hermite_.empty()
                        ? affine_blend(frames_[key], a.control_points(), b.control_points(), local)
                        : frames_[key].place(hermite_[key][c].at(local).control_points(), local);
    shape.contours.emplace_back(a.degree(), a.knots(), std::move(points), a.weights());
  }
  return shape;
}

KeyPosition locate_key(double s, std::size_t key_count) {
  if (key_count < 2) {
    throw InvalidArgument(fmt::format("morph: {} keys, expected at least 2", key_count));
  }
  if (!std::isfinite(s)) throw InvalidArgument(fmt::format("morph: s is {}, expected a finite number", s));
  const double last = static_cast<double>(key_count - 1);
  double x = s * last;
  // i / last * last may miss i by a rounding; a key's own s must give the key.
  const double nearest = std::round(x);
  if (nearest / last == s) x = nearest;
  const double key = std::clamp(std::floor(x), 0.0, last - 1.0);
  return {static_cast<std::size_t>(key), x - key};
}

}  // namespace v0
}  // namespace tandem
