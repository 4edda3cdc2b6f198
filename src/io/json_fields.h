#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/json_value.h"

namespace tandem {
inline namespace v0 {

/// Reads the members of an object of ours, a curve or a surface; all that is wrong is a ParseError with the
/// place and the name of the object.
class JsonFields {
 public:
  /// text: where the values come from; object: "curve 3".
  JsonFields(std::string_view text, const std::string& source, std::string object);

  [[noreturn]] void fail(const JsonValue& where, const std::string& message) const;

  [[nodiscard]] const JsonValue& required(const JsonValue& value, std::string_view key) const;
  [[nodiscard]] const JsonValue::Array& array(const JsonValue& value, std::string_view name) const;
  /// Element i of something: "knot 7".
  [[nodiscard]] double number(const JsonValue& value, std::string_view name, std::size_t i) const;
  [[nodiscard]] std::vector<double> numbers(const JsonValue& value, std::string_view name,
                                            std::string_view element) const;
  /// A whole number from 1 to kLargestDegree.
  [[nodiscard]] int degree(const JsonValue& value, std::string_view name) const;

 private:
  std::string_view text_;
  const std::string& source_;
  std::string object_;
};

}  // namespace v0
}  // namespace tandem
