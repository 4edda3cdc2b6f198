#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/morph/quality.h"
#include "tandem/shape/path_view.h"

namespace tandem {
inline namespace v0 {

/// Keys and in-betweens of a morph, evenly spaced, by value: frame 0 is the first key, the last one the last.
class QualityFrames {
 public:
  /// @throws InvalidArgument see measure_quality
  QualityFrames(const PathSampler& sampler, const QualityOptions& options);

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] double s(std::size_t frame) const noexcept {
    return static_cast<double>(frame) / static_cast<double>(size_ - 1);
  }
  /// Frames from one key to the next.
  [[nodiscard]] std::size_t per_key() const noexcept { return per_key_; }
  [[nodiscard]] bool is_key(std::size_t frame) const noexcept { return frame % per_key_ == 0; }
  /// One view per contour.
  [[nodiscard]] std::span<const PathView> operator[](std::size_t frame) const noexcept {
    return {views_.data() + frame * contours_, contours_};
  }
  /// All control points of a frame, contour after contour.
  [[nodiscard]] std::span<const double> points(std::size_t frame) const noexcept {
    return {points_.data() + frame * stride_, stride_};
  }

 private:
  void append(std::span<const PathView> sample, std::size_t frame);

  std::size_t size_ = 0;
  std::size_t per_key_ = 1;
  std::size_t contours_ = 0;
  std::size_t stride_ = 0;
  std::vector<double> points_;
  std::vector<PathView> views_;
};

/// Largest movement of a control point from frame to frame, by the mean over the steps between the same keys.
[[nodiscard]] double measure_steps(const QualityFrames& frames);

/// Largest |ratio - 1| to the linear blend of the keys.
struct SizeDeviation {
  double length = 0.0;
  double area = 0.0;
};
[[nodiscard]] SizeDeviation measure_sizes(const QualityFrames& frames);

/// MorphQuality::g1_defect.
[[nodiscard]] double measure_g1_defect(const QualityFrames& frames, double smooth_angle);

}  // namespace v0
}  // namespace tandem
