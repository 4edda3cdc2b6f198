#include "match/edge_plan.h"

#include <algorithm>
#include <utility>

#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Stands for the length of a chord that has none (of a whole of 1): shares of it are slivers, unless all
/// chords of an edge are like it, which then share it equally.
constexpr double kNoLength = 1e-100;

/// Numbers of weights that are kept, at most: 16 MB. Outlines of 128 samples have up to half as many.
constexpr std::size_t kMostWeights = std::size_t{1} << 21;

/// Plans kept by those who match: of few samples and of many, in both directions, and a few more.
constexpr std::size_t kMostPlans = 8;

double length_of(const Samples& s, std::size_t chord) {
  return std::max(s.chord_lengths[chord], kNoLength);
}

/// No step may go round a loop more than once; none is longer than both curves.
int longest_step(const Samples& a, const Samples& b, int wanted) {
  std::size_t longest = std::max(a.chords(), b.chords());
  if (a.cyclic) longest = std::min(longest, a.chords());
  if (b.cyclic) longest = std::min(longest, b.chords());
  return std::min(wanted, static_cast<int>(longest));
}

}  // namespace

EdgePlan::EdgePlan(const Samples& a, const Samples& b, int wanted)
    : given_lengths_{a.chord_lengths, b.chord_lengths},
      cyclic_{a.cyclic, b.cyclic},
      longest_step_(wanted),
      longest_(longest_step(a, b, wanted)) {
  if (wanted < 1) throw InvalidArgument("the longest step must be at least 1 and lambda at least 0");
  steps_ = coprime_steps(longest_);
  first_steps_.push_back(0);
  for (int i = 0; i <= longest_; ++i) {
    const auto behind = std::find_if(steps_.begin(), steps_.end(), [&](const Step& s) { return s.a > i; });
    first_steps_.push_back(static_cast<std::size_t>(behind - steps_.begin()));
  }
  const int cols = static_cast<int>(b.size());
  first_col_ = b.cyclic ? longest_ : 1;
  width_ = b.cyclic ? cols : cols - 1;
  stride_ = whole_blocks(width_);
  measure_columns();

  const int count = static_cast<int>(a.chords());
  std::vector<double> lengths;  // from `longest` before node 0 on
  for (int k = -longest_; k < count; ++k) {
    const int chord = k >= 0 ? k : (a.cyclic ? k + count : 0);
    lengths.push_back(length_of(a, static_cast<std::size_t>(chord)));
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::span<const double> chords(lengths.data() + i, static_cast<std::size_t>(longest_));
    std::size_t known = rows_.size();
    while (known > 0 && !std::ranges::equal(rows_[known - 1].chords, chords)) --known;
    if (known == 0) {
      rows_.push_back(plan_row(chords));
      known = rows_.size();
    }
    row_of_.push_back(known - 1);
  }
  keep_weights();
}

bool EdgePlan::is_of(const Samples& a, const Samples& b, int longest_step) const {
  return longest_step == longest_step_ && a.cyclic == cyclic_[0] && b.cyclic == cyclic_[1] &&
         a.chord_lengths == given_lengths_[0] && b.chord_lengths == given_lengths_[1];
}

