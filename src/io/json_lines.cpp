#include "io/json_lines.h"

#include <fmt/format.h>

#include <string_view>

#include "io/json_curves.h"
#include "io/text_position.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

std::string read_text(const JsonValue& root, std::string_view key, const JsonLine& line,
                      const std::string& source) {
  const JsonValue* member = root.member(key);
  if (member == nullptr) return {};
  if (member->text() == nullptr) {
    fail_at(source, line.text, member->offset,
            fmt::format("\"{}\": expected a string, found {}", key, member->kind()));
  }
  return *member->text();
}

}  // namespace

std::optional<JsonLine> JsonLines::next() {
  std::string text;
  while (std::getline(in_, text)) {
    ++number_;
    if (number_ == 1) text = std::string(without_bom(text));
    if (text.find_first_not_of(" \t\r\f\v") != std::string::npos) return JsonLine{std::move(text), number_};
  }
  return std::nullopt;
}

NamedShape parse_json_line(const JsonLine& line, const std::string& source) {
  try {
    const JsonValue root = parse_json(line.text, source);
    NamedShape result{read_text(root, "name", line, source), read_text(root, "label", line, source), {}};
    result.shape.contours = read_json_curves(root, line.text, source);
    for (const Curve& contour : result.shape.contours) {
      if (contour.dim() != result.shape.dim())
        fail_at(source, line.text, 0, "its curves are of different dimensions");
    }
    return result;
  } catch (const ParseError& error) {
    // Within the line it was line 1; the message stands behind "source:1:column: ".
    const std::string_view what = error.what();
    const std::size_t message = what.find(": ", source.size());
    throw ParseError(source, line.number, error.column(),
                     std::string(message == std::string_view::npos ? what : what.substr(message + 2)));
  }
}

}  // namespace v0
}  // namespace tandem
