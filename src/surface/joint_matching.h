#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "surface/section_laws.h"
#include "tandem/curve/curve.h"
#include "tandem/surface/skin.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The path of `section` that costs least against all of `neighbours` together: curves in step, whose
/// parameter the path refers to. In the direction of `path`, the path so far. None when it would not be
/// admissible: a section that the steps cannot bridge.
[[nodiscard]] std::vector<SectionPath> match_between(const Curve& section, const SectionPath& path,
                                                     std::span<const Curve> neighbours,
                                                     const MatchOptions& options);

/// The paths of a ring with what is left over once round it spread over all of its sections.
///
/// once_round: the path of the first section matched with the last one, back at its own start. Where that is
/// not the identity, section k takes k/n of it back.
[[nodiscard]] std::vector<SectionPath> spread_round(const std::vector<SectionPath>& paths,
                                                    const SectionPath& once_round);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
