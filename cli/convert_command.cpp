#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "commands.h"
#include "names.h"
#include "output.h"
#include "surface_output.h"
#include "tandem/io/cad.h"
#include "tandem/io/itd.h"
#include "tandem/io/json.h"
#include "tandem/io/svg.h"
#include "usage_error.h"

namespace cli {
namespace {

std::string format_shape(const tandem::Shape& shape, Format format) {
  if (const std::optional<tandem::CadFormat> cad = cad_format_of(format))
    return tandem::format_cad(*cad, shape.contours);
  switch (format) {
    case Format::svg:
      return tandem::format_svg(shape);
    case Format::itd:
      return tandem::format_itd(shape.contours);
    default:
      return tandem::format_json_curves(shape.contours);
  }
}

std::vector<Format> all_formats() {
  std::vector<Format> formats = surface_formats();
  formats.push_back(Format::itd);
  return formats;
}

void convert_shape(const Command& command, const tandem::Shape& shape) {
  const Format format =
      output_format(command.output, command.to,
                    {Format::json, Format::svg, Format::itd, Format::step, Format::iges, Format::brep});
  std::string text = format_shape(shape, format);
  if (text.empty() || text.back() != '\n') text += '\n';
  write_output(command.output, text);
}

Status run(const Command& command) {
  if (command.output.empty()) {
    throw UsageError(
        "convert needs -o OUT: of curves .json, .svg, .itd, .step, .iges, .brep, or - for standard output; "
        "of surfaces " +
        surface_endings());
  }
  // Which formats there are depends on what is read; one that neither has is refused before.
  static_cast<void>(output_format(command.output, command.to, all_formats()));
  const std::variant<tandem::Shape, tandem::Surface> loaded = load_any_input(command);
  if (const auto* shape = std::get_if<tandem::Shape>(&loaded)) {
    convert_shape(command, *shape);
    return kDone;
  }
  const SurfaceOutput output = plan_surface_output(*command.app, command.output, command.to, command.surface);
  SurfaceContent content;
  content.surface = &std::get<tandem::Surface>(loaded);
  content.title = short_name(command.inputs.front());
  write_surface(output, content);
  return kDone;
}

void add_flags(Command& command) {
  command.app->add_option("shape", command.inputs, "A file, a part of a file, or path data");
  command.app
      ->add_option(
          "-o,--output", command.output,
          "Of curves .json, .svg, .itd, .step; of a surface .json, .obj, .stl, .ply, .glb, .svg, .png, .html")
      ->type_name("OUT");
  command.app->add_option("--to", command.to, "json, svg, ...: whatever the ending of OUT")
      ->type_name("FORMAT");
  add_surface_flags(*command.app, command.surface);
  add_common_flags(*command.app, command.common);
}

}  // namespace

const Subcommand kConvertCommand = {"convert", "The same curves, or the same surface, in another format",
                                    add_flags, run};

}  // namespace cli
