#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/json_value.h"
#include "tandem/curve/curve.h"

namespace tandem {
inline namespace v0 {

/// The curves of a JSON document: one, an array, or {"curves": [...]}. text: where `root` comes from.
/// @throws ParseError as parse_json_curves()
[[nodiscard]] std::vector<Curve> read_json_curves(const JsonValue& root, std::string_view text,
                                                  const std::string& source);

}  // namespace v0
}  // namespace tandem
