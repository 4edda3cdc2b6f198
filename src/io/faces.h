#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/camera.h"
#include "tandem/io/scene.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The triangles of a scene as pixels, each of them `factor` x `factor` samples with their depth.
class Faces {
 public:
  /// size: pixels of the longer side, within which all of the scene lies.
  Faces(const Scene& scene, const Camera& camera, int size);

  [[nodiscard]] int width() const noexcept { return width_; }
  [[nodiscard]] int height() const noexcept { return height_; }
  /// Where a point of the camera falls: pixels from the left and from the top, and its depth unchanged.
  [[nodiscard]] Vector3 to_pixel(const Vector3& p) const noexcept;
  /// Whether nothing nearer hides a point (in pixels), which may lie deeper by `slack`. Near the rim of a
  /// face, within a pixel, everything is visible.
  [[nodiscard]] bool is_visible(const Vector3& pixel, double slack) const;
  /// Whether most of what is seen is seen from the side from which its triangles run counter-clockwise
  /// (planar ones: with y up). If not, the picture takes the backs for fronts.
  [[nodiscard]] bool shows_fronts() const;
  /// Red, green, blue, opacity of each pixel, row by row from the top; not premultiplied.
  [[nodiscard]] std::vector<std::uint8_t> colors() const;

 private:
  struct Corner {
    Vector3 at;
    double light;
  };
  void draw(const Corner& a, const Corner& b, const Corner& c, std::uint8_t side);
  [[nodiscard]] std::size_t sample(int x, int y) const noexcept {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ * factor_) +
           static_cast<std::size_t>(x);
  }

  int width_ = 1;
  int height_ = 1;
  int factor_ = 1;
  bool planar_ = false;
  double scale_ = 1.0;
  double x_ = 0.0;  ///< left and top of the picture, in the camera's units
  double y_ = 0.0;
  std::vector<float> depth_;
  std::vector<std::uint8_t> light_;
  std::vector<std::uint8_t> side_;  ///< 0: nothing, 1: front, 2: back
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
