#pragma once

#include <string_view>
#include <vector>

#include "tandem/shape/cubic_path.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {

/// parse_path_data for texts that stand inside another one. @throws SyntaxError with the offset in `text`
[[nodiscard]] std::vector<CubicPath> read_path_data(std::string_view text, bool fill,
                                                    const Transform& transform);

/// A filled outline whose author left out the Z: an open path whose ends meet within 1e-3 of its diagonal
/// becomes closed, by a line when there is a gap. Other paths stay as they are.
[[nodiscard]] std::vector<CubicPath> close_meeting_ends(std::vector<CubicPath> paths);

/// The same for outlines that are stroked only: those that go around an area. A line there and back stays
/// open.
[[nodiscard]] std::vector<CubicPath> close_meeting_outlines(std::vector<CubicPath> paths);

/// Whether all control points are within kLargestCoordinate: an arc can reach far beyond its ends.
[[nodiscard]] bool is_in_range(const CubicPath& path);

/// Throws SyntaxError at `offset` when the point, or its image, is not finite or beyond kLargestCoordinate.
void check_range(Vec2 point, const Transform& transform, std::size_t offset);

}  // namespace v0
}  // namespace tandem
