#include "io/faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/scene_ball.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Room for bold lines round the scene, as a share of its longer side.
constexpr double kMargin = 0.03;
// Samples of a pixel's side: 3 as long as they fit into some 100 MB.
constexpr int kMostFine = 1400;
constexpr int kMostMiddling = 2800;

constexpr std::uint8_t kFront = 1;
constexpr std::uint8_t kBack = 2;

/// A colour for every light from 0 to 1: dark, own, light, glint.
struct Ramp {
  std::array<std::array<double, 3>, 4> colors;
};
constexpr Ramp kFrontRamp{{{{40, 58, 112}, {101, 132, 216}, {178, 198, 244}, {246, 249, 255}}}};
constexpr Ramp kBackRamp{{{{116, 60, 38}, {222, 158, 122}, {244, 211, 188}, {255, 249, 243}}}};
constexpr Ramp kFoldRamp{{{{120, 20, 30}, {214, 60, 60}, {226, 84, 80}, {255, 240, 240}}}};
constexpr std::array<double, 4> kStops = {0.0, 0.5, 0.82, 1.0};

std::array<double, 3> color(const Ramp& ramp, double light) {
  std::size_t i = 0;
  while (i + 2 < kStops.size() && light > kStops[i + 1]) ++i;
  const double t = std::clamp((light - kStops[i]) / (kStops[i + 1] - kStops[i]), 0.0, 1.0);
  std::array<double, 3> result{};
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = (1.0 - t) * ramp.colors[i][k] + t * ramp.colors[i + 1][k];
  }
  return result;
}

/// How bright a face is whose normal, turned to the viewer, is n: lamps above to the left and at the viewer,
/// and a glint.
double light_of(Vector3 n, bool planar) {
  if (planar) return 0.72;
  if (n[2] < 0.0) n = -1.0 * n;
  const Vector3 lamp = unit({-0.5, 0.75, 0.6});
  const Vector3 half = unit(lamp + Vector3{0.0, 0.0, 1.0});
  const double glint = std::pow(std::max(0.0, dot(n, half)), 48.0);
  return 0.16 + 0.46 * std::max(0.0, dot(n, lamp)) + 0.2 * n[2] + 0.18 * glint;
}

int pixels(double length) {
  return std::max(1, static_cast<int>(std::lround(length)));
}

}  // namespace

Faces::Faces(const Scene& scene, const Camera& camera, int size) : planar_(scene.planar) {
  const std::vector<Vector3> points = camera.place(scene.mesh.vertices);
  std::array<double, 4> box = {1e9, 1e9, -1e9, -1e9};
  const auto add = [&](const Vector3& p) {
    box = {std::min(box[0], p[0]), std::min(box[1], p[1]), std::max(box[2], p[0]), std::max(box[3], p[1])};
  };
  for (const Vector3& p : points) add(p);
  for_each_line(scene, [&](const Points& line) {
    for (std::size_t i = 0; i < line.size(); ++i) add(camera.place(line[i]));
  });
  const double longer = std::max({box[2] - box[0], box[3] - box[1], 1e-9});
  const double margin = kMargin * longer;
  scale_ = size / (longer + 2.0 * margin);
  width_ = pixels((box[2] - box[0] + 2.0 * margin) * scale_);
  height_ = pixels((box[3] - box[1] + 2.0 * margin) * scale_);
  x_ = box[0] - margin;
  y_ = box[3] + margin;
  factor_ = size <= kMostFine ? 3 : size <= kMostMiddling ? 2 : 1;
  const std::size_t count = sample(0, height_ * factor_);
  depth_.assign(count, -std::numeric_limits<float>::infinity());
  light_.assign(count, 0);
  side_.assign(count, 0);

  for (const auto& t : scene.mesh.triangles) {
    std::array<Corner, 3> corners;
    Vector3 n = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
    // Seen with y up; the camera of planar scenes looks at y down, from the other side as it were.
    const std::uint8_t side = n[2] >= 0.0 ? kFront : kBack;
    n = unit(n);
    for (std::size_t k = 0; k < 3; ++k) {
      Vector3 normal = scene.mesh.normals.empty() ? n : camera.turn(scene.mesh.normals[t[k]]);
      // Of a face that is seen from behind all corners are.
      if (dot(normal, n) < 0.0) normal = -1.0 * normal;
      if (n[2] < 0.0) normal = -1.0 * normal;
      if (normal[2] < 0.0) normal = unit({normal[0], normal[1], 0.0});
      corners[k] = {to_pixel(points[t[k]]), light_of(normal, planar_)};
    }
    draw(corners[0], corners[1], corners[2], side);
  }
}

