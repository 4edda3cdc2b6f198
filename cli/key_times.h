#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cli {

/// When the shapes are reached.
struct KeyTimes {
  std::vector<double> shares;      ///< of the whole, rising from 0 to 1; empty: evenly
  std::optional<double> duration;  ///< in seconds, when the times are
};

/// --times: one for each of `count` shapes, as shares (0,0.4,1), in percent (0%,40%,100%) or in seconds
/// (0s,0.8s,2s). Empty text: evenly. @throws UsageError
[[nodiscard]] KeyTimes parse_key_times(const std::string& text, std::size_t count);

}  // namespace cli
