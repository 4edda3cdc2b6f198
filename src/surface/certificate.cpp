#include "tandem/surface/certificate.h"

#include <fmt/format.h>

#include <array>

#include "surface/certify_ruled.h"
#include "surface/planar.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

void check_dimension(int dim) {
  if (dim != 2 && dim != 3)
    throw InvalidArgument(fmt::format("certificates are for surfaces in R^2 and R^3, not in R^{}", dim));
}

}  // namespace

Certificate certify(const Curve& a, const Curve& b) {
  check_dimension(a.dim());
  if (a.dim() != b.dim()) {
    throw InvalidArgument(
        fmt::format("the first curve is in R^{}, the second one in R^{}: they must agree", a.dim(), b.dim()));
  }
  if (!(a.domain() == b.domain())) {
    throw InvalidArgument(
        fmt::format("the first curve is over [{}, {}], the second one over [{}, {}]: they must agree",
                    a.domain().lo, a.domain().hi, b.domain().lo, b.domain().hi));
  }
  const std::array<const Points*, 2> clouds = {&a.control_points(), &b.control_points()};
  const auto plane = detail::common_plane(clouds);
  if (plane) return detail::certify_planar_ruled(a, b, *plane);
  return {};
}

}  // namespace v0
}  // namespace tandem
