#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tandem {
inline namespace v0 {

struct JsonMember;

/// A JSON value that remembers where it stands, so that errors of meaning can say it too.
struct JsonValue {
  using Array = std::vector<JsonValue>;
  using Object = std::vector<JsonMember>;

  std::size_t offset = 0;
  std::variant<std::monostate, bool, double, std::string, Array, Object> value;

  [[nodiscard]] bool is_null() const noexcept { return std::holds_alternative<std::monostate>(value); }
  [[nodiscard]] const double* number() const noexcept { return std::get_if<double>(&value); }
  [[nodiscard]] const bool* boolean() const noexcept { return std::get_if<bool>(&value); }
  [[nodiscard]] const std::string* text() const noexcept { return std::get_if<std::string>(&value); }
  [[nodiscard]] const Array* array() const noexcept { return std::get_if<Array>(&value); }
  [[nodiscard]] const Object* object() const noexcept { return std::get_if<Object>(&value); }
  /// The member of that name; null when there is none, or its value is null, or this is no object.
  [[nodiscard]] const JsonValue* member(std::string_view key) const noexcept;
  /// "a number", "an array" ...
  [[nodiscard]] std::string_view kind() const noexcept;
};

struct JsonMember {
  std::string key;
  JsonValue value;
};

/// @throws ParseError with line and column
[[nodiscard]] JsonValue parse_json(std::string_view text, const std::string& source);

}  // namespace v0
}  // namespace tandem
