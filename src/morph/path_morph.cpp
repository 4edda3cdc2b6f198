#include "tandem/morph/path_morph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "shape/cubic_fit.h"
#include "shape/trigonometry.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

// How far a line's handles may stand off the thirds, as a share of the diagonal: the same bound by which ends
// count as meeting, well above rounding and far below anything drawn.
constexpr double kLineTolerance = 1e-9;

// In-betweens per pair of keys that the box is taken from: between two of them the frame turns by no more
// than 12 degrees, and what sticks out of the box by then is less than the margin of a picture.
constexpr std::size_t kBoxSamples = 16;

bool is_point(std::span<const Points> keys, std::size_t segment) {
  for (const Points& points : keys) {
    const auto first = points[3 * segment];
    for (std::size_t i = 3 * segment + 1; i <= 3 * segment + 3; ++i) {
      if (!std::equal(first.begin(), first.end(), points[i].begin())) return false;
    }
  }
  return true;
}

// Without the segments that are a point in every key; one is always left.
std::vector<Points> without_points(std::vector<Points> keys) {
  const std::size_t count = (keys.front().size() - 1) / 3;
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < count; ++k) {
    if (!is_point(keys, k)) kept.push_back(k);
  }
  if (kept.size() == count) return keys;
  if (kept.empty()) kept.push_back(0);
  for (Points& points : keys) {
    Points rest;
    rest.push_back(std::as_const(points).front());
    for (std::size_t k : kept) {
      for (std::size_t i = 3 * k + 1; i <= 3 * k + 3; ++i) rest.push_back(std::as_const(points)[i]);
    }
    points = std::move(rest);
  }
  return keys;
}

/// line_tolerances: one per key.
PathContour to_contour(std::span<const Curve> curves, double tolerance,
                       std::span<const double> line_tolerances) {
  std::vector<Points> keys = without_points(cubic_control_points(curves, tolerance));
  // A contour collapsed to a point is no reason to leave the others open, nor to close them.
  const bool closed = std::all_of(curves.begin(), curves.end(),
                                  [](const Curve& c) { return c.is_closed() || c.extent() == 0.0; }) &&
                      std::any_of(curves.begin(), curves.end(), [](const Curve& c) { return c.is_closed(); });
  PathContour contour;
  for (Points& points : keys) {
    if (closed) {  // the ends meet up to rounding only
      const auto front = std::as_const(points).front();
      std::copy(front.begin(), front.end(), points[points.size() - 1].begin());
    }
    contour.keys.emplace_back(std::move(points), closed);
  }
  for (std::size_t k = 0; k < contour.keys.front().segment_count(); ++k) {
    bool line = true;
    for (std::size_t key = 0; key < contour.keys.size(); ++key) {
      line = line && contour.keys[key].is_line(k, line_tolerances[key]);
    }
    contour.lines.push_back(line);
  }
  return contour;
}

// The points turned, then moved.
void place(Points& points, const CosSin& turn, Vec2 center) {
  const Transform map{turn.cosine, turn.sine, -turn.sine, turn.cosine, center.x, center.y};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto p = points[i];
    const Vec2 placed = map({p[0], p[1]});
    p[0] = placed.x;
    p[1] = placed.y;
  }
}

// The path as the frame sees it in this pose.
CubicPath seen_from(const FramePose& pose, const CubicPath& path) {
  Points points = path.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i][0] -= pose.center.x;
    points[i][1] -= pose.center.y;
  }
  place(points, cos_sin_degrees(-pose.degrees), {});
  return CubicPath(std::move(points), path.is_closed());
}

// The centres are those of the frames, the same on both sides of a key; where a frame stands still it has
// none, and any will do.
std::vector<FramePose> poses_of(const Morph& morph) {
  std::vector<FramePose> poses(morph.key_count());
  for (std::size_t key = 0; key + 1 < poses.size(); ++key) {
    const MovingFrame& frame = morph.frame(key);
    poses[key + 1].degrees = poses[key].degrees + frame.rotation().degrees();
    if (frame.stands_still()) continue;
    poses[key].center = {frame.first_center()[0], frame.first_center()[1]};
    poses[key + 1].center = {frame.second_center()[0], frame.second_center()[1]};
  }
  return poses;
}

}  // namespace

