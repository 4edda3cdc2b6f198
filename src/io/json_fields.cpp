#include "io/json_fields.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "io/limits.h"
#include "io/text_position.h"

namespace tandem {
inline namespace v0 {

JsonFields::JsonFields(std::string_view text, const std::string& source, std::string object)
    : text_(text), source_(source), object_(std::move(object)) {}

void JsonFields::fail(const JsonValue& where, const std::string& message) const {
  fail_at(source_, text_, where.offset, fmt::format("{}: {}", object_, message));
}

const JsonValue& JsonFields::required(const JsonValue& value, std::string_view key) const {
  if (const JsonValue* member = value.member(key)) return *member;
  fail(value, fmt::format("\"{}\" is missing", key));
}

const JsonValue::Array& JsonFields::array(const JsonValue& value, std::string_view name) const {
  if (const JsonValue::Array* items = value.array()) return *items;
  fail(value, fmt::format("{}: expected an array, found {}", name, value.kind()));
}

double JsonFields::number(const JsonValue& value, std::string_view name, std::size_t i) const {
  const double* number = value.number();
  if (number == nullptr)
    fail(value, fmt::format("{} {}: expected a number, found {}", name, i, value.kind()));
  if (std::fabs(*number) > kLargestCoordinate) {
    fail(value, fmt::format("{} {} is {}, beyond the largest number taken, {}", name, i, *number,
                            kLargestCoordinate));
  }
  return *number;
}

std::vector<double> JsonFields::numbers(const JsonValue& value, std::string_view name,
                                        std::string_view element) const {
  const JsonValue::Array& items = array(value, name);
  std::vector<double> result;
  result.reserve(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) result.push_back(number(items[i], element, i));
  return result;
}

int JsonFields::degree(const JsonValue& value, std::string_view name) const {
  const double* degree = value.number();
  if (degree == nullptr) fail(value, fmt::format("{}: expected a number, found {}", name, value.kind()));
  if (!(*degree >= 1.0) || *degree > kLargestDegree || *degree != std::floor(*degree)) {
    fail(value, fmt::format("{} is {}, expected a whole number from 1 to {}", name, *degree, kLargestDegree));
  }
  return static_cast<int>(*degree);
}

}  // namespace v0
}  // namespace tandem
