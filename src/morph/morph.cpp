#include "tandem/morph/morph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "morph/in_step.h"
#include "morph/length_center.h"
#include "tandem/curve/compatible.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

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

MovingFrame frame_between(std::span<const Curve> a, std::span<const Curve> b, const Rotation& rotation) {
  if (rotation.is_identity()) return MovingFrame(rotation.dim());
  return {length_center(a), length_center(b), rotation};
}

}  // namespace

Morph::Morph(std::span<const Shape> keys, const MorphOptions& options) : key_count_(keys.size()) {
  check_keys(keys);
  fill_rule_ = common_fill_rule(keys);
  InStep in_step = put_in_step(keys, fill_rule_ == FillRule::nonzero, options);
  cancelled_ = in_step.cancelled;
  if (cancelled_) return;
  for (std::size_t key = 0; key + 1 < keys.size(); ++key) {
    frames_.push_back(frame_between(keys[key].contours, keys[key + 1].contours, in_step.rotations[key]));
  }
  contours_ = std::move(in_step.contours);
  matches_ = std::move(in_step.matches);
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
  for (const std::vector<Curve>& curves : contours_) {
    const Curve& a = curves[key];
    const Curve& b = curves[key + 1];
    // At the keys themselves the products below would be exact as well, but for the sign of zero.
    if (local == 0.0 || local == 1.0) {
      shape.contours.push_back(local == 0.0 ? a : b);
      continue;
    }
    shape.contours.emplace_back(a.degree(), a.knots(),
                                affine_blend(frames_[key], a.control_points(), b.control_points(), local),
                                a.weights());
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
