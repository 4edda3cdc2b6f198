#include "tandem/match/elastic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

namespace {

/// Filling the table takes about as long as running the programme on it.
constexpr double kShareOfTables = 0.5;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The chords of one curve as the quadrature needs them: running lengths that go on past the end of a loop.
class ChordRuns {
 public:
  ChordRuns(const Samples& samples, int longest)
      : count_(static_cast<int>(samples.chords())),
        extra_(samples.cyclic ? longest : 0),
        nodes_(samples.size()) {
    for (int k = -extra_; k < count_; ++k)
      lengths_.push_back(samples.chord_lengths[static_cast<std::size_t>(wrap(k))]);
    std::vector<int> equal(lengths_.size(), 1);
    for (std::size_t k = 1; k < lengths_.size(); ++k) {
      if (lengths_[k] == lengths_[k - 1]) equal[k] = equal[k - 1] + 1;
    }
    for (int n = 0; n <= longest; ++n) {
      runs_.emplace_back(nodes_, 0.0);
      uniform_.emplace_back(nodes_, std::uint8_t{0});
      for (std::size_t end = 0; end < nodes_; ++end) {
        const int first = static_cast<int>(end) - n;
        if (n == 0 || first < -extra_) continue;
        double sum = 0.0;
        for (int k = first; k < static_cast<int>(end); ++k) sum += length(k);
        runs_.back()[end] = sum;
        uniform_.back()[end] =
            equal[static_cast<std::size_t>(static_cast<int>(end) - 1 + extra_)] >= n ? 1 : 0;
      }
    }
  }

  [[nodiscard]] int wrap(int chord) const { return chord < 0 ? chord + count_ : chord; }
  /// Length of chord k, k >= -longest on a loop.
  [[nodiscard]] double length(int k) const { return lengths_[static_cast<std::size_t>(k + extra_)]; }
  /// Lengths of the n chords before each node.
  [[nodiscard]] const std::vector<double>& runs(int n) const { return runs_[static_cast<std::size_t>(n)]; }
  /// Whether the n chords before each node are equally long.
  [[nodiscard]] const std::vector<std::uint8_t>& uniform(int n) const {
    return uniform_[static_cast<std::size_t>(n)];
  }

 private:
  int count_;
  int extra_;
  std::size_t nodes_;
  std::vector<double> lengths_;
  std::vector<std::vector<double>> runs_;
  std::vector<std::vector<std::uint8_t>> uniform_;
};

/// A stretch of an edge on which neither curve changes its chord.
struct Cell {
  int a = 0;  ///< chord of the first curve, counted from the start of the edge
  int b = 0;
  double share = 0.0;  ///< of the edge
};

/// Cells of an edge over chords that share its length as `first` and `second` say (each sums to 1).
void cut_cells(std::span<const double> first, std::span<const double> second, std::vector<Cell>& cells) {
  cells.clear();
  std::size_t a = 0;
  std::size_t b = 0;
  double end_a = first[0];
  double end_b = second[0];
  double at = 0.0;
  for (;;) {
    const bool last = a + 1 == first.size() && b + 1 == second.size();
    const double end =
        last ? 1.0
             : (a + 1 == first.size() ? end_b : (b + 1 == second.size() ? end_a : std::min(end_a, end_b)));
    cells.push_back({static_cast<int>(a), static_cast<int>(b), std::max(0.0, end - at)});
    if (last) return;
    at = std::max(at, end);
    const bool next_a = a + 1 < first.size() && end_a <= end;
    const bool next_b = b + 1 < second.size() && end_b <= end;
    if (next_a) end_a += first[++a];
    if (next_b) end_b += second[++b];
  }
}

/// No step may go round a loop more than once.
int longest_step(const Samples& a, const Samples& b, const ElasticOptions& options) {
  return std::min(options.longest_step, static_cast<int>(std::min(a.chords(), b.chords())));
}

/// Shares of n equal chords.
std::vector<double> equal_shares(int n) {
  return std::vector<double>(static_cast<std::size_t>(n), 1.0 / n);
}

/// x rounded to a whole number, for 0 <= x < 2^51, in a form that loops over lanes.
double round_whole(double x) {
  constexpr double kShift = 6755399441055744.0;  // 1.5 * 2^52
  return (x + kShift) - kShift;
}

class EdgeCosts {
 public:
  EdgeCosts(const Samples& a, const Samples& b, const NodeTable& chords, const ElasticOptions& options,
            Aggregate aggregate, const NodeMask& mask)
      : chords_(chords),
        chord_invalid_(chords.invalid.begin(), chords.invalid.end()),
        options_(options),
        aggregate_(aggregate),
        mask_(mask),
        runs_a_(a, longest_step(a, b, options)),
        runs_b_(b, longest_step(a, b, options)) {
    table_.rows = a.size();
    table_.cols = b.size();
    table_.rows_cyclic = a.cyclic;
    table_.cols_cyclic = b.cyclic;
    table_.steps = coprime_steps(longest_step(a, b, options));
    table_.cost.assign(table_.rows * table_.cols * table_.steps.size(), kInfinity);
    table_.invalid.assign(table_.cost.size(), 0.0);
    for (const Step& s : table_.steps) {
      cut_cells(equal_shares(s.a), equal_shares(s.b), cells_);
      patterns_.push_back(cells_);
    }
    integral_.resize(table_.cols);
    invalid_.resize(table_.cols);
  }

