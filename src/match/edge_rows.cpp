#include "match/edge_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Rows of chords that pass before the window is moved back to the start of its memory.
constexpr std::size_t kSlide = 32;

/// Stands for the length of a chord that has none (of a whole of 1): shares of it are slivers, unless all
/// chords of an edge are like it, which then share it equally.
constexpr double kNoLength = 1e-100;

/// Costs above this count as infinite, so that no sum overflows.
constexpr double kMostCost = 1e300;

double length_of(const Samples& s, std::size_t chord) {
  return std::max(s.chord_lengths[chord], kNoLength);
}

/// No step may go round a loop more than once; none is longer than both curves.
int longest_step(const Samples& a, const Samples& b, const ElasticOptions& options) {
  std::size_t longest = std::max(a.chords(), b.chords());
  if (a.cyclic) longest = std::min(longest, a.chords());
  if (b.cyclic) longest = std::min(longest, b.chords());
  return std::min(options.longest_step, static_cast<int>(longest));
}

int longest_of(const std::vector<Step>& steps) {
  int longest = 1;
  for (const Step& s : steps) longest = std::max({longest, s.a, s.b});
  return longest;
}

}  // namespace

std::vector<std::size_t> tie_order(const std::vector<Step>& steps) {
  std::vector<std::size_t> order(steps.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
    const Step& p = steps[x];
    const Step& q = steps[y];
    const int lhs = std::abs(p.a - p.b) * (q.a + q.b);
    const int rhs = std::abs(q.a - q.b) * (p.a + p.b);
    return lhs != rhs ? lhs < rhs : p.a < q.a;
  });
  return order;
}

EdgeRows::EdgeRows(const Samples& a, const Samples& b, const NodeTable& chords, const ElasticOptions& options,
                   Aggregate aggregate)
    : rows_(static_cast<int>(a.size())),
      cols_(static_cast<int>(b.size())),
      rows_cyclic_(a.cyclic),
      cols_cyclic_(b.cyclic),
      longest_(longest_step(a, b, options)),
      threshold_(kInfinity),
      chords_(&chords),
      aggregate_(aggregate),
      lambda_(options.lambda) {
  if (chords.rows != a.chords() || chords.cols != b.chords()) {
    throw InvalidArgument("the chord costs do not belong to these samples");
  }
  if (options.longest_step < 1 || !(options.lambda >= 0.0)) {
    throw InvalidArgument("the longest step must be at least 1 and lambda at least 0");
  }
  steps_ = coprime_steps(longest_);
  first_col_ = cols_cyclic_ ? longest_ : 1;
  width_ = cols_cyclic_ ? cols_ : cols_ - 1;
  stride_ = whole_blocks(width_);
  row_size_ = steps_.size() * static_cast<std::size_t>(stride_);

  const int count = static_cast<int>(a.chords());
  for (int k = -longest_; k < count; ++k) {
    const int chord = k >= 0 ? k : (rows_cyclic_ ? k + count : 0);
    lengths_a_.push_back(length_of(a, static_cast<std::size_t>(chord)));
  }
  measure_columns(b);
  for (const double cost : chords.cost) most_ = std::max(most_, cost);

  window_rows_ = static_cast<std::size_t>(longest_) + kSlide;
  chord_cost_.assign(window_rows_ * static_cast<std::size_t>(chord_stride_), kInfinity);
  flagged_.assign(window_rows_, 0);
  weighed_.assign(static_cast<std::size_t>(longest_) + 1, -1.0);
  factor_.assign(row_size_, 1.0);
  strain_.assign(row_size_, 0.0);
  ends_a_.resize(static_cast<std::size_t>(longest_) + 1);
}

EdgeRows::EdgeRows(const EdgeTable& table)
    : rows_(static_cast<int>(table.rows)),
      cols_(static_cast<int>(table.cols)),
      rows_cyclic_(table.rows_cyclic),
      cols_cyclic_(table.cols_cyclic),
      steps_(table.steps),
      longest_(longest_of(table.steps)),
      threshold_(kInfinity),
      table_(&table) {
  first_col_ = cols_cyclic_ ? std::min(longest_, cols_) : 1;
  width_ = cols_cyclic_ ? cols_ : cols_ - 1;
  stride_ = whole_blocks(width_);
  row_size_ = steps_.size() * static_cast<std::size_t>(stride_);
}

