#include "match/second_curve.h"

#include <utility>

#include "tandem/curve/edit.h"

namespace tandem {
inline namespace v0 {
namespace detail {

Reparametrization in_own_domain(Reparametrization r, const Interval& cut, const Interval& own) {
  const double offset = (own.lo + own.hi) - (cut.lo + cut.hi);
  if (!r.reversed || offset == 0.0) return r;
  Points points = r.v.control_points();
  for (double& v : points.data()) v += offset;
  r.v = Curve(r.v.degree(), r.v.knots(), std::move(points));
  return r;
}

Curve second_curve(const Curve& b, const Correspondence& correspondence, const Reparametrization& r) {
  const bool was_cut = b.is_closed() && !correspondence.closed && !(correspondence.domain_v == b.domain());
  Curve curve = was_cut ? move_seam(b, correspondence.domain_v.lo) : b;
  if (r.reversed) {
    // t -> lo + hi - t in the curve's own domain, wherever it was cut.
    const double sum = b.domain().lo + b.domain().hi;
    const Interval cut = curve.domain();
    curve = with_domain(reverse(curve), {sum - cut.hi, sum - cut.lo});
  }
  if (correspondence.closed) curve = move_seam(curve, r.v.control_points().front()[0]);
  return curve;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
