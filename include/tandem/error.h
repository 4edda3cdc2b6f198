#pragma once

#include <stdexcept>
#include <string>

#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// Base of everything that Tandem throws. The message says what, where, and what was expected.
class TANDEM_EXPORT Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  Error(const Error&) = default;
  Error& operator=(const Error&) = default;
  ~Error() override;
};

/// An argument breaks the contract of the function: "knot 7 is 0.4, before knot 6 (0.5)".
class TANDEM_EXPORT InvalidArgument : public Error {
 public:
  using Error::Error;
  InvalidArgument(const InvalidArgument&) = default;
  InvalidArgument& operator=(const InvalidArgument&) = default;
  ~InvalidArgument() override;
};

/// A file or text is malformed. `what()` starts with "source:line:column: ".
class TANDEM_EXPORT ParseError : public Error {
 public:
  /// line and column count from 1; 0 where the format has none (binary files).
  ParseError(std::string source, int line, int column, const std::string& message);
  ParseError(const ParseError&) = default;
  ParseError& operator=(const ParseError&) = default;
  ~ParseError() override;

  [[nodiscard]] const std::string& source() const noexcept { return source_; }
  [[nodiscard]] int line() const noexcept { return line_; }
  [[nodiscard]] int column() const noexcept { return column_; }

 private:
  std::string source_;
  int line_;
  int column_;
};

/// A file cannot be read or written.
class TANDEM_EXPORT IoError : public Error {
 public:
  using Error::Error;
  IoError(const IoError&) = default;
  IoError& operator=(const IoError&) = default;
  ~IoError() override;
};

}  // namespace v0
}  // namespace tandem
