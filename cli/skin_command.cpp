#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands.h"
#include "interrupt.h"
#include "messages.h"
#include "output.h"
#include "progress_bar.h"
#include "rule_law.h"
#include "skin_report.h"
#include "surface_output.h"
#include "tandem/curve/nearest_point.h"
#include "tandem/error.h"
#include "values.h"

namespace cli {
namespace {

using tandem::Curve;
using tandem::LoftParameters;
using tandem::Points;
using tandem::Shape;
using tandem::SkinMatching;

constexpr int kHighestDegree = 25;  // of the formats of CAD
constexpr int kMostRows = 100'000;

/// What the options ask for, checked before anything is read.
struct Plan {
  SurfaceOutput output;
  tandem::SkinOptions skin;
  double spacing = 0.0;  // 0: not given
};

Plan make_plan(const Command& command) {
  const SkinFlags& flags = command.skin;
  Plan plan;
  plan.output = plan_surface_output(*command.app, command.output, command.to, command.surface);
  plan.skin.law = law_options(command, plan.skin.law);
  plan.skin.match = to_match_options(command.match);
  plan.skin.match.reduction.reset();
  plan.skin.loft.degree = parse_count("--degree", flags.degree, 1, kHighestDegree);
  plan.skin.loft.parameters = choose<LoftParameters>("--parameters", flags.parameters,
                                                     {{"chord", LoftParameters::chord},
                                                      {"centripetal", LoftParameters::centripetal},
                                                      {"uniform", LoftParameters::uniform}});
  plan.skin.loft.closed = flags.ring;
  if (!flags.rows.empty()) plan.skin.loft.rows = parse_count("--rows", flags.rows, 2, kMostRows);
  if (!flags.matching.empty()) {
    plan.skin.matching = choose<SkinMatching>(
        "--matching", flags.matching, {{"sequence", SkinMatching::sequence}, {"joint", SkinMatching::joint}});
  }
  if (!flags.spacing.empty()) {
    plan.spacing = parse_number("--spacing", flags.spacing);
    if (plan.spacing == 0.0) throw UsageError("--spacing takes a number that is not 0");
  }
  if (flags.solid && (flags.ring || flags.certify || !flags.rows.empty() || !flags.pins.empty())) {
    throw UsageError("--solid excludes --ring, --rows, --certify and --pin");
  }
  return plan;
}

/// The planar curve at height z.
Curve lifted(const Curve& curve, double z) {
  if (curve.dim() != 2) {
    throw tandem::InvalidArgument(
        fmt::format("--spacing stacks planar curves; there is one of dimension {}", curve.dim()));
  }
  Points points(3, curve.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i][0] = curve.control_points()[i][0];
    points[i][1] = curve.control_points()[i][1];
    points[i][2] = z;
  }
  return Curve(curve.degree(), curve.knots(), std::move(points), curve.weights());
}

/// Levels so near or so far, against the size of what is stacked, are a slip: doubles tell neither the shape
/// nor the distance.
constexpr double kLargestSpacing = 1e9;

void check_spacing(const Command& command, double spacing, const std::vector<std::vector<Curve>>& levels) {
  double extent = 0.0;
  for (const auto& level : levels) {
    for (const Curve& curve : level) extent = std::max(extent, curve.extent());
  }
  const double share = std::fabs(spacing) / extent;
  if (share <= kLargestSpacing && share >= 1.0 / kLargestSpacing) return;
  throw tandem::InvalidArgument(
      fmt::format("--spacing {} does not go with inputs of size {:.3g}: expected {:.3g} to {:.3g}",
                  command.skin.spacing, extent, extent / kLargestSpacing, extent * kLargestSpacing));
}

/// The inputs' contours, input by input, stacked if that was asked for.
std::vector<std::vector<Curve>> read_levels(const Command& command, const Plan& plan) {
  std::vector<std::vector<Curve>> levels;
  for (Shape& shape : load_inputs(command, 1, std::string::npos)) {
    levels.push_back(std::move(shape.contours));
  }
  if (plan.spacing == 0.0) return levels;
  check_spacing(command, plan.spacing, levels);
  for (std::size_t k = 0; k < levels.size(); ++k) {
    for (Curve& curve : levels[k]) curve = lifted(curve, plan.spacing * static_cast<double>(k));
  }
  return levels;
}

/// The pin `p=q=...`, a point of each section, as parameters: those of the nearest points.
std::vector<double> locate_pin(const std::string& pin, const std::vector<Curve>& sections) {
  std::vector<std::string> parts{""};
  for (const char c : pin) {
    if (c == '=') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  if (parts.size() != sections.size()) {
    throw UsageError(fmt::format("--pin {}: {} points for {} sections, expected one each", pin, parts.size(),
                                 sections.size()));
  }
  std::vector<double> parameters;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    tandem::Point point;
    for (const std::string& x : split_list("--pin", parts[k])) point.push_back(parse_number("--pin", x));
    if (static_cast<int>(point.size()) != sections[k].dim()) {
      throw UsageError(fmt::format("--pin {}: '{}' has {} coordinates, expected {}", pin, parts[k],
                                   point.size(), sections[k].dim()));
    }
    parameters.push_back(tandem::nearest_point(sections[k], point).parameter);
  }
  return parameters;
}

void warn(const Messages& messages, const tandem::SkinnedSurface& skinned, double tolerance) {
  if (skinned.report.wrong_sign_share > 0.0) {
    messages.warning(fmt::format("the surface folds over itself: the wrong sign on {:.3g} % of its area",
                                 100.0 * skinned.report.wrong_sign_share));
  }
  for (std::size_t k = 0; k < skinned.report.pairs.size(); ++k) {
    const tandem::Validity& validity = skinned.report.pairs[k].validity;
    if (validity.valid) continue;
    messages.warning(fmt::format(
        "sections {} and {}: not valid on {:.3g} % of their length, least <T1,T2> {:.3g}", k,
        (k + 1) % skinned.sections.size(), 100.0 * (1.0 - validity.valid_share), validity.min_dot));
  }
  warn_of_deviation(messages, skinned.laws, tolerance);
}

Status write_skin(const Command& command, Plan plan, std::vector<std::vector<Curve>> levels,
                  const Messages& messages) {
  std::vector<Curve> sections;
  for (auto& level : levels) {
    for (Curve& curve : level) sections.push_back(std::move(curve));
  }
  fit_order(
      command, plan.output.format, [&](int q) { return skinned_degree(sections, q); }, plan.skin.law,
      messages);
  for (const std::string& pin : command.skin.pins) plan.skin.pins.push_back(locate_pin(pin, sections));
  const auto make = [&] {
    const InterruptibleScope interruptible;
    plan.skin.match.progress = show_progress(messages.quiet());
    return tandem::skin(sections, plan.skin);
  };
  const tandem::SkinnedSurface skinned = make();
  throw_if_interrupted();
  erase_progress_bar();
  if (command.match.strict && !skinned.report.valid) {
    messages.error("not all sections match validly (--strict): nothing was written");
    return kNoValidMatch;
  }
  warn(messages, skinned, plan.skin.law.tolerance);
  std::optional<tandem::Certificate> certificate;
  if (command.skin.certify) {
    certificate = certify(skinned.surface, plan.output);
    warn(messages, *certificate);
  }
  const std::string report = format_skin_report(skinned, certificate);
  write_surface(plan.output, {&skinned.surface, nullptr, "\"report\": " + report, skinned.sections, "Skin"});
  if (command.common.json && command.output != "-") write_output("-", report + "\n");
  return kDone;
}

/// What contours_to_solid() says of levels, in terms of the inputs.
void check_solid(const Command& command, const std::vector<std::vector<Curve>>& levels) {
  if (levels.size() < 2) {
    throw tandem::InvalidArgument(fmt::format(
        "--solid needs two levels of contours or more: each input is one level, and {} is the only one",
        command.inputs.front()));
  }
  for (std::size_t l = 0; l < levels.size(); ++l) {
    for (const Curve& curve : levels[l]) {
      if (curve.dim() == 2) {
        throw tandem::InvalidArgument(
            fmt::format("{}: its contours are planar; --spacing X stacks the inputs at z = 0, X, 2X, ...",
                        command.inputs[l]));
      }
      if (!curve.is_closed()) {
        throw tandem::InvalidArgument(fmt::format(
            "{} (level {}): has an open curve, --solid takes closed contours", command.inputs[l], l));
      }
    }
  }
}

Status write_solid(const Command& command, const Plan& plan, const std::vector<std::vector<Curve>>& levels,
                   const Messages& messages) {
  check_solid(command, levels);
  tandem::SolidOptions options;
  options.match = plan.skin.match;
  options.chord = plan.output.mesh.chord;
  const tandem::Solid solid = tandem::contours_to_solid(levels, options);
  if (solid.report.left_out > 0) {
    messages.warning(fmt::format("{} contour{} on no level beside: nothing comes of {}",
                                 solid.report.left_out,
                                 solid.report.left_out == 1 ? " has a partner" : "s have partners",
                                 solid.report.left_out == 1 ? "it" : "them"));
  }
  if (solid.report.simple == tandem::Verdict::violated) {
    messages.warning(fmt::format("triangles {} and {} of the solid meet: it crosses or touches itself",
                                 solid.report.crossing[0], solid.report.crossing[1]));
  }
  std::vector<Curve> curves;
  for (const auto& level : levels) curves.insert(curves.end(), level.begin(), level.end());
  write_surface(plan.output, {nullptr, &solid.mesh, "", std::move(curves), "Solid"});
  if (command.common.json && command.output != "-") write_output("-", format_solid_report(solid) + "\n");
  return kDone;
}

Status run(const Command& command) {
  Plan plan = make_plan(command);
  const Messages messages(command.common.quiet);
  std::vector<std::vector<Curve>> levels = read_levels(command, plan);
  if (command.skin.solid) return write_solid(command, plan, levels, messages);
  return write_skin(command, std::move(plan), std::move(levels), messages);
}

void add_skin_flags(CLI::App& app, SkinFlags& flags) {
  app.add_option("--degree", flags.degree, "Across the sections (3, or as many as there are less one)")
      ->type_name("N");
  app.add_option("--parameters", flags.parameters, "Spacing: chord (default), centripetal, uniform")
      ->type_name("NAME");
  app.add_option("--rows", flags.rows, "Approximate, with so many control points across")->type_name("N");
  app.add_option("--matching", flags.matching, "sequence (default), joint (default with --ring)")
      ->type_name("NAME");
  app.add_option("--spacing", flags.spacing, "Stack planar inputs at z = 0, X, 2X, ...")->type_name("X");
  app.add_flag("--ring", flags.ring, "The last section is followed by the first");
  app.add_flag("--certify", flags.certify,
               "Prove that the surface is regular, and its triangles do not cross");
  app.add_flag("--solid", flags.solid, "Each input is a level of closed contours: a closed mesh with caps");
  app.add_option("--pin", flags.pins,
                 "x,y,z=x,y,z=...: points that belong together, one per section; repeatable")
      ->type_name("POINTS")
      ->expected(1)
      ->take_all();
}

void add_flags(Command& command) {
  command.app->add_option("curves", command.inputs, "C1, C2, ...: files, parts of files, or path data");
  command.app->add_option("-o,--output", command.output, surface_endings())->type_name("OUT");
  command.app->add_option("--to", command.to, "json, obj, ...: whatever the ending of OUT")
      ->type_name("FORMAT");
  add_skin_flags(*command.app, command.skin);
  add_surface_flags(*command.app, command.surface);
  add_common_flags(*command.app, command.common);
  add_match_flags(*command.app, command.match);
  describe_skin_laws(*command.app);
}

}  // namespace

const Subcommand kSkinCommand = {"skin", "The surface through curves, or the solid through contours",
                                 add_flags, run};

}  // namespace cli
