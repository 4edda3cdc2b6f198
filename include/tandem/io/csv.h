#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/curve/points.h"
#include "tandem/tandem_io_export.h"

namespace tandem {
inline namespace v0 {

/// One curve in R^n: a row per sample, columns separated by comma, semicolon, tab or blanks, an optional
/// header. Semicolons leave the comma to be the decimal sign; # starts a comment line. The first column is
/// the parameter when the header calls it t or time; else rows stand at 0, 1, 2, ... Interpolated by a C2
/// cubic spline (not-a-knot ends; lower degree below four rows); points where the data stands still, or turns
/// back, are legal (spec C18).
/// @throws ParseError a malformed number, rows of different length, fewer than two rows, time that does not
/// increase
[[nodiscard]] TANDEM_IO_EXPORT Curve parse_csv(std::string_view text, const std::string& source = "csv");

/// A curve with what else its table says.
struct CsvTable {
  Curve curve;
  /// Names of the time column and of the values, as the header has them; "t", "x1", "x2", ... without one.
  std::vector<std::string> columns;
  std::size_t rows = 0;
  bool named = false;  ///< there is a header
};

/// As parse_csv().
[[nodiscard]] TANDEM_IO_EXPORT CsvTable parse_csv_table(std::string_view text,
                                                        const std::string& source = "csv");

/// A header, quoted where it must be, and a line per point; numbers that read back equal.
/// @throws InvalidArgument other numbers of columns than coordinates
[[nodiscard]] TANDEM_IO_EXPORT std::string format_csv(const Points& rows,
                                                      std::span<const std::string> columns);

}  // namespace v0
}  // namespace tandem
