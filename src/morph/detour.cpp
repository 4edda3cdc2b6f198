#include "morph/detour.h"

#include <algorithm>
#include <cmath>

#include "curve/scratch.h"
#include "morph/measures.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Steps of the implicit flow: the more, the nearer to a Gaussian.
constexpr int kFlowSteps = 3;
// Edges shorter than this share of the mean one count as that long: handles that lie on their joints.
constexpr double kShortest = 1e-3;
// Control points up to which nothing is allocated: 200 segments.
constexpr std::size_t kOnStack = 601;

std::vector<double> edge_shares(const CubicPath& path) {
  const Points& p = path.control_points();
  std::vector<double> shares(p.size() - 1);
  double whole = 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double x = p[i + 1][0] - p[i][0];
    const double y = p[i + 1][1] - p[i][1];
    shares[i] = std::sqrt(x * x + y * y);
    whole += shares[i];
  }
  if (whole > 0.0) {
    for (double& share : shares) share /= whole;
  }
  return shares;
}

}  // namespace

Detour::Detour(const CubicPath& a, const CubicPath& b) : closed_(a.is_closed() && b.is_closed()) {
  const std::vector<double> of_a = edge_shares(a);
  const std::vector<double> of_b = edge_shares(b);
  const std::size_t n = of_a.size();
  std::vector<double> lengths(n);
  for (std::size_t i = 0; i < n; ++i) {
    lengths[i] = std::max(0.5 * of_a[i] + 0.5 * of_b[i], kShortest / static_cast<double>(n));
    conductance_.push_back(1.0 / lengths[i]);
  }
  mass_.resize(closed_ ? n : n + 1);
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const double before = i > 0 ? lengths[i - 1] : (closed_ ? lengths[n - 1] : 0.0);
    const double after = i < n ? lengths[i] : 0.0;
    mass_[i] = 0.5 * (before + after);
  }
  smooth_ = smooth_joints(a, b);
}

void Detour::apply(double width, std::span<double> points) const {
  if (!(width > 0.0)) return;
  const double before = signed_area(points);
  // A Gaussian of this standard deviation is heat after width^2 / 2.
  flow(0.5 * width * width / kFlowSteps, kFlowSteps, points);
  straighten(points);
  if (!closed_) return;
  const double after = signed_area(points);
  if (!(before * after > 0.0)) return;
  const double scale = std::sqrt(std::clamp(before / after, 1.0, 4.0));
  double x = 0.0;
  double y = 0.0;
  double whole = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    x += mass_[i] * points[2 * i];
    y += mass_[i] * points[2 * i + 1];
    whole += mass_[i];
  }
  x /= whole;
  y /= whole;
  for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
    points[i] = x + scale * (points[i] - x);
    points[i + 1] = y + scale * (points[i + 1] - y);
  }
}

// Implicit steps of the same time: each solves (M + time K) q = M p, tridiagonal, with corners where the path
// is closed (Sherman and Morrison). The matrix is factored once.
void Detour::flow(double time, int steps, std::span<double> points) const {
  const std::size_t n = mass_.size();
  Scratch<4 * kOnStack> scratch(4 * n);
  double* const upper = scratch.data();  // by the pivots, as the next two
  double* const lower = upper + n;
  double* const mass = lower + n;
  double* const corner = mass + n;                                          // the column that closes the loop
  const auto link = [&](std::size_t i) { return time * conductance_[i]; };  // point i to i + 1
  const bool pinned = !closed_;                                             // the ends stay
  const auto is_pinned = [&](std::size_t i) { return pinned && (i == 0 || i == n - 1); };
  const auto below = [&](std::size_t i) { return is_pinned(i) ? 0.0 : -link(i - 1); };  // (i, i - 1)
  const auto above = [&](std::size_t i) { return is_pinned(i) ? 0.0 : -link(i); };      // (i, i + 1)
  const auto diagonal = [&](std::size_t i) {
    if (is_pinned(i)) return 1.0;
    return mass_[i] + link(i > 0 ? i - 1 : n - 1) + link(i + 1 < n ? i : n - 1);
  };
  const double wrap = closed_ ? -link(n - 1) : 0.0;
  const double gamma = closed_ ? -diagonal(0) : 1.0;
  for (std::size_t i = 0; i < n; ++i) {
    double pivot = diagonal(i);
    double column = 0.0;
    if (closed_ && i == 0) {
      pivot -= gamma;
      column = gamma;
    }
    if (closed_ && i == n - 1) {
      pivot -= wrap * wrap / gamma;
      column = wrap;
    }
    if (i > 0) pivot -= below(i) * upper[i - 1];
    const double inverse = 1.0 / pivot;
    upper[i] = i + 1 < n ? above(i) * inverse : 0.0;
    lower[i] = i > 0 ? below(i) * inverse : 0.0;
    mass[i] = (is_pinned(i) ? 1.0 : mass_[i]) * inverse;
    corner[i] = column * inverse - (i > 0 ? lower[i] * corner[i - 1] : 0.0);
  }
  for (std::size_t i = n - 1; i-- > 0;) corner[i] -= upper[i] * corner[i + 1];
  const double share = wrap / gamma;
  const double denominator = 1.0 + corner[0] + share * corner[n - 1];
  double* const p = points.data();
  for (int step = 0; step < steps; ++step) {
    double x = 0.0;
    double y = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      x = p[2 * i] = mass[i] * p[2 * i] - lower[i] * x;
      y = p[2 * i + 1] = mass[i] * p[2 * i + 1] - lower[i] * y;
    }
    for (std::size_t i = n - 1; i-- > 0;) {
      p[2 * i] -= upper[i] * p[2 * i + 2];
      p[2 * i + 1] -= upper[i] * p[2 * i + 3];
    }
    if (!closed_) continue;
    const double along_x = (p[0] + share * p[2 * n - 2]) / denominator;
    const double along_y = (p[1] + share * p[2 * n - 1]) / denominator;
    for (std::size_t i = 0; i < n; ++i) {
      p[2 * i] -= along_x * corner[i];
      p[2 * i + 1] -= along_y * corner[i];
    }
  }
  if (closed_) std::copy_n(p, 2, p + 2 * n);
}

// Handles on both sides of a smooth joint back into one line, at their lengths.
void Detour::straighten(std::span<double> points) const {
  const std::size_t n = points.size() / 2 - 1;
  for (const std::size_t joint : smooth_) {
    const std::size_t before = joint == 0 ? n - 1 : joint - 1;
    const std::size_t after = joint + 1;
    const double px = points[2 * joint];
    const double py = points[2 * joint + 1];
    const double ix = px - points[2 * before];
    const double iy = py - points[2 * before + 1];
    const double ox = points[2 * after] - px;
    const double oy = points[2 * after + 1] - py;
    const double in = std::sqrt(ix * ix + iy * iy);
    const double out = std::sqrt(ox * ox + oy * oy);
    const double sx = ix + ox;
    const double sy = iy + oy;
    const double sum = std::sqrt(sx * sx + sy * sy);
    if (!(in > 0.0 && out > 0.0 && sum > 0.0)) continue;
    points[2 * before] = px - in * sx / sum;
    points[2 * before + 1] = py - in * sy / sum;
    points[2 * after] = px + out * sx / sum;
    points[2 * after + 1] = py + out * sy / sum;
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
