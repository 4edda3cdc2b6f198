#include "shape/refine_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "shape/plane.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr int kSteps = 12;

// How far a parameter may move from where the polyline has it: that is off by less than an edge.
constexpr double kFarthest = 0.25;

struct Jet {
  Vec2 point;
  Vec2 derivative;
};

double coordinate(std::span<const double> c, double t, double& derivative) {
  const double s = 1.0 - t;
  derivative = 3.0 * (s * s * (c[1] - c[0]) + 2.0 * s * t * (c[2] - c[1]) + t * t * (c[3] - c[2]));
  return s * s * s * c[0] + 3.0 * s * t * (s * c[1] + t * c[2]) + t * t * t * c[3];
}

/// The path in units of `scale` about `origin`.
class ScaledPath {
 public:
  ScaledPath(const CubicPath& path, Vec2 origin, double scale)
      : path_(path), origin_(origin), scale_(scale) {}

  [[nodiscard]] double end() const { return static_cast<double>(path_.segment_count()); }
  [[nodiscard]] Jet operator()(double u) const {
    const double last = end() - 1.0;
    const double i = std::clamp(std::floor(u), 0.0, last);
    const auto control = path_.segment(static_cast<std::size_t>(i));
    std::array<double, 4> xs{};
    std::array<double, 4> ys{};
    for (std::size_t k = 0; k < 4; ++k) {
      xs[k] = (control[k][0] - origin_.x) / scale_;
      ys[k] = (control[k][1] - origin_.y) / scale_;
    }
    Jet jet;
    jet.point.x = coordinate(xs, u - i, jet.derivative.x);
    jet.point.y = coordinate(ys, u - i, jet.derivative.y);
    return jet;
  }

 private:
  const CubicPath& path_;
  Vec2 origin_;
  double scale_;
};

// Size of the control points about the origin.
double size_about(const CubicPath& path, Vec2 origin) {
  double size = 0.0;
  const std::span<const double> c = path.control_points().data();
  for (std::size_t i = 0; i < c.size(); i += 2) {
    size = std::max({size, std::abs(c[i] - origin.x), std::abs(c[i + 1] - origin.y)});
  }
  return size;
}

}  // namespace

void refine_crossing(Crossing& crossing, const CubicPath& path_a, const CubicPath& path_b) {
  const Vec2 origin = crossing.point;
  const double scale = std::max(size_about(path_a, origin), size_about(path_b, origin));
  if (!(scale > 0.0) || !std::isfinite(scale)) return;
  const ScaledPath a(path_a, origin, scale);
  const ScaledPath b(path_b, origin, scale);
  const bool same = crossing.path_a == crossing.path_b;
  const double apart = crossing.v - crossing.u;
  const double farthest = same ? std::min(kFarthest, 0.25 * apart) : kFarthest;
  double u = crossing.u;
  double v = crossing.v;
  for (int step = 0; step < kSteps; ++step) {
    const Jet p = a(u);
    const Jet q = b(v);
    const Vec2 gap = minus(q.point, p.point);
    const Vec2 da = p.derivative;
    const Vec2 db = q.derivative;
    const double determinant = cross(da, db);
    const double size = length(da) * length(db);
    if (!(std::abs(determinant) > 1e-6 * size)) return;
    const double du = cross(gap, db) / determinant;
    const double dv = cross(gap, da) / determinant;
    u = std::clamp(u + du, 0.0, a.end());
    v = std::clamp(v + dv, 0.0, b.end());
    if (std::abs(u - crossing.u) > farthest || std::abs(v - crossing.v) > farthest) return;
    if (std::max(std::abs(du), std::abs(dv)) <= 1e-15 * std::max(a.end(), b.end())) break;
  }
  const Vec2 p = a(u).point;
  const Vec2 q = b(v).point;
  constexpr double kMet = 1e-12;  // rounding of the points, whose coordinates are at most 1
  if (std::max(std::abs(p.x - q.x), std::abs(p.y - q.y)) > kMet) return;
  crossing.u = u;
  crossing.v = v;
  crossing.point = plus(origin, times(scale, p));
}

}  // namespace v0
}  // namespace tandem
