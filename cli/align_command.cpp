#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "commands.h"
#include "messages.h"
#include "morph_run.h"
#include "output.h"
#include "pins.h"
#include "tandem/error.h"
#include "tandem/io/path_data.h"
#include "tandem/io/svg.h"
#include "usage_error.h"
#include "values.h"

namespace cli {
namespace {

constexpr int kMostDecimals = 15;
constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz";

/// {"a": path, "b": path, ...}: letters as far as they go, and all as "paths" when there are more than two.
std::string format_json(const tandem::PathMorph& morph, int precision, const std::string& reports) {
  const std::vector<std::string> keys = tandem::format_key_paths(morph, precision);
  std::string text = "{";
  for (std::size_t i = 0; i < keys.size() && i < kLetters.size(); ++i) {
    text += fmt::format("\"{}\": \"{}\",\n ", kLetters[i], keys[i]);
  }
  if (keys.size() > 2) {
    text += "\"paths\": [";
    for (std::size_t i = 0; i < keys.size(); ++i)
      text += fmt::format("{}\"{}\"", i == 0 ? "" : ",\n  ", keys[i]);
    text += "],\n ";
  }
  text += fmt::format("\"fill_rule\": \"{}\",\n ",
                      morph.fill_rule() == tandem::FillRule::evenodd ? "evenodd" : "nonzero");
  return text + reports + "}\n";
}

Status run(const Command& command) {
  if (command.output.empty()) {
    throw UsageError("align needs -o OUT: .json, .svg, or - for JSON on standard output");
  }
  const Format format = output_format(command.output, command.to, {Format::json, Format::svg});
  tandem::MorphOptions options;
  options.match = to_match_options(command.match);
  options.pins = parse_pins(command.match.pins);
  options.cuts = false;  // chords come in from the outline along curves, which takes more than two frames
  // Number by number, nothing turns; the match alone may.
  options.match.rotate = options.match.rotate.value_or(false);
  options.blend = tandem::BlendKind::affine;
  const int precision =
      command.precision.empty() ? -1 : parse_count("--precision", command.precision, 0, kMostDecimals);
  const Messages messages(command.common.quiet);
  const std::vector<tandem::Shape> keys = load_inputs(command, 2, std::string::npos);
  check_writable(command.output);
  if (keys.front().dim() != 2) {
    throw tandem::InvalidArgument(
        fmt::format("the shapes have dimension {}; only planar ones can be aligned", keys.front().dim()));
  }
  const MorphRun made = run_morph(command, keys, options, messages, false);
  if (made.status != kDone) return made.status;
  const std::string reports = format_reports(made);
  write_output(command.output, format == Format::svg ? tandem::format_keys_svg(*made.paths, precision)
                                                     : format_json(*made.paths, precision, reports));
  if (command.common.json && command.output != "-") write_output("-", "{" + reports + "}\n");
  return kDone;
}

void add_flags(Command& command) {
  command.app->add_option("shapes", command.inputs, "A, B, ...: files, parts of files, or path data");
  command.app->add_option("-o,--output", command.output, ".json, .svg, -")->type_name("OUT");
  command.app->add_option("--to", command.to, "json, svg: whatever the ending of OUT")->type_name("FORMAT");
  command.app->add_option("--precision", command.precision, "Decimals of coordinates (as the size needs)")
      ->type_name("N");
  add_common_flags(*command.app, command.common);
  add_match_flags(*command.app, command.match);
  add_pin_flag(*command.app, command.match);
}

}  // namespace

const Subcommand kAlignCommand = {"align", "Two or more shapes as path data that blends number by number",
                                  add_flags, run};

}  // namespace cli
