#include "surface/even_speed.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "curve/norm.h"
#include "surface/law_function.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Relative; speeds that agree so well leave creases far below what anybody sees.
constexpr double kSameSpeed = 1e-9;
/// Knots and values of laws nearer than this share of the domain are meant to be one; as in compose().
constexpr double kSameKnot = 1e-12;
/// Of the room that the next coefficient leaves: the law has to increase beyond as well.
constexpr double kShareOfRoom = 0.75;
constexpr std::size_t kSpans = 4;
/// A knot this near, as a share of a piece, to where another is wanted will do: halved spans end there but
/// for rounding.
constexpr double kSameSpan = 1e-3;

bool do_differ(double before, double after) {
  return std::abs(before - after) > kSameSpeed * std::max(before, after);
}

/// Speeds before and after a place, 0 where the direction is not the same.
struct Speeds {
  double before = 0.0;
  double after = 0.0;

  [[nodiscard]] bool same_direction() const { return before > 0.0 && after > 0.0; }
  [[nodiscard]] bool jump() const { return same_direction() && do_differ(before, after); }
};

Speeds speeds_at(const Curve& curve, double before, double after, double angle) {
  const Points left = curve.derivatives(before, 1, Side::left);
  const Points right = curve.derivatives(after, 1, Side::right);
  const double a = scaled_norm(left[1]);
  const double b = scaled_norm(right[1]);
  if (!(a > 0.0 && b > 0.0)) return {};
  Point gap(left[1].size());
  for (std::size_t c = 0; c < gap.size(); ++c) gap[c] = left[1][c] / a - right[1][c] / b;
  return scaled_norm(gap) <= angle ? Speeds{a, b} : Speeds{};
}

/// The knot at v, which may be off by the rounding of moved seams and of laws; v itself where there is none.
double nearest_knot(const Curve& curve, double v) {
  const std::vector<double>& knots = curve.knots();
  const auto next = std::lower_bound(knots.begin(), knots.end(), v);
  const double near = kSameKnot * curve.domain().length();
  if (next != knots.end() && *next - v <= near) return *next;
  return next != knots.begin() && v - *(next - 1) <= near ? *(next - 1) : v;
}

/// Where a law meets a joint: the coefficients beside those that have its value make the slopes.
struct Joint {
  std::size_t at_left = 0;   ///< coefficient that ends the piece before
  std::size_t at_right = 0;  ///< and that begins the piece after: the same one inside
  double span_before = 0.0;
  double span_after = 0.0;
};

bool is_near_knot(const Curve& law, double t, double near) {
  const auto next = std::lower_bound(law.knots().begin(), law.knots().end(), t - near);
  return next != law.knots().end() && *next <= t + near;
}

/// The same law with kSpans spans or more between any two knots of full multiplicity (less one): slopes at
/// both ends of such a piece are then made by coefficients of their own, and some are left.
Curve with_room(const Curve& law) {
  std::vector<double> added;
  double start = law.domain().lo;
  std::size_t spans = 0;
  for (const Knot& knot : distinct_knots(law.knots())) {
    if (knot.value == law.domain().lo) continue;
    ++spans;
    if (knot.multiplicity < law.degree()) continue;
    for (std::size_t i = 1; spans < kSpans && i < kSpans; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(kSpans);
      const double t = (1.0 - share) * start + share * knot.value;
      if (!is_near_knot(law, t, kSameSpan * (knot.value - start))) added.push_back(t);
    }
    start = knot.value;
    spans = 0;
  }
  return refine(law, added);
}

