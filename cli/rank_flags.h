#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "tandem/rank/rank.h"

namespace cli {

/// The options of recognition as they were written; empty: not given.
struct RankFlags {
  std::string cost = "symmetric";
  std::string charge;
  std::string samples;
  std::string top;
  std::string threads;
  bool rotate = false;
  bool no_rotate = false;
  bool mirror = false;
  bool exhaustive = false;
  bool all_pairs = false;
};

void add_rank_flags(CLI::App& command, RankFlags& flags);
void add_samples_flag(CLI::App& command, RankFlags& flags);
void add_threads_flag(CLI::App& command, RankFlags& flags);

/// @throws UsageError a value that does not exist
[[nodiscard]] tandem::CompareOptions to_compare_options(const RankFlags& flags);
[[nodiscard]] tandem::RankOptions to_rank_options(const RankFlags& flags);
[[nodiscard]] int to_rank_samples(const RankFlags& flags);
[[nodiscard]] int to_threads(const RankFlags& flags);

}  // namespace cli