  EdgeTable run(const Progress& progress) {
    for (std::size_t i = 0; i < table_.rows; ++i) {
      if (progress && !progress(kShareOfTables * static_cast<double>(i) / static_cast<double>(table_.rows)))
        break;
      for (std::size_t s = 0; s < table_.steps.size(); ++s) fill_row(static_cast<int>(i), s);
    }
    if (!mask_.allowed.empty()) bar_masked();
    return std::move(table_);
  }

 private:
  /// All edges of one step that end in row i: first the integrals, then the costs. Stretches of equal chords,
  /// the usual case between corners, share one pattern of cells and are filled together.
  void fill_row(int i, std::size_t s) {
    const Step step = table_.steps[s];
    if (!table_.rows_cyclic && i < step.a) return;
    const int cols = static_cast<int>(table_.cols);
    const int first = table_.cols_cyclic ? 0 : step.b;
    const bool uniform_a = runs_a_.uniform(step.a)[static_cast<std::size_t>(i)] != 0;
    const std::vector<std::uint8_t>& uniform_b = runs_b_.uniform(step.b);
    for (int j = first; j < cols;) {
      // Edges that begin behind the seam of a loop read their chords from the end of the table: one by one.
      int end = j;
      while (uniform_a && end < cols && end >= step.b && uniform_b[static_cast<std::size_t>(end)] != 0) ++end;
      if (end > j) {
        integrate_run(i, j, end, step, patterns_[s]);
        j = end;
      } else {
        integrate_edge(i, j, step);
        ++j;
      }
    }
    finish_row(i, s, first);
  }

  /// Row of the chord table under chord `chord` of the first curve.
  [[nodiscard]] std::size_t chord_row(int chord) const {
    return chords_.index(static_cast<std::size_t>(runs_a_.wrap(chord)), 0);
  }

  void integrate_run(int i, int from, int to, Step step, const std::vector<Cell>& cells) {
    double* integral = integral_.data() + from;
    double* invalid = invalid_.data() + from;
    const auto n = static_cast<std::size_t>(to - from);
    std::fill_n(integral, n, 0.0);
    std::fill_n(invalid, n, 0.0);
    for (const Cell& cell : cells) {
      const std::size_t at =
          chord_row(i - step.a + cell.a) + static_cast<std::size_t>(from - step.b + cell.b);
      const double* cost = chords_.cost.data() + at;
      const double* flag = chord_invalid_.data() + at;
      const double share = cell.share;
      if (aggregate_ == Aggregate::maximum) {
        for (std::size_t k = 0; k < n; ++k) integral[k] = integral[k] < cost[k] ? cost[k] : integral[k];
      } else {
        for (std::size_t k = 0; k < n; ++k) integral[k] += share * cost[k];
      }
      for (std::size_t k = 0; k < n; ++k) invalid[k] += share * flag[k];
    }
  }

