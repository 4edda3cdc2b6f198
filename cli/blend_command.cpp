#include <fmt/format.h>

#include <string>
#include <vector>

#include "commands.h"
#include "interrupt.h"
#include "messages.h"
#include "names.h"
#include "output.h"
#include "pins.h"
#include "progress_bar.h"
#include "rule_law.h"
#include "rule_plan.h"
#include "rule_report.h"

namespace cli {
namespace {

using tandem::Shape;

Status run(const Command& command) {
  RailPlan plan = make_rail_plan(command);
  const Messages messages(command.common.quiet);
  const std::vector<Shape> shapes = load_inputs(command, 4, 4);
  const tandem::Rail first{single_curve(command, shapes, 0), single_curve(command, shapes, 1)};
  const tandem::Rail second{single_curve(command, shapes, 2), single_curve(command, shapes, 3)};
  tandem::HermiteOptions options;
  options.match = plan.match;
  if (!command.match.pins.empty()) {
    options.match.pins =
        locate_pins(command.match.pins, Shape{{first.curve}, {}}, Shape{{second.curve}, {}}).front();
  }
  fit_order(
      command, plan.output.format,
      [&](int q) {
        return ruled_degree({&first.curve, &first.tangents}, {&second.curve, &second.tangents}, q);
      },
      plan.law, messages);
  options.law = plan.law;
  options.largest_crease = plan.crease;
  const auto make = [&] {
    const InterruptibleScope interruptible;
    options.match.progress = show_progress(messages.quiet());
    return tandem::blend_rails(first, second, options);
  };
  const tandem::HermiteSurface blend = make();
  throw_if_interrupted();
  erase_progress_bar();
  if (!blend.report.validity.valid) {
    if (command.match.strict) {
      messages.error("no valid match of the rails exists for these samples (--strict): nothing was written");
      return kNoValidMatch;
    }
    messages.warning(
        fmt::format("the rails do not match validly on {:.3g} % of their length, smallest <T1,T2> {:.3g}",
                    100.0 * (1.0 - blend.report.validity.valid_share), blend.report.validity.min_dot));
  }
  warn_of_deviation(messages, "the law", blend.report.law.max_deviation, options.law.tolerance);
  const std::string report = format_blend_report(blend);
  write_surface(plan.output, {&blend.surface,
                              nullptr,
                              "\"report\": " + report,
                              {first.curve, second.curve},
                              title({command.inputs[0], command.inputs[2]})});
  if (command.common.json && command.output != "-") write_output("-", report + "\n");
  return kDone;
}

void add_flags(Command& command) {
  command.app->add_option("curves", command.inputs,
                          "RAIL1 TANGENT1 RAIL2 TANGENT2: tangents are curves of vectors over the rails' "
                          "parameters, towards the second rail");
  add_rail_flags(command);
}

}  // namespace

const Subcommand kBlendCommand = {"blend", "The Hermite surface between two rails with tangents across",
                                  add_flags, run};

}  // namespace cli
