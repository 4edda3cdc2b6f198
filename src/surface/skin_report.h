#pragma once

#include <span>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/match/norm.h"
#include "tandem/surface/skin.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// What one section in step costs against another.
struct PairCost {
  double cost = 0.0;     ///< elastic, see SkinPair::cost
  double invalid = 0.0;  ///< share of the mean length on which <T1,T2> <= 0
};

/// Unit tangents, and speeds relative to the mean speed, at places spread evenly over a section's parameter.
struct SectionLook {
  Points tangents;
  std::vector<double> speeds;
};

[[nodiscard]] SectionLook look_at(const Curve& section);
[[nodiscard]] PairCost cost_between(const SectionLook& a, const SectionLook& b, double lambda);

/// Largest creases along lines u = const, in radians.
struct Creases {
  double laws = 0.0;      ///< see SkinReport::crease_angle
  double sections = 0.0;  ///< see SkinReport::section_crease_angle
};

/// sections: in step, they tell where the shape itself has corners.
[[nodiscard]] Creases find_creases(const Surface& surface, std::span<const Curve> sections,
                                   std::span<const double> parameters, double corner_angle);

/// See SkinReport::wrong_sign_share; 0 if the surface is not in R^2.
[[nodiscard]] double wrong_sign_share(const Surface& surface);

/// See SkinReport::interpolation_error.
[[nodiscard]] double interpolation_error(const Surface& surface, std::span<const Curve> sections,
                                         std::span<const double> parameters);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
