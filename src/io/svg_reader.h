#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tandem/io/svg.h"

namespace tandem {
inline namespace v0 {

/// The elements as one shape. The fill rule is evenodd when that is the rule of every element that has
/// several contours, and nonzero otherwise.
[[nodiscard]] Shape merge(const std::vector<SvgElement>& elements);

}  // namespace v0
}  // namespace tandem
