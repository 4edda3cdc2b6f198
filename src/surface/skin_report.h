#pragma once

#include <span>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/match/norm.h"
#include "tandem/surface/skin.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The elastic cost of each section in step against the next, of a ring the last against the first, too.
[[nodiscard]] std::vector<double> pair_costs(std::span<const Curve> sections, double lambda, bool ring);

/// See SkinReport::crease_angle. sections: in step, they tell where the shape itself has corners.
[[nodiscard]] double crease_angle(const Surface& surface, std::span<const Curve> sections,
                                  std::span<const double> parameters, double corner_angle);

/// See SkinReport::interpolation_error.
[[nodiscard]] double interpolation_error(const Surface& surface, std::span<const Curve> sections,
                                         std::span<const double> parameters);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
