#pragma once

#include <span>

#include "surface/rail_norm.h"
#include "surface/section_laws.h"
#include "tandem/curve/curve.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A section in the direction and from the seam in which it is in step, and its law.
struct Neighbour {
  const Curve& curve;
  const Curve& law;
};

/// The path of `section` once more, on finer nodes beside it, against a neighbour that is in step: see
/// refine_path(), and with along_neighbour refine_path_along_first(). Nodes are those of the neighbour's own
/// parameter: where its law all but stands still, or runs, its parameter in step tells little. Corners and
/// pins stay.
[[nodiscard]] SectionPath refine_section(const Neighbour& neighbour, const Curve& section,
                                         const SectionPath& path, const RailNorm& norm, double strain,
                                         bool along_neighbour);

/// A law as a path that runs like another one, `like`: a polyline on it, through its knots and the parameters
/// `exact`.
[[nodiscard]] Correspondence as_correspondence(const Reparametrization& law, const Correspondence& like,
                                               std::span<const double> exact);

/// The path of a later section after the one of the section before it was changed: through the same points of
/// that section as before.
[[nodiscard]] SectionPath carry_over(const SectionPath& later, const Correspondence& before,
                                     const Correspondence& changed);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
