#pragma once

#include <string>

namespace cli {

/// --easing as tandem::AnimationOptions takes it: a name of CSS, or "x1 y1 x2 y2" from x1,y1,x2,y2 or
/// cubic-bezier(x1, y1, x2, y2). @throws UsageError
[[nodiscard]] std::string parse_easing(const std::string& text);

}  // namespace cli
