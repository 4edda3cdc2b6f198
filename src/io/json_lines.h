#pragma once

#include <istream>
#include <optional>
#include <string>

#include "tandem/shape/shape.h"

namespace tandem {
inline namespace v0 {

/// A line of a .jsonl file that is not blank.
struct JsonLine {
  std::string text;
  int number = 0;  ///< counted from 1, blank lines included
};

/// A shape of a .jsonl file: curves as in a .json file, and optional members "name" and "label".
struct NamedShape {
  std::string name;
  std::string label;
  Shape shape;
};

/// The lines of a stream that are not blank. The stream must outlive it.
class JsonLines {
 public:
  explicit JsonLines(std::istream& in) : in_(in) {}
  [[nodiscard]] std::optional<JsonLine> next();

 private:
  std::istream& in_;
  int number_ = 0;
};

/// @throws ParseError with the line of the file
[[nodiscard]] NamedShape parse_json_line(const JsonLine& line, const std::string& source);

}  // namespace v0
}  // namespace tandem
