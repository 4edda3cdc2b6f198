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
#include "easing.h"
#include "frames.h"
#include "interrupt.h"
#include "messages.h"
#include "output.h"
#include "progress_bar.h"
#include "report.h"
#include "tandem/error.h"
#include "tandem/io/svg.h"
#include "tandem/match/rotation.h"
#include "tandem/morph/morph.h"
#include "tandem/morph/path_morph.h"
#include "usage_error.h"
#include "values.h"

namespace cli {
namespace {

using tandem::Morph;
using tandem::PathMorph;
using tandem::Shape;

constexpr int kDefaultFrames = 60;
constexpr int kMostFrames = 100'000;
constexpr double kLongestDuration = 86'400.0;  // a day, in seconds

/// What the options ask for, checked before anything is read.
struct Plan {
  Format format = Format::json;
  std::vector<double> positions;  ///< --at, or --frames spread over [0, 1]
  bool still = false;             ///< one in-between as a still SVG
  tandem::AnimationOptions animation;
  tandem::MorphOptions morph;
};

Plan make_plan(const Command& command) {
  if (command.output.empty()) {
    throw UsageError("morph needs -o OUT: .svg, .html, .json, DIRECTORY/, or - for JSON on standard output");
  }
  Plan plan;
  plan.format =
      output_format(command.output, command.to, {Format::svg, Format::html, Format::json, Format::directory});
  plan.morph.match = to_match_options(command.match);
  [[maybe_unused]] const bool affine =
      choose<bool>("--blend", command.blend, {{"auto", true}, {"affine", true}},
                   {"hermite", "bezier", "similarity", "intrinsic", "detour"});
  plan.animation.duration = parse_number("--duration", command.duration, 1e-3, kLongestDuration);
  plan.animation.easing = parse_easing(command.easing);
  const int frames =
      command.frames.empty() ? kDefaultFrames : parse_count("--frames", command.frames, 2, kMostFrames);
  if (command.at.empty()) {
    for (int i = 0; i < frames; ++i) plan.positions.push_back(static_cast<double>(i) / (frames - 1));
    return plan;
  }
  if (!command.frames.empty()) throw UsageError("--frames and --at exclude each other");
  for (const std::string& part : split_list("--at", command.at))
    plan.positions.push_back(parse_number("--at", part));
  plan.still = plan.format == Format::svg;
  if (plan.still && plan.positions.size() != 1) {
    throw UsageError("--at with an .svg takes one number; for several there is .json or DIRECTORY/");
  }
  if (plan.format == Format::html)
    throw UsageError("--at does not go with .html, which holds all in-betweens");
  return plan;
}

ShapeReport report_of(const Morph& morph, std::size_t key, const Shape& a, const Shape& b) {
  return make_report(a.contours.size(), b.contours.size(), [&](std::size_t i) -> const tandem::Match* {
    const std::optional<tandem::Match>& match = morph.match(key, i);
    return match ? &*match : nullptr;
  });
}

/// The last part of a path without its ending; path data has no name.
std::string short_name(const std::string& input) {
  if (input.empty() || input == "-") return "standard input";
  if ((input.front() == 'M' || input.front() == 'm') && input.find_first_of(" ,") != std::string::npos)
    return "path";
  const std::string name = input.substr(input.find_last_of('/') + 1);
  const std::size_t dot = name.find('.');
  const std::string stem = dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
  const std::size_t part = name.find('#');
  return part == std::string::npos || part < dot ? stem : stem + " " + name.substr(part + 1);
}

std::string title(const std::vector<std::string>& inputs) {
  std::string text;
  for (const std::string& input : inputs) text += (text.empty() ? "" : " \u2192 ") + short_name(input);
  return text;
}

/// `"report": {...}` of two keys, `"reports": [...]` of more.
std::string format_reports(const std::vector<ShapeReport>& reports) {
  if (reports.size() == 1) return "\"report\": " + format_report(reports.front());
  std::string text = "\"reports\": [";
  for (std::size_t i = 0; i < reports.size(); ++i) text += (i == 0 ? "" : ", ") + format_report(reports[i]);
  return text + "]";
}

void write(const Command& command, const Plan& plan, const Morph& morph, int dim,
           const std::vector<ShapeReport>& reports) {
  if (plan.format == Format::json && dim != 2) {
    return write_output(command.output, format_curve_frames(morph, plan.positions, format_reports(reports)));
  }
  const PathMorph paths(morph);
  switch (plan.format) {
    case Format::svg:
      return write_output(command.output, plan.still ? tandem::format_frame_svg(paths, plan.positions.front())
                                                     : tandem::format_animated_svg(paths, plan.animation));
    case Format::html:
      return write_output(command.output,
                          tandem::format_html_player(paths, title(command.inputs), plan.animation));
    case Format::directory:
      return write_frame_directory(command.output, plan.positions.size(), [&](std::size_t i) {
        return tandem::format_frame_svg(paths, plan.positions[i]);
      });
    default:
      return write_output(command.output, format_path_frames(paths, plan.positions, format_reports(reports)));
  }
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
  if (dim != 2 && plan.format != Format::json) {
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
  write(command, plan, morph, keys.front().dim(), reports);
  if (command.common.json && command.output != "-") write_output("-", "{" + format_reports(reports) + "}\n");
  return kDone;
}

}  // namespace

void add_morph_command(CLI::App& program, Command& command) {
  command.app = program.add_subcommand("morph", "The in-betweens of two or more curves or shapes");
  command.app->add_option("shapes", command.inputs, "A, B, ...: files, parts of files, or path data");
  command.app
      ->add_option("-o,--output", command.output, ".svg (animated), .html (player), .json (frames), DIR/, -")
      ->type_name("OUT");
  command.app->add_option("--to", command.to, "svg, html, json: whatever the ending of OUT")
      ->type_name("FORMAT");
  command.app->add_option("--frames", command.frames, "Number of frames in .json and DIR/ (60)")
      ->type_name("N");
  command.app->add_option("--at", command.at, "These in-betweens instead: 0 is A, 1 the last shape")
      ->type_name("S,...");
  command.app->add_option("--duration", command.duration, "Seconds from the first shape to the last (2)")
      ->type_name("X");
  command.app
      ->add_option("--easing", command.easing, "linear, ease, ease-in, ease-out, ease-in-out, x1,y1,x2,y2")
      ->type_name("NAME");
  command.app->add_option("--blend", command.blend, "auto, affine")->type_name("NAME");
  add_common_flags(*command.app, command.common);
  add_match_flags(*command.app, command.match);
  command.run = run;
}

}  // namespace cli
