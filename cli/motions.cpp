#include "motions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <string>

#include "frames.h"
#include "morph_run.h"
#include "motion_columns.h"
#include "output.h"
#include "pins.h"
#include "report.h"
#include "tandem/error.h"
#include "tandem/io/files.h"
#include "tandem/io/json.h"
#include "tandem/io/motion_picture.h"
#include "tandem/morph/motion_morph.h"
#include "usage_error.h"

namespace cli {
namespace {

using tandem::CsvTable;
using tandem::Curve;
using tandem::MotionMorph;

bool is_csv_file(const std::string& name) {
  constexpr std::size_t kEnding = 4;
  std::string ending = name.size() > kEnding ? name.substr(name.size() - kEnding) : "";
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  std::error_code error;
  return ending == ".csv" && std::filesystem::exists(name, error);
}

/// As many rows as the inputs have, blended as their durations are.
std::size_t row_count(const std::vector<CsvTable>& tables, const MotionMorph& morph, double s) {
  const tandem::KeyPosition at = tandem::locate_key(std::clamp(s, 0.0, 1.0), morph.key_times());
  const double rows = (1.0 - at.local) * static_cast<double>(tables[at.key].rows) +
                      at.local * static_cast<double>(tables[at.key + 1].rows);
  return static_cast<std::size_t>(std::lround(rows));
}

std::string format_rows(const std::vector<CsvTable>& tables, const MotionMorph& morph, double s) {
  return tandem::format_csv(morph.rows(s, row_count(tables, morph, s)), tables.front().columns);
}

/// Members of the frame: the curve over the first motion's time, and when its moments are.
std::string format_motion_frame(const std::vector<CsvTable>& tables, const MotionMorph& morph, double s) {
  const Curve graph = morph.graph(s);
  const auto part = [&](int first, int count) {
    tandem::Points points(count, graph.size());
    for (std::size_t i = 0; i < graph.size(); ++i) {
      for (int c = 0; c < count; ++c) {
        points[i][static_cast<std::size_t>(c)] =
            graph.control_points()[i][static_cast<std::size_t>(first + c)];
      }
    }
    const Curve curve(graph.degree(), graph.knots(), std::move(points));
    return trimmed(tandem::format_json_curves({&curve, 1}));
  };
  std::string columns;
  for (const std::string& name : tables.front().columns)
    columns += (columns.empty() ? "" : ", ") + json_string(name);
  const tandem::Points rows = morph.rows(s, row_count(tables, morph, s));
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += i == 0 ? "[" : ", [";
    for (std::size_t c = 0; c < rows[i].size(); ++c) text += (c == 0 ? "" : ", ") + json_number(rows[i][c]);
    text += ']';
  }
  return fmt::format("\"curves\": [{}], \"time\": {}, \"columns\": [{}], \"rows\": [{}]",
                     part(1, graph.dim() - 1), part(0, 1), columns, text);
}

void write(const Command& command, const std::vector<CsvTable>& tables, const MorphOutput& output,
           const MotionMorph& morph, const std::string& reports) {
  const tandem::MotionPicture picture{tables.front().columns, output.title,
                                      output.at_given ? output.positions : std::vector<double>{}};
  switch (output.format) {
    case Format::csv:
      return write_output(command.output, format_rows(tables, morph, output.positions.front()));
    case Format::svg:
      return write_output(command.output, format_motion_svg(morph, picture));
    case Format::html:
      return write_output(command.output, format_motion_html(morph, picture, output.animation));
    case Format::directory:
      return write_frame_directory(command.output, output.positions.size(), ".csv", [&](std::size_t i) {
        return format_rows(tables, morph, output.positions[i]);
      });
    default:
      return write_output(command.output, format_frames(output.positions, reports, [&](double s) {
                            return format_motion_frame(tables, morph, s);
                          }));
  }
}

}  // namespace

std::optional<std::vector<CsvTable>> load_motions(const Command& command, Format format,
                                                  const Messages& messages) {
  const std::vector<std::string>& names = command.inputs;
  if (names.size() < 2 || !std::all_of(names.begin(), names.end(), is_csv_file)) {
    if (format == Format::csv) {
      throw UsageError("a .csv holds a motion, which is blended from motions: two or more .csv files");
    }
    return std::nullopt;
  }
  std::vector<CsvTable> tables;
  for (const std::string& name : names) {
    tables.push_back(tandem::parse_csv_table(tandem::read_file(name), name));
  }
  if (tables.front().curve.dim() == 2 && format != Format::csv && command.to != "csv") return std::nullopt;
  pair_columns(tables, names, messages);
  return tables;
}

Status morph_motions(const Command& command, const std::vector<CsvTable>& tables, const MorphOutput& output,
                     const tandem::MorphOptions& options, const Messages& messages) {
  constexpr Format kFormats[] = {Format::csv, Format::svg, Format::html, Format::json, Format::directory};
  if (std::find(std::begin(kFormats), std::end(kFormats), output.format) == std::end(kFormats)) {
    throw tandem::InvalidArgument("motions go to .csv, .json, .svg, .html or DIRECTORY/, not to that format");
  }
  check_writable(command.output, output.format == Format::directory);
  tandem::MotionOptions own;
  own.match = options.match;
  own.match.pins = parse_time_pins(command.match.pins);
  if (!own.match.pins.empty() && tables.size() != 2) {
    throw UsageError(fmt::format("--pin goes with two motions, not with {}", tables.size()));
  }
  own.times = options.times;
  say_smooth(messages, options.smooth, tables.size());
  own.smooth = options.smooth;
  std::vector<Curve> motions;
  for (const CsvTable& table : tables) motions.push_back(table.curve);
  const MorphRun made = [&] {
    try {
      return run_motions(command, motions, own, messages);
    } catch (const tandem::InvalidArgument& error) {
      // The library knows curves, not files.
      throw tandem::InvalidArgument(fmt::format("{}: {}", fmt::join(command.inputs, ", "), error.what()));
    }
  }();
  if (made.status != kDone) return made.status;
  const std::string reports = format_reports(made);
  write(command, tables, output, *made.motions, reports);
  if (command.common.json && command.output != "-") write_output("-", "{" + reports + "}\n");
  return kDone;
}

}  // namespace cli
