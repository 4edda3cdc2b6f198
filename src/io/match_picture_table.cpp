#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "io/match_picture_parts.h"
#include "tandem/match/norm.h"
#include "tandem/match/rotation.h"

namespace tandem {
inline namespace v0 {
namespace {

constexpr std::size_t kMostCells = 160;  // per side: more cannot be told apart
constexpr int kLevels = 24;              // shades; equal neighbours become one rectangle
constexpr int kCurveSamples = 600;       // of v(u)

// The table as drawn: rows x cols cells from (first_i, first_j) on, indices taken modulo the table's on
// closed curves.
struct Cells {
  std::size_t rows = 0;
  std::size_t cols = 0;
  std::vector<double> cost;
  std::vector<bool> invalid;
};

NodeTable costs(const Match& match, const MatchOptions& options, RuledSign sign) {
  // As they were matched: turned back.
  const Rotation rotation(match.samples_b.dim(), match.report.rotation);
  const Samples b = turned(match.samples_b, rotation.inverse());
  if (match.report.method == Method::paper) {
    return node_costs(match.samples_a, b, options.norm, options.features, sign);
  }
  return chord_costs(match.samples_a, b, options.norm, options.features, sign);
}

std::size_t invalid_on_path(const NodeTable& table, const std::vector<Node>& path) {
  std::size_t count = 0;
  for (const Node& node : path) {
    const auto i = static_cast<std::size_t>(node.i) % table.rows;
    const auto j = static_cast<std::size_t>(node.j) % table.cols;
    count += table.invalid[table.index(i, j)];
  }
  return count;
}

// The ruled norm ran with one of two orientations; the report does not say which, the path does.
NodeTable table_of(const Match& match, const MatchOptions& options) {
  const NormKind* kind = std::get_if<NormKind>(&options.norm);
  if (kind == nullptr || *kind != NormKind::ruled || match.report.method == Method::paper) {
    return costs(match, options,
                 match.report.method == Method::paper ? RuledSign::product : RuledSign::positive);
  }
  NodeTable positive = costs(match, options, RuledSign::positive);
  NodeTable negative = costs(match, options, RuledSign::negative);
  return invalid_on_path(negative, match.report.path) < invalid_on_path(positive, match.report.path)
             ? std::move(negative)
             : std::move(positive);
}

// Blocks of cells become one: mean cost, invalid when most of them are.
Cells cells_of(const NodeTable& table, Node first) {
  Cells cells;
  cells.rows = std::min(table.rows, kMostCells);
  cells.cols = std::min(table.cols, kMostCells);
  for (std::size_t r = 0; r < cells.rows; ++r) {
    for (std::size_t c = 0; c < cells.cols; ++c) {
      double sum = 0.0;
      int invalid = 0;
      int count = 0;
      for (std::size_t i = r * table.rows / cells.rows; i < (r + 1) * table.rows / cells.rows; ++i) {
        for (std::size_t j = c * table.cols / cells.cols; j < (c + 1) * table.cols / cells.cols; ++j) {
          const std::size_t at = table.index((i + static_cast<std::size_t>(first.i)) % table.rows,
                                             (j + static_cast<std::size_t>(first.j)) % table.cols);
          sum += table.cost[at];
          invalid += table.invalid[at];
          ++count;
        }
      }
      cells.cost.push_back(sum / count);
      cells.invalid.push_back(2 * invalid > count);
    }
  }
  return cells;
}

// Light where it is cheap. Invalid cells are warm, valid ones cool.
std::string shade(int level, bool invalid) {
  const double x = std::pow(static_cast<double>(level) / (kLevels - 1), 0.8);
  const auto mix = [&](double from, double to) { return from + x * (to - from); };
  if (invalid) return color(mix(0.975, 0.84), mix(0.885, 0.61), mix(0.84, 0.53));
  return color(mix(0.985, 0.42), mix(0.985, 0.52), mix(0.975, 0.67));
}

std::string draw_cells(const Cells& cells, const Frame& frame) {
  // Each kind has its own range: what an invalid cell costs is no measure for the valid ones.
  std::array<double, 2> most{};
  for (std::size_t at = 0; at < cells.cost.size(); ++at) {
    most[cells.invalid[at]] = std::max(most[cells.invalid[at]], cells.cost[at]);
  }
  const auto key_of = [&](std::size_t at) {
    const double range = most[cells.invalid[at]];
    const double share = range > 0.0 ? cells.cost[at] / range : cells.invalid[at] ? 0.5 : 0.0;
    const int level = static_cast<int>(std::lround(share * (kLevels - 1)));
    return std::pair<int, bool>{std::clamp(level, 0, kLevels - 1), cells.invalid[at]};
  };
  std::map<std::pair<int, bool>, std::string> paths;  // one path per colour, in cell units
  for (std::size_t r = 0; r < cells.rows; ++r) {
    for (std::size_t c = 0; c < cells.cols;) {
      const auto key = key_of(r * cells.cols + c);
      std::size_t end = c + 1;
      while (end < cells.cols && key_of(r * cells.cols + end) == key) ++end;
      paths[key] += fmt::format("M{} {}h{}v1h-{}", c, r, end - c, end - c);
      c = end;
    }
  }
  std::string text =
      fmt::format("<g shape-rendering=\"crispEdges\" transform=\"matrix({:.6g} 0 0 {:.6g} {} {})\">\n",
                  frame.width / static_cast<double>(cells.cols),
                  frame.height / static_cast<double>(cells.rows), pixels(frame.x), pixels(frame.y));
  for (const auto& [key, path] : paths) {
    text += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", shade(key.first, key.second), path);
  }
  return text + "</g>\n";
}

// Position of parameter t among the samples: 2.5 is half way from sample 2 to sample 3.
double index_of(const Samples& samples, double t) {
  const std::vector<double>& p = samples.parameters;
  const double n = static_cast<double>(p.size());
  double turns = 0.0;
  if (samples.cyclic && samples.period > 0.0) {
    turns = std::floor((t - p.front()) / samples.period);
    t -= turns * samples.period;
  }
  const auto next = std::upper_bound(p.begin() + 1, samples.cyclic ? p.end() : p.end() - 1, t);
  const auto k = static_cast<std::size_t>(next - p.begin());
  const double lo = p[k - 1];
  const double hi = k < p.size() ? p[k] : p.front() + samples.period;
  const double share = hi > lo ? std::clamp((t - lo) / (hi - lo), 0.0, 1.0) : 0.0;
  return static_cast<double>(k - 1) + share + turns * n;
}

double column_at(const std::vector<Node>& path, double row) {
  const auto next = std::upper_bound(path.begin() + 1, path.end() - 1, row,
                                     [](double r, const Node& node) { return r < node.i; });
  const Node& a = *(next - 1);
  const Node& b = *next;
  const double share = b.i > a.i ? std::clamp((row - a.i) / (b.i - a.i), 0.0, 1.0) : 0.0;
  return a.j + share * (b.j - a.j);
}

class Overlay {
 public:
  Overlay(const Match& match, const NodeTable& table, Node first, Frame frame)
      : match_(match),
        table_(table),
        first_(first),
        frame_(frame),
        // A node stands in the middle of its cell, or at the corners of the chords' cells.
        offset_(match.report.method == Method::paper ? 0.5 : 0.0) {}

  [[nodiscard]] std::string path() const {
    std::string d;
    for (const Node& node : match_.report.path) append(d, node.i, node.j, d.empty());
    return d;
  }

  // v(u) in the same cells; on closed curves it leaves the table at one end and goes on at the other.
  [[nodiscard]] std::string reparametrization() const {
    const std::vector<Node>& path = match_.report.path;
    const Interval domain = match_.curve.domain();
    const double rows = static_cast<double>(table_.rows);
    const double cols = static_cast<double>(table_.cols);
    const bool closed = match_.correspondence.closed;
    std::string d;
    double last_row = 0.0;
    bool pen_up = true;
    for (int k = 0; k <= kCurveSamples; ++k) {
      const double u = domain.lo + domain.length() * k / kCurveSamples;
      double row = index_of(match_.samples_a, u);
      double col = index_of(match_.samples_b, match_.reparametrization.v.evaluate(u)[0]);
      if (closed) {
        row -= std::floor((row - first_.i) / rows) * rows;
        col += std::round((column_at(path, row) - col) / cols) * cols;
      }
      append(d, row, col, pen_up || std::fabs(row - last_row) > rows / 2.0);
      pen_up = false;
      last_row = row;
    }
    return d;
  }

 private:
  void append(std::string& d, double row, double col, bool move) const {
    const double x = (col - first_.j + offset_) / static_cast<double>(table_.cols);
    const double y = (row - first_.i + offset_) / static_cast<double>(table_.rows);
    d += fmt::format("{}{} {}", move ? 'M' : 'L', pixels(frame_.x + x * frame_.width),
                     pixels(frame_.y + y * frame_.height));
  }

  const Match& match_;
  const NodeTable& table_;
  Node first_;
  Frame frame_;
  double offset_;
};

}  // namespace

std::string draw_table(const Match& match, const MatchOptions& options, Frame frame) {
  const std::vector<Node>& path = match.report.path;
  if (path.size() < 2) return {};
  const NodeTable table = table_of(match, options);
  const Node first = match.correspondence.closed ? path.front() : Node{};
  const Overlay overlay(match, table, first, frame);
  const auto box = [&](const char* attributes) {
    return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>\n", pixels(frame.x),
                       pixels(frame.y), pixels(frame.width), pixels(frame.height), attributes);
  };
  std::string text = draw_cells(cells_of(table, first), frame);
  text += "<clipPath id=\"table\">" + box("") + "</clipPath>\n";
  text += "<g clip-path=\"url(#table)\" fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
  text += fmt::format(
      "<path class=\"path\" d=\"{}\" stroke=\"#1d2b53\" stroke-width=\"5\" stroke-opacity=\"0.4\"/>\n",
      overlay.path());
  text += fmt::format("<path class=\"v\" d=\"{}\" stroke=\"#e8590c\" stroke-width=\"1.8\"/>\n",
                      overlay.reparametrization());
  text += "</g>\n" + box("fill=\"none\" stroke=\"#c8cdd6\"");
  text +=
      fmt::format("<text class=\"small\" x=\"{}\" y=\"{}\" text-anchor=\"end\">B: v \xE2\x86\x92</text>\n",
                  pixels(frame.x + frame.width), pixels(frame.y - 8.0));
  text += fmt::format(
      "<text class=\"small\" transform=\"translate({} {}) rotate(-90)\">\xE2\x86\x90 A: u</text>\n",
      pixels(frame.x - 10.0), pixels(frame.y + frame.height));
  return text;
}

}  // namespace v0
}  // namespace tandem
