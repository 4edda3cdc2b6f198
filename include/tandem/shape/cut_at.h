#pragma once

#include <vector>

#include "tandem/shape/cubic_path.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// The path cut at these parameters, which may start and end anywhere on a closed one: its pieces between two
/// neighbouring cuts, none of which reaches over a joint; exact, and the joints to the bit. Descending cuts
/// turn the path round.
/// cuts: parameters of to_curve(path); on a closed path they run on past its end.
/// closed: the pieces go round once, and are joined into a closed path.
/// @throws InvalidArgument fewer than two cuts
[[nodiscard]] TANDEM_EXPORT CubicPath cut_at(const CubicPath& path, const std::vector<double>& cuts,
                                             bool closed);

}  // namespace v0
}  // namespace tandem
