#pragma once

#include "tandem/match/rotation.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// The samples of the curve turned about its centre, the mean of its points over the length.
[[nodiscard]] Samples turned(Samples samples, const Rotation& rotation);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
