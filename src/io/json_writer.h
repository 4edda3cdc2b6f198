#pragma once

#include <span>
#include <string>

#include "tandem/curve/curve.h"

namespace tandem {
inline namespace v0 {

/// Appends the shortest text that reads back equal. @throws InvalidArgument not finite (JSON has no such
/// number)
void append_json_number(std::string& out, double value);
/// Appends "[1, 2]".
void append_json_numbers(std::string& out, std::span<const double> values);
/// Appends "[[0, 0], [1, 2]]".
void append_json_points(std::string& out, const Points& points);
/// Appends the curve as one JSON object on one line.
void append_json_curve(std::string& out, const Curve& curve);

}  // namespace v0
}  // namespace tandem
