#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "curve/spline.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

// Ends within this share of the larger curve's size meet, as for closed curves.
constexpr double kMeetTolerance = 1e-9;
// Parameters within this share of the joint domains are the same.
constexpr double kParameterTolerance = 1e-10;

void check_meeting(const Curve& before, const Curve& after, std::size_t index) {
  const Interval a = before.domain();
  const Interval b = after.domain();
  const double rounding =
      8.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a.hi), std::abs(b.lo));
  if (!(std::abs(a.hi - b.lo) <= kParameterTolerance * std::min(a.length(), b.length()) + rounding)) {
    throw InvalidArgument(fmt::format("curve {} ends at parameter {}, but curve {} starts at {}", index - 1,
                                      a.hi, index, b.lo));
  }
  const double extent = std::max(before.extent(), after.extent());
  const auto end = before.control_points().back();
  const auto start = after.control_points().front();
  for (std::size_t c = 0; c < end.size(); ++c) {
    const double slack = kMeetTolerance * extent + 8.0 * std::numeric_limits<double>::epsilon() *
                                                       std::max(std::abs(end[c]), std::abs(start[c]));
    if (!(std::abs(end[c] - start[c]) <= slack)) {
      throw InvalidArgument(fmt::format("curve {} ends at {} in coordinate {}, but curve {} starts at {}",
                                        index - 1, end[c], c, index, start[c]));
    }
  }
}

}  // namespace

Curve join(std::span<const Curve> curves) {
  if (curves.empty()) throw InvalidArgument("no curves to join, expected at least one");
  int degree = 1;
  bool rational = false;
  for (const Curve& curve : curves) {
    if (curve.dim() != curves.front().dim()) {
      throw InvalidArgument(
          fmt::format("cannot join curves of dimension {} and {}", curves.front().dim(), curve.dim()));
    }
    degree = std::max(degree, curve.degree());
    rational = rational || curve.is_rational();
  }
  detail::Spline joined;
  Curve before = clamp(curves.front());
  for (std::size_t i = 0; i < curves.size(); ++i) {
    Curve curve = clamp(curves[i]);
    if (i > 0) check_meeting(before, curve, i);
    detail::Spline next = detail::elevated(detail::premultiplied(curve, rational), degree - curve.degree());
    if (i == 0) {
      joined = std::move(next);
    } else {
      detail::append(joined, next, 0.0);
    }
    before = std::move(curve);
  }
  return detail::euclidean(std::move(joined));
}

}  // namespace v0
}  // namespace tandem