PathMorph::PathMorph(const Morph& morph, double tolerance)
    : key_count_(morph.key_count()), fill_rule_(morph.fill_rule()) {
  std::vector<Box> boxes(key_count_);
  for (std::size_t c = 0; c < morph.contour_count(); ++c) {
    for (std::size_t key = 0; key < key_count_; ++key) {
      const Curve& curve = morph.keys(c)[key];
      if (curve.dim() != 2) {
        throw InvalidArgument(
            fmt::format("path morph: the shapes have dimension {}, expected 2", curve.dim()));
      }
      boxes[key].include(bounding_box(curve));
    }
  }
  // Every key is redrawn to its own size: the keys may differ by orders of magnitude, or lie far apart.
  double smallest = std::numeric_limits<double>::infinity();
  std::vector<double> line_tolerances;
  for (const Box& box : boxes) {
    box_.include(box);
    const double diagonal = box.diagonal();
    line_tolerances.push_back(kLineTolerance * diagonal);
    if (diagonal > 0.0) smallest = std::min(smallest, diagonal);
  }
  // Nothing is finer than the rounding of the coordinates themselves.
  double rounding = 0.0;
  for (const Point& corner : {box_.lo, box_.hi}) {
    for (double x : corner)
      rounding = std::max(rounding, 8.0 * std::numeric_limits<double>::epsilon() * std::abs(x));
  }
  const double absolute = std::max(tolerance * std::min(smallest, box_.diagonal()), rounding);
  for (std::size_t c = 0; c < morph.contour_count(); ++c) {
    contours_.push_back(to_contour(morph.keys(c), absolute, line_tolerances));
  }
  poses_ = poses_of(morph);
  turns_ = std::any_of(poses_.begin(), poses_.end(), [](const FramePose& p) { return p.degrees != 0.0; });
  if (turns_) enter_frame();
}

void PathMorph::enter_frame() {
  for (PathContour& contour : contours_) {
    for (std::size_t key = 0; key < key_count_; ++key) {
      contour.keys[key] = seen_from(poses_[key], contour.keys[key]);
    }
  }
  const std::size_t samples = kBoxSamples * (key_count_ - 1);
  for (std::size_t i = 1; i < samples; ++i) {
    for (const CubicPath& path : at(static_cast<double>(i) / static_cast<double>(samples))) {
      box_.include(bounding_box(to_curve(path)));
    }
  }
}

std::vector<CubicPath> PathMorph::at(double s) const {
  const auto [key, local] = locate_key(s, key_count_);
  const FramePose& first = poses_[key];
  const FramePose& second = poses_[key + 1];
  const CosSin turn = cos_sin_degrees((1.0 - local) * first.degrees + local * second.degrees);
  const Vec2 center{(1.0 - local) * first.center.x + local * second.center.x,
                    (1.0 - local) * first.center.y + local * second.center.y};
  std::vector<CubicPath> paths;
  paths.reserve(contours_.size());
  for (const PathContour& contour : contours_) {
    const CubicPath& a = contour.keys[key];
    const CubicPath& b = contour.keys[key + 1];
    if (!turns_ && (local == 0.0 || local == 1.0)) {
      paths.push_back(local == 0.0 ? a : b);
      continue;
    }
    Points points = a.control_points();
    const std::span<double> blend = points.data();
    const std::span<const double> other = b.control_points().data();
    for (std::size_t i = 0; i < blend.size(); ++i) blend[i] = (1.0 - local) * blend[i] + local * other[i];
    if (turns_) place(points, turn, center);
    paths.emplace_back(std::move(points), a.is_closed());
  }
  return paths;
}

}  // namespace v0
}  // namespace tandem
