#pragma once

#include <stdexcept>

namespace cli {

/// The command line asks for something that does not exist: exit status 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace cli
