#include "morph/intrinsic_blend.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "curve/scratch.h"
#include "shape/plane.h"
#include "shape/trigonometry.h"
#include "tandem/curve/points.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Every edge gives a little, as a share of the mean length: otherwise edges of equal length would have to
// bear what does not close.
constexpr double kLeastGive = 0.02;
// Steps towards a closed polygon: they converge cubically, 2 to 4 are usual.
constexpr int kMostSteps = 20;
constexpr double kClosed = 1e-13;  // of the perimeter
// A step this small is the last: what it leaves open is of the size of its cube.
constexpr double kLastStep = 1e-5;
// Edges up to which nothing is allocated: 200 segments.
constexpr std::size_t kOnStack = 600;

struct Heading {
  double length = 0.0;
  double degrees = 0.0;
};

double signed_turn(double from, double to) {
  double turn = std::fmod(to - from, 360.0);
  if (turn > 180.0) turn -= 360.0;
  if (turn <= -180.0) turn += 360.0;
  return turn;
}

// Edges of no length, as of a handle that lies on its joint, point where the next one of their segment does,
// the last ones of a segment where the one before does.
std::vector<Heading> headings_of(const CubicPath& path) {
  const Points& p = path.control_points();
  std::vector<Heading> edges(p.size() - 1);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double x = p[i + 1][0] - p[i][0];
    const double y = p[i + 1][1] - p[i][1];
    edges[i] = {std::sqrt(x * x + y * y), angle_degrees(x, y)};
  }
  const auto has_length = [](const Heading& edge) { return edge.length > 0.0; };
  const auto first = std::find_if(edges.begin(), edges.end(), has_length);
  for (auto edge = edges.begin(); edge != edges.end(); ++edge) {
    if (has_length(*edge)) continue;
    const auto end = edges.begin() + (edge - edges.begin()) / 3 * 3 + 3;
    const auto next = std::find_if(edge, end, has_length);
    if (next != end) {
      edge->degrees = next->degrees;
    } else if (edge != edges.begin()) {
      edge->degrees = (edge - 1)->degrees;
    } else if (first != edges.end()) {
      edge->degrees = first->degrees;
    }
  }
  return edges;
}

bool is_point(const std::vector<Heading>& edges) {
  return std::all_of(edges.begin(), edges.end(), [](const Heading& edge) { return !(edge.length > 0.0); });
}

void copy_headings(const std::vector<Heading>& from, std::vector<Heading>& to) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i].degrees = from[i].degrees;
}

/// The turn at every control point; the first one's is that at the seam.
std::vector<double> turns_of(const std::vector<Heading>& edges) {
  std::vector<double> turns;
  turns.reserve(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    turns.push_back(signed_turn(edges[i == 0 ? edges.size() - 1 : i - 1].degrees, edges[i].degrees));
  }
  return turns;
}

/// Turns by nearly 180 degrees, as where handles pass each other, could as well go the other way round. Where
/// two loops do not wind alike, the nearest to that do: otherwise all of the difference would fall upon the
/// seam, smooth or not.
void wind_alike(std::vector<double>& a, std::vector<double>& b) {
  const auto whole = [](const std::vector<double>& turns) {
    return std::floor(std::accumulate(turns.begin(), turns.end(), 0.0) / 360.0 + 0.5);
  };
  const double more = whole(b) - whole(a);
  for (double left = std::fabs(more); left > 0.0; left -= 1.0) {
    std::vector<double>& larger = more > 0.0 ? b : a;
    std::vector<double>& smaller = more > 0.0 ? a : b;
    const auto top = std::max_element(larger.begin(), larger.end());
    const auto bottom = std::min_element(smaller.begin(), smaller.end());
    if (*top >= -*bottom) {
      *top -= 360.0;
    } else {
      *bottom += 360.0;
    }
  }
}