/// The same law with knots of full multiplicity (less one) also at those joints of the section that it runs
/// through elsewhere: where slopes are limited a law misses joints by more than rounding.
Curve through_joints(const Curve& law, const Curve& section, double angle) {
  const LawFunction function(law);
  const Interval domain = law.domain();
  const double near = kSameKnot * domain.length();
  const std::vector<Knot> knots = distinct_knots(law.knots());
  std::vector<double> added;
  std::vector<std::pair<double, double>> joints;  // u and v, the latter to the last bit
  for (const double v : smooth_joints(section, angle)) {
    double u = function.parameter(v);
    const double before = joints.empty() ? domain.lo : joints.back().first;
    if (u - before <= near || domain.hi - u <= near) continue;
    int missing = law.degree();
    for (const Knot& knot : knots) {
      if (std::abs(knot.value - u) > near) continue;
      u = knot.value;
      missing -= knot.multiplicity;
    }
    added.insert(added.end(), static_cast<std::size_t>(std::max(missing, 0)), u);
    joints.emplace_back(u, v);
  }
  const Curve refined = refine(law, added);
  Points values = refined.control_points();
  for (const auto& [u, v] : joints) {
    const auto first = std::lower_bound(refined.knots().begin(), refined.knots().end(), u);
    values[static_cast<std::size_t>(first - refined.knots().begin()) - 1][0] = v;
  }
  return Curve(refined.degree(), refined.knots(), std::move(values));
}

void even_out(Points& c, const Joint& joint, const Speeds& speeds) {
  const double left = c[joint.at_left][0] - c[joint.at_left - 1][0];
  const double right = c[joint.at_right + 1][0] - c[joint.at_right][0];
  // Speeds of the composed section, but for the law's degree.
  const double before = left / joint.span_before * speeds.before;
  const double after = right / joint.span_after * speeds.after;
  if (!do_differ(before, after)) return;
  double speed = std::sqrt(before) * std::sqrt(after);
  const auto limit = [&](double room, double span, double own) {
    speed = std::min(speed, kShareOfRoom * room / span * own);
  };
  limit(c[joint.at_left][0] - c[joint.at_left - 2][0], joint.span_before, speeds.before);
  limit(c[joint.at_right + 2][0] - c[joint.at_right][0], joint.span_after, speeds.after);
  c[joint.at_left - 1][0] = c[joint.at_left][0] - speed * joint.span_before / speeds.before;
  c[joint.at_right + 1][0] = c[joint.at_right][0] + speed * joint.span_after / speeds.after;
}

}  // namespace

std::vector<double> smooth_joints(const Curve& curve, double angle) {
  std::vector<double> joints;
  const Interval domain = curve.domain();
  if (curve.is_closed() && speeds_at(curve, domain.hi, domain.lo, angle).jump()) joints.push_back(domain.lo);
  for (const Knot& knot : distinct_knots(curve.knots())) {
    if (!(domain.lo < knot.value && knot.value < domain.hi) || knot.multiplicity < curve.degree()) continue;
    if (speeds_at(curve, knot.value, knot.value, angle).jump()) joints.push_back(knot.value);
  }
  return joints;
}

Curve with_even_speed(const Curve& given, const Curve& section, bool loop, double angle) {
  const Curve law = with_room(through_joints(given, section, angle));
  const auto degree = static_cast<std::size_t>(law.degree());
  const std::vector<double>& knots = law.knots();
  Points c = law.control_points();
  const std::size_t n = c.size();
  for (std::size_t i = 2; i + 2 < n; ++i) {
    // Coefficient i is interpolated where knots i + 1 .. i + degree are one.
    if (knots[i + 1] != knots[i + degree]) continue;
    const double v = nearest_knot(section, c[i][0]);
    const Speeds speeds = speeds_at(section, v, v, angle);
    // The law may bend where the section does not: at a corner that limited slopes make it miss.
    if (!speeds.same_direction()) continue;
    even_out(c, {i, i, knots[i + 1] - knots[i], knots[i + degree + 1] - knots[i + 1]}, speeds);
  }
  if (loop && n > 4) {
    const Speeds speeds = speeds_at(section, c[n - 1][0], c[0][0], angle);
    if (speeds.same_direction()) {
      even_out(c, {n - 1, 0, knots[n] - knots[n - 1], knots[degree + 1] - knots[degree]}, speeds);
    }
  }
  return Curve(law.degree(), knots, std::move(c));
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
