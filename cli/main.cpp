#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "commands.h"
#include "interrupt.h"
#include "messages.h"
#include "progress_bar.h"
#include "suggest.h"
#include "tandem/error.h"
#include "tandem/version.h"
#include "usage_error.h"

namespace cli {
namespace {

/// Commands and options of the interface that do not work yet: people shall be told so, not that they
/// mistyped.
constexpr std::array<std::string_view, 1> kLaterCommands = {"font"};
constexpr std::array<std::string_view, 4> kLaterOptions = {"--mirror", "--linear", "--grid", "--axis"};

constexpr std::array<const Subcommand*, 11> kCommands = {
    &kMatchCommand, &kMorphCommand, &kInfoCommand, &kConvertCommand, &kRankCommand,      &kIndexCommand,
    &kAlignCommand, &kSkinCommand,  &kRuleCommand, &kBlendCommand,   &kLoftRepairCommand};

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string with_suggestion(const std::string& text, std::string_view word,
                            const std::vector<std::string>& known) {
  const std::string meant = nearest(word, known);
  return meant.empty() ? text : text + fmt::format("; did you mean {}?", meant);
}

[[noreturn]] void reject_option(const CLI::App& command, const std::string& argument) {
  const std::string option = argument.substr(0, argument.find('='));
  if (contains(kLaterOptions, option)) throw UsageError(option + " is not available yet");
  std::vector<std::string> known;
  for (const CLI::Option* each : command.get_options()) {
    if (!each->get_lnames().empty()) known.push_back("--" + each->get_lnames().front());
  }
  throw UsageError(
      with_suggestion(fmt::format("{} has no option {}", command.get_name(), option), option, known));
}

[[noreturn]] void reject_command(const std::string& word) {
  if (contains(kLaterCommands, word)) throw UsageError(word + " is not available yet");
  if (word.size() > 1 && word.front() == '-') {
    throw UsageError(with_suggestion("no option " + word, word, {"--help", "--version"}) +
                     "; options of a command stand behind it");
  }
  std::vector<std::string> names;
  for (const Subcommand* each : kCommands) names.emplace_back(each->name);
  throw UsageError(with_suggestion("no command " + word, word, names));
}

/// Our structs hold text, where empty means "not given"; an empty value that was given is a mistake.
void reject_empty_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() || option->count() == 0) continue;
    for (const std::string& value : option->results()) {
      if (value.empty()) throw UsageError(option->get_name() + " needs a value");
    }
  }
}

void add_usage(CLI::App& program) {
  program.set_help_flag("-h,--help", "This text");
  program.set_version_flag("--version", fmt::format("tandem {}", tandem::version()));
  program.footer(
      "A curve or shape is FILE.svg, FILE.svg#ID, FILE.json, FILE.json#2, FONT.ttf#A, FILE.itd, FILE.csv, "
      "SVG path\n"
      "data ('M0 0C...'), or - for standard input. Exit status: 0 done, 1 not read or written, 2 wrong "
      "usage,\n"
      "3 invalid input, 4 no valid match (--strict), 130 interrupted. More in docs/interface.md.");
}

int run(int argc, char** argv) {
  CLI::App program("Tandem puts freeform curves in step: correspondence, exact reparametrisation, morphs.",
                   "tandem");
  add_usage(program);
  program.allow_extras();
  program.require_subcommand(0, 1);  // a file behind a command may have a command's name
  Command command;
  const Subcommand* asked = nullptr;
  for (const Subcommand* each : kCommands) {
    CLI::App* app = program.add_subcommand(each->name, each->about);
    app->allow_extras();
    app->preparse_callback([&command, &asked, each, app](std::size_t) {
      asked = each;
      command.app = app;
      each->add_flags(command);
    });
  }

  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);  // --help and --version
    throw UsageError(error.what());
  }
  if (asked != nullptr) {
    const std::vector<std::string> unknown = command.app->remaining();
    if (!unknown.empty()) reject_option(*command.app, unknown.front());
    if (!program.remaining().empty()) reject_command(program.remaining().front());
    reject_empty_values(*command.app);
    return asked->run(command);
  }
  if (!program.remaining().empty()) reject_command(program.remaining().front());
  fmt::print(stderr, "{}", program.help());
  return kWrongUsage;
}

/// Everything that can go wrong, as exit statuses.
int run_and_report(int argc, char** argv) {
  // Asked before the command line is understood: it may be what is wrong with it.
  const Messages messages(
      std::any_of(argv + 1, argv + argc, [](std::string_view a) { return a == "--quiet"; }));
  try {
    return run(argc, argv);
  } catch (const Interrupted&) {
    erase_progress_bar();
    return 128 + interrupt_signal();
  } catch (const UsageError& error) {
    messages.error(fmt::format("{}\nTry 'tandem --help' or 'tandem COMMAND --help'.", error.what()));
    return kWrongUsage;
  } catch (const tandem::IoError& error) {
    messages.error(error.what());
    return kNotReadOrWritten;
  } catch (const std::bad_alloc&) {
    messages.error("not enough memory for this input with these options");
    return kInvalidInput;
  } catch (const std::exception& error) {
    messages.error(error.what());
    return kInvalidInput;
  }
}

}  // namespace
}  // namespace cli

int main(int argc, char** argv) {
  cli::install_interrupt_handlers();
  return cli::run_and_report(argc, argv);
}
