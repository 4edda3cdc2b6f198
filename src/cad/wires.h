#pragma once

#include <vector>

#include "tandem/curve/curve.h"

namespace tandem {
inline namespace v0 {
namespace cad {

/// The curves that meet end to end, two at each point, joined; curves that do not stay as they are. A joined
/// curve runs over [0, length], each part over as much of it as it is long, in the direction of its first
/// part. Ends meet within 1e-6, the precision of CAD files in millimetres, or 1e-9 of their size.
[[nodiscard]] std::vector<Curve> chained(std::vector<Curve> curves);

}  // namespace cad
}  // namespace v0
}  // namespace tandem
