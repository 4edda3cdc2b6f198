#pragma once

#include <span>

#include "tandem/curve/curve.h"
#include "tandem/surface/loft.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// What STEP, IGES and the kernels that read them take.
inline constexpr int kHighestDegree = 25;

/// The degree that the surface will have along v. @throws InvalidArgument as loft(), for what can be told
/// from number and kind of the sections and from the options
int check_loft(std::span<const Curve> sections, const LoftOptions& options);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
