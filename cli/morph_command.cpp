#include <fmt/format.h>

#include <string>
#include <vector>

#include "commands.h"
#include "drawings.h"
#include "frames.h"
#include "look_notes.h"
#include "messages.h"
#include "morph_output.h"
#include "morph_run.h"
#include "motions.h"
#include "output.h"
#include "pins.h"
#include "tandem/error.h"
#include "values.h"

namespace cli {
namespace {

using tandem::BlendKind;
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
  plan.morph.times = plan.output.key_times;
  plan.morph.smooth = command.smooth;
  if (!are_time_pins(command.match.pins)) plan.morph.pins = parse_pins(command.match.pins);
  if (!command.blend.empty()) {
    plan.morph.blend = choose<BlendKind>("--blend", command.blend,
                                         {{"auto", BlendKind::automatic},
                                          {"affine", BlendKind::affine},
                                          {"bezier", BlendKind::bezier},
                                          {"hermite", BlendKind::hermite},
                                          {"similarity", BlendKind::similarity},
                                          {"intrinsic", BlendKind::intrinsic},
                                          {"detour", BlendKind::detour}});
  }
  plan.morph.cuts = !command.no_cut;
  return plan;
}

Status run(const Command& command) {
  const Plan plan = make_plan(command);
  const Messages messages(command.common.quiet);
  note_idle_flags(command, plan.output, messages);
  check_standard_input(command);
  if (const auto motions = load_motions(command, plan.output.format, messages)) {
    return morph_motions(command, *motions, plan.output, plan.morph, messages);
  }
  if (are_time_pins(command.match.pins)) (void)parse_pins(command.match.pins);  // says what is wrong
  const std::vector<tandem::Drawing> drawings = load_drawings(command, 2, std::string::npos);
  const std::vector<Shape> keys = shapes_of(drawings);
  check_writable(command.output, plan.output.format == Format::directory);
  say_smooth(messages, plan.morph.smooth, keys.size());
  const tandem::Look look = tandem::look_of(drawings);
  const int dim = keys.front().dim();
  if (dim != 2 && plan.output.format != Format::json) {
    throw tandem::InvalidArgument(fmt::format(
        "the shapes have dimension {}; only planar ones can be drawn, others go to .json or -", dim));
  }
  const MorphRun made = run_morph(command, keys, plan.morph, messages, true, look.styles);
  if (made.status != kDone) return made.status;
  const std::string reports = format_reports(made);
  if (made.paths) {
    if (plan.output.format != Format::json) say_look(messages, command, drawings, look, *made.paths);
    write_morph(command, plan.output, *made.paths, look, reports);
  } else {
    write_output(command.output, format_curve_frames(*made.curves, plan.output.positions, reports));
  }
  if (command.common.json && command.output != "-") write_output("-", "{" + reports + "}\n");
  return kDone;
}

void add_flags(Command& command) {
  command.app->add_option("shapes", command.inputs, "A, B, ...: files, parts of files, or path data");
  add_morph_output_flags(command);
  command.app
      ->add_option("--blend", command.blend, "auto, affine, bezier, hermite, similarity, intrinsic, detour")
      ->type_name("NAME");
  add_common_flags(*command.app, command.common);
  add_match_flags(*command.app, command.match);
  add_pin_flag(*command.app, command.match);
  command.app->add_flag("--no-cut", command.no_cut,
                        "Cut no contour into pieces: what is too much grows from points");
}

}  // namespace

const Subcommand kMorphCommand = {"morph", "The in-betweens of two or more curves or shapes", add_flags, run};

}  // namespace cli
