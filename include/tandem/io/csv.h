#pragma once

#include <string>
#include <string_view>

#include "tandem/curve/curve.h"
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

}  // namespace v0
}  // namespace tandem
