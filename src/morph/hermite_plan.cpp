#include "morph/hermite_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "match/vector.h"
#include "shape/trigonometry.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// A handle shorter than this share of its segment has no direction of its own, only rounding.
constexpr double kNoHandle = 1e-12;

/// Handles within this share of the path's size from the thirds make a straight line.
constexpr double kStraight = 1e-12;

/// cos(0.05 rad): a joint that turns by less is meant to be smooth (see SampleOptions::corner_angle).
constexpr double kSmooth = 0.99875026;

/// cos(0.002 rad): lines that meet at less are pieces of one; polygons turn by more. Real icons' joints are
/// smooth to 1e-3.
constexpr double kOneLine = 0.999998;

/// Directions whose sum is shorter than this are opposite: within 11.5 degrees. Their mean would turn round
/// at more than ten times the speed of an even turn.
constexpr double kOpposite = 0.2;

/// By so much (rad) lines that stay straight may add to the turn of their joint.
constexpr double kRounding = 1e-10;

/// One end of a segment, in one of the paths.
struct Tangent {
  Point direction;  ///< unit, as the segment runs; zero: unknown
  double length = 0.0;

  [[nodiscard]] bool known() const { return largest(direction) > 0.0; }
};

Point difference(std::span<const double> from, std::span<const double> to) {
  Point d(from.size());
  for (std::size_t k = 0; k < d.size(); ++k) d[k] = to[k] - from[k];
  return d;
}

/// From the end at points[0] inwards (sign 1), or from there outwards (sign -1).
Tangent tangent_of(const std::array<std::span<const double>, 4>& points, double sign) {
  std::array<Point, 3> arms;
  std::array<double, 3> lengths{};
  double size = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    arms[k] = difference(points[0], points[k + 1]);
    lengths[k] = normalize(arms[k]);
    size = std::max(size, lengths[k]);
  }
  Tangent tangent{Point(points[0].size(), 0.0), lengths[0]};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(lengths[k] > kNoHandle * size)) continue;
    for (double& x : arms[k]) x *= sign;
    tangent.direction = std::move(arms[k]);
    break;
  }
  return tangent;
}

double angle_between(std::span<const double> x, std::span<const double> y) {
  Point sum(x.size());
  Point gap(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    sum[k] = x[k] + y[k];
    gap[k] = x[k] - y[k];
  }
  const double far = std::sqrt(dot(gap, gap));
  const double near = std::sqrt(dot(sum, sum));
  return angle_degrees(near, far) * (3.14159265358979323846 / 90.0);
}

bool opposite(std::span<const double> x, std::span<const double> y) {
  return dot(x, y) < 0.5 * kOpposite * kOpposite - 1.0;  // |x + y|^2 = 2 + 2 <x, y>
}

/// A unit vector orthogonal to the unit vector w: in the plane the positive quarter turn.
Point any_orthogonal(std::span<const double> w) {
  Point t(w.size(), 0.0);
  if (w.size() == 1) return t;
  if (w.size() == 2) return {-w[1], w[0]};
  std::size_t axis = 0;
  for (std::size_t k = 1; k < w.size(); ++k) {
    if (std::fabs(w[k]) < std::fabs(w[axis])) axis = k;
  }
  for (std::size_t k = 0; k < w.size(); ++k) t[k] = (k == axis ? 1.0 : 0.0) - w[axis] * w[k];
  normalize(t);
  return t;
}

/// Plans the blend of two paths, joint by joint.
class Planner {
 public:
  Planner(const CubicPath& a, const CubicPath& b) : paths_{&a, &b}, segments_(a.segment_count()) {
    plan_.a = a.control_points();
    plan_.b = b.control_points();
    plan_.closed = a.is_closed();
    for (std::size_t x = 0; x < 2; ++x) {
      for (std::size_t i = 0; i < segments_; ++i) {
        const auto [p0, p1, p2, p3] = paths_[x]->segment(i);
        tangents_[x].push_back(tangent_of({p0, p1, p2, p3}, 1.0));
        tangents_[x].push_back(tangent_of({p3, p2, p1, p0}, -1.0));
      }
    }
    plan_.handles.resize(2 * segments_);
    plan_.rests = Points(a.dim(), 4 * segments_);
    for (std::size_t h = 0; h < 2 * segments_; ++h) {
      for (std::size_t x = 0; x < 2; ++x) plan_.handles[h].lengths[x] = tangents_[x][h].length;
    }
  }

  HermitePlan run() {
    if (plan_.closed) share_directions(2 * segments_ - 1, 0);
    for (std::size_t i = 1; i < segments_; ++i) share_directions(2 * i - 1, 2 * i);
    if (!plan_.closed) {
      share_directions(0, 0);
      share_directions(2 * segments_ - 1, 2 * segments_ - 1);
    }
    find_straight();
    if (plan_.closed) plan_joint(2 * segments_ - 1, 0);
    for (std::size_t i = 1; i < segments_; ++i) plan_joint(2 * i - 1, 2 * i);
    if (!plan_.closed) {
      plan_corner(0, nullptr);
      plan_corner(2 * segments_ - 1, nullptr);
    }
    return std::move(plan_);
  }

