#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// Reads the curves of an IRIT text data file: [CURVE BEZIER|BSPLINE ...] with E1..E9 or P1..P9 control
/// points, anywhere in the tree of objects; other objects (surfaces with their trimming curves, models,
/// polygons) are passed over. P types hold (w, w x, w y, ...); periodic curves ([KVP ...]) get back the
/// points that they leave out.
/// @throws ParseError with line and column; no curve in the file
[[nodiscard]] TANDEM_IO_EXPORT std::vector<Curve> parse_itd(std::string_view text,
                                                            const std::string& source = "itd");

/// Writes them so that they read back equal; of rational curves, whose points the format holds multiplied by
/// their weights, the weights and knots, and the points within one unit in the last place.
/// @throws InvalidArgument more than nine coordinates, or a point times its weight overflows
[[nodiscard]] TANDEM_IO_EXPORT std::string format_itd(std::span<const Curve> curves);

}  // namespace v0
}  // namespace tandem
