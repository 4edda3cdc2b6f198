#pragma once

#include <string>

#include "tandem/rank/rank.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// A self-contained HTML page (no network): the query, and the ranking with a picture of every shape, the
/// query laid over it as it was turned and mirrored. Shapes are drawn as the comparison saw them, from their
/// chords; those of R^n, n > 2, by their first two coordinates. Needs RankOptions::keep_shapes; a shape that
/// was not kept has no picture.
[[nodiscard]] TANDEM_IO_EXPORT std::string format_rank_page(const ShapeDescriptor& query,
                                                            const Ranking& ranking, const std::string& title);

}  // namespace v0
}  // namespace tandem
