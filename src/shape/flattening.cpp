#include "shape/flattening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "shape/plane.h"

namespace tandem {
inline namespace v0 {
namespace {

// Turning of a piece's control polygon (radians) above which it is halved.
constexpr double kTurning = 0.09;

// Length of a piece's control polygon below which it is no longer halved, as a share of the scale: cusps turn
// at once, however short the piece.
constexpr double kShortest = 2e-5;

// Vertices closer to the one before are left out: directions between them are rounding.
constexpr double kSame = 1e-6;

// Halvings of a segment: 2^-10 of a segment as large as the picture is 1e-3 of it, where all but cusps are
// straight within any tolerance of use.
constexpr int kDeepest = 10;

struct Cubic {
  Vec2 p0, p1, p2, p3;
};

// The angles between successive legs of the control polygon sum up to kTurning at most; tan x >= x.
bool turns_little(Vec2 a, Vec2 b, Vec2 c) {
  constexpr double kNone = 1e-24;  // squared length of a leg without a direction
  const bool has_a = dot(a, a) > kNone;
  const bool has_b = dot(b, b) > kNone;
  const bool has_c = dot(c, c) > kNone;
  if (!has_b) return !has_a || !has_c || std::abs(cross(a, c)) <= kTurning * dot(a, c);
  const double d1 = has_a ? dot(a, b) : 1.0;
  const double d2 = has_c ? dot(b, c) : 1.0;
  if (!(d1 > 0.0 && d2 > 0.0)) return false;
  const double c1 = has_a ? std::abs(cross(a, b)) : 0.0;
  const double c2 = has_c ? std::abs(cross(b, c)) : 0.0;
  return c1 * d2 + c2 * d1 <= kTurning * d1 * d2;
}

bool is_short(Vec2 a, Vec2 b, Vec2 c) {
  // Mostly seen without a root.
  if (std::abs(a.x) + std::abs(b.x) + std::abs(c.x) > 2.0 * kShortest) return false;
  return length(a) + length(b) + length(c) <= kShortest;
}

// The cheapest look first: all roots together would take longest.
bool is_flat(const Cubic& c, double tolerance) {
  const Vec2 a = minus(c.p1, c.p0);
  const Vec2 b = minus(c.p2, c.p1);
  const Vec2 d = minus(c.p3, c.p2);
  if (is_short(a, b, d)) return true;
  if (!turns_little(a, b, d)) return false;
  const Vec2 chord = minus(c.p3, c.p0);
  const double along = length(chord);
  const double off = std::max(std::abs(cross(a, chord)), std::abs(cross(d, chord)));
  return !(along > 1e-12 ? off > tolerance * along : std::max(length(a), length(d)) > tolerance);
}

class Halving {
 public:
  Halving(std::vector<FlatVertex>& vertices, double tolerance) : vertices_(vertices), tolerance_(tolerance) {}

  void add(const Cubic& c, double from, double share, int depth) {
    if (depth == kDeepest || is_flat(c, tolerance_)) {
      push({c.p3.x, c.p3.y, from + share});
      return;
    }
    const Vec2 p01 = middle(c.p0, c.p1);
    const Vec2 p12 = middle(c.p1, c.p2);
    const Vec2 p23 = middle(c.p2, c.p3);
    const Vec2 q = middle(p01, p12);
    const Vec2 r = middle(p12, p23);
    const Vec2 m = middle(q, r);
    add({c.p0, p01, q, m}, from, 0.5 * share, depth + 1);
    add({m, r, p23, c.p3}, from + 0.5 * share, 0.5 * share, depth + 1);
  }

 private:
  void push(const FlatVertex& v) {
    const FlatVertex& before = vertices_.back();
    const Vec2 step{v.x - before.x, v.y - before.y};
    if (dot(step, step) > kSame * kSame) vertices_.push_back(v);
  }

  std::vector<FlatVertex>& vertices_;
  double tolerance_;
};

}  // namespace

Flattening::Frame Flattening::find_frame(std::span<const PathView> paths, double tolerance, double scale) {
  Frame frame;
  frame.tolerance = tolerance;
  if (paths.empty()) return frame;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec2 lo{kInfinity, kInfinity};
  Vec2 hi{-kInfinity, -kInfinity};
  for (const PathView& path : paths) {
    for (std::size_t i = 0; i + 1 < path.points.size(); i += 2) {
      lo = {std::min(lo.x, path.points[i]), std::min(lo.y, path.points[i + 1])};
      hi = {std::max(hi.x, path.points[i]), std::max(hi.y, path.points[i + 1])};
    }
  }
  frame.half_center = {0.25 * lo.x + 0.25 * hi.x, 0.25 * lo.y + 0.25 * hi.y};
  const double width = 0.5 * hi.x - 0.5 * lo.x;
  const double height = 0.5 * hi.y - 0.5 * lo.y;
  const double largest = std::max(width, height);
  const double w = largest > 0.0 ? width / largest : 0.0;
  const double h = largest > 0.0 ? height / largest : 0.0;
  const double half_diagonal = scale > 0.0 ? 0.5 * scale : largest * std::sqrt(w * w + h * h);
  if (half_diagonal > 0.0) frame.half_scale = half_diagonal;
  if (!(scale > 0.0)) return frame;
  const auto to_unit = [&](double x) { return frame.half_scale * std::round(x / frame.half_scale); };
  const Vec2 whole{to_unit(frame.half_center.x), to_unit(frame.half_center.y)};
  if (std::isfinite(whole.x) && std::isfinite(whole.y)) frame.half_center = whole;
  return frame;
}

void Flattening::flatten(const PathView& path) {
  FlatPath flat;
  flat.first = vertices_.size();
  flat.closed = path.closed;
  const auto point = [&](std::size_t i) { return to_flat(path.points[2 * i], path.points[2 * i + 1]); };
  Vec2 start = point(0);
  const Vec2 origin = start;
  vertices_.push_back({start.x, start.y, 0.0});
  Halving halving(vertices_, frame_.tolerance);
  const std::size_t count = path.segment_count();
  for (std::size_t i = 0; i < count; ++i) {
    const Cubic cubic{start, point(3 * i + 1), point(3 * i + 2), point(3 * i + 3)};
    halving.add(cubic, static_cast<double>(i), 1.0, 0);
    start = cubic.p3;
  }
  if (flat.closed) {
    const auto back_at_origin = [&] {
      const Vec2 gap{vertices_.back().x - origin.x, vertices_.back().y - origin.y};
      return dot(gap, gap) <= kSame * kSame;
    };
    while (vertices_.size() > flat.first + 1 && back_at_origin()) vertices_.pop_back();
    if (vertices_.size() > flat.first + 1) {
      vertices_.push_back({origin.x, origin.y, static_cast<double>(count)});
    }
  }
  flat.last = vertices_.size() - 1;
  paths_.push_back(flat);
}

Vec2 Flattening::point(const PathView& path, double u) const noexcept {
  const double last = static_cast<double>(path.segment_count() - 1);
  const double segment = std::min(std::floor(u), last);
  const double t = u - segment;
  const double s = 1.0 - t;
  const double* c = path.points.data() + 6 * static_cast<std::size_t>(segment);
  const std::array<double, 4> weights{s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
  Vec2 p;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 q = to_flat(c[2 * k], c[2 * k + 1]);
    p = {p.x + weights[k] * q.x, p.y + weights[k] * q.y};
  }
  return p;
}

void Flattening::assign(std::span<const PathView> paths, double tolerance, double scale) {
  const Frame frame = find_frame(paths, tolerance, scale);
  const std::size_t known = frame == frame_ ? std::min(paths.size(), paths_.size()) : 0;
  frame_ = frame;
  std::swap(vertices_, vertices_before_);
  std::swap(paths_, paths_before_);
  vertices_.clear();
  paths_.clear();
  changed_.assign(paths.size(), true);
  points_.resize(paths.size());
  for (std::size_t p = 0; p < paths.size(); ++p) {
    const auto& [points, closed] = paths[p];
    if (p < known && closed == paths_before_[p].closed && std::ranges::equal(points, points_[p])) {
      FlatPath same = paths_before_[p];
      const auto begin = vertices_before_.begin();
      const std::size_t first = vertices_.size();
      vertices_.insert(vertices_.end(), begin + static_cast<std::ptrdiff_t>(same.first),
                       begin + static_cast<std::ptrdiff_t>(same.last) + 1);
      same.last = vertices_.size() - 1;
      same.first = first;
      paths_.push_back(same);
      changed_[p] = false;
    } else {
      flatten(paths[p]);
      points_[p].assign(points.begin(), points.end());
    }
  }
}

}  // namespace v0
}  // namespace tandem