/// The middle of every edge, weighted with `lengths`.
template <class Length>
void center_of(const Points& p, std::size_t edges, const Length& length, double* center) {
  double x = 0.0;
  double y = 0.0;
  double whole = 0.0;
  for (std::size_t i = 0; i < edges; ++i) {
    const double weight = length(i);
    x += weight * 0.5 * (p[i][0] + p[i + 1][0]);
    y += weight * 0.5 * (p[i][1] + p[i + 1][1]);
    whole += weight;
  }
  center[0] = whole > 0.0 ? x / whole : p[0][0];
  center[1] = whole > 0.0 ? y / whole : p[0][1];
}

/// What a step towards a closed polygon is made of: sums over edges of their lengths times their directions,
/// once, twice and three times, with one `give` less each.
class ClosingSums {
 public:
  void add(Vec2 d, double length, double give) {
    const double lx = length * d.x;
    const double ly = length * d.y;
    const double kx = give * lx;
    const double ky = give * ly;
    const double xx = kx * d.x;
    const double xy = kx * d.y;
    const double yy = ky * d.y;
    gap_.x += lx;
    gap_.y += ly;
    xx_ += xx;
    xy_ += xy;
    yy_ += yy;
    xxx_ += give * xx * d.x;
    xxy_ += give * xx * d.y;
    xyy_ += give * yy * d.x;
    yyy_ += give * yy * d.y;
  }

  [[nodiscard]] double gap_size() const { return std::sqrt(dot(gap_, gap_)); }
  [[nodiscard]] double determinant() const { return xx_ * yy_ - xy_ * xy_; }
  [[nodiscard]] Vec2 step() const {
    const Vec2 newton = solve(gap_);
    const double xx = newton.x * newton.x;
    const double xy = 2.0 * newton.x * newton.y;
    const double yy = newton.y * newton.y;
    const Vec2 more = solve({0.5 * (xx * xxx_ + xy * xxy_ + yy * xyy_),  //
                             0.5 * (xx * xxy_ + xy * xyy_ + yy * yyy_)});
    if (dot(more, more) > kMostCurved * dot(newton, newton)) return newton;
    return {newton.x + more.x, newton.y + more.y};
  }

 private:
  // Far from the end the second derivative leads astray: its share of the step, squared.
  static constexpr double kMostCurved = 0.25;

  [[nodiscard]] Vec2 solve(Vec2 v) const {
    return {(yy_ * v.x - xy_ * v.y) / determinant(), (xx_ * v.y - xy_ * v.x) / determinant()};
  }

  Vec2 gap_{};
  double xx_ = 0.0, xy_ = 0.0, yy_ = 0.0;
  double xxx_ = 0.0, xxy_ = 0.0, xyy_ = 0.0, yyy_ = 0.0;
};

}  // namespace

IntrinsicBlend::IntrinsicBlend(const CubicPath& a, const CubicPath& b)
    : closed_(a.is_closed() && b.is_closed()) {
  std::vector<Heading> of_a = headings_of(a);
  std::vector<Heading> of_b = headings_of(b);
  // What grows from a point does not turn.
  if (is_point(of_a)) copy_headings(of_b, of_a);
  if (is_point(of_b)) copy_headings(of_a, of_b);
  double whole = 0.0;
  for (std::size_t i = 0; i < of_a.size(); ++i) whole += 0.5 * (of_a[i].length + of_b[i].length);
  const double least = kLeastGive * whole / static_cast<double>(of_a.size());
  std::vector<double> at_points_a = turns_of(of_a);
  std::vector<double> at_points_b = turns_of(of_b);
  if (closed_) wind_alike(at_points_a, at_points_b);
  double turn = 0.0;
  double mean = 0.0;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    turn += i == 0 ? signed_turn(of_a[0].degrees, of_b[0].degrees) : at_points_b[i] - at_points_a[i];
    const double length = 0.5 * (of_a[i].length + of_b[i].length);
    if (whole > 0.0) mean += length / whole * turn;
    edges_.push_back({of_a[i].length, of_b[i].length, of_a[i].degrees, turn,
                      std::max(least, std::fabs(of_a[i].length - of_b[i].length))});
  }
  // Whole turns make no difference at the ends; the smallest turn on the way does.
  const double laps = std::floor(mean / 360.0 + 0.5) * 360.0;
  for (Edge& edge : edges_) edge.turn -= laps;
  center_of(
      a.control_points(), edges_.size(), [&](std::size_t i) { return of_a[i].length; }, center_a_);
  center_of(
      b.control_points(), edges_.size(), [&](std::size_t i) { return of_b[i].length; }, center_b_);
}

