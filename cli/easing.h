#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cli {

/// --easing as tandem::AnimationOptions takes it: names of CSS, or "x1 y1 x2 y2" from x1,y1,x2,y2 or
/// cubic-bezier(x1, y1, x2, y2), separated by semicolons. words: each one or several such. steps: from shape
/// to shape. @throws UsageError also when there are neither one nor as many as steps
[[nodiscard]] std::string parse_easings(const std::vector<std::string>& words, std::size_t steps);

}  // namespace cli
