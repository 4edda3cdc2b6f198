#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/json_writer.h"
#include "tandem/io/json.h"
#include "tandem/version.h"

namespace tandem {
inline namespace v0 {
namespace {

std::string_view name(Method method) {
  switch (method) {
    case Method::paper:
      return "paper";
    case Method::segments:
      return "segments";
    case Method::elastic:
      break;
  }
  return "elastic";
}

std::string_view name(Sampling sampling) {
  switch (sampling) {
    case Sampling::parameter:
      return "parameter";
    case Sampling::curvature:
      return "curvature";
    case Sampling::arc:
      break;
  }
  return "arc";
}

std::string_view name(Direction direction) {
  return direction == Direction::reversed ? "reversed" : "forward";
}

/// One field a line: the report is read by people too.
class ReportWriter {
 public:
  void text(std::string_view key, std::string_view value) {
    start(key);
    fmt::format_to(std::back_inserter(out_), "\"{}\"", value);
  }
  void integer(std::string_view key, long value) {
    start(key);
    fmt::format_to(std::back_inserter(out_), "{}", value);
  }
  void boolean(std::string_view key, bool value) {
    start(key);
    out_ += value ? "true" : "false";
  }
  /// null when there is no such number.
  void number(std::string_view key, double value) {
    start(key);
    if (std::isfinite(value)) {
      append_json_number(out_, value);
    } else {
      out_ += "null";
    }
  }
  /// Where a field is written that no function here knows.
  std::string& field(std::string_view key) {
    start(key);
    return out_;
  }
  [[nodiscard]] std::string take() {
    out_ += "\n}\n";
    return std::move(out_);
  }

 private:
  void start(std::string_view key) {
    fmt::format_to(std::back_inserter(out_), "{}\n  \"{}\": ", first_ ? "" : ",", key);
    first_ = false;
  }

  std::string out_ = "{";
  bool first_ = true;
};

template <typename Range, typename First, typename Second>
void append_pairs(std::string& out, const Range& range, First first, Second second) {
  out += '[';
  bool comma = false;
  for (const auto& item : range) {
    out += comma ? ", [" : "[";
    comma = true;
    append_json_number(out, static_cast<double>(first(item)));
    out += ", ";
    append_json_number(out, static_cast<double>(second(item)));
    out += ']';
  }
  out += ']';
}

/// Cosine and sine in the plane, rows of a matrix otherwise; the identity where no turn was looked for.
void append_rotation(std::string& out, const std::vector<double>& rotation, int dim) {
  const auto n = static_cast<std::size_t>(dim);
  if (dim == 2) {
    static constexpr double kNone[] = {1.0, 0.0};
    append_json_numbers(
        out, rotation.size() == 2 ? std::span<const double>(rotation) : std::span<const double>(kNone));
    return;
  }
  Points rows(dim, n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      rows[i][k] = rotation.size() == n * n ? rotation[i * n + k] : (i == k ? 1.0 : 0.0);
    }
  }
  append_json_points(out, rows);
}

void append_reparametrization(std::string& out, const Reparametrization& reparametrization) {
  fmt::format_to(std::back_inserter(out), R"({{"degree": {}, "knots": )", reparametrization.v.degree());
  append_json_numbers(out, reparametrization.v.knots());
  out += R"(, "points": )";
  append_json_points(out, reparametrization.v.control_points());
  out += R"(, "max_deviation": )";
  append_json_number(out, reparametrization.max_deviation);
  out += '}';
}

}  // namespace

std::string format_json_report(const Match& match) {
  const MatchReport& report = match.report;
  ReportWriter writer;
  writer.text("tandem", version());
  writer.text("method", name(report.method));
  writer.text("norm", report.norm);
  writer.field("samples") += fmt::format("[{}, {}]", report.samples[0], report.samples[1]);
  writer.text("sampling", name(report.sampling));
  writer.number("cost", report.cost);
  writer.number("mean_cost", report.mean_cost);
  writer.boolean("exact", report.exact);
  writer.integer("invalid_nodes", report.invalid_nodes);
  writer.number("invalid_length", report.invalid_length);
  writer.boolean("valid", report.validity.valid);
  writer.number("min_dot", report.validity.min_dot);
  writer.number("valid_share", report.validity.valid_share);
  writer.text("direction", name(report.direction));
  writer.integer("shift", report.shift);
  append_rotation(writer.field("rotation"), report.rotation, match.curve.dim());
  append_pairs(
      writer.field("path"), report.path, [](const Node& node) { return node.i; },
      [](const Node& node) { return node.j; });
  append_pairs(
      writer.field("correspondence"), match.correspondence.points,
      [](const ParameterPair& pair) { return pair.u; }, [](const ParameterPair& pair) { return pair.v; });
  append_reparametrization(writer.field("reparametrization"), match.reparametrization);
  append_json_curve(writer.field("curve"), match.curve);
  std::string& seconds = writer.field("seconds");
  seconds +=
      fmt::format(R"({{"sample": {:.6f}, "match": {:.6f}, "fit": {:.6f}, "compose": {:.6f}}})",
                  report.seconds.sample, report.seconds.match, report.seconds.fit, report.seconds.compose);
  return writer.take();
}

}  // namespace v0
}  // namespace tandem
