#include "match_flags.h"

#include <cstddef>
#include <vector>

#include "values.h"

namespace cli {
namespace {

using tandem::ClosedMode;
using tandem::Direction;
using tandem::FillRule;
using tandem::MatchOptions;
using tandem::Method;
using tandem::NormKind;
using tandem::ReductionOptions;
using tandem::Sampling;
using tandem::SegmentCost;
using tandem::SegmentSplit;

// The tables take about 20 bytes per pair of nodes (paper) and up to 50 (elastic): these numbers need 2 GB.
constexpr int kMostPaperSamples = 10'000;
constexpr int kMostElasticSamples = 6'000;
constexpr int kMostCoefficients = 10'000;
constexpr int kHighestOrder = 12;       // composition multiplies degrees; beyond this doubles do not carry it
constexpr int kPaperCoefficients = 20;  // [C] section 3

std::array<int, 2> parse_samples(const std::string& text, Method method) {
  const int most = method == Method::paper ? kMostPaperSamples : kMostElasticSamples;
  const std::vector<std::string> parts = split_list("--samples", text);
  if (parts.size() > 2) throw UsageError("--samples takes M or M1,M2, not '" + text + "'");
  const int first = parse_count("--samples", parts.front(), 2, most);
  return {first, parts.size() == 1 ? first : parse_count("--samples", parts.back(), 2, most)};
}

std::optional<ReductionOptions> parse_reduction(const MatchFlags& flags, Method method) {
  if (flags.reduce.empty() && flags.tolerance.empty() && flags.order.empty()) return std::nullopt;
  if (!flags.reduce.empty() && !flags.tolerance.empty()) {
    throw UsageError("--reduce and --tolerance exclude each other: a number of coefficients, or an error");
  }
  ReductionOptions reduction;
  if (!flags.order.empty()) reduction.order = parse_count("--order", flags.order, 2, kHighestOrder);
  if (!flags.reduce.empty()) {
    reduction.coefficients = parse_count("--reduce", flags.reduce, reduction.order, kMostCoefficients);
  } else if (!flags.tolerance.empty()) {
    reduction.tolerance = parse_number("--tolerance", flags.tolerance, 1e-12, 1.0);
  } else if (method == Method::paper) {
    reduction.coefficients = kPaperCoefficients;
  }
  return reduction;
}

}  // namespace

void add_common_flags(CLI::App& command, CommonFlags& flags) {
  command.add_option("--fill-rule", flags.fill_rule, "of bare path data: nonzero, evenodd")
      ->type_name("RULE");
  command.add_flag("--json", flags.json, "The report as JSON on standard output");
  command.add_flag("--quiet", flags.quiet, "No messages on standard error");
}

void add_match_flags(CLI::App& command, MatchFlags& flags) {
  const std::string group = "Matching";
  const auto option = [&](const char* name, std::string& value, const char* type, const char* help) {
    command.add_option(name, value, help)->type_name(type)->group(group);
  };
  option("--method", flags.method, "NAME", "elastic (default), paper, segments");
  option("--norm", flags.norm, "NAME", "tangent (default), ruled, distance, bottleneck");
  option("--samples", flags.samples, "M[,M2]", "Nodes per curve (128 closed, 100 open; paper: 100)");
  option("--sampling", flags.sampling, "NAME", "arc, parameter, curvature (arc; paper: parameter)");
  option("--features", flags.features, "NAME", "tangent (default), tangent+curvature");
  option("--reduce", flags.reduce, "N", "Coefficients of v (paper: 20)");
  option("--tolerance", flags.tolerance, "X",
         "Error of v allowed, as a share of its domain (elastic: 0.001)");
  option("--order", flags.order, "K", "Order of v: 2 is piecewise linear (default)");
  option("--direction", flags.direction, "NAME", "auto (default), forward, reversed");
  option("--closed", flags.closed, "NAME", "auto (default), yes, no, pinned");
  option("--split", flags.split, "NAME", "segments: proportional (default), uniform");
  option("--segment-cost", flags.segment_cost, "NAME", "segments: derivative (default), paper");
  option("--low-pass", flags.low_pass, "X",
         "Smooth the samples first: deviation as a share of the length (0)");
  option("--threads", flags.threads, "N", "Threads to use (all); the result does not depend on it");
  command.add_flag("--fast", flags.fast, "Faster, but not exact")->group(group);
  CLI::Option* rotate = command.add_flag_callback(
      "--rotate", [&flags] { flags.rotate = true; }, "Match under the best turn (default of morph)");
  CLI::Option* no_rotate = command.add_flag_callback(
      "--no-rotate", [&flags] { flags.rotate = false; }, "Match the curves as they lie (default of match)");
  rotate->group(group);
  no_rotate->group(group)->excludes(rotate);
  command.add_flag("--strict", flags.strict, "Exit with 4 and write nothing when there is no valid match")
      ->group(group);
}

namespace {

/// The segments method has no samples, and a cost of its own.
void refuse_samples(const MatchFlags& flags) {
  const auto refuse = [](bool given, const char* name) {
    if (given) throw UsageError(std::string(name) + " does not go with --method segments");
  };
  refuse(flags.norm != "tangent", "--norm");
  refuse(!flags.samples.empty(), "--samples");
  refuse(!flags.sampling.empty(), "--sampling");
  refuse(flags.features != "tangent", "--features");
  refuse(!flags.low_pass.empty(), "--low-pass");
  refuse(flags.fast, "--fast");
  refuse(flags.closed == "pinned", "--closed pinned");
}

/// The other methods know no segments.
void refuse_segments(const MatchFlags& flags) {
  if (!flags.split.empty()) throw UsageError("--split goes with --method segments only");
  if (!flags.segment_cost.empty()) throw UsageError("--segment-cost goes with --method segments only");
}

tandem::SegmentRules parse_rules(const MatchFlags& flags) {
  tandem::SegmentRules rules;
  if (!flags.split.empty()) {
    rules.split = choose<SegmentSplit>(
        "--split", flags.split,
        {{"proportional", SegmentSplit::proportional}, {"uniform", SegmentSplit::uniform}});
  }
  if (!flags.segment_cost.empty()) {
    rules.cost =
        choose<SegmentCost>("--segment-cost", flags.segment_cost,
                            {{"derivative", SegmentCost::derivative}, {"paper", SegmentCost::paper}});
  }
  return rules;
}

/// What would not pass through pins.
void refuse_free_ends(const MatchFlags& flags) {
  if (flags.closed == "pinned") throw UsageError("--closed pinned does not go with --pin");
  if (!flags.reduce.empty()) throw UsageError("--reduce does not go with --pin; there is --tolerance");
}

}  // namespace

void add_pin_flag(CLI::App& command, MatchFlags& flags) {
  command
      .add_option("--pin", flags.pins,
                  "A point of A and one of B that belong together, of motions t1=t2 (may be repeated)")
      ->type_name("X1,Y1=X2,Y2")
      ->group("Matching")
      ->expected(1)
      ->take_all();
}

tandem::LoadOptions to_load_options(const CommonFlags& flags) {
  return {.fill_rule = choose<FillRule>("--fill-rule", flags.fill_rule,
                                        {{"nonzero", FillRule::nonzero}, {"evenodd", FillRule::evenodd}})};
}

MatchOptions to_match_options(const MatchFlags& flags) {
  MatchOptions options;
  options.method = choose<Method>(
      "--method", flags.method,
      {{"elastic", Method::elastic}, {"paper", Method::paper}, {"segments", Method::segments}});
  if (options.method == Method::segments) {
    refuse_samples(flags);
    options.segments = parse_rules(flags);
  } else {
    refuse_segments(flags);
  }
  if (!flags.pins.empty()) refuse_free_ends(flags);
  options.norm = choose<NormKind>("--norm", flags.norm,
                                  {{"tangent", NormKind::tangent},
                                   {"ruled", NormKind::ruled},
                                   {"distance", NormKind::distance},
                                   {"bottleneck", NormKind::bottleneck}});
  if (!flags.samples.empty()) options.samples = parse_samples(flags.samples, options.method);
  if (!flags.sampling.empty()) {
    options.sampling = choose<Sampling>(
        "--sampling", flags.sampling,
        {{"arc", Sampling::arc}, {"parameter", Sampling::parameter}, {"curvature", Sampling::curvature}});
  }
  options.features.curvature =
      choose<bool>("--features", flags.features, {{"tangent", false}, {"tangent+curvature", true}});
  options.reduction = parse_reduction(flags, options.method);
  options.direction = choose<Direction>(
      "--direction", flags.direction,
      {{"auto", Direction::automatic}, {"forward", Direction::forward}, {"reversed", Direction::reversed}});
  options.rotate = flags.rotate;
  if (flags.rotate.value_or(false) && std::get<NormKind>(options.norm) == NormKind::ruled) {
    throw UsageError("--rotate does not go with --norm ruled: rulings join the curves where they lie");
  }
  options.closed = choose<ClosedMode>("--closed", flags.closed,
                                      {{"auto", ClosedMode::automatic},
                                       {"yes", ClosedMode::yes},
                                       {"no", ClosedMode::no},
                                       {"pinned", ClosedMode::pinned}});
  if (!flags.low_pass.empty()) options.low_pass = parse_number("--low-pass", flags.low_pass, 0.0, 0.5);
  options.coarse_to_fine = flags.fast;
  if (!flags.threads.empty()) options.threads = parse_count("--threads", flags.threads, 1, 1024);
  return options;
}

}  // namespace cli