void EdgeRows::hold(Counting counting, double threshold) {
  counting_ = counting;
  threshold_ = most_ > kMostCost ? std::min(threshold, kMostCost) : threshold;
  window_row_ = -1;
  if (counting == Counting::counted) chord_flag_.resize(chord_cost_.size());
  cost_.clear();
  invalid_.clear();
  known_.clear();
}

void EdgeRows::keep(std::size_t bytes, bool whole) {
  kept_bytes_ = bytes;
  whole_rows_ = whole;
}

EdgeRows::Row EdgeRows::row(int i, Columns columns) {
  const bool counted = counting_ == Counting::counted;
  const std::size_t row_bytes = row_size_ * sizeof(double) * (counted ? 2 : 1);
  const bool kept = row_bytes > 0 && static_cast<std::size_t>(rows_) <= kept_bytes_ / row_bytes;
  if (cost_.empty()) {
    cost_.resize(row_size_ * (kept ? static_cast<std::size_t>(rows_) : 1));
    if (counted) invalid_.resize(cost_.size());
    if (kept) known_.assign(static_cast<std::size_t>(rows_), Columns{});
  }
  const std::size_t at = kept ? row_size_ * static_cast<std::size_t>(i) : 0;
  double* cost = cost_.data() + at;
  double* invalid = counted ? invalid_.data() + at : nullptr;
  if (kept && whole_rows_) columns = {0, stride_};
  Columns* known = kept ? &known_[static_cast<std::size_t>(i)] : nullptr;
  if (known == nullptr || columns.lo < known->lo || columns.hi > known->hi) {
    // Columns that are not computed are compared with the threshold, too.
    if (threshold_ < kInfinity) std::fill_n(cost, row_size_, kInfinity);
    if (table_ != nullptr) {
      copy_row(i, cost, invalid);
    } else {
      compute_row(i, columns, cost, invalid);
    }
    if (threshold_ < kInfinity) {
      for (std::size_t k = 0; k < row_size_; ++k) {
        if (!(cost[k] > threshold_)) continue;
        cost[k] = kInfinity;
        if (counted) invalid[k] = kInfinity;
      }
    }
    if (known != nullptr) *known = columns;
  }
  return {cost, invalid};
}

void EdgeRows::copy_row(int i, double* cost, double* invalid) {
  std::fill_n(cost, row_size_, kInfinity);
  if (invalid != nullptr) std::fill_n(invalid, row_size_, kInfinity);
  for (std::size_t s = 0; s < steps_.size(); ++s) {
    const std::size_t from = table_->index(static_cast<std::size_t>(i), s, 0);
    const std::size_t to = s * static_cast<std::size_t>(stride_);
    for (int x = 0; x < width_; ++x) {
      const std::size_t k = from + static_cast<std::size_t>((x + first_col_) % cols_);
      const std::size_t out = to + static_cast<std::size_t>(x);
      if (table_->cost[k] > kMostCost || (invalid == nullptr && table_->invalid[k] > 0.0)) continue;
      cost[out] = table_->cost[k];
      if (invalid != nullptr) invalid[out] = table_->invalid[k];
    }
  }
}

