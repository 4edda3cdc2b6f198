#include "tandem/io/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "io/file_format.h"
#include "io/json_lines.h"
#include "io/scan_number.h"
#include "io/svg_reader.h"
#include "io/text_position.h"
#include "tandem/error.h"
#include "tandem/io/cad.h"
#include "tandem/io/csv.h"
#include "tandem/io/files.h"
#include "tandem/io/font.h"
#include "tandem/io/itd.h"
#include "tandem/io/json.h"
#include "tandem/io/load_surface.h"
#include "tandem/io/path_data.h"
#include "tandem/io/surface_json.h"
#include "tandem/io/svg.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {
namespace {

bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == ',';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string_view without_leading_separators(std::string_view text) {
  while (!text.empty() && is_separator(text.front())) text.remove_prefix(1);
  return text;
}

/// M or m, then optional separators, then a number.
bool is_path_data(std::string_view text) {
  text = without_leading_separators(text);
  if (text.empty() || (text.front() != 'M' && text.front() != 'm')) return false;
  return starts_number(without_leading_separators(text.substr(1)));
}

bool is_font(std::string_view text) {
  using namespace std::string_view_literals;
  constexpr std::array<std::string_view, 7> kMagic = {"\0\1\0\0"sv, "OTTO"sv, "true"sv,  "ttcf"sv,
                                                      "wOFF"sv,     "wOF2"sv, "%!PS-A"sv};
  return std::any_of(kMagic.begin(), kMagic.end(),
                     [text](std::string_view magic) { return text.substr(0, magic.size()) == magic; });
}

/// Told by how a text starts: standard input and files of no known extension.
FileFormat format_of_content(std::string_view text) {
  if (is_font(text)) return FileFormat::font;
  if (text.substr(0, 2) == "\x1F\x8B") return FileFormat::compressed;
  text = without_leading_separators(without_bom(text));
  if (text.empty()) return FileFormat::unknown;
  const char first = text.front();
  if (first == '<') return FileFormat::svg;
  if (first == '{') return FileFormat::json;
  if (first == '[') {
    // "[OBJECT" or "[1": a list of IRIT's, or a JSON array.
    const std::string_view inside = without_leading_separators(text.substr(1));
    const bool word = !inside.empty() && inside.front() >= 'A' && inside.front() <= 'Z';
    return word ? FileFormat::itd : FileFormat::json;
  }
  if (is_path_data(text)) return FileFormat::path_data;
  if (text.find("[OBJECT") != std::string_view::npos) return FileFormat::itd;
  if (is_digit(first) || first == '-' || first == '+' || first == '.' || first == '#') return FileFormat::csv;
  return FileFormat::unknown;
}

std::optional<std::size_t> index_of(const std::string& part) {
  constexpr std::size_t kMostDigits = 9;
  if (part.empty() || part.size() > kMostDigits || !std::all_of(part.begin(), part.end(), is_digit)) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(*parse_number(part));
}

[[noreturn]] void fail(const std::string& source, const std::string& message) {
  throw ParseError(source, 0, 0, message);
}

/// Curves of one file as the contours of one shape.
Shape shape_of(std::vector<Curve> curves, const FilePart& name) {
  Shape shape;
  if (name.part) {
    const std::optional<std::size_t> index = index_of(*name.part);
    if (!index || *index >= curves.size()) {
      fail(name.path, fmt::format("there is no curve #{}; it has {} (#0 to #{})", *name.part, curves.size(),
                                  curves.size() - 1));
    }
    shape.contours.push_back(std::move(curves[*index]));
    return shape;
  }
  for (std::size_t i = 1; i < curves.size(); ++i) {
    if (curves[i].dim() != curves[0].dim()) {
      fail(name.path,
           fmt::format("curve 0 is of dimension {}, curve {} of dimension {}: name one of them with #0, #1, "
                       "...",
                       curves[0].dim(), i, curves[i].dim()));
    }
  }
  shape.contours = std::move(curves);
  return shape;
}

/// FILE.svg#ID, or FILE.svg#3 when no element has that id.
Drawing svg_drawing(std::string_view text, const FilePart& name) {
  if (!name.part) return merge(read_svg(text, name.path));
  const std::optional<std::size_t> index = index_of(*name.part);
  if (!index) return merge(read_svg_part(text, *name.part, name.path));
  SvgPicture picture = read_svg(text, name.path);
  const std::vector<SvgElement>& elements = picture.elements;
  const bool is_id = std::any_of(elements.begin(), elements.end(),
                                 [&](const SvgElement& element) { return element.id == *name.part; });
  if (is_id) return merge(read_svg_part(text, *name.part, name.path));
  if (*index >= elements.size()) {
    fail(name.path, fmt::format("there is no drawable #{}; it has {} (#0 to #{})", *index, elements.size(),
                                elements.size() - 1));
  }
  const SvgElement wanted = elements[*index];
  return {wanted.shape, wanted.style, picture.view_box, false, picture.missed};
}

/// Fonts have y up, everything else that is planar has y down.
Shape glyph_shape(const FilePart& name) {
  if (!name.part) fail(name.path, "is a font, expected a glyph of it: FONT.ttf#A");
  Shape shape = read_glyph(name.path, *name.part);
  for (Curve& contour : shape.contours) contour = transform(contour, Transform::scale(1.0, -1.0));
  return shape;
}

/// Far from the origin numbers are too far apart to tell points from each other.
std::string why_nothing(std::string_view path_data) {
  constexpr double kWhole =
      9007199254740992.0;  // 2^53: from here on not every whole number is one of double's
  double largest = 0.0;
  for (std::size_t i = 0; i < path_data.size();) {
    const std::optional<ScannedNumber> number = scan_number(path_data.substr(i));
    i += number ? number->length : 1;
    if (number && std::isfinite(number->value)) largest = std::max(largest, std::fabs(number->value));
  }
  if (largest < kWhole) return "";
  const double gap = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
  return fmt::format(": at coordinates of {:g} numbers are {:g} apart, and its points fall together", largest,
                     gap);
}

Shape path_data_shape(std::string_view text, const std::string& source, const LoadOptions& options) {
  Shape shape = to_shape(parse_path_data(without_bom(text), source), options.fill_rule);
  if (shape.contours.empty()) fail(source, "draws nothing" + why_nothing(text));
  return shape;
}

/// FILE.jsonl#3: the 4th line that is not blank.
Shape json_line_shape(std::string_view text, const FilePart& name) {
  const std::optional<std::size_t> index = name.part ? index_of(*name.part) : std::nullopt;
  if (!index) fail(name.path, "holds a shape per line, expected one of them: FILE.jsonl#0");
  std::istringstream in{std::string(text)};
  JsonLines lines(in);
  std::size_t count = 0;
  while (const std::optional<JsonLine> line = lines.next()) {
    if (count++ == *index) return parse_json_line(*line, name.path).shape;
  }
  fail(name.path, fmt::format("there is no line #{}; it has {} (#0 to #{})", *index, count, count - 1));
}

[[noreturn]] void fail_part(const FilePart& name, std::string_view kind) {
  fail(name.path, fmt::format("is {}, which has no parts; '#{}' names none", kind, *name.part));
}

/// All that are no SVG.
Shape parse_shape(std::string_view text, FileFormat format, const FilePart& name,
                  const LoadOptions& options) {
  switch (format) {
    case FileFormat::json:
      return shape_of(parse_json_curves(text, name.path), name);
    case FileFormat::itd:
      return shape_of(parse_itd(text, name.path), name);
    case FileFormat::csv:
      if (name.part) fail_part(name, "a table");
      return shape_of({parse_csv(text, name.path)}, name);
    case FileFormat::path_data:
      if (name.part) fail_part(name, "path data");
      return path_data_shape(text, name.path, options);
    case FileFormat::compressed:
      fail(name.path, "is compressed, expected plain text (gunzip it first)");
    case FileFormat::cad:
      return shape_of(read_cad_curves(name.path), name);
    case FileFormat::json_lines:
      return json_line_shape(text, name);
    case FileFormat::index:
      throw InvalidArgument(
          fmt::format("{}: is an index, which has no curves; only rank takes it", name.path));
    case FileFormat::svg:
    case FileFormat::font:
    case FileFormat::unknown:
      break;
  }
  if (text.empty()) fail(name.path, "is empty");
  fail(name.path, "is of no known kind: expected SVG, JSON, ITD, CSV, path data or a font");
}

Drawing without_style(Shape shape) {
  return {std::move(shape), {}, {}, false};
}

Drawing parse(std::string_view text, FileFormat format, const FilePart& name, const LoadOptions& options) {
  if (format == FileFormat::svg) return svg_drawing(text, name);
  return without_style(parse_shape(text, format, name, options));
}

/// JSON that says it is a surface is one, where a surface will do.
std::variant<Drawing, Surface> parse_any(std::string_view text, FileFormat format, const FilePart& name,
                                         const LoadOptions& options) {
  if (format == FileFormat::json && !name.part && is_json_surface(text)) {
    return parse_json_surface(text, name.path);
  }
  return parse(text, format, name, options);
}

std::variant<Drawing, Surface> load_file(const FilePart& name, const LoadOptions& options) {
  const FileFormat by_name = format_of_extension(name.path);
  if (by_name == FileFormat::font) return without_style(glyph_shape(name));
  if (by_name == FileFormat::cad) return parse({}, by_name, name, options);
  const std::string text = read_file(name.path);
  if (text.empty()) fail(name.path, "is empty");
  const FileFormat format = by_name == FileFormat::unknown ? format_of_content(text) : by_name;
  if (format == FileFormat::font) return without_style(glyph_shape(name));
  return parse_any(text, format, name, options);
}

/// Whether someone who writes this means a file.
bool looks_like_a_file(const std::string& name) {
  const std::string path = name.substr(0, name.find('#'));
  return format_of_extension(path) != FileFormat::unknown;
}

std::variant<Drawing, Surface> load_any(const std::string& name, const LoadOptions& options) {
  if (name == "-" || name.rfind("-#", 0) == 0) {
    const std::string text = read_file("-");
    FilePart input{"standard input", std::nullopt};
    if (name.size() > 2) input.part = name.substr(2);
    return parse_any(text, format_of_content(text), input, options);
  }
  if (const std::optional<FilePart> file = existing_file(name)) return load_file(*file, options);
  if (looks_like_a_file(name)) throw IoError(fmt::format("cannot read {}: there is no such file", name));
  if (is_path_data(name)) return without_style(path_data_shape(name, "path data", options));
  if (name.find('/') != std::string::npos || name.find('#') != std::string::npos) {
    throw IoError(fmt::format("cannot read {}: there is no such file", name));
  }
  throw InvalidArgument(
      fmt::format("'{}' is neither a file nor path data (M or m, and a number)", name.substr(0, 80)));
}

}  // namespace

std::variant<Shape, Surface> load_shape_or_surface(const std::string& name, const LoadOptions& options) {
  std::variant<Drawing, Surface> loaded = load_any(name, options);
  if (Surface* surface = std::get_if<Surface>(&loaded)) return std::move(*surface);
  return std::move(std::get<Drawing>(loaded).shape);
}

Drawing load_drawing(const std::string& name, const LoadOptions& options) {
  std::variant<Drawing, Surface> loaded = load_any(name, options);
  if (Drawing* drawing = std::get_if<Drawing>(&loaded)) return std::move(*drawing);
  fail(name == "-" ? "standard input" : name, "is a surface, expected curves");
}

Shape load_shape(const std::string& name, const LoadOptions& options) {
  return load_drawing(name, options).shape;
}

Surface load_surface(const std::string& name) {
  std::variant<Shape, Surface> loaded = load_shape_or_surface(name);
  if (Surface* surface = std::get_if<Surface>(&loaded)) return std::move(*surface);
  fail(name == "-" ? "standard input" : name,
       "holds curves, expected a surface (\"type\": \"bspline_surface\")");
}

}  // namespace v0
}  // namespace tandem
