#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "match_flags.h"
#include "rank_flags.h"
#include "rule_flags.h"
#include "skin_flags.h"
#include "surface_output.h"

namespace cli {

/// Exit statuses (docs/interface.md).
enum Status : int {
  kDone = 0,
  kNotReadOrWritten = 1,
  kWrongUsage = 2,
  kInvalidInput = 3,
  kNoValidMatch = 4,
};

/// A subcommand: what it reads from the command line, and what it does.
struct Command {
  CLI::App* app = nullptr;
  std::vector<std::string> inputs;
  std::string output;
  std::string to;
  CommonFlags common;
  MatchFlags match;
  RankFlags rank;
  std::string blend;  ///< empty: the method's own
  SurfaceFlags surface;
  SkinFlags skin;
  RuleFlags rule;
  std::string frames;
  std::string at;
  std::string duration = "2";
  std::vector<std::string> easings = {"linear"};
  std::string times;
  bool smooth = false;
  std::string play = "alternate";
  std::string size = "512";
  std::string precision;
  std::string css = "d";
  std::string name = "morph";
  bool no_cut = false;
  std::function<Status(const Command&)> run;
};

/// Each adds its subcommand to `program` and fills `command`, which must stay where it is.
void add_match_command(CLI::App& program, Command& command);
void add_morph_command(CLI::App& program, Command& command);
void add_align_command(CLI::App& program, Command& command);
void add_info_command(CLI::App& program, Command& command);
void add_convert_command(CLI::App& program, Command& command);
void add_rule_command(CLI::App& program, Command& command);
void add_blend_command(CLI::App& program, Command& command);
void add_skin_command(CLI::App& program, Command& command);
void add_loft_repair_command(CLI::App& program, Command& command);
void add_rank_command(CLI::App& program, Command& command);
void add_index_command(CLI::App& program, Command& command);

/// @throws UsageError standard input is named twice
void check_standard_input(const Command& command);

/// The one input, which may be a surface. @throws UsageError there is not one
[[nodiscard]] std::variant<tandem::Shape, tandem::Surface> load_any_input(const Command& command);

/// The inputs as shapes. @throws UsageError unless their number lies in [least, most]; standard input named
/// twice
[[nodiscard]] std::vector<tandem::Shape> load_inputs(const Command& command, std::size_t least,
                                                     std::size_t most);

}  // namespace cli
