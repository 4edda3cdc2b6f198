#include "surface/check_rails.h"

#include <fmt/format.h>

#include <algorithm>

#include "tandem/curve/knots.h"
#include "tandem/curve/nearest_point.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// The tolerance within which ends of closed curves meet, as a share of the size.
constexpr double kCoincident = 1e-9;
/// Places per span at which curves are compared, besides one per degree: two polynomials that agree at so
/// many are one.
constexpr int kPlaces = 4;

/// Does every point of a that is looked at lie on b?
bool lies_on(const Curve& a, const Curve& b) {
  const double near = kCoincident * std::max(a.extent(), b.extent());
  const int places = a.degree() + kPlaces;
  double from = a.domain().lo;
  for (const Knot& knot : distinct_knots(a.knots())) {
    if (!(knot.value > from) || knot.value > a.domain().hi) continue;
    for (int i = 0; i <= places; ++i) {
      const double t = from + (knot.value - from) * i / places;
      if (nearest_point(b, a.evaluate(a.domain().clamp(t))).distance > near) return false;
    }
    from = knot.value;
  }
  return true;
}

}  // namespace

void check_rails(const Curve& a, const Curve& b, ClosedMode closed, std::string_view what) {
  if (a.dim() != b.dim()) {
    throw InvalidArgument(fmt::format("the curves have different dimensions: the first has {}, the second {}",
                                      a.dim(), b.dim()));
  }
  if (a.dim() < 2) throw InvalidArgument("the curves lie on a line (dimension 1): no surface between them");
  if (a.is_closed() != b.is_closed() && closed != ClosedMode::no) {
    throw InvalidArgument(fmt::format(
        "the first curve is {}, the second {}: {} needs two open curves or two closed ones; a closed one "
        "counts as open, from its seam on, when the curves are matched as not closed",
        a.is_closed() ? "closed" : "open", b.is_closed() ? "closed" : "open", what));
  }
}

bool do_coincide(const Curve& a, const Curve& b) {
  return a.dim() == b.dim() && lies_on(a, b) && lies_on(b, a);
}

void refuse_coincident(const Curve& a, const Curve& b) {
  if (do_coincide(a, b)) throw InvalidArgument("the two curves coincide: no surface between them");
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
