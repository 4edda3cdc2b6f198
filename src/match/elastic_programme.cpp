#include "match/elastic_programme.h"

#include <algorithm>
#include <limits>

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Cells between two looks at the progress callback: about a millisecond.
constexpr std::size_t kCellsPerLook = std::size_t{1} << 17;

constexpr int divide_up(int x, int by) {
  return (x + by - 1) / by;
}

}  // namespace

ElasticProgramme::ElasticProgramme(EdgeRows& edges, Aggregate aggregate, const Band* band)
    : edges_(edges),
      maximum_(aggregate == Aggregate::maximum),
      band_(band),
      order_(tie_order(edges.steps())),
      start_rows_(edges.rows_cyclic() ? edges.rows() : 1),
      base_row_(0),
      descent_(edges.rows_cyclic() ? edges.rows() : edges.rows() - 1),
      pad_(whole_blocks(edges.longest())),
      cell_stride_(static_cast<std::size_t>(pad_ + edges.stride())) {
  if (band != nullptr && edges.rows_cyclic()) {
    base_row_ = band->first_row;
    start_rows_ = static_cast<int>(band->columns.size()) - descent_;
  }
}

ElasticProgramme::Cell ElasticProgramme::end_of(int start) const {
  const int per_row = edges_.first_col();
  return {start / per_row - first_row_ + descent_, edges_.width() - per_row + start % per_row};
}

int ElasticProgramme::start_at(Cell c) const {
  const int per_row = edges_.first_col();
  return (first_row_ + c.i) * per_row + per_row + c.x;
}

int ElasticProgramme::table_row(int i) const {
  const int row = (base_row_ + first_row_ + i) % edges_.rows();
  return row < 0 ? row + edges_.rows() : row;
}

/// Columns of row i that the steps can reach from the starts and from which they can reach an end.
Columns ElasticProgramme::reachable(int i, int start_rows) const {
  const int longest = edges_.longest();
  const int per_row = edges_.first_col();
  const int width = edges_.width();
  const int late = i - (start_rows - 1);  // rows behind the last start
  // Columns are the edges': a start lies in [-per_row, 0), its end `width` further on.
  int lo = 0;
  if (late > 0) lo = std::max(lo, divide_up(late, longest) - per_row);
  lo = std::max(lo, width - per_row - longest * (descent_ - late));
  int hi = std::min<std::int64_t>(width, std::int64_t{longest} * i);
  if (i < descent_) hi = std::min(hi, width - divide_up(descent_ - i, longest));
  if (band_ != nullptr) {
    const std::size_t row = static_cast<std::size_t>(base_row_ + first_row_ + i - band_->first_row);
    lo = std::max(lo, band_->columns[row].lo - per_row);
    hi = std::min(hi, band_->columns[row].hi + 1 - per_row);
  }
  if (lo >= hi) return {};
  return {lo / kBlock * kBlock, whole_blocks(hi)};
}

bool ElasticProgramme::run(std::span<const ProgrammeStart> starts, const Progress& keep_going) {
  const int per_row = edges_.first_col();
  first_row_ = starts.front().number / per_row;
  const int start_rows = starts.back().number / per_row - first_row_ + 1;
  const int rows = start_rows + descent_;
  const bool counted = edges_.counting() == Counting::counted;
  const std::size_t size = static_cast<std::size_t>(rows) * cell_stride_;
  cost_.assign(size, kInfinity);
  invalid_.assign(counted ? size : 0, kInfinity);
  origin_.clear();
  for (const ProgrammeStart& start : starts) {
    const Cell cell{start.number / per_row - first_row_, start.number % per_row - per_row};
    cost_[index(cell)] = start.value.cost;
    if (counted) invalid_[index(cell)] = start.value.invalid;
  }
  std::size_t unseen = 0;
  int last_reached = start_rows - 1;
  for (int i = 1; i < rows; ++i) {
    // No step bridges this many rows without a path.
    if (i - last_reached > edges_.longest()) break;
    const Columns columns = reachable(i, start_rows);
    if (columns.lo >= columns.hi) continue;
    relax_row(i, columns);
    const auto row = cost_.begin() + static_cast<std::ptrdiff_t>(index({i, 0}));
    const auto reached = [](double cost) { return cost < kInfinity; };
    if (i >= start_rows && std::any_of(row + columns.lo, row + columns.hi, reached)) last_reached = i;
    unseen += static_cast<std::size_t>(columns.hi - columns.lo);
    if (keep_going && unseen > kCellsPerLook) {
      unseen = 0;
      if (!keep_going(static_cast<double>(i) / rows)) return false;
    }
  }
  return true;
}