 private:
  [[nodiscard]] const Point& direction(std::size_t x, std::size_t h) const {
    return tangents_[x][h].direction;
  }

  /// Gives a direction to the handles of a joint that have none. in and out: the ends that meet there.
  void share_directions(std::size_t in, std::size_t out) {
    for (std::size_t x = 0; x < 2; ++x) {
      Tangent& left = tangents_[x][in];
      Tangent& right = tangents_[x][out];
      if (!left.known()) left.direction = right.direction;
      if (!right.known()) right.direction = left.direction;
    }
    for (const std::size_t h : {in, out}) {
      for (std::size_t x = 0; x < 2; ++x) {
        if (!tangents_[x][h].known()) tangents_[x][h].direction = tangents_[1 - x][h].direction;
      }
    }
  }

  [[nodiscard]] bool meets(std::size_t in, std::size_t out, double cosine) const {
    return dot(direction(0, in), direction(0, out)) >= cosine &&
           dot(direction(1, in), direction(1, out)) >= cosine;
  }

  [[nodiscard]] bool turns_back(std::size_t h) const { return opposite(direction(0, h), direction(1, h)); }

  /// Where a straight line runs at s: its chord, not normalised.
  [[nodiscard]] Point line_at(std::size_t segment, double s) const {
    Point chord(direction(0, 0).size());
    for (std::size_t k = 0; k < chord.size(); ++k) {
      chord[k] = (1.0 - s) * (plan_.a[3 * segment + 3][k] - plan_.a[3 * segment][k]) +
                 s * (plan_.b[3 * segment + 3][k] - plan_.b[3 * segment][k]);
    }
    return chord;
  }

  /// Whether two lines that meet smoothly in both paths do so all the time.
  [[nodiscard]] bool stay_one_line(std::size_t before, std::size_t after) const {
    const std::size_t in = 2 * before + 1;
    const std::size_t out = 2 * after;
    double most = kRounding;
    for (std::size_t x = 0; x < 2; ++x) {
      most = std::max(most, kRounding + angle_between(direction(x, in), direction(x, out)));
    }
    for (const double s : {0.25, 0.5, 0.75}) {
      Point left = line_at(before, s);
      Point right = line_at(after, s);
      if (normalize(left) == 0.0 || normalize(right) == 0.0) continue;
      if (angle_between(left, right) > most) return false;
    }
    return true;
  }

  void find_straight() {
    double size = 0.0;
    for (const CubicPath* path : paths_) size = std::max(size, largest(path->control_points().data()));
    std::vector<char> lines(segments_);
    for (std::size_t i = 0; i < segments_; ++i) {
      lines[i] = paths_[0]->is_line(i, kStraight * size) && paths_[1]->is_line(i, kStraight * size) ? 1 : 0;
    }
    plan_.straight = lines;
    const auto settle = [&](std::size_t before, std::size_t after) {
      const std::size_t in = 2 * before + 1;
      const std::size_t out = 2 * after;
      const bool both = lines[before] != 0 && lines[after] != 0;
      if (!meets(in, out, both ? kOneLine : kSmooth)) return;
      // A line that turns back shrinks to a point: nothing can follow it smoothly.
      if (turns_back(in) || (both && !stay_one_line(before, after))) {
        plan_.straight[before] = plan_.straight[after] = 0;
      }
    };
    for (std::size_t i = 1; i < segments_; ++i) settle(i - 1, i);
    if (plan_.closed) settle(segments_ - 1, 0);
  }

  /// A new turn between two unit vectors; `sense` tells opposite ones in which plane to turn.
  std::size_t add_turn(const Point& from, const Point& to, const Turn* weights, const Point* sense) {
    Turn turn;
    if (weights != nullptr) std::copy(weights->weights, weights->weights + 2, turn.weights);
    turn.cosine = std::clamp(dot(from, to), -1.0, 1.0);
    Point t(from.size());
    for (std::size_t k = 0; k < t.size(); ++k) t[k] = to[k] - turn.cosine * from[k];
    turn.even = opposite(from, to);
    const double length = normalize(t);
    const bool vague = length < kNoHandle;
    if (vague) t = turn.even && sense != nullptr ? *sense : any_orthogonal(from);
    if (from.size() == 2) {  // exactly orthogonal, so that nothing is left beside the plane
      const double side = cross(from, t) < 0.0 ? -1.0 : 1.0;
      t = {-side * from[1], side * from[0]};
    }
    turn.sine = vague ? 0.0 : std::max(0.0, dot(to, t));
    turn.degrees = angle_degrees(turn.cosine, turn.sine);
    plan_.turns.push_back(turn);
    plan_.turn_w.push_back(from);
    plan_.turn_t.push_back(t);
    return plan_.turns.size() - 1;
  }

