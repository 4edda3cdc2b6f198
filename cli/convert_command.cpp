#include "commands.h"
#include "output.h"
#include "tandem/io/itd.h"
#include "tandem/io/json.h"
#include "tandem/io/svg.h"
#include "usage_error.h"

namespace cli {
namespace {

std::string format_shape(const tandem::Shape& shape, Format format) {
  switch (format) {
    case Format::svg:
      return tandem::format_svg(shape);
    case Format::itd:
      return tandem::format_itd(shape.contours);
    default:
      return tandem::format_json_curves(shape.contours);
  }
}

Status run(const Command& command) {
  if (command.output.empty())
    throw UsageError("convert needs -o OUT: .json, .svg, .itd, or - for standard output");
  const Format format = output_format(command.output, command.to, {Format::json, Format::svg, Format::itd});
  std::string text = format_shape(load_inputs(command, 1, 1).front(), format);
  if (text.empty() || text.back() != '\n') text += '\n';
  write_output(command.output, text);
  return kDone;
}

}  // namespace

void add_convert_command(CLI::App& program, Command& command) {
  command.app = program.add_subcommand("convert", "The same curves in another format");
  command.app->add_option("shape", command.inputs, "A file, a part of a file, or path data");
  command.app->add_option("-o,--output", command.output, ".json, .svg, .itd, or - for standard output")
      ->type_name("OUT");
  command.app->add_option("--to", command.to, "json, svg, itd: whatever the ending of OUT")
      ->type_name("FORMAT");
  add_common_flags(*command.app, command.common);
  command.run = run;
}

}  // namespace cli
