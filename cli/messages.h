#pragma once

#include <string_view>

namespace cli {

/// Where messages go: standard error, or nowhere with --quiet.
class Messages {
 public:
  explicit Messages(bool quiet = false) : quiet_(quiet) {}

  [[nodiscard]] bool quiet() const noexcept { return quiet_; }
  void error(std::string_view text) const;
  void warning(std::string_view text) const;
  void note(std::string_view text) const;

 private:
  bool quiet_;
};

}  // namespace cli
