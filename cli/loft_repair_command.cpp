#include <fmt/format.h>

#include <utility>
#include <vector>

#include "commands.h"
#include "interrupt.h"
#include "messages.h"
#include "output.h"
#include "progress_bar.h"
#include "rule_law.h"
#include "skin_report.h"
#include "surface_output.h"
#include "tandem/error.h"
#include "tandem/io/cad.h"
#include "tandem/surface/skin.h"
#include "usage_error.h"

namespace cli {
namespace {

const std::vector<Format> kFormats = {Format::step, Format::iges, Format::brep};

tandem::SkinnedSurface put_in_step(const std::vector<tandem::Curve>& sections, const Command& command,
                                   tandem::SkinOptions options) {
  options.match = to_match_options(command.match);
  options.match.progress = show_progress(command.common.quiet);
  const InterruptibleScope interruptible;
  return tandem::skin(sections, options);
}

Status run(const Command& command) {
  if (command.inputs.size() != 1) {
    throw UsageError(fmt::format("loft-repair takes one file of sections, not {}", command.inputs.size()));
  }
  if (command.output.empty()) throw UsageError("loft-repair needs -o OUT: .step, .iges or .brep");
  const Format format = output_format(command.output, command.to, kFormats);
  tandem::SkinOptions options;
  options.law = law_options(command, options.law);
  check_writable(command.output);
  const Messages messages(command.common.quiet);
  const std::vector<tandem::Curve> sections = tandem::read_cad_curves(command.inputs.front());
  if (sections.size() < 2) {
    throw tandem::InvalidArgument(
        fmt::format("{} has one section, a loft needs at least 2", command.inputs.front()));
  }
  fit_order(
      command, format, [&](int q) { return skinned_degree(sections, q); }, options.law, messages);
  const tandem::SkinnedSurface skinned = put_in_step(sections, command, options);
  throw_if_interrupted();
  erase_progress_bar();
  if (command.match.strict && !skinned.report.valid) {
    messages.error("not all sections match validly (--strict): nothing was written");
    return kNoValidMatch;
  }
  if (!skinned.report.valid) messages.warning("not all sections match validly; --json says which");
  warn_of_deviation(messages, skinned.laws, options.law.tolerance);
  write_output(command.output, tandem::format_cad(*cad_format_of(format), skinned.sections));
  if (command.common.json) write_output("-", format_skin_report(skinned) + "\n");
  return kDone;
}

void add_flags(Command& command) {
  command.app->add_option("file", command.inputs,
                          "IN.step, .iges or .brep: sections in the order of the loft");
  command.app->add_option("-o,--output", command.output, ".step, .iges or .brep")->type_name("OUT");
  command.app->add_option("--to", command.to, "step, iges, brep: whatever the ending of OUT")
      ->type_name("FORMAT");
  add_common_flags(*command.app, command.common);
  add_match_flags(*command.app, command.match);
  describe_skin_laws(*command.app);
}

}  // namespace

const Subcommand kLoftRepairCommand = {
    "loft-repair", "The section wires of a CAD file, in step: seams, directions, parameters", add_flags, run};

}  // namespace cli