void EdgeRows::measure_columns(const Samples& b) {
  const int pad = whole_blocks(longest_);
  const int count = static_cast<int>(b.chords());
  chord_stride_ = pad + stride_;
  chord_b_.assign(static_cast<std::size_t>(chord_stride_), 1.0);
  for (int y = 0; y < chord_stride_; ++y) {
    const int chord = y - pad + first_col_;
    if (chord < 0 || chord >= width_ + first_col_ - 1) continue;
    chord_b_[static_cast<std::size_t>(y)] = length_of(b, static_cast<std::size_t>(chord % count));
  }
  const auto length = [&](int x, int back) { return chord_b_[static_cast<std::size_t>(pad + x - back)]; };
  runs_b_.resize(static_cast<std::size_t>(longest_) + 1);
  for (int n = 1; n <= longest_; ++n) {
    Runs& runs = runs_b_[static_cast<std::size_t>(n)];
    runs.length.assign(static_cast<std::size_t>(stride_), 1.0);
    for (int block = 0; block < stride_; block += kBlock) {
      bool mixed = false;
      for (int x = block; x < std::min(block + kBlock, width_); ++x) {
        double sum = 0.0;
        for (int back = n; back > 0; --back) sum += length(x, back);
        runs.length[static_cast<std::size_t>(x)] = sum;
        // Edges that would start outside an open curve do not matter.
        if (!cols_cyclic_ && x + first_col_ < n) continue;
        for (int back = n; back > 1; --back) mixed = mixed || length(x, back) != length(x, back - 1);
      }
      if (!mixed) continue;
      if (!runs.mixed.empty() && runs.mixed.back().hi == block) {
        runs.mixed.back().hi += kBlock;
      } else {
        runs.mixed.push_back({block, block + kBlock});
      }
    }
    if (runs.mixed.empty()) continue;
    runs.ends.assign(static_cast<std::size_t>(n) + 1,
                     std::vector<double>(static_cast<std::size_t>(stride_), 0.0));
    for (int x = 0; x < stride_; ++x) {
      double sum = 0.0;
      for (int q = 1; q <= n; ++q) {
        sum += length(x, n - q + 1);
        runs.ends[static_cast<std::size_t>(q)][static_cast<std::size_t>(x)] =
            q == n ? 1.0 : sum / runs.length[static_cast<std::size_t>(x)];
      }
    }
    for (const std::vector<double>& ends : runs.ends) runs.end_arrays.push_back(ends.data());
    for (int block = 0; block < stride_; block += kBlock) {
      for (const std::vector<double>& ends : runs.ends) {
        const auto [least, largest] =
            std::minmax_element(ends.begin() + block, ends.begin() + block + kBlock);
        runs.spread.push_back(*least);
        runs.spread.push_back(*largest);
      }
    }
  }
}

/// The chords of one row that edges ending in these columns need.
void EdgeRows::load_chord_row(int row, std::size_t slot, Columns columns) {
  const int pad = whole_blocks(longest_);
  const bool barred = counting_ == Counting::barred;
  double* cost = chord_cost_.data() + slot * static_cast<std::size_t>(chord_stride_) + columns.lo;
  double* flag = barred ? nullptr : chord_flag_.data() + (cost - chord_cost_.data());
  const int size = pad + columns.hi - columns.lo;
  std::fill_n(cost, size, kInfinity);
  if (!barred) std::fill_n(flag, size, kInfinity);
  const int count = static_cast<int>(chords_->rows);
  if (row < 0) {
    flagged_[slot] = 0;
    if (!rows_cyclic_) return;
    row += count;
  }
  const std::size_t at = chords_->index(static_cast<std::size_t>(row), 0);
  const auto cols = static_cast<int>(chords_->cols);
  std::uint8_t any = 0;
  // Chord k is the one before column k + 1 - first_col(); a loop's go on after its end.
  const int start = columns.lo + first_col_ - pad;
  const int first = std::max(start, 0);
  const int last = std::min(columns.hi, width_) + first_col_ - 1;
  for (int k = first; k < last;) {
    const int from = k % cols;
    const int n = std::min(cols - from, last - k);
    const double* costs = chords_->cost.data() + at + static_cast<std::size_t>(from);
    const std::uint8_t* flags = chords_->invalid.data() + at + static_cast<std::size_t>(from);
    double* to = cost + (k - start);
    for (int c = 0; c < n; ++c) any |= flags[c];
    if (barred && any != 0) {
      for (int c = 0; c < n; ++c) to[c] = flags[c] != 0 ? kInfinity : costs[c];
    } else {
      std::copy_n(costs, n, to);
    }
    for (int c = 0; c < n && !barred; ++c) flag[k - start + c] = flags[c];
    k += n;
  }
  flagged_[slot] = any;
}

