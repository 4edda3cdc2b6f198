#pragma once

#include <string_view>

#include "tandem/curve/curve.h"
#include "tandem/match/match.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// @throws InvalidArgument dimensions that differ, or are 1; one rail closed and the other not, unless
/// ClosedMode::no. what: "a ruled surface", say.
void check_rails(const Curve& a, const Curve& b, ClosedMode closed, std::string_view what);

/// Are both the same set of points, within 1e-9 of their size, whatever their parameters, directions and
/// seams? Matched, they would be no further apart than their law is off: it is to be asked before.
[[nodiscard]] bool do_coincide(const Curve& a, const Curve& b);
/// @throws InvalidArgument they do
void refuse_coincident(const Curve& a, const Curve& b);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
