#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tandem/io/load.h"
#include "tandem/match/match.h"

namespace cli {

/// What every command understands.
struct CommonFlags {
  std::string fill_rule = "nonzero";
  bool json = false;
  bool quiet = false;
};

/// The options of matching as they were written; empty: not given.
struct MatchFlags {
  std::string method = "elastic";
  std::string norm = "tangent";
  std::string samples;
  std::string sampling;
  std::string features = "tangent";
  std::string reduce;
  std::string tolerance;
  std::string order;
  std::string direction = "auto";
  std::string closed = "auto";
  std::string split;  ///< of segments, as the next one
  std::string segment_cost;
  std::string low_pass;
  std::string threads;
  bool fast = false;
  std::optional<bool> rotate;  ///< nothing: the command's default
  bool strict = false;
  std::vector<std::string> pins;  ///< of match only; see pins.h
};

void add_common_flags(CLI::App& command, CommonFlags& flags);
void add_match_flags(CLI::App& command, MatchFlags& flags);
void add_pin_flag(CLI::App& command, MatchFlags& flags);

/// @throws UsageError a value that does not exist
[[nodiscard]] tandem::LoadOptions to_load_options(const CommonFlags& flags);
[[nodiscard]] tandem::MatchOptions to_match_options(const MatchFlags& flags);

}  // namespace cli
