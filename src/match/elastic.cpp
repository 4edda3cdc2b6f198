#include "tandem/match/elastic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The chords of one curve as the quadrature needs them: running lengths that go on past the end of a loop.
class ChordRuns {
 public:
  ChordRuns(const Samples& samples, int longest) : count_(static_cast<int>(samples.chords())) {
    const int extra = samples.cyclic ? longest : 0;
    for (int k = -extra; k < count_; ++k)
      lengths_.push_back(samples.chord_lengths[static_cast<std::size_t>(wrap(k))]);
    extra_ = extra;
    uniform_.resize(lengths_.size(), 1);
    for (std::size_t k = 1; k < lengths_.size(); ++k) {
      uniform_[k] = lengths_[k] == lengths_[k - 1] ? uniform_[k - 1] + 1 : 1;
    }
  }

  [[nodiscard]] int wrap(int chord) const { return chord < 0 ? chord + count_ : chord; }
  /// Length of chord k, k >= -longest on a loop.
  [[nodiscard]] double length(int k) const { return lengths_[static_cast<std::size_t>(k + extra_)]; }
  /// Length of the n chords before node `end`.
  [[nodiscard]] double run(int end, int n) const {
    double sum = 0.0;
    for (int k = end - n; k < end; ++k) sum += length(k);
    return sum;
  }
  /// Whether the n chords before node `end` are equally long.
  [[nodiscard]] bool uniform(int end, int n) const {
    return uniform_[static_cast<std::size_t>(end - 1 + extra_)] >= n;
  }

 private:
  int count_;
  int extra_ = 0;
  std::vector<double> lengths_;
  std::vector<int> uniform_;  ///< how many chords up to this one have its length
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

class EdgeCosts {
 public:
  EdgeCosts(const Samples& a, const Samples& b, const NodeTable& chords, const ElasticOptions& options,
            Aggregate aggregate, const NodeMask& mask)
      : chords_(chords),
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
  }

  EdgeTable run() {
    for (std::size_t i = 0; i < table_.rows; ++i) {
      for (std::size_t s = 0; s < table_.steps.size(); ++s) fill_row(static_cast<int>(i), s);
    }
    return std::move(table_);
  }

 private:
  [[nodiscard]] double chord_cost(int i, int j) const {
    return chords_.cost[chords_.index(static_cast<std::size_t>(runs_a_.wrap(i)),
                                      static_cast<std::size_t>(runs_b_.wrap(j)))];
  }
  [[nodiscard]] bool chord_invalid(int i, int j) const {
    return chords_.invalid[chords_.index(static_cast<std::size_t>(runs_a_.wrap(i)),
                                         static_cast<std::size_t>(runs_b_.wrap(j)))] != 0;
  }

  /// All edges of one step that end in row i. Stretches of equal chords, the usual case between corners,
  /// share one pattern of cells.
  void fill_row(int i, std::size_t s) {
    const Step step = table_.steps[s];
    if (!table_.rows_cyclic && i < step.a) return;
    const int cols = static_cast<int>(table_.cols);
    const bool uniform_a = runs_a_.uniform(i, step.a);
    for (int j = table_.cols_cyclic ? 0 : step.b; j < cols; ++j) {
      if (!allowed(i, j) || !allowed(i - step.a, j - step.b)) continue;
      if (uniform_a && runs_b_.uniform(j, step.b)) {
        fill(i, j, s, patterns_[s]);
      } else {
        cut_general(i, j, step);
        fill(i, j, s, cells_);
      }
    }
  }

  [[nodiscard]] bool allowed(int i, int j) const {
    if (mask_.allowed.empty()) return true;
    const auto rows = static_cast<int>(table_.rows);
    const auto cols = static_cast<int>(table_.cols);
    return mask_.allows(static_cast<std::size_t>((i + rows) % rows),
                        static_cast<std::size_t>((j + cols) % cols));
  }

  void cut_general(int i, int j, Step step) {
    shares(runs_a_, i, step.a, shares_a_);
    shares(runs_b_, j, step.b, shares_b_);
    cut_cells(shares_a_, shares_b_, cells_);
  }

  /// Shares of the n chords before node `end`; equal ones where the curve stands still.
  static void shares(const ChordRuns& runs, int end, int n, std::vector<double>& out) {
    const double length = runs.run(end, n);
    out.clear();
    for (int k = end - n; k < end; ++k) out.push_back(length > 0.0 ? runs.length(k) / length : 1.0 / n);
  }

  void fill(int i, int j, std::size_t s, const std::vector<Cell>& cells) {
    const Step step = table_.steps[s];
    const double length_a = runs_a_.run(i, step.a);
    const double length_b = runs_b_.run(j, step.b);
    const double length = length_a + length_b;
    double integral = 0.0;
    double largest = 0.0;
    double invalid = 0.0;
    for (const Cell& cell : cells) {
      const int ca = i - step.a + cell.a;
      const int cb = j - step.b + cell.b;
      const double cost = chord_cost(ca, cb);
      integral += cost * cell.share;
      largest = std::max(largest, cost);
      if (chord_invalid(ca, cb)) invalid += cell.share;
    }
    const std::size_t k = table_.index(static_cast<std::size_t>(i), s, static_cast<std::size_t>(j));
    const double strain = length > 0.0 ? (length_a - length_b) * (length_a - length_b) / length : 0.0;
    table_.cost[k] =
        aggregate_ == Aggregate::maximum ? largest : integral * (0.5 * length) + options_.lambda * strain;
    table_.invalid[k] = std::round(invalid * (0.5 * length) / kInvalidQuantum);
  }

  const NodeTable& chords_;
  const ElasticOptions& options_;
  Aggregate aggregate_;
  const NodeMask& mask_;
  ChordRuns runs_a_;
  ChordRuns runs_b_;
  EdgeTable table_;
  std::vector<std::vector<Cell>> patterns_;  ///< per step, for equal chords
  std::vector<Cell> cells_;
  std::vector<double> shares_a_;
  std::vector<double> shares_b_;
};

}  // namespace

EdgeTable edge_costs(const Samples& a, const Samples& b, const NodeTable& chord_costs,
                     const ElasticOptions& options, Aggregate aggregate, const NodeMask& mask) {
  if (chord_costs.rows != a.chords() || chord_costs.cols != b.chords()) {
    throw InvalidArgument("the chord costs do not belong to these samples");
  }
  if (options.longest_step < 1 || !(options.lambda >= 0.0)) {
    throw InvalidArgument("the longest step must be at least 1 and lambda at least 0");
  }
  return EdgeCosts(a, b, chord_costs, options, aggregate, mask).run();
}

}  // namespace v0
}  // namespace tandem
