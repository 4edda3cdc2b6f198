#include "morph/detour.h"

#include <algorithm>
#include <cmath>

#include "curve/scratch.h"
#include "morph/measures.h"
#include "tandem/shape/transform.h"

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

/// An implicit step of the flow: solves (M + time K) q = M p, tridiagonal, with corners where the path is
/// closed (Sherman and Morrison). The matrix is factored once, from both ends towards the middle: two chains
/// of half the length, at which a processor works at once.
class HeatFlow {
 public:
  static constexpr std::size_t kRoom = 4;  ///< doubles per point

  /// conductance: per edge. mass: per point, at least three. room: must outlive it.
  HeatFlow(std::span<const double> conductance, std::span<const double> mass, bool closed, double time,
           double* room)
      : n_(mass.size()),
        middle_(n_ / 2),
        closed_(closed),
        mass_(room),
        in_(mass_ + n_),
        out_(in_ + n_),
        corner_(out_ + n_) {
    const auto link = [&](std::size_t i) { return time * conductance[i]; };  // point i to i + 1
    const auto add_row = [&](std::size_t i) {
      if (!closed && (i == 0 || i == n_ - 1)) return set_row(i, {1.0, 1.0, 0.0, 0.0, 0.0});  // the ends stay
      const double before = link(i > 0 ? i - 1 : n_ - 1);
      const double after = link(i);
      Row row{mass[i], mass[i] + before + after, -before, -after, 0.0};
      if (i == 0) {
        wrap_ = before / row.diagonal;
        row.corner = -row.diagonal;
        row.diagonal += row.diagonal;
      } else if (i == n_ - 1) {
        row.corner = -after;
        row.diagonal += after * wrap_;
      }
      set_row(i, row);
    };
    for (std::size_t k = 0; k + middle_ + 1 < n_; ++k) {
      add_row(k);
      add_row(n_ - 1 - k);
    }
    if (n_ % 2 == 0) add_row(middle_ - 1);
    add_row(middle_);
    if (!closed) return;
    for (std::size_t k = 1; k <= middle_; ++k) {
      corner_[middle_ - k] -= out_[middle_ - k] * corner_[middle_ - k + 1];
      if (middle_ + k < n_) corner_[middle_ + k] -= out_[middle_ + k] * corner_[middle_ + k - 1];
    }
    denominator_ = 1.0 + corner_[0] + wrap_ * corner_[n_ - 1];
  }

  void flow(double* p) const {
    inwards(p);
    outwards(p);
    if (!closed_) return;
    const double along_x = (p[0] + wrap_ * p[2 * n_ - 2]) / denominator_;
    const double along_y = (p[1] + wrap_ * p[2 * n_ - 1]) / denominator_;
    for (std::size_t i = 0; i < n_; ++i) {
      p[2 * i] -= along_x * corner_[i];
      p[2 * i + 1] -= along_y * corner_[i];
    }
  }

 private:
  struct Row {
    double mass;
    double diagonal;
    double before;
    double after;
    double corner;  ///< of the column that closes the loop
  };

  /// Eliminates the neighbour towards the end, which must be set; both neighbours of the middle.
  void set_row(std::size_t i, const Row& row) {
    double pivot = row.diagonal;
    double corner = row.corner;
    if (i > 0 && i <= middle_) {
      pivot -= row.before * out_[i - 1];
      corner -= row.before * corner_[i - 1];
    }
    if (i + 1 < n_ && i >= middle_) {
      pivot -= row.after * out_[i + 1];
      corner -= row.after * corner_[i + 1];
    }
    const double inverse = 1.0 / pivot;
    mass_[i] = row.mass * inverse;
    in_[i] = (i <= middle_ ? row.before : row.after) * inverse;
    out_[i] = (i <= middle_ ? row.after : row.before) * inverse;
    corner_[i] = corner * inverse;
  }

  void inwards(double* p) const {
    Vec2 head{};
    Vec2 tail{};
    const auto pass = [&](std::size_t i, Vec2& before) {
      before = {mass_[i] * p[2 * i] - in_[i] * before.x, mass_[i] * p[2 * i + 1] - in_[i] * before.y};
      p[2 * i] = before.x;
      p[2 * i + 1] = before.y;
    };
    for (std::size_t k = 0; k + middle_ + 1 < n_; ++k) {
      pass(k, head);
      pass(n_ - 1 - k, tail);
    }
    if (n_ % 2 == 0) pass(middle_ - 1, head);
    pass(middle_, head);
    p[2 * middle_] -= out_[middle_] * tail.x;
    p[2 * middle_ + 1] -= out_[middle_] * tail.y;
  }

  void outwards(double* p) const {
    Vec2 head{p[2 * middle_], p[2 * middle_ + 1]};
    Vec2 tail = head;
    const auto pass = [&](std::size_t i, Vec2& before) {
      before = {p[2 * i] - out_[i] * before.x, p[2 * i + 1] - out_[i] * before.y};
      p[2 * i] = before.x;
      p[2 * i + 1] = before.y;
    };
    for (std::size_t k = 1; middle_ + k < n_; ++k) {
      pass(middle_ - k, head);
      pass(middle_ + k, tail);
    }
    if (n_ % 2 == 0) pass(0, head);
  }

  std::size_t n_;
  std::size_t middle_;
  bool closed_;
  double wrap_ = 0.0;  ///< share of the last point in the rank-one term
  double denominator_ = 1.0;
  double* mass_;  ///< by the pivots, as the next three
  double* in_;    ///< to the neighbour towards the end; of the middle, to the one before it
  double* out_;   ///< to the neighbour towards the middle; of the middle, to the one after it
  double* corner_;
};

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

void Detour::flow(double time, int steps, std::span<double> points) const {
  Scratch<HeatFlow::kRoom * kOnStack> room(HeatFlow::kRoom * mass_.size());
  const HeatFlow heat(conductance_, mass_, closed_, time, room.data());
  for (int step = 0; step < steps; ++step) heat.flow(points.data());
  if (closed_) std::copy_n(points.begin(), 2, points.end() - 2);
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
