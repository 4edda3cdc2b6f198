#pragma once

#include "tandem/match/correspondence.h"
#include "tandem/match/cost_table.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Nodes of a x b within `radius` samples of a coarse correspondence, in rows and in columns.
[[nodiscard]] NodeMask mask_near(const Samples& a, const Samples& b, const Correspondence& coarse,
                                 int radius);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
