#pragma once

#include <CLI/CLI.hpp>
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
};

/// What the program knows of a subcommand before it is asked for: its flags are added only then, since a
/// program that sets up those of all commands starts markedly later.
struct Subcommand {
  const char* name;
  const char* about;
  void (*add_flags)(Command& command);
  Status (*run)(const Command& command);
};

extern const Subcommand kMatchCommand;
extern const Subcommand kMorphCommand;
extern const Subcommand kAlignCommand;
extern const Subcommand kInfoCommand;
extern const Subcommand kConvertCommand;
extern const Subcommand kRuleCommand;
extern const Subcommand kBlendCommand;
extern const Subcommand kSkinCommand;
extern const Subcommand kLoftRepairCommand;
extern const Subcommand kRankCommand;
extern const Subcommand kIndexCommand;

/// @throws UsageError standard input is named twice
void check_standard_input(const Command& command);

/// The one input, which may be a surface. @throws UsageError there is not one
[[nodiscard]] std::variant<tandem::Shape, tandem::Surface> load_any_input(const Command& command);

/// The inputs as shapes. @throws UsageError unless their number lies in [least, most]; standard input named
/// twice
[[nodiscard]] std::vector<tandem::Shape> load_inputs(const Command& command, std::size_t least,
                                                     std::size_t most);

}  // namespace cli
