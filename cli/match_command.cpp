#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "commands.h"
#include "interrupt.h"
#include "match_sheet.h"
#include "messages.h"
#include "output.h"
#include "pins.h"
#include "progress_bar.h"
#include "report.h"
#include "tandem/error.h"
#include "tandem/io/match_picture.h"
#include "tandem/match/rotation.h"

namespace cli {
namespace {

using tandem::Match;
using tandem::MatchOptions;
using tandem::Shape;

/// pins: of each pair of contours.
std::vector<Match> match_contours(const Shape& a, const Shape& b, MatchOptions options,
                                  const std::vector<std::vector<tandem::ParameterPair>>& pins, bool quiet) {
  const InterruptibleScope interruptible;
  const std::size_t count = std::min(a.contours.size(), b.contours.size());
  std::vector<Match> matches;
  matches.reserve(count);
  const std::size_t before = options.rotate.value_or(false) && count > 1 ? 1 : 0;
  if (before > 0) {
    // The contours of a shape turn together.
    options.progress = show_progress(quiet, 0, count + before);
    options.rotation =
        tandem::common_rotation({a.contours.data(), count}, {b.contours.data(), count}, options).values();
    throw_if_interrupted();
  }
  for (std::size_t i = 0; i < count; ++i) {
    options.progress = show_progress(quiet, i + before, count + before);
    options.pins = pins[i];
    matches.push_back(tandem::match(a.contours[i], b.contours[i], options));
    throw_if_interrupted();
  }
  return matches;
}

std::string format_pictures(const Shape& a, const Shape& b, const std::vector<Match>& matches,
                            const MatchOptions& options) {
  std::vector<std::string> pictures;
  pictures.reserve(matches.size());
  for (std::size_t i = 0; i < matches.size(); ++i) {
    pictures.push_back(tandem::format_match_picture(a.contours[i], b.contours[i], matches[i], options));
  }
  return stack_pictures(pictures);
}

Status run(const Command& command) {
  const MatchOptions options = to_match_options(command.match);
  const bool to_file = !command.output.empty();
  const Format format =
      to_file ? output_format(command.output, command.to, {Format::json, Format::svg}) : Format::json;
  const Messages messages(command.common.quiet);
  const std::vector<Shape> shapes = load_inputs(command, 2, 2);
  if (to_file) check_writable(command.output);
  const std::vector<Match> matches = match_contours(
      shapes[0], shapes[1], options, locate_pins(command.match.pins, shapes[0], shapes[1]), messages.quiet());
  erase_progress_bar();

  const ShapeReport report = make_report(shapes[0].contours.size(), shapes[1].contours.size(),
                                         [&](std::size_t i) { return &matches[i]; });
  if (command.match.strict && !report.valid()) {
    messages.error("no valid match exists for these samples (--strict): nothing was written");
    return kNoValidMatch;
  }
  warn(messages, report);
  if (to_file) {
    write_output(command.output, format == Format::svg
                                     ? format_pictures(shapes[0], shapes[1], matches, options)
                                     : format_report(report) + "\n");
  }
  if (command.common.json && command.output != "-") write_output("-", format_report(report) + "\n");
  if (!command.common.json && !to_file) write_output("-", format_table(report));
  return kDone;
}

void add_flags(Command& command) {
  command.app->add_option("shapes", command.inputs, "A and B: files, parts of files, or path data");
  command.app->add_option("-o,--output", command.output, ".json, .svg (picture), or - for standard output")
      ->type_name("OUT");
  command.app->add_option("--to", command.to, "json, svg: whatever the ending of OUT")->type_name("FORMAT");
  add_common_flags(*command.app, command.common);
  add_match_flags(*command.app, command.match);
  add_pin_flag(*command.app, command.match);
}

}  // namespace

const Subcommand kMatchCommand = {"match", "The correspondence of two curves or shapes", add_flags, run};

}  // namespace cli
