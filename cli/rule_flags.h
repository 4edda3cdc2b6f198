#pragma once

#include <string>

namespace cli {

/// The options of rule and blend as they were written; empty: not given.
struct RuleFlags {
  std::string inclination;
  std::string contour;
  std::string crease = "0.0175";  ///< radians: a degree
  bool planar = false;
  bool certify = false;
};

}  // namespace cli
