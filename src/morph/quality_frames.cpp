#include "morph/quality_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "shape/joint_tangents.h"
#include "shape/plane.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

// Gauss-Legendre with 5 nodes on [0, 1] (Abramowitz and Stegun, table 25.4): the length of a segment of an
// icon to about 1e-4, of one with a cusp to 1e-2.
constexpr std::array<double, 5> kNodes{0.04691007703066800, 0.23076534494715845, 0.5, 0.76923465505284155,
                                       0.95308992296933200};
constexpr std::array<double, 5> kWeights{0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                         0.23931433524968324, 0.11846344252809454};

std::size_t frame_count(const QualityOptions& options) {
  if (options.key_count < 2) {
    throw InvalidArgument(fmt::format("morph quality: {} keys, expected two or more", options.key_count));
  }
  if (options.in_betweens < 1) throw InvalidArgument("morph quality: no in-betweens, expected one or more");
  return (options.key_count - 1) * (options.in_betweens + 1) + 1;
}

struct Size {
  double length = 0.0;
  double area = 0.0;
};

double speed(Vec2 a, Vec2 b, Vec2 c, double t) {
  const double s = 1.0 - t;
  return 3.0 * length(plus(times(s * s, a), plus(times(2.0 * s * t, b), times(t * t, c))));
}

// Coordinates in units of `unit`, so that squares stay in range.
Size size_of(std::span<const PathView> paths, double unit) {
  Size size;
  for (const PathView& path : paths) {
    const double* c = path.points.data();
    const Vec2 origin{c[0], c[1]};
    const auto point = [&](std::size_t i) {
      return Vec2{(c[2 * i] - origin.x) / unit, (c[2 * i + 1] - origin.y) / unit};
    };
    Vec2 p0;
    for (std::size_t i = 0; i < path.segment_count(); ++i) {
      const Vec2 p1 = point(3 * i + 1);
      const Vec2 p2 = point(3 * i + 2);
      const Vec2 p3 = point(3 * i + 3);
      for (std::size_t k = 0; k < kNodes.size(); ++k) {
        size.length += kWeights[k] * speed(minus(p1, p0), minus(p2, p1), minus(p3, p2), kNodes[k]);
      }
      if (path.closed) size.area += swept_area(p0, p1, p2, p3);
      p0 = p3;
    }
  }
  return size;
}

// |x / blend - 1|, 0 where the blend is nothing.
double deviation(double x, double a, double b, double s) {
  const double blend = (1.0 - s) * a + s * b;
  return blend > 0.0 ? std::abs(x / blend - 1.0) : 0.0;
}

double largest_coordinate(std::span<const double> points) {
  double largest = 0.0;
  for (const double x : points) largest = std::max(largest, std::abs(x));
  return largest;
}

}  // namespace

QualityFrames::QualityFrames(const PathSampler& sampler, const QualityOptions& options)
    : size_(frame_count(options)), per_key_(options.in_betweens + 1) {
  for (std::size_t frame = 0; frame < size_; ++frame) append(sampler(s(frame)), frame);
  const double* points = points_.data();
  for (PathView& view : views_) {
    view.points = {points, view.points.size()};
    points += view.points.size();
  }
}

void QualityFrames::append(std::span<const PathView> sample, std::size_t frame) {
  if (frame == 0) {
    contours_ = sample.size();
    for (const PathView& path : sample) stride_ += path.points.size();
    points_.reserve(size_ * stride_);
    views_.reserve(size_ * contours_);
  }
  const auto same = [&] {
    if (sample.size() != contours_) return false;
    for (std::size_t i = 0; i < contours_; ++i) {
      if (frame > 0 && sample[i].points.size() != views_[i].points.size()) return false;
    }
    return true;
  };
  if (!same()) {
    throw InvalidArgument(fmt::format(
        "morph quality: the paths at s = {} have other contours or segments than at s = 0", s(frame)));
  }
  for (const PathView& path : sample) {
    points_.insert(points_.end(), path.points.begin(), path.points.end());
    views_.push_back(path);
  }
}

double measure_steps(const QualityFrames& frames) {
  double worst = 1.0;
  for (std::size_t key = 0; key + 1 < frames.size(); key += frames.per_key()) {
    double sum = 0.0;
    double largest = 0.0;
    for (std::size_t i = key; i < key + frames.per_key(); ++i) {
      const auto a = frames.points(i);
      const auto b = frames.points(i + 1);
      double step = 0.0;
      for (std::size_t k = 0; k < a.size(); k += 2) {
        step = std::max(step, distance({a[k], a[k + 1]}, {b[k], b[k + 1]}));
      }
      sum += step;
      largest = std::max(largest, step);
    }
    const double mean = sum / static_cast<double>(frames.per_key());
    if (mean > 0.0) worst = std::max(worst, largest / mean);
  }
  return worst;
}

SizeDeviation measure_sizes(const QualityFrames& frames) {
  double unit = 0.0;
  for (std::size_t i = 0; i < frames.size(); ++i) unit = std::max(unit, largest_coordinate(frames.points(i)));
  SizeDeviation worst;
  if (!(unit > 0.0)) return worst;
  for (std::size_t key = 0; key + 1 < frames.size(); key += frames.per_key()) {
    const Size a = size_of(frames[key], unit);
    const Size b = size_of(frames[key + frames.per_key()], unit);
    for (std::size_t i = 1; i < frames.per_key(); ++i) {
      const double s = static_cast<double>(i) / static_cast<double>(frames.per_key());
      const Size size = size_of(frames[key + i], unit);
      worst.length = std::max(worst.length, deviation(size.length, a.length, b.length, s));
      worst.area =
          std::max(worst.area, deviation(std::abs(size.area), std::abs(a.area), std::abs(b.area), s));
    }
  }
  return worst;
}

double measure_g1_defect(const QualityFrames& frames, double smooth_angle) {
  double worst = 0.0;
  for (std::size_t c = 0; c < frames[0].size(); ++c) {
    for (std::size_t joint = 0; joint < frames[0][c].segment_count(); ++joint) {
      double key_size = 0.0;
      for (std::size_t i = 0; i < frames.size(); i += frames.per_key()) {
        key_size = std::max(key_size, break_size(joint_tangents(frames[i][c], joint)));
      }
      const double key_angle = break_angle(key_size);
      if (key_angle > smooth_angle) continue;
      for (std::size_t i = 0; i < frames.size(); ++i) {
        const double size = break_size(joint_tangents(frames[i][c], joint));
        // The angle grows by at most twice what its size grows by.
        if (2.0 * (size - key_size) > worst) worst = std::max(worst, break_angle(size) - key_angle);
      }
    }
  }
  return worst;
}

}  // namespace v0
}  // namespace tandem