/// Moves the window to row i. Out of order, only what these columns need is loaded, for this once.
void EdgeRows::load_chords(int i, Columns columns) {
  const auto longest = static_cast<std::size_t>(longest_);
  const auto stride = static_cast<std::size_t>(chord_stride_);
  if (i == window_row_) return;
  const bool next = window_row_ >= 0 && (i == window_row_ + 1 || (i == 0 && window_row_ == rows_ - 1));
  const Columns all{0, stride_};
  if (!next) {
    const bool once = columns.hi - columns.lo <= kBlock;
    for (std::size_t k = 0; k < longest; ++k) {
      load_chord_row(i - longest_ + static_cast<int>(k), k, once ? columns : all);
    }
    window_slot_ = longest;
    window_row_ = once ? -1 : i;
    return;
  }
  if (window_slot_ + 1 == window_rows_) {
    const std::size_t from = window_slot_ - longest + 1;
    for (std::vector<double>* rows : {&chord_cost_, &chord_flag_}) {
      if (rows->empty()) continue;
      std::copy_n(rows->begin() + static_cast<std::ptrdiff_t>(from * stride), (longest - 1) * stride,
                  rows->begin());
    }
    std::copy_n(flagged_.begin() + static_cast<std::ptrdiff_t>(from), longest - 1, flagged_.begin());
    window_slot_ = longest - 1;
  }
  load_chord_row(i - 1, window_slot_, all);
  ++window_slot_;
  window_row_ = i;
}

/// The own slot of the row gets the chords before it, times their lengths on the second curve: what the steps
/// (1,b) add up.
void EdgeRows::weigh_last_chords(Columns columns) {
  const auto stride = static_cast<std::size_t>(chord_stride_);
  const std::size_t size = static_cast<std::size_t>(whole_blocks(longest_) + columns.hi - columns.lo);
  const double* length = chord_b_.data() + columns.lo;
  const std::size_t to = window_slot_ * stride + static_cast<std::size_t>(columns.lo);
  const std::size_t from = to - stride;
  if (aggregate_ == Aggregate::maximum) {
    std::copy_n(chord_cost_.data() + from, size, chord_cost_.data() + to);
  } else {
    for (std::size_t k = 0; k < size; ++k) chord_cost_[to + k] = length[k] * chord_cost_[from + k];
  }
  if (counting_ == Counting::barred) return;
  for (std::size_t k = 0; k < size; ++k) chord_flag_[to + k] = length[k] * chord_flag_[from + k];
}

/// Factors that make integrals costs, and strains, of all steps (a,b) over this length of the first curve.
/// The integrals of (1,b) and (a,1) are not divided by the run's length yet.
void EdgeRows::plan_weights(int a, double length_a) {
  if (weighed_[static_cast<std::size_t>(a)] == length_a) return;
  weighed_[static_cast<std::size_t>(a)] = length_a;
  for (std::size_t s = 0; s < steps_.size(); ++s) {
    if (steps_[s].a != a) continue;
    const int b = steps_[s].b;
    const double* length_b = runs_b_[static_cast<std::size_t>(b)].length.data();
    double* factor = factor_.data() + s * static_cast<std::size_t>(stride_);
    double* strain = strain_.data() + s * static_cast<std::size_t>(stride_);
    for (std::size_t x = 0; x < static_cast<std::size_t>(stride_); ++x) {
      const double length = length_a + length_b[x];
      const double difference = length_a - length_b[x];
      const double run = a == 1 ? length_b[x] : (b == 1 ? length_a : 1.0);
      factor[x] = 0.5 * length / run;
      strain[x] = lambda_ * (difference * difference / length);
    }
  }
}