Vector3 Faces::to_pixel(const Vector3& p) const noexcept {
  return {(p[0] - x_) * scale_, (y_ - p[1]) * scale_, p[2]};
}

void Faces::draw(const Corner& a, const Corner& b, const Corner& c, std::uint8_t side) {
  const double f = factor_;
  const double ax = a.at[0] * f;
  const double ay = a.at[1] * f;
  const double bx = b.at[0] * f - ax;
  const double by = b.at[1] * f - ay;
  const double cx = c.at[0] * f - ax;
  const double cy = c.at[1] * f - ay;
  const double twice_area = bx * cy - by * cx;
  if (!(std::fabs(twice_area) > 1e-12)) return;  // of a sample: seen edge on
  const auto first = [](double lo) { return static_cast<int>(std::ceil(lo - 0.5)); };
  const auto last = [](double hi) { return static_cast<int>(std::floor(hi - 0.5)); };
  const int x0 = std::max(0, first(ax + std::min({0.0, bx, cx})));
  const int x1 = std::min(width_ * factor_ - 1, last(ax + std::max({0.0, bx, cx})));
  const int y0 = std::max(0, first(ay + std::min({0.0, by, cy})));
  const int y1 = std::min(height_ * factor_ - 1, last(ay + std::max({0.0, by, cy})));
  for (int y = y0; y <= y1; ++y) {
    const double py = y + 0.5 - ay;
    for (int x = x0; x <= x1; ++x) {
      const double px = x + 0.5 - ax;
      const double s = (px * cy - py * cx) / twice_area;
      const double t = (bx * py - by * px) / twice_area;
      // A sample on an edge belongs to both sides: no gaps.
      if (s < 0.0 || t < 0.0 || s + t > 1.0) continue;
      const std::size_t at = sample(x, y);
      // Folds of planar scenes lie on top, whichever side is one: see colors().
      const auto z = static_cast<float>((1.0 - s - t) * a.at[2] + s * b.at[2] + t * c.at[2]);
      if (planar_) {
        side_[at] |= side;
        light_[at] = static_cast<std::uint8_t>(255.0 * a.light);
        depth_[at] = z;
      } else if (z > depth_[at]) {
        depth_[at] = z;
        side_[at] = side;
        const double light = (1.0 - s - t) * a.light + s * b.light + t * c.light;
        light_[at] = static_cast<std::uint8_t>(255.0 * std::clamp(light, 0.0, 1.0));
      }
    }
  }
}

bool Faces::is_visible(const Vector3& pixel, double slack) const {
  if (planar_) return true;
  const int x = static_cast<int>(std::floor(pixel[0] * factor_));
  const int y = static_cast<int>(std::floor(pixel[1] * factor_));
  for (int dy = -factor_; dy <= factor_; dy += factor_) {
    for (int dx = -factor_; dx <= factor_; dx += factor_) {
      const bool inside =
          x + dx >= 0 && y + dy >= 0 && x + dx < width_ * factor_ && y + dy < height_ * factor_;
      if (!inside || pixel[2] + slack >= static_cast<double>(depth_[sample(x + dx, y + dy)])) return true;
    }
  }
  return false;
}

bool Faces::shows_fronts() const {
  const auto fronts = std::count(side_.begin(), side_.end(), kFront);
  return fronts >= std::count(side_.begin(), side_.end(), kBack);
}

std::vector<std::uint8_t> Faces::colors() const {
  // What is seen most of is the front, whichever way the surface was parametrized.
  const std::uint8_t front = shows_fronts() ? kFront : kBack;
  std::vector<std::uint8_t> result(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4);
  const double samples = factor_ * factor_;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      std::array<double, 3> sum{};
      double covered = 0.0;
      for (int k = 0; k < factor_ * factor_; ++k) {
        const std::size_t at = sample(x * factor_ + k % factor_, y * factor_ + k / factor_);
        if (side_[at] == 0) continue;
        const Ramp& ramp = side_[at] == front ? kFrontRamp : planar_ ? kFoldRamp : kBackRamp;
        const std::array<double, 3> c = color(ramp, light_[at] / 255.0);
        for (std::size_t i = 0; i < 3; ++i) sum[i] += c[i];
        covered += 1.0;
      }
      std::uint8_t* out =
          result.data() +
          4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
      for (std::size_t i = 0; covered > 0.0 && i < 3; ++i) {
        out[i] = static_cast<std::uint8_t>(std::lround(sum[i] / covered));
      }
      out[3] = static_cast<std::uint8_t>(std::lround(255.0 * covered / samples));
    }
  }
  return result;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
