#include "tandem/error.h"

#include <fmt/format.h>

#include <utility>

namespace tandem {
inline namespace v0 {

Error::~Error() = default;
InvalidArgument::~InvalidArgument() = default;
ParseError::~ParseError() = default;
IoError::~IoError() = default;

namespace {

std::string located(const std::string& source, int line, int column, const std::string& message) {
  if (line <= 0) return fmt::format("{}: {}", source, message);
  if (column <= 0) return fmt::format("{}:{}: {}", source, line, message);
  return fmt::format("{}:{}:{}: {}", source, line, column, message);
}

}  // namespace

ParseError::ParseError(std::string source, int line, int column, const std::string& message)
    : Error(located(source, line, column, message)),
      source_(std::move(source)),
      line_(line),
      column_(column) {}

}  // namespace v0
}  // namespace tandem
