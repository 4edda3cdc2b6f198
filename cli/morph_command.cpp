#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "commands.h"
#include "interrupt.h"
#include "messages.h"
#include "morph_output.h"
#include "output.h"
#include "progress_bar.h"
#include "report.h"
#include "tandem/error.h"
#include "tandem/match/rotation.h"
#include "tandem/morph/morph.h"
#include "values.h"

namespace cli {
namespace {

using tandem::Morph;
using tandem::Shape;

/// What the options ask for, checked before anything is read.
struct Plan {
  MorphOutput output;
  tandem::MorphOptions morph;
};

Plan make_plan(const Command& command) {
  Plan plan;
  plan.output = plan_morph_output(command);
  plan.morph.match = to_match_options(command.match);
  [[maybe_unused]] const bool affine =
      choose<bool>("--blend", command.blend, {{"auto", true}, {"affine", true}},
                   {"hermite", "bezier", "similarity", "intrinsic", "detour"});
  return plan;
}

ShapeReport report_of(const Morph& morph, std::size_t key, const Shape& a, const Shape& b) {
  return make_report(a.contours.size(), b.contours.size(), [&](std::size_t i) -> const tandem::Match* {
    const std::optional<tandem::Match>& match = morph.match(key, i);
    return match ? &*match : nullptr;
  });
}

/// `"report": {...}` of two keys, `"reports": [...]` of more.
std::string format_reports(const std::vector<ShapeReport>& reports) {
  if (reports.size() == 1) return "\"report\": " + format_report(reports.front());
  std::string text = "\"reports\": [";
  for (std::size_t i = 0; i < reports.size(); ++i) text += (i == 0 ? "" : ", ") + format_report(reports[i]);
  return text + "]";
}

/// A turn that nobody asked for should not puzzle anybody.
void say_turn(const Messages& messages, const ShapeReport& report) {
  if (report.pairs.empty()) return;
  const tandem::Match& match = *report.pairs.front().match;
  const double degrees = tandem::Rotation(match.curve.dim(), match.report.rotation).degrees();
  if (std::fabs(degrees) < 0.05) return;
  messages.note(
      fmt::format("turned by {:.1f} degrees on the way; --no-rotate blends as the shapes lie", degrees));
}

Status run(const Command& command) {
  Plan plan = make_plan(command);
  const Messages messages(command.common.quiet);
  const std::vector<Shape> keys = load_inputs(command, 2, std::string::npos);
  const int dim = keys.front().dim();
  if (dim != 2 && plan.output.format != Format::json) {
    throw tandem::InvalidArgument(fmt::format(
        "the shapes have dimension {}; only planar ones can be drawn, others go to .json or -", dim));
  }
  plan.morph.match.progress = show_progress(messages.quiet());
  const Morph morph = [&] {
    const InterruptibleScope interruptible;
    return Morph(keys, plan.morph);
  }();
  throw_if_interrupted();
  erase_progress_bar();

  std::vector<ShapeReport> reports;
  for (std::size_t key = 0; key + 1 < keys.size(); ++key) {
    reports.push_back(report_of(morph, key, keys[key], keys[key + 1]));
  }
  const bool valid =
      std::all_of(reports.begin(), reports.end(), [](const ShapeReport& r) { return r.valid(); });
  if (command.match.strict && !valid) {
    messages.error("no valid match exists for these samples (--strict): nothing was written");
    return kNoValidMatch;
  }
  for (const ShapeReport& report : reports) {
    warn(messages, report);
    say_turn(messages, report);
  }
  write_morph(command, plan.output, morph, keys.front().dim(), format_reports(reports));
  if (command.common.json && command.output != "-") write_output("-", "{" + format_reports(reports) + "}\n");
  return kDone;
}

}  // namespace

void add_morph_command(CLI::App& program, Command& command) {
  command.app = program.add_subcommand("morph", "The in-betweens of two or more curves or shapes");
  command.app->add_option("shapes", command.inputs, "A, B, ...: files, parts of files, or path data");
  add_morph_output_flags(command);
  command.app->add_option("--blend", command.blend, "auto, affine")->type_name("NAME");
  add_common_flags(*command.app, command.common);
  add_match_flags(*command.app, command.match);
  command.run = run;
}

}  // namespace cli