void ElasticProgramme::relax_row(int i, Columns columns) {
  const EdgeRows::Row edges = edges_.row(table_row(i), columns);
  relax_.clear();
  for (std::size_t s = 0; s < edges_.steps().size(); ++s) {
    const Step step = edges_.steps()[s];
    if (step.a > i) continue;
    const std::size_t from = index({i - step.a, -step.b});
    const std::size_t edge = s * static_cast<std::size_t>(edges_.stride());
    RelaxStep relax{cost_.data() + from, edges.cost + edge, nullptr, nullptr};
    if (edges.invalid != nullptr) {
      relax.from_invalid = invalid_.data() + from;
      relax.edge_invalid = edges.invalid + edge;
    }
    relax_.push_back(relax);
  }
  const std::size_t to = index({i, 0});
  const auto lo = static_cast<std::size_t>(columns.lo);
  const auto hi = static_cast<std::size_t>(columns.hi);
  if (edges.invalid == nullptr) {
    relax_costs(relax_.data(), relax_.size(), cost_.data() + to, lo, hi, maximum_);
  } else {
    relax_pairs(relax_.data(), relax_.size(), cost_.data() + to, invalid_.data() + to, lo, hi, maximum_);
  }
}

LexCost ElasticProgramme::end_cost(int start) const {
  const std::size_t k = index(end_of(start));
  return {invalid_.empty() ? (cost_[k] < kInfinity ? 0.0 : kInfinity) : invalid_[k], cost_[k]};
}

/// The last edge of a cell's best path: the first in the order of ties that attains its cost.
ElasticProgramme::Edge ElasticProgramme::edge_to(Cell c) {
  const int block = c.x / kBlock * kBlock;
  const EdgeRows::Row edges = edges_.row(table_row(c.i), {block, block + kBlock});
  const std::size_t to = index(c);
  for (const std::size_t s : order_) {
    const Step step = edges_.steps()[s];
    if (step.a > c.i) continue;
    const Cell from{c.i - step.a, c.x - step.b};
    const std::size_t k = index(from);
    const std::size_t e = s * static_cast<std::size_t>(edges_.stride()) + static_cast<std::size_t>(c.x);
    const LexCost edge{invalid_.empty() ? 0.0 : edges.invalid[e], edges.cost[e]};
    const double cost = maximum_ ? MaxCosts::join(cost_[k], edge.cost) : cost_[k] + edge.cost;
    if (cost != cost_[to]) continue;
    if (invalid_.empty() || invalid_[k] + edge.invalid == invalid_[to]) return {from, edge};
  }
  return {{0, -pad_}, {}};  // cannot be: the cell got its cost from one of them
}

int ElasticProgramme::origin(int start) {
  if (origin_.empty()) origin_.assign(cost_.size(), 0);
  std::vector<std::size_t> trail;
  Cell c = end_of(start);
  int found = 0;
  for (; c.x >= 0; c = edge_to(c).from) {
    found = origin_[index(c)];
    if (found > 0) break;
    trail.push_back(index(c));
  }
  if (found == 0) found = start_at(c) + 1;
  for (const std::size_t k : trail) origin_[k] = found;
  return found - 1;
}

Path ElasticProgramme::path(int start) {
  const int per_row = edges_.first_col();
  const int row = base_row_ + first_row_;
  Path path;
  std::vector<double> costs;
  Cell c = end_of(start);
  path.nodes.push_back({row + c.i, per_row + c.x});
  while (c.x >= 0) {
    const Edge edge = edge_to(c);
    c = edge.from;
    path.nodes.push_back({row + c.i, per_row + c.x});
    path.invalid += static_cast<std::int64_t>(edge.cost.invalid);
    costs.push_back(edge.cost.cost);
  }
  for (std::size_t k = costs.size(); k-- > 0;) {
    path.cost = maximum_ ? MaxCosts::join(path.cost, costs[k]) : path.cost + costs[k];
  }
  std::reverse(path.nodes.begin(), path.nodes.end());
  if (edges_.rows_cyclic()) {
    const int lap = path.nodes.front().i - table_row(path.nodes.front().i - row);
    for (Node& node : path.nodes) node.i -= lap;
  }
  return path;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