void EdgePlan::measure_columns() {
  const int pad = whole_blocks(longest_);
  const std::vector<double>& given = given_lengths_[1];
  chord_stride_ = pad + stride_;
  chord_b_.assign(static_cast<std::size_t>(chord_stride_), 1.0);
  for (int y = 0; y < chord_stride_; ++y) {
    const int chord = y - pad + first_col_;
    if (chord < 0 || chord >= width_ + first_col_ - 1) continue;
    chord_b_[static_cast<std::size_t>(y)] =
        std::max(given[static_cast<std::size_t>(chord) % given.size()], kNoLength);
  }
  const auto length = [&](int x, int back) { return chord_b_[static_cast<std::size_t>(pad + x - back)]; };
  runs_b_.resize(static_cast<std::size_t>(longest_) + 1);
  for (int n = 1; n <= longest_; ++n) {
    Runs& runs = runs_b_[static_cast<std::size_t>(n)];
    runs.length.assign(static_cast<std::size_t>(stride_), 1.0);
    mark_mixed(runs, n);
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

/// Measures the runs of n chords, and finds the blocks in which some have chords of different length.
void EdgePlan::mark_mixed(Runs& runs, int n) {
  const int pad = whole_blocks(longest_);
  const auto length = [&](int x, int back) { return chord_b_[static_cast<std::size_t>(pad + x - back)]; };
  for (int block = 0; block < stride_; block += kBlock) {
    bool mixed = false;
    for (int x = block; x < std::min(block + kBlock, width_); ++x) {
      double sum = 0.0;
      for (int back = n; back > 0; --back) sum += length(x, back);
      runs.length[static_cast<std::size_t>(x)] = sum;
      // Edges that would start outside an open curve do not matter.
      if (!cyclic_[1] && x + first_col_ < n) continue;
      for (int back = n; back > 1; --back) mixed = mixed || length(x, back) != length(x, back - 1);
    }
    std::vector<Columns>& blocks = mixed ? runs.mixed : runs.plain;
    if (!blocks.empty() && blocks.back().hi == block) {
      blocks.back().hi += kBlock;
    } else {
      blocks.push_back({block, block + kBlock});
    }
  }
}

void EdgePlan::weigh(int a, double length_a, Weights& weights) const {
  const auto stride = static_cast<std::size_t>(stride_);
  const std::size_t size = (first_step(a + 1) - first_step(a)) * stride;
  weights.factor.resize(size);
  weights.strain.resize(size);
  double* factor = weights.factor.data();
  double* strain = weights.strain.data();
  for (std::size_t s = first_step(a); s < first_step(a + 1); ++s, factor += stride, strain += stride) {
    const int b = steps_[s].b;
    const double* length_b = runs(b).length.data();
    for (std::size_t x = 0; x < stride; ++x) {
      const double length = length_a + length_b[x];
      const double difference = length_a - length_b[x];
      const double run = a == 1 ? length_b[x] : (b == 1 ? length_a : 1.0);
      factor[x] = 0.5 * length / run;
      strain[x] = difference * difference / length;
    }
  }
}

/// Which chords the edges that end in a row add up, with what weights. chords: the lengths before it.
EdgePlan::RowPlan EdgePlan::plan_row(std::span<const double> chords) const {
  RowPlan plan;
  plan.chords.assign(chords.begin(), chords.end());
  plan.lengths.assign(static_cast<std::size_t>(longest_) + 1, 0.0);
  plan.ends.resize(static_cast<std::size_t>(longest_) + 1);
  const auto length = [&](int back) { return chords[static_cast<std::size_t>(longest_ - back)]; };
  for (int a = 1; a <= longest_; ++a) {
    double total = 0.0;
    for (int back = a; back > 0; --back) total += length(back);
    plan.lengths[static_cast<std::size_t>(a)] = total;
    std::vector<double>& ends = plan.ends[static_cast<std::size_t>(a)];
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
  add_terms(plan);
  return plan;
}

void EdgePlan::add_terms(RowPlan& plan) const {
  const std::ptrdiff_t stride = chord_stride_;
  std::vector<EdgeTerm>& terms = plan.terms;
  const auto length = [&](int back) { return plan.chords[static_cast<std::size_t>(longest_ - back)]; };
  const auto add_sum = [&](std::size_t s, bool continues, std::size_t first) {
    plan.sums.push_back({s, continues, first, terms.size()});
  };
  // The steps come by a, then b: (1,1) .. (1,n) are running sums along the row.
  for (int b = 1; b <= longest_; ++b) {
    terms.push_back({-b, 1.0});
    add_sum(static_cast<std::size_t>(b) - 1, b > 1, terms.size() - 1);
  }
  // (2,1) .. (n,1) are running sums across the rows.
  std::size_t first = terms.size();
  terms.push_back({-stride - 1, length(1)});
  for (std::size_t s = static_cast<std::size_t>(longest_); s < steps_.size(); ++s) {
    const auto [a, b] = steps_[s];
    if (b != 1) continue;
    terms.push_back({-a * stride - 1, length(a)});
    add_sum(s, a > 2, first);
    first = terms.size();
  }
  // The others have a term for every cell of the edge on which neither curve changes its chord; here for
  // equal chords of the second curve.
  std::vector<std::size_t> others;
  for (std::size_t s = static_cast<std::size_t>(longest_); s < steps_.size(); ++s) {
    if (steps_[s].b > 1) others.push_back(s);
  }
  std::ranges::stable_sort(others, {}, [&](std::size_t s) { return steps_[s].b; });
  for (const std::size_t s : others) {
    const auto [a, b] = steps_[s];
    first = terms.size();
    const std::vector<double>& ends = plan.ends[static_cast<std::size_t>(a)];
    for (int p = 0; p < a; ++p) {
      for (int q = 0; q < b; ++q) {
        const double from = std::max(ends[static_cast<std::size_t>(p)], static_cast<double>(q) / b);
        const double to = std::min(ends[static_cast<std::size_t>(p) + 1], static_cast<double>(q + 1) / b);
        if (to - from > kSliver) terms.push_back({-(a - p) * stride - (b - q), to - from});
      }
    }
    add_sum(s, false, first);
  }
}

void EdgePlan::keep_weights() {
  // Which weights the rows have in common.
  std::vector<std::pair<int, double>> wanted;
  std::size_t size = 0;
  for (int a = 1; a <= longest_; ++a) {
    const std::size_t begin = wanted.size();
    for (RowPlan& row : rows_) {
      const double length = row.lengths[static_cast<std::size_t>(a)];
      std::size_t k = wanted.size();
      while (k > begin && wanted[k - 1].second != length) --k;
      if (k == begin) {
        wanted.emplace_back(a, length);
        k = wanted.size();
        size += 2 * (first_step(a + 1) - first_step(a)) * static_cast<std::size_t>(stride_);
        if (size > kMostWeights) return;
      }
      row.weights.resize(static_cast<std::size_t>(longest_) + 1);
      row.weights[static_cast<std::size_t>(a)] = k - 1;
    }
  }
  weights_.resize(wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) weigh(wanted[k].first, wanted[k].second, weights_[k]);
  keeps_weights_ = true;
}

std::shared_ptr<const EdgePlan> EdgePlans::find(const Samples& a, const Samples& b, int longest_step) {
  const std::lock_guard lock(mutex_);
  for (const auto& plan : plans_) {
    if (plan->is_of(a, b, longest_step)) return plan;
  }
  if (plans_.size() == kMostPlans) plans_.erase(plans_.begin());
  plans_.push_back(std::make_shared<const EdgePlan>(a, b, longest_step));
  return plans_.back();
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
