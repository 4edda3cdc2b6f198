#include <fmt/format.h>

#include <numbers>
#include <optional>
#include <string>
#include <utility>
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
#include "values.h"

namespace cli {
namespace {

constexpr const char* kDevelopable = "developable";

struct Plan {
  RailPlan rails;
  tandem::RuleOptions rule;
};

Plan make_plan(Command command) {
  Plan plan;
  // A norm of rule alone; what is not given is rule's own choice.
  const bool given = command.app->get_option("--norm")->count() > 0;
  plan.rule.developable = command.match.norm == kDevelopable;
  if (plan.rule.developable) command.match.norm = "tangent";
  plan.rails = make_rail_plan(command);
  if (given && !plan.rule.developable) plan.rule.norm = plan.rails.match.norm;
  plan.rule.match = plan.rails.match;
  plan.rule.law = plan.rails.law;
  plan.rule.largest_crease = plan.rails.crease;
  plan.rule.planar = command.rule.planar;
  if (!command.rule.inclination.empty()) {
    if (!plan.rule.developable) throw UsageError("--inclination goes with --norm developable");
    plan.rule.largest_inclination =
        parse_number("--inclination", command.rule.inclination, 1e-3, 0.5 * std::numbers::pi);
  }
  return plan;
}

tandem::RuledSurface rule(const Command& command, Plan& plan, const std::vector<tandem::Shape>& shapes,
                          const Messages& messages) {
  const tandem::Curve a = single_curve(command, shapes, 0);
  const tandem::Curve b = single_curve(command, shapes, 1);
  if (!command.match.pins.empty()) {
    plan.rule.match.pins =
        locate_pins(command.match.pins, tandem::Shape{{a}, {}}, tandem::Shape{{b}, {}}).front();
  }
  fit_order(
      command, plan.rails.output.format, [&](int q) { return ruled_degree({&a}, {&b}, q); }, plan.rule.law,
      messages);
  const InterruptibleScope interruptible;
  plan.rule.match.progress = show_progress(messages.quiet());
  return tandem::rule(a, b, plan.rule);
}

void warn(const Messages& messages, const tandem::RuledReport& report, double tolerance,
          const std::optional<tandem::Certificate>& certificate) {
  if (!report.validity.valid) {
    messages.warning(
        report.planar ? fmt::format("the surface folds over itself: the wrong sign on {:.3g} % of its area",
                                    100.0 * report.wrong_sign_share)
                      : fmt::format("not valid on {:.3g} % of the length, smallest <T1,T2> {:.3g}",
                                    100.0 * (1.0 - report.validity.valid_share), report.validity.min_dot));
  }
  if (report.law.outcome == tandem::LawOutcome::lower_order) {
    messages.warning(
        fmt::format("the law has order {}: smoother ones leave the surface invalid", report.law.order));
  }
  warn_of_deviation(messages, "the law", report.law.max_deviation, tolerance);
  if (certificate) warn(messages, *certificate);
}

Status run(const Command& command) {
  Plan plan = make_plan(command);
  const Messages messages(command.common.quiet);
  const std::vector<tandem::Shape> shapes = load_inputs(command, 2, 2);
  const tandem::RuledSurface ruled = rule(command, plan, shapes, messages);
  throw_if_interrupted();
  erase_progress_bar();
  if (command.match.strict && !ruled.report.validity.valid) {
    messages.error("no valid ruled surface exists for these samples (--strict): nothing was written");
    return kNoValidMatch;
  }
  std::optional<tandem::Certificate> certificate;
  if (command.rule.certify) certificate = certify(ruled.surface, plan.rails.output);
  warn(messages, ruled.report, plan.rule.law.tolerance, certificate);
  const std::string report = format_rule_report(ruled, certificate);
  write_surface(plan.rails.output, {&ruled.surface,
                                    nullptr,
                                    "\"report\": " + report,
                                    {single_curve(command, shapes, 0), single_curve(command, shapes, 1)},
                                    title(command.inputs)});
  if (command.common.json && command.output != "-") write_output("-", report + "\n");
  return kDone;
}

void add_flags(Command& command) {
  command.app->add_option("curves", command.inputs, "A and B: files, parts of files, or path data");
  add_rail_flags(command);
  command.app->get_option("--norm")->description(
      "ruled or its anti-twist form (default), developable, tangent, distance, bottleneck");
  command.app
      ->add_option("--inclination", command.rule.inclination,
                   "With --norm developable: rulings lean no further, in radians")
      ->type_name("X");
  command.app->add_flag("--planar", command.rule.planar, "Refuse curves that do not lie in one plane");
  command.app->add_flag("--certify", command.rule.certify, "Prove that the surface is free of folds");
}

}  // namespace

const Subcommand kRuleCommand = {"rule", "The ruled surface between two curves", add_flags, run};

}  // namespace cli
