#pragma once

#include <string>
#include <vector>

namespace cli {

/// The options of skin as they were written; empty: not given.
struct SkinFlags {
  std::string degree = "3";
  std::string parameters = "chord";
  std::string rows;
  std::string matching;
  std::string spacing;
  bool ring = false;
  bool solid = false;
  bool certify = false;
  std::vector<std::string> pins;
};

}  // namespace cli
