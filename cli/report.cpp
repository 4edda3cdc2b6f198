#include "report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "tandem/io/json.h"
#include "tandem/match/rotation.h"
#include "tandem/version.h"

namespace cli {
namespace {

using tandem::Match;
using tandem::MatchReport;

std::string_view name(tandem::Method method) {
  switch (method) {
    case tandem::Method::paper:
      return "paper";
    case tandem::Method::segments:
      return "segments";
    case tandem::Method::elastic:
      break;
  }
  return "elastic";
}

std::string_view name(tandem::Sampling sampling) {
  switch (sampling) {
    case tandem::Sampling::arc:
      return "arc";
    case tandem::Sampling::parameter:
      return "parameter";
    case tandem::Sampling::curvature:
      return "curvature";
  }
  return "";
}

std::string_view name(tandem::Direction direction) {
  return direction == tandem::Direction::reversed ? "reversed" : "forward";
}

/// Sums and means over all pairs; means are weighted with the length of both contours.
struct Totals {
  double cost = 0.0;
  double mean_cost = 0.0;
  int invalid_nodes = 0;
  double invalid_length = 0.0;
  double min_dot = std::numeric_limits<double>::infinity();
  double valid_share = 0.0;
  MatchReport::Seconds seconds;
};

Totals add_up(const ShapeReport& report) {
  Totals totals;
  if (report.pairs.empty())
    return {.min_dot = 1.0, .valid_share = 1.0, .seconds = {}};  // nothing that could be invalid
  double weights = 0.0;
  for (const ContourMatch& pair : report.pairs)
    weights += pair.match->samples_a.length + pair.match->samples_b.length;
  for (const ContourMatch& pair : report.pairs) {
    const MatchReport& r = pair.match->report;
    const double length = pair.match->samples_a.length + pair.match->samples_b.length;
    const double weight = weights > 0.0 && std::isfinite(weights)
                              ? length / weights
                              : 1.0 / static_cast<double>(report.pairs.size());
    totals.cost += r.cost;
    totals.mean_cost += weight * r.mean_cost;
    totals.invalid_nodes += r.invalid_nodes;
    totals.invalid_length += weight * r.invalid_length;
    totals.min_dot = std::min(totals.min_dot, r.validity.min_dot);
    totals.valid_share += weight * r.validity.valid_share;
    totals.seconds.sample += r.seconds.sample;
    totals.seconds.match += r.seconds.match;
    totals.seconds.fit += r.seconds.fit;
    totals.seconds.compose += r.seconds.compose;
  }
  return totals;
}

std::string format_seconds(const MatchReport::Seconds& seconds) {
  return fmt::format(R"({{"sample": {}, "match": {}, "fit": {}, "compose": {}}})",
                     json_number(seconds.sample), json_number(seconds.match), json_number(seconds.fit),
                     json_number(seconds.compose));
}

std::string format_indices(const std::vector<std::size_t>& indices) {
  std::string text = "[";
  for (const std::size_t i : indices) text += fmt::format("{}{}", text.size() == 1 ? "" : ", ", i);
  return text + "]";
}

bool is_one_pair(const ShapeReport& report) {
  return report.pairs.size() == 1 && report.unmatched_a.empty() && report.unmatched_b.empty();
}

std::string percent(double share) {
  return fmt::format("{:.4g} %", 100.0 * share);
}

/// How much of the length is valid, rounded down: nearly all is not all, and neither is all but a point.
std::string valid_percent(double share, bool valid) {
  constexpr double kPlaces = 100.0;
  if (valid && share >= 1.0) return "100 %";
  if (share > 1.0 - 1.0 / (100.0 * kPlaces)) return "over 99.99 %";
  return fmt::format("{:.4g} %", std::floor(100.0 * share * kPlaces) / kPlaces);
}

/// A line that says how far B was turned back; nothing where it was not.
std::string format_turn(const Match& match, std::string_view label) {
  const double degrees = tandem::Rotation(match.curve.dim(), match.report.rotation).degrees();
  return degrees == 0.0 ? "" : fmt::format("{}{:.6g} degrees\n", label, degrees);
}

std::string format_contour_table(const Match& match) {
  const MatchReport& r = match.report;
  const bool segments = r.method == tandem::Method::segments;
  const char* nodes = segments ? "joints" : "samples";
  const char* unit = r.method == tandem::Method::paper ? "node"
                     : segments                        ? "pair of segments"
                                                       : "unit of length";
  const tandem::Curve& v = match.reparametrization.v;
  std::string text;
  text += fmt::format("cost         {:.6g} (mean {:.4g} per {})\n", r.cost, r.mean_cost, unit);
  text += fmt::format("valid        {} (smallest <T1,T2> {:.4g}, > 0 on {} of the length)\n",
                      r.validity.valid ? "yes" : "no", r.validity.min_dot,
                      valid_percent(r.validity.valid_share, r.validity.valid));
  text += fmt::format("direction    {}\n", name(r.direction));
  if (match.correspondence.closed)
    text += fmt::format("shift        {} of {} {}\n", r.shift, r.samples[1], nodes);
  text += format_turn(match, "turn         ");
  if (segments) {
    text += fmt::format("joints       {} and {}\n", r.samples[0], r.samples[1]);
  } else {
    text += fmt::format("samples      {} and {}, by {}\n", r.samples[0], r.samples[1], name(r.sampling));
  }
  text += fmt::format("v(u)         order {}, {} coefficients, within {} of its domain\n", v.degree() + 1,
                      v.size(), percent(match.reparametrization.max_deviation));
  text += fmt::format("method       {}, norm {}{}\n", name(r.method), r.norm, r.exact ? "" : ", fast");
  text += fmt::format("milliseconds sample {:.3f}, match {:.3f}, fit {:.3f}, compose {:.3f}\n",
                      1e3 * r.seconds.sample, 1e3 * r.seconds.match, 1e3 * r.seconds.fit,
                      1e3 * r.seconds.compose);
  return text;
}

}  // namespace

bool ShapeReport::valid() const {
  return std::all_of(pairs.begin(), pairs.end(),
                     [](const ContourMatch& pair) { return pair.match->report.validity.valid; });
}

std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of(" \n") + 1);
  return text;
}

