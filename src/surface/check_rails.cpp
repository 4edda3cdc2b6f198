#include "surface/check_rails.h"

#include <fmt/format.h>

#include <algorithm>

#include "match/vector.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// The tolerance within which ends of closed curves meet, as a share of the size.
constexpr double kCoincident = 1e-9;
/// Pairs of points at which curves are compared.
constexpr int kComparisons = 64;

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

void refuse_coincident(const Curve& a, const Curve& b) {
  const Interval domain = a.domain();
  const double near = kCoincident * std::max(a.extent(), b.extent());
  for (int i = 0; i <= kComparisons; ++i) {
    const double u = domain.lo + domain.length() * i / kComparisons;
    if (distance(a.evaluate(u), b.evaluate(u)) > near) return;
  }
  throw InvalidArgument("the two curves coincide: no surface between them");
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