double IntrinsicBlend::Edge::length_at(double s) const {
  return std::max(0.0, (1.0 - s) * length_a + s * length_b);
}

// Chebyshev's method: Newton's, and what the second derivative adds where that is less.
void IntrinsicBlend::close(double s, std::span<const double> directions, std::span<double> lengths,
                           std::span<const double> gives) const {
  const std::size_t n = lengths.size();
  const double* const p = directions.data();
  const double whole = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  Vec2 at{};
  for (int step = 0; step < kMostSteps; ++step) {
    ClosingSums sums;
    for (std::size_t i = 0; i < n; ++i) sums.add({p[2 * i], p[2 * i + 1]}, lengths[i], gives[i]);
    if (sums.gap_size() <= kClosed * whole) return;
    if (!(sums.determinant() > 0.0)) return;
    Vec2 way = sums.step();
    const double size = std::sqrt(dot(way, way));
    if (size <= kLastStep) {  // needs no exponentials
      for (std::size_t i = 0; i < n; ++i) {
        const double x = gives[i] * (way.x * p[2 * i] + way.y * p[2 * i + 1]);
        lengths[i] *= 1.0 - x * (1.0 - x * (0.5 - x / 6.0));
      }
      return;
    }
    if (size > 1.0) way = {way.x / size, way.y / size};  // could overshoot where exponentials grow
    at = {at.x + way.x, at.y + way.y};
    for (std::size_t i = 0; i < n; ++i) {
      const double x = gives[i] * (at.x * p[2 * i] + at.y * p[2 * i + 1]);
      lengths[i] = edges_[i].length_at(s) * std::exp(std::clamp(-x, -30.0, 30.0));
    }
  }
}

void IntrinsicBlend::at(double s, std::span<double> points) const {
  const std::size_t n = edges_.size();
  // Until they are added up, point i + 1 holds the direction of edge i.
  double* p = points.data();
  Scratch<2 * kOnStack> scratch(2 * n);
  double* const lengths = scratch.data();
  double* const gives = lengths + n;  // as shares of the lengths, bounded where a length vanishes
  for (std::size_t i = 0; i < n; ++i) {
    const CosSin direction = cos_sin_degrees(edges_[i].heading + s * edges_[i].turn);
    p[2 * i + 2] = direction.cosine;
    p[2 * i + 3] = direction.sine;
    lengths[i] = edges_[i].length_at(s);
    gives[i] = lengths[i] > 0.0 ? std::min(edges_[i].give / lengths[i], 8.0) : 0.0;
  }
  if (closed_) close(s, {p + 2, 2 * n}, {lengths, n}, {gives, n});
  double cx = 0.0;
  double cy = 0.0;
  double sum = 0.0;
  p[0] = 0.0;
  p[1] = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double c = p[2 * i + 2];
    const double d = p[2 * i + 3];
    const double length = lengths[i];
    p[2 * i + 2] = p[2 * i] + length * c;
    p[2 * i + 3] = p[2 * i + 1] + length * d;
    cx += length * 0.5 * (p[2 * i] + p[2 * i + 2]);
    cy += length * 0.5 * (p[2 * i + 1] + p[2 * i + 3]);
    sum += length;
  }
  const double ox = (1.0 - s) * center_a_[0] + s * center_b_[0] - (sum > 0.0 ? cx / sum : 0.0);
  const double oy = (1.0 - s) * center_a_[1] + s * center_b_[1] - (sum > 0.0 ? cy / sum : 0.0);
  // What is left open after the last step is spread along the way.
  const double gap_x = closed_ ? p[2 * n] : 0.0;
  const double gap_y = closed_ ? p[2 * n + 1] : 0.0;
  for (std::size_t i = 0; i <= n; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(n);
    p[2 * i] += ox - share * gap_x;
    p[2 * i + 1] += oy - share * gap_y;
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
