#include "rule_plan.h"

#include <fmt/format.h>

#include <numbers>

#include "tandem/error.h"
#include "values.h"

namespace cli {

RailPlan make_rail_plan(const Command& command) {
  RailPlan plan;
  plan.output = plan_surface_output(*command.app, command.output, command.to, command.surface);
  if (!command.match.reduce.empty()) {
    throw UsageError(
        fmt::format("{} makes its laws to a tolerance: it takes --tolerance and --order, not --reduce",
                    command.app->get_name()));
  }
  plan.match = to_match_options(command.match);
  if (plan.match.rotate.value_or(false)) {
    throw UsageError(fmt::format("--rotate does not go with {}: it joins the curves where they lie",
                                 command.app->get_name()));
  }
  if (!command.match.order.empty()) plan.law.order = plan.match.reduction->order;
  if (!command.match.tolerance.empty()) plan.law.tolerance = plan.match.reduction->tolerance;
  plan.match.reduction.reset();
  plan.crease = parse_number("--crease", command.rule.crease, 0.0, std::numbers::pi);
  return plan;
}

tandem::Curve single_curve(const Command& command, const std::vector<tandem::Shape>& shapes,
                           std::size_t index) {
  const std::size_t contours = shapes[index].contours.size();
  if (contours != 1) {
    throw tandem::InvalidArgument(
        fmt::format("{}: has {} contours; {} takes one curve each (FILE.svg#ID names one)",
                    command.inputs[index], contours, command.app->get_name()));
  }
  return shapes[index].contours.front();
}

void add_rail_flags(Command& command) {
  command.app->add_option("-o,--output", command.output, surface_endings())->type_name("OUT");
  command.app->add_option("--to", command.to, "json, obj, ...: whatever the ending of OUT")
      ->type_name("FORMAT");
  command.app
      ->add_option("--crease", command.rule.crease,
                   "Largest crease where the curves have no corner, in radians (0.0175)")
      ->type_name("X");
  add_surface_flags(*command.app, command.surface);
  add_common_flags(*command.app, command.common);
  add_match_flags(*command.app, command.match);
  add_pin_flag(*command.app, command.match);
}

}  // namespace cli
