#pragma once

#include "surface/rail_norm.h"
#include "surface/section_laws.h"
#include "tandem/curve/curve.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The path of `section` once more, on finer nodes beside it, against a neighbour that is in step: see
/// refine_path(), and with along_neighbour refine_path_along_first(). Corners and pins stay.
[[nodiscard]] SectionPath refine_section(const Curve& neighbour, const Curve& section,
                                         const SectionPath& path, const RailNorm& norm, double strain,
                                         bool along_neighbour);

/// The path of a later section after the one of a section before it was changed: through the same points of
/// that section as before.
[[nodiscard]] SectionPath carry_over(const SectionPath& later, const Correspondence& before,
                                     const Correspondence& changed);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
