#include "morph/drawing_mirror.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "morph/mirror.h"
#include "shape/plane.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Parts that a segment is seen in.
constexpr std::size_t kParts = 6;
// How far a mirror image may be off, as a share of the size of the drawing.
constexpr double kExactly = 0.01;
// Axes nearer to one another than this, in degrees, are one.
constexpr double kSame = 0.5;
// Ratio of the principal moments of what has a direction.
constexpr double kLengthy = 1.05;
constexpr double kDegrees = 57.29577951308232;

double wrapped(double degrees, double period) {
  return degrees - period * std::round(degrees / period);
}

Vec2 on_segment(const CubicPath& path, std::size_t i, double t) {
  const auto p = path.segment(i);
  const double s = 1.0 - t;
  const double w[4] = {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
  Vec2 sum{};
  for (std::size_t k = 0; k < 4; ++k) sum = plus(sum, times(w[k], {p[k][0], p[k][1]}));
  return sum;
}

double distance_to_segment(Vec2 x, Vec2 p, Vec2 q) {
  const Vec2 along = minus(q, p);
  const double square = dot(along, along);
  const double share = square > 0.0 ? std::clamp(dot(minus(x, p), along) / square, 0.0, 1.0) : 0.0;
  return distance(x, plus(p, times(share, along)));
}

/// A contour as a polygon about the drawing's centre.
struct Outline {
  std::vector<Vec2> points;
  bool closed = false;
  double length = 0.0;
  Vec2 center{};
  /// Second moments about its own centre: (xx - yy, 2 xy) has twice the angle of the longer axis.
  Vec2 lengthy{};
  double moment = 0.0;

  explicit Outline(const CubicPath& path) : closed(path.is_closed()) {
    points.push_back(on_segment(path, 0, 0.0));
    for (std::size_t i = 0; i < path.segment_count(); ++i) {
      for (std::size_t k = 1; k <= kParts; ++k) {
        points.push_back(on_segment(path, i, static_cast<double>(k) / kParts));
      }
    }
    for_edges([&](double edge, Vec2 at) {
      length += edge;
      center = plus(center, times(edge, at));
    });
    center = length > 0.0 ? times(1.0 / length, center) : points.front();
    for_edges([&](double edge, Vec2 at) {
      const Vec2 d = minus(at, center);
      lengthy = plus(lengthy, times(edge, {d.x * d.x - d.y * d.y, 2.0 * d.x * d.y}));
      moment += edge * dot(d, d);
    });
  }
  void move(Vec2 by) {
    for (Vec2& p : points) p = plus(p, by);
    center = plus(center, by);
  }
  [[nodiscard]] double distance_to(Vec2 x) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      nearest = std::min(nearest, distance_to_segment(x, points[i], points[i + 1]));
    }
    return nearest;
  }
  /// Its longer axis, modulo 180 degrees; nothing of what is round.
  [[nodiscard]] std::optional<double> direction() const {
    const double along = tandem::length(lengthy);
    if (!(moment + along > kLengthy * (moment - along))) return std::nullopt;
    return 0.5 * std::atan2(lengthy.y, lengthy.x) * kDegrees;
  }

 private:
  template <typename Take>
  void for_edges(const Take& take) const {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      take(distance(points[i], points[i + 1]), middle(points[i], points[i + 1]));
    }
  }
};

class Outlines {
 public:
  explicit Outlines(std::span<const CubicPath> paths) {
    Vec2 sum{};
    double whole = 0.0;
    for (const CubicPath& path : paths) {
      all_.emplace_back(path);
      sum = plus(sum, times(all_.back().length, all_.back().center));
      whole += all_.back().length;
    }
    if (!(whole > 0.0)) return;
    for (Outline& outline : all_) {
      outline.move(times(-1.0 / whole, sum));
      for (const Vec2 p : outline.points) radius_ = std::max(radius_, length(p));
    }
  }

  // An axis takes the longest contour to one that is as long: it is half-way between the two.
  [[nodiscard]] std::vector<double> candidates(std::span<const CubicPath> paths) const {
    std::vector<double> found;
    if (!(radius_ > 0.0)) return found;
    const std::size_t first = static_cast<std::size_t>(
        std::max_element(all_.begin(), all_.end(),
                         [](const Outline& x, const Outline& y) { return x.length < y.length; }) -
        all_.begin());
    const auto angle = [](Vec2 p) { return std::atan2(p.y, p.x) * kDegrees; };
    const bool central = length(all_[first].center) <= tolerance();
    for (const Outline& outline : all_) {
      if (!are_alike(all_[first], outline)) continue;
      if (!central) {
        found.push_back(0.5 * (angle(all_[first].center) + angle(outline.center)));
      } else if (const auto p = all_[first].direction(), q = outline.direction(); p && q) {
        found.push_back(0.5 * (*p + *q));
        found.push_back(found.back() + 90.0);
      }
    }
    if (central && found.empty()) {
      for (const Mirror& mirror : find_mirrors(to_curve(paths[first]))) found.push_back(mirror.degrees);
    }
    return found;
  }

  // Nothing when some contour has no image.
  [[nodiscard]] std::vector<std::size_t> images(double degrees) const {
    std::vector<std::size_t> found;
    for (const Outline& outline : all_) {
      std::size_t j = 0;
      while (j < all_.size() && !(is_image(outline, all_[j], degrees) && !contains(found, j))) ++j;
      if (j == all_.size()) return {};
      found.push_back(j);
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[found[i]] != i) return {};
    }
    return found;
  }

 private:
  [[nodiscard]] double tolerance() const { return 2.0 * kExactly * radius_; }
  [[nodiscard]] bool are_alike(const Outline& x, const Outline& y) const {
    return x.closed == y.closed && std::fabs(x.length - y.length) <= 2.0 * tolerance() &&
           std::fabs(length(x.center) - length(y.center)) <= tolerance();
  }
  static bool contains(const std::vector<std::size_t>& all, std::size_t j) {
    return std::find(all.begin(), all.end(), j) != all.end();
  }
  [[nodiscard]] bool is_image(const Outline& x, const Outline& y, double degrees) const {
    if (!are_alike(x, y)) return false;
    const Vec2 twice{std::cos(2.0 * degrees / kDegrees), std::sin(2.0 * degrees / kDegrees)};
    const auto mirrored = [&](Vec2 p) {
      return Vec2{twice.x * p.x + twice.y * p.y, twice.y * p.x - twice.x * p.y};
    };
    if (distance(mirrored(x.center), y.center) > tolerance()) return false;
    return std::all_of(x.points.begin(), x.points.end(),
                       [&](Vec2 p) { return y.distance_to(mirrored(p)) <= tolerance(); });
  }

  std::vector<Outline> all_;
  double radius_ = 0.0;
};

}  // namespace

std::vector<DrawingMirror> find_drawing_mirrors(std::span<const CubicPath> paths) {
  std::vector<DrawingMirror> found;
  if (paths.empty()) return found;
  const Outlines outlines(paths);
  for (const double degrees : outlines.candidates(paths)) {
    const bool known = std::any_of(found.begin(), found.end(), [&](const DrawingMirror& other) {
      return std::fabs(wrapped(other.degrees - degrees, 180.0)) < kSame;
    });
    if (known) continue;
    std::vector<std::size_t> images = outlines.images(degrees);
    if (!images.empty()) found.push_back({degrees, std::move(images)});
  }
  return found;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