ShapeReport make_report(std::size_t contours_a, std::size_t contours_b,
                        const std::function<const Match*(std::size_t)>& match_of) {
  ShapeReport report;
  for (std::size_t i = 0; i < std::max(contours_a, contours_b); ++i) {
    const Match* match = i < std::min(contours_a, contours_b) ? match_of(i) : nullptr;
    if (match != nullptr) {
      report.pairs.push_back({i, i, match});
      continue;
    }
    if (i < contours_a) report.unmatched_a.push_back(i);
    if (i < contours_b) report.unmatched_b.push_back(i);
  }
  return report;
}

std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

std::string json_string(std::string_view text) {
  // A name of a file need not be UTF-8; JSON must be.
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string format_report(const ShapeReport& report) {
  if (is_one_pair(report)) {
    return trimmed(tandem::format_json_report(*report.pairs.front().match));
  }
  const Totals totals = add_up(report);
  std::string text = fmt::format(R"({{"tandem": {}, )", json_string(tandem::version()));
  if (!report.pairs.empty()) {
    const MatchReport& first = report.pairs.front().match->report;
    text += fmt::format(R"("method": "{}", "norm": "{}", "sampling": "{}", )", name(first.method), first.norm,
                        name(first.sampling));
  }
  text += fmt::format(
      R"("cost": {}, "mean_cost": {}, "invalid_nodes": {}, "invalid_length": {}, "valid": {}, "min_dot": {}, )"
      R"("valid_share": {}, "contours": [)",
      json_number(totals.cost), json_number(totals.mean_cost), totals.invalid_nodes,
      json_number(totals.invalid_length), report.valid(), json_number(totals.min_dot),
      json_number(totals.valid_share));
  for (const ContourMatch& pair : report.pairs) {
    const std::string fields = trimmed(tandem::format_json_report(*pair.match));
    text += fmt::format("{}{{\"a\": {}, \"b\": {}, {}", &pair == report.pairs.data() ? "" : ", ", pair.a,
                        pair.b, std::string_view(fields).substr(fields.find_first_not_of(" \n", 1)));
  }
  text += fmt::format(R"(], "unmatched": {{"a": {}, "b": {}}}, "seconds": {}}})",
                      format_indices(report.unmatched_a), format_indices(report.unmatched_b),
                      format_seconds(totals.seconds));
  return text;
}

std::string format_table(const ShapeReport& report) {
  if (is_one_pair(report)) return format_contour_table(*report.pairs.front().match);
  std::string text = fmt::format("{:>3} {:>3}  {:>10}  {:>5}  {:>8}  {:>9}  {:>9}  {:>6}  {:>9}\n", "A", "B",
                                 "cost", "valid", "smallest", "valid on", "direction", "shift", "samples");
  for (const ContourMatch& pair : report.pairs) {
    const MatchReport& r = pair.match->report;
    text += fmt::format("{:>3} {:>3}  {:>10.5g}  {:>5}  {:>8.4f}  {:>9}  {:>9}  {:>6}  {:>9}\n", pair.a,
                        pair.b, r.cost, r.validity.valid ? "yes" : "no", r.validity.min_dot,
                        valid_percent(r.validity.valid_share, r.validity.valid), name(r.direction), r.shift,
                        fmt::format("{},{}", r.samples[0], r.samples[1]));
  }
  const Totals totals = add_up(report);
  text +=
      fmt::format("all      {:>10.5g}  {:>5}  {:>8.4f}  {:>9}\n", totals.cost, report.valid() ? "yes" : "no",
                  totals.min_dot, valid_percent(totals.valid_share, report.valid()));
  if (!report.pairs.empty()) text += format_turn(*report.pairs.front().match, "turn     ");
  for (const std::size_t i : report.unmatched_a) text += fmt::format("{:>3}   -  no partner\n", i);
  for (const std::size_t i : report.unmatched_b) text += fmt::format("  - {:>3}  no partner\n", i);
  return text;
}

/// "contour 4 of A", "contours 4, 5 and 6 of B".
std::string list_contours(const std::vector<std::size_t>& contours, std::string_view of) {
  constexpr std::size_t kMostNamed = 5;
  std::string text = contours.size() == 1 ? "contour " : "contours ";
  const std::size_t named = contours.size() > kMostNamed + 1 ? kMostNamed : contours.size();
  for (std::size_t k = 0; k < named; ++k) {
    if (k > 0) text += k + 1 == contours.size() ? " and " : ", ";
    text += fmt::format("{}", contours[k]);
  }
  if (named < contours.size()) text += fmt::format(" and {} more", contours.size() - named);
  return fmt::format("{} of {}", text, of);
}

std::string key_name(std::size_t key) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  return key < kLetters.size() ? std::string(1, kLetters[key]) : fmt::format("shape {}", key + 1);
}

void warn(const Messages& messages, const ShapeReport& report, std::size_t key) {
  if (!report.valid()) {
    const Totals totals = add_up(report);
    messages.warning(fmt::format(
        "the match is not valid, only the least invalid one: valid on {} of the length, smallest <T1,T2> "
        "{:.4g}; in-betweens may fold where it is not",
        valid_percent(totals.valid_share, report.valid()), totals.min_dot));
  }
  const auto lonely = [&](const std::vector<std::size_t>& contours, std::string_view of,
                          std::string_view what) {
    if (contours.empty()) return;
    messages.warning(fmt::format("{} {} no partner: {} a point in a morph", list_contours(contours, of),
                                 contours.size() == 1 ? "has" : "have", what));
  };
  lonely(report.unmatched_a, key_name(key), "shrinking to");
  lonely(report.unmatched_b, key_name(key + 1), "growing from");
}

}  // namespace cli
