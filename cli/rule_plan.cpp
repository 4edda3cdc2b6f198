#include "rule_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>

#include "rule_law.h"
#include "tandem/curve/arc_length.h"
#include "tandem/error.h"
#include "values.h"

namespace cli {

RailPlan make_rail_plan(const Command& command) {
  RailPlan plan;
  plan.output = plan_surface_output(*command.app, command.output, command.to, command.surface);
  plan.law = law_options(command, {});
  plan.match = to_match_options(command.match);
  if (plan.match.rotate.value_or(false)) {
    throw UsageError(fmt::format("--rotate does not go with {}: it joins the curves where they lie",
                                 command.app->get_name()));
  }
  plan.match.reduction.reset();
  plan.crease = parse_number("--crease", command.rule.crease, 0.0, std::numbers::pi);
  return plan;
}

namespace {

constexpr int kMostContours = 1'000'000;

/// The contour that --contour picks of input `index`; nothing when it was not given.
std::optional<std::size_t> picked_contour(const Command& command, std::size_t index) {
  if (command.rule.contour.empty()) return std::nullopt;
  const std::vector<std::string> parts = split_list("--contour", command.rule.contour);
  if (parts.size() != 1 && parts.size() != command.inputs.size()) {
    throw UsageError(fmt::format("--contour takes one number, or one for each of the {} inputs, not '{}'",
                                 command.inputs.size(), command.rule.contour));
  }
  return parse_count("--contour", parts[parts.size() == 1 ? 0 : index], 0, kMostContours);
}

/// What people choose by: "0 (length 41.5), 1 (length 12)".
std::string list_contours(const std::vector<tandem::Curve>& contours) {
  constexpr std::size_t kMost = 6;
  std::string list;
  for (std::size_t i = 0; i < std::min(contours.size(), kMost); ++i) {
    list += fmt::format("{}{} (length {:.3g})", i == 0 ? "" : ", ", i, tandem::arc_length(contours[i], 1e-3));
  }
  return contours.size() > kMost ? list + ", ..." : list;
}

}  // namespace

tandem::Curve single_curve(const Command& command, const std::vector<tandem::Shape>& shapes,
                           std::size_t index) {
  const std::vector<tandem::Curve>& contours = shapes[index].contours;
  const std::optional<std::size_t> picked = picked_contour(command, index);
  if (contours.size() == 1 && !picked) return contours.front();
  if (picked && *picked < contours.size()) return contours[*picked];
  throw tandem::InvalidArgument(fmt::format(
      "{}: has {} contour{}{}; {} takes one curve each, and --contour N picks one: {}", command.inputs[index],
      contours.size(), contours.size() == 1 ? "" : "s", picked ? fmt::format(", and no {}", *picked) : "",
      command.app->get_name(), list_contours(contours)));
}

void add_rail_flags(Command& command) {
  command.app->add_option("-o,--output", command.output, surface_endings())->type_name("OUT");
  command.app->add_option("--to", command.to, "json, obj, ...: whatever the ending of OUT")
      ->type_name("FORMAT");
  command.app
      ->add_option("--crease", command.rule.crease,
                   "Largest crease where the curves have no corner, in radians (0.0175)")
      ->type_name("X");
  command.app
      ->add_option("--contour", command.rule.contour,
                   "Which contour of inputs that have several, from 0; one number, or one per input")
      ->type_name("N[,M]");
  add_surface_flags(*command.app, command.surface);
  add_common_flags(*command.app, command.common);
  add_match_flags(*command.app, command.match);
  command.app->get_option("--reduce")->group("");  // law_options() says what there is instead
  add_pin_flag(*command.app, command.match);
  command.app->get_option("--order")->description("Order of v: 4 is C2 (default), 2 piecewise linear");
  command.app->get_option("--tolerance")->description("Error of v allowed, as a share of its domain (0.001)");
}

}  // namespace cli
