#include "match/edge_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Rows of chords that pass before the window is moved back to the start of its memory.
constexpr std::size_t kSlide = 32;

/// Costs above this count as infinite, so that no sum overflows.
constexpr double kMostCost = 1e300;

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
                   Aggregate aggregate, std::shared_ptr<const EdgePlan> plan)
    : rows_(static_cast<int>(a.size())),
      cols_(static_cast<int>(b.size())),
      rows_cyclic_(a.cyclic),
      cols_cyclic_(b.cyclic),
      threshold_(kInfinity),
      chords_(&chords),
      aggregate_(aggregate),
      lambda_(options.lambda),
      plan_(std::move(plan)) {
  if (chords.rows != a.chords() || chords.cols != b.chords()) {
    throw InvalidArgument("the chord costs do not belong to these samples");
  }
  if (options.longest_step < 1 || !(options.lambda >= 0.0)) {
    throw InvalidArgument("the longest step must be at least 1 and lambda at least 0");
  }
  if (plan_ == nullptr) plan_ = std::make_shared<const EdgePlan>(a, b, options.longest_step);
  steps_ = plan_->steps();
  longest_ = plan_->longest();
  first_col_ = plan_->first_col();
  width_ = plan_->width();
  stride_ = plan_->stride();
  chord_stride_ = plan_->chord_stride();
  row_size_ = steps_.size() * static_cast<std::size_t>(stride_);
  for (const double cost : chords.cost) most_ = std::max(most_, cost);

  window_rows_ = static_cast<std::size_t>(longest_) + kSlide;
  chord_cost_.assign(window_rows_ * static_cast<std::size_t>(chord_stride_), kInfinity);
  flagged_.assign(window_rows_, 0);
  weights_.resize(static_cast<std::size_t>(longest_) + 1);
  if (!plan_->keeps_weights()) {
    own_weights_.resize(weights_.size());
    weighed_.assign(weights_.size(), -1.0);
  }
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
  const double* length = plan_->chord_lengths().data() + columns.lo;
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

void EdgeRows::plan_row(int i) {
  const EdgePlan::RowPlan* plan = &plan_->row(i);
  if (plan == row_plan_) return;
  row_plan_ = plan;
  for (int a = 1; a <= longest_; ++a) {
    const auto k = static_cast<std::size_t>(a);
    if (plan_->keeps_weights()) {
      weights_[k] = &plan_->kept_weights(*plan, a);
      continue;
    }
    weights_[k] = &own_weights_[k];
    if (weighed_[k] == plan->lengths[k]) continue;
    weighed_[k] = plan->lengths[k];
    plan_->weigh(a, weighed_[k], own_weights_[k]);
  }
  sums_.clear();
  for (const EdgePlan::StepTerms& terms : plan->sums) {
    const int a = steps_[terms.step].a;
    const EdgePlan::Weights& weights = *weights_[static_cast<std::size_t>(a)];
    const std::size_t at = (terms.step - plan_->first_step(a)) * static_cast<std::size_t>(stride_);
    sums_.push_back({terms.continues, terms.first, terms.last, weights.factor.data() + at,
                     weights.strain.data() + at, nullptr});
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
  const EdgeOptions options{value, 1.0 / kInvalidQuantum, lambda_};
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    sums_[k].out = out + row_plan_->sums[k].step * static_cast<std::size_t>(stride_);
  }
  const auto lo = static_cast<std::size_t>(columns.lo);
  const auto hi = static_cast<std::size_t>(columns.hi);
  const EdgeTerm* terms = row_plan_->terms.data();
  const std::size_t straight = plan_->straight_steps();
  integrate_edges(base, terms, sums_.data(), straight, lo, hi, options);
  const auto common = [&](const Columns& part) {
    return std::pair(std::max(lo, static_cast<std::size_t>(part.lo)),
                     std::min(hi, static_cast<std::size_t>(part.hi)));
  };
  const auto step_of = [&](std::size_t k) { return steps_[row_plan_->sums[k].step]; };
  for (std::size_t k = straight, next = k; k < sums_.size(); k = next) {
    const int b = step_of(k).b;
    while (next < sums_.size() && step_of(next).b == b) ++next;
    for (const Columns& part : plan_->runs(b).plain) {
      const auto [from, to] = common(part);
      if (from < to) integrate_edges(base, terms, sums_.data() + k, next - k, from, to, options);
    }
  }
  for (std::size_t k = straight; k < sums_.size(); ++k) {
    const auto [a, b] = step_of(k);
    const EdgePlan::Runs& runs = plan_->runs(b);
    if (runs.mixed.empty()) continue;
    const EdgeOverlaps edges{a,
                             b,
                             chord_stride_,
                             row_plan_->ends[static_cast<std::size_t>(a)].data(),
                             runs.end_arrays.data(),
                             runs.spread.data(),
                             sums_[k].factor,
                             sums_[k].strain,
                             sums_[k].out};
    for (const Columns& part : runs.mixed) {
      const auto [from, to] = common(part);
      if (from < to) integrate_overlaps(base, edges, from, to, options);
    }
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