  /// Handle h as seen from a turn.
  void see_from(std::size_t h, std::size_t turn) {
    Handle& handle = plan_.handles[h];
    handle.turn = turn;
    const Turn& seen = plan_.turns[turn];
    const auto w = plan_.turn_w[turn];
    const auto t = plan_.turn_t[turn];
    for (std::size_t x = 0; x < 2; ++x) {
      const double cosine = x == 0 ? 1.0 : seen.cosine;
      const double sine = x == 0 ? 0.0 : seen.sine;
      const double on_w = dot(direction(x, h), w);
      const double on_t = dot(direction(x, h), t);
      handle.along[x] = cosine * on_w + sine * on_t;
      handle.beside[x] = cosine * on_t - sine * on_w;
      if (w.size() == 2) continue;
      const auto rest = plan_.rests[2 * h + x];
      for (std::size_t k = 0; k < rest.size(); ++k) {
        rest[k] = direction(x, h)[k] - on_w * w[k] - on_t * t[k];
      }
    }
  }

  /// The end of a segment by itself, and its turn.
  std::size_t plan_corner(std::size_t h, const Point* sense) {
    const std::size_t turn = add_turn(direction(0, h), direction(1, h), nullptr, sense);
    see_from(h, turn);
    return turn;
  }

  /// Where the plane and the sense of a turn take another direction: orthogonal to that.
  [[nodiscard]] Point sense_for(std::size_t turn, const Point& other) const {
    const auto w = plan_.turn_w[turn];
    const auto t = plan_.turn_t[turn];
    const double on_w = dot(w, other);
    const double on_t = dot(t, other);
    Point sense(other.size());
    for (std::size_t k = 0; k < sense.size(); ++k) sense[k] = on_w * t[k] - on_t * w[k];
    return normalize(sense) > kNoHandle ? sense : any_orthogonal(other);
  }

  void plan_joint(std::size_t in, std::size_t out) {
    if (!meets(in, out, kSmooth)) {
      // The side whose turn is certain goes first.
      const std::size_t first = turns_back(in) ? out : in;
      const std::size_t second = first == in ? out : in;
      const Point sense = sense_for(plan_corner(first, nullptr), direction(0, second));
      plan_corner(second, &sense);
      return;
    }
    const bool line_in = plan_.straight[in / 2] != 0;
    const bool line_out = plan_.straight[out / 2] != 0;
    std::size_t turn = 0;
    if (line_in || line_out) {
      const std::size_t line = line_in ? in : out;
      Turn weights;
      for (std::size_t x = 0; x < 2; ++x) weights.weights[x] = tangents_[x][line].length;
      turn = add_turn(direction(0, line), direction(1, line), &weights, nullptr);
    } else {
      turn = add_turn(mean_direction(0, in, out), mean_direction(1, in, out), nullptr, nullptr);
    }
    see_from(in, turn);
    see_from(out, turn);
  }

  [[nodiscard]] Point mean_direction(std::size_t x, std::size_t in, std::size_t out) const {
    Point mean = direction(x, in);
    for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += direction(x, out)[k];
    normalize(mean);
    return mean;
  }

  std::array<const CubicPath*, 2> paths_;
  std::size_t segments_;
  std::array<std::vector<Tangent>, 2> tangents_;  ///< [path][handle]
  HermitePlan plan_;
};

}  // namespace

void HermitePlan::handle_at(std::size_t h, double s, std::span<double> out) const {
  const Handle& handle = handles[h];
  const Turn& turn = turns[handle.turn];
  double x = (1.0 - s) * turn.weights[0] + s * turn.weights[1] * turn.cosine;
  double y = s * turn.weights[1] * turn.sine;
  if (turn.even) {
    const CosSin at = cos_sin_degrees(s * turn.degrees);
    x = at.cosine;
    y = at.sine;
  }
  const double radius = std::sqrt(x * x + y * y);
  x = radius > 0.0 ? x / radius : 1.0;
  y = radius > 0.0 ? y / radius : 0.0;
  // Beyond its ends a joint is to stay as smooth as it was there.
  const double inside = std::clamp(s, 0.0, 1.0);
  const double along = (1.0 - inside) * handle.along[0] + inside * handle.along[1];
  const double beside = (1.0 - inside) * handle.beside[0] + inside * handle.beside[1];
  const double on_w = along * x - beside * y;
  const double on_t = along * y + beside * x;
  const auto w = turn_w[handle.turn];
  const auto t = turn_t[handle.turn];
  const auto rest_a = rests[2 * h];
  const auto rest_b = rests[2 * h + 1];
  double square = 0.0;
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k] = on_w * w[k] + on_t * t[k] + (1.0 - inside) * rest_a[k] + inside * rest_b[k];
    square += out[k] * out[k];
  }
  const double length = std::max(0.0, (1.0 - s) * handle.lengths[0] + s * handle.lengths[1]);
  const double factor = square > 0.0 ? length / std::sqrt(square) : 0.0;
  for (double& c : out) c *= factor;
}

HermitePlan plan_hermite_blend(const CubicPath& a, const CubicPath& b) {
  return Planner(a, b).run();
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
