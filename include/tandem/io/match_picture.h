#pragma once

#include <string>

#include "tandem/match/match.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// The picture of a match as SVG: both curves with the links between them, the cost table with its path, and
/// v(u) drawn over the path ([C] Figures 5 and 6). Curves of R^n, n > 2, are drawn by their first two
/// coordinates.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_match_picture(const Curve& a, const Curve& b,
                                                                const Match& match,
                                                                const MatchOptions& options);

}  // namespace v0
}  // namespace tandem