  void integrate_edge(int i, int j, Step step) {
    shares(runs_a_, i, step.a, shares_a_);
    shares(runs_b_, j, step.b, shares_b_);
    cut_cells(shares_a_, shares_b_, cells_);
    double integral = 0.0;
    double invalid = 0.0;
    for (const Cell& cell : cells_) {
      const std::size_t at =
          chord_row(i - step.a + cell.a) + static_cast<std::size_t>(runs_b_.wrap(j - step.b + cell.b));
      const double cost = chords_.cost[at];
      integral = aggregate_ == Aggregate::maximum ? std::max(integral, cost) : integral + cell.share * cost;
      invalid += cell.share * chord_invalid_[at];
    }
    integral_[static_cast<std::size_t>(j)] = integral;
    invalid_[static_cast<std::size_t>(j)] = invalid;
  }

  /// Shares of the n chords before node `end`; equal ones where the curve stands still.
  static void shares(const ChordRuns& runs, int end, int n, std::vector<double>& out) {
    const double length = runs.runs(n)[static_cast<std::size_t>(end)];
    out.clear();
    for (int k = end - n; k < end; ++k) out.push_back(length > 0.0 ? runs.length(k) / length : 1.0 / n);
  }

  /// Costs and invalid lengths from the row's integrals.
  void finish_row(int i, std::size_t s, int first) {
    const Step step = table_.steps[s];
    const double length_a = runs_a_.runs(step.a)[static_cast<std::size_t>(i)];
    const double* length_b = runs_b_.runs(step.b).data();
    const std::size_t row = table_.index(static_cast<std::size_t>(i), s, 0);
    double* cost = table_.cost.data() + row;
    double* invalid = table_.invalid.data() + row;
    const double lambda = options_.lambda;
    const bool sums = aggregate_ == Aggregate::sum;
    for (std::size_t j = static_cast<std::size_t>(first); j < table_.cols; ++j) {
      const double length = length_a + length_b[j];
      const double difference = length_a - length_b[j];
      const double strain = length > 0.0 ? difference * difference / length : 0.0;
      cost[j] = sums ? integral_[j] * (0.5 * length) + lambda * strain : integral_[j];
      invalid[j] = round_whole(invalid_[j] * (0.5 * length) * (1.0 / kInvalidQuantum));
    }
  }

  void bar_masked() {
    const auto rows = static_cast<int>(table_.rows);
    const auto cols = static_cast<int>(table_.cols);
    const auto allowed = [&](int i, int j) {
      return mask_.allows(static_cast<std::size_t>((i + rows) % rows),
                          static_cast<std::size_t>((j + cols) % cols));
    };
    for (int i = 0; i < rows; ++i) {
      for (std::size_t s = 0; s < table_.steps.size(); ++s) {
        const Step step = table_.steps[s];
        for (int j = 0; j < cols; ++j) {
          const std::size_t k = table_.index(static_cast<std::size_t>(i), s, static_cast<std::size_t>(j));
          if (table_.cost[k] < kInfinity && !(allowed(i, j) && allowed(i - step.a, j - step.b))) {
            table_.cost[k] = kInfinity;
          }
        }
      }
    }
  }

  const NodeTable& chords_;
  std::vector<double> chord_invalid_;  ///< the flags as numbers, to be integrated
  const ElasticOptions& options_;
  Aggregate aggregate_;
  const NodeMask& mask_;
  ChordRuns runs_a_;
  ChordRuns runs_b_;
  EdgeTable table_;
  std::vector<std::vector<Cell>> patterns_;  ///< per step, for equal chords
  std::vector<double> integral_;             ///< of the row that is being filled, per column
  std::vector<double> invalid_;
  std::vector<Cell> cells_;
  std::vector<double> shares_a_;
  std::vector<double> shares_b_;
};

}  // namespace

EdgeTable edge_costs(const Samples& a, const Samples& b, const NodeTable& chord_costs,
                     const ElasticOptions& options, Aggregate aggregate, const NodeMask& mask,
                     const Progress& progress) {
  if (chord_costs.rows != a.chords() || chord_costs.cols != b.chords()) {
    throw InvalidArgument("the chord costs do not belong to these samples");
  }
  if (options.longest_step < 1 || !(options.lambda >= 0.0)) {
    throw InvalidArgument("the longest step must be at least 1 and lambda at least 0");
  }
  return EdgeCosts(a, b, chord_costs, options, aggregate, mask).run(progress);
}

}  // namespace v0
}  // namespace tandem
