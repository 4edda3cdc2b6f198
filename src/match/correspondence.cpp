#include "tandem/match/correspondence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

/// A path seen from one of its two axes, in the direction in which that axis (the key) never decreases.
struct View {
  const std::vector<ParameterPair>& points;
  bool by_v = false;
  bool backwards = false;
  Interval keys;
  double value_period = 0.0;  ///< signed: what one period of the key adds to the value
  bool closed = false;

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] const ParameterPair& point(std::size_t i) const {
    return points[backwards ? points.size() - 1 - i : i];
  }
  [[nodiscard]] double key(std::size_t i) const { return by_v ? point(i).v : point(i).u; }
  [[nodiscard]] double value(std::size_t i) const { return by_v ? point(i).u : point(i).v; }
};

/// First index whose key is >= x (strict: > x).
std::size_t first_from(const View& view, double x, bool strict) {
  std::size_t lo = 0;
  std::size_t hi = view.size();
  while (lo < hi) {
    const std::size_t mid = lo + (hi - lo) / 2;
    const bool before = strict ? view.key(mid) <= x : view.key(mid) < x;
    if (before) {
      lo = mid + 1;
    } else {
      hi = mid;
    }
  }
  return lo;
}

double middle(double a, double b) {
  return a == b ? a : 0.5 * a + 0.5 * b;
}

/// The value half-way along the run of points [first, last) that share one key.
double middle_of_run(const View& view, std::size_t first, std::size_t last) {
  double from = view.value(first);
  double to = view.value(last - 1);
  // On a closed path a jump at the seam stands half at the end of the list and half at its start.
  const std::size_t n = view.size();
  if (view.closed && first == 0 && last < n) {
    from = view.value(first_from(view, view.key(n - 1), false)) - view.value_period;
  } else if (view.closed && last == n && first > 0) {
    to = view.value(first_from(view, view.key(0), true) - 1) + view.value_period;
  }
  return middle(from, to);
}

double interpolate(const View& view, double x) {
  const std::size_t first = first_from(view, x, false);
  const std::size_t last = first_from(view, x, true);
  if (first != last) return middle_of_run(view, first, last);
  if (first == 0) return view.value(0);
  if (first == view.size()) return view.value(first - 1);
  const double x0 = view.key(first - 1);
  const double x1 = view.key(first);
  const double y0 = view.value(first - 1);
  const double y1 = view.value(first);
  const double share = (x - x0) / (x1 - x0);
  return std::clamp((1.0 - share) * y0 + share * y1, std::min(y0, y1), std::max(y0, y1));
}

double value_at(const View& view, double x) {
  if (view.size() == 0) throw InvalidArgument("the correspondence has no points, expected at least 1");
  if (!view.closed) return interpolate(view, view.keys.clamp(x));
  const double period = view.keys.length();
  const double first = view.key(0);
  const double periods = period > 0.0 ? std::floor((x - first) / period) : 0.0;
  // Rounding may leave x a hair outside the list, where the seam's own jump would be missed.
  const double inside = Interval{first, view.key(view.size() - 1)}.clamp(x - periods * period);
  return interpolate(view, inside) + periods * view.value_period;
}

}  // namespace

double Correspondence::v_at(double u) const {
  const double value_period = reversed ? -domain_v.length() : domain_v.length();
  const double v = value_at({points, false, false, domain_u, value_period, closed}, u);
  return closed ? v : domain_v.clamp(v);
}

double Correspondence::u_at(double v) const {
  const double value_period = reversed ? -domain_u.length() : domain_u.length();
  const double u = value_at({points, true, reversed, domain_v, value_period, closed}, v);
  return closed ? u : domain_u.clamp(u);
}

Correspondence Correspondence::inverse() const {
  Correspondence swapped;
  swapped.points.reserve(points.size());
  for (const ParameterPair& point : points) swapped.points.push_back({point.v, point.u});
  if (reversed) std::reverse(swapped.points.begin(), swapped.points.end());
  swapped.domain_u = domain_v;
  swapped.domain_v = domain_u;
  swapped.closed = closed;
  swapped.reversed = reversed;
  return swapped;
}

}  // namespace v0
}  // namespace tandem