/// Which chords the edges that end in row i add up, with what weights.
void EdgeRows::plan_row(int i) {
  const auto longest = static_cast<std::size_t>(longest_);
  const std::span<const double> lengths(lengths_a_.data() + i, longest);
  if (!planned_.empty() && std::equal(lengths.begin(), lengths.end(), planned_.begin())) return;
  planned_.assign(lengths.begin(), lengths.end());
  terms_.clear();
  sums_.clear();
  const auto length = [&](int back) { return planned_[longest - static_cast<std::size_t>(back)]; };
  for (int a = 1; a <= longest_; ++a) {
    double total = 0.0;
    for (int back = a; back > 0; --back) total += length(back);
    plan_weights(a, total);
    std::vector<double>& ends = ends_a_[static_cast<std::size_t>(a)];
    ends.assign(1, 0.0);
    bool mixed = false;
    double sum = 0.0;
    for (int back = a; back > 0; --back) {
      mixed = mixed || length(back) != length(a);
      sum += length(back);
      ends.push_back(sum / total);
    }
    if (!mixed) {
      for (int p = 0; p <= a; ++p) ends[static_cast<std::size_t>(p)] = static_cast<double>(p) / a;
    }
    ends.back() = 1.0;
  }
  const std::ptrdiff_t stride = chord_stride_;
  const auto add_sum = [&](std::size_t s, bool continues, std::size_t first) {
    const std::size_t at = s * static_cast<std::size_t>(stride_);
    sums_.push_back({continues, first, terms_.size(), factor_.data() + at, strain_.data() + at, nullptr});
  };
  // The steps come by a, then b: (1,1) .. (1,n) are running sums along the row.
  for (int b = 1; b <= longest_; ++b) {
    terms_.push_back({-b, 1.0});
    add_sum(static_cast<std::size_t>(b) - 1, b > 1, terms_.size() - 1);
  }
  // (2,1) .. (n,1) are running sums across the rows.
  std::size_t first = terms_.size();
  terms_.push_back({-stride - 1, length(1)});
  for (std::size_t s = static_cast<std::size_t>(longest_); s < steps_.size(); ++s) {
    const auto [a, b] = steps_[s];
    if (b != 1) continue;
    terms_.push_back({-a * stride - 1, length(a)});
    add_sum(s, a > 2, first);
    first = terms_.size();
  }
  // The others have a term for every cell of the edge on which neither curve changes its chord; here for
  // equal chords of the second curve.
  for (std::size_t s = static_cast<std::size_t>(longest_); s < steps_.size(); ++s) {
    const auto [a, b] = steps_[s];
    if (b == 1) continue;
    first = terms_.size();
    const std::vector<double>& ends = ends_a_[static_cast<std::size_t>(a)];
    for (int p = 0; p < a; ++p) {
      for (int q = 0; q < b; ++q) {
        const double from = std::max(ends[static_cast<std::size_t>(p)], static_cast<double>(q) / b);
        const double to = std::min(ends[static_cast<std::size_t>(p) + 1], static_cast<double>(q + 1) / b);
        if (to - from > kSliver) terms_.push_back({-(a - p) * stride - (b - q), to - from});
      }
    }
    add_sum(s, false, first);
  }
}

void EdgeRows::compute_row(int i, Columns columns, double* cost, double* invalid) {
  load_chords(i, columns);
  weigh_last_chords(columns);
  plan_row(i);
  integrate(columns, chord_cost_, aggregate_ == Aggregate::maximum ? EdgeValue::largest : EdgeValue::integral,
            cost);
  if (invalid == nullptr) return;
  const auto begin = flagged_.begin() + static_cast<std::ptrdiff_t>(window_slot_) - longest_;
  if (std::any_of(begin, begin + longest_, [](std::uint8_t f) { return f != 0; })) {
    integrate(columns, chord_flag_, EdgeValue::invalid, invalid);
  } else {
    std::fill_n(invalid, row_size_, 0.0);
  }
}

void EdgeRows::integrate(Columns columns, const std::vector<double>& chords, EdgeValue value, double* out) {
  const double* base = chords.data() + window_slot_ * static_cast<std::size_t>(chord_stride_) +
                       static_cast<std::size_t>(whole_blocks(longest_));
  const EdgeOptions options{value, 1.0 / kInvalidQuantum};
  for (EdgeSum& sum : sums_) sum.out = out + (sum.factor - factor_.data());
  const auto lo = static_cast<std::size_t>(columns.lo);
  const auto hi = static_cast<std::size_t>(columns.hi);
  integrate_edges(base, terms_.data(), sums_.data(), sums_.size(), lo, hi, options);
  for (std::size_t s = 0; s < steps_.size(); ++s) {
    const auto [a, b] = steps_[s];
    const Runs& runs = runs_b_[static_cast<std::size_t>(b)];
    if (a == 1 || b == 1 || runs.mixed.empty()) continue;
    const std::size_t at = s * static_cast<std::size_t>(stride_);
    const EdgeOverlaps edges{a,
                             b,
                             chord_stride_,
                             ends_a_[static_cast<std::size_t>(a)].data(),
                             runs.end_arrays.data(),
                             runs.spread.data(),
                             factor_.data() + at,
                             strain_.data() + at,
                             out + at};
    for (const Columns& mixed : runs.mixed) {
      const auto from = std::max(lo, static_cast<std::size_t>(mixed.lo));
      const auto to = std::min(hi, static_cast<std::size_t>(mixed.hi));
      if (from < to) integrate_overlaps(base, edges, from, to, options);
    }
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
