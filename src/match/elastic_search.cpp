#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

#include "match/elastic_programme.h"
#include "match/start_search.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

namespace detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Edges are kept for the next programme up to this many bytes. Beyond, computing them again takes no longer
/// than fetching them from memory.
constexpr std::size_t kKeptBytes = std::size_t{1} << 28;

/// The best start of a path, exact, by branch and bound.
///
/// A run from many starts at once gives for each of them a cost that no path from it to its own end can
/// undercut. Where the path at an end really comes from the start that it belongs to, the bound is attained;
/// the other starts are searched again in halves, best bound first, until none can beat the best path found.
/// Rounding does no harm: addition and minimum are monotone in floating point, so a bound is never above the
/// cost that it bounds.
class BestStart {
 public:
  /// limit: paths that cost more are not wanted. give_up: nothing is found, and gave_up() says so, when the
  /// likeliest start has no path to its end.
  BestStart(ElasticProgramme& programme, LexCost limit, bool give_up, const Progress& progress)
      : programme_(programme), limit_(limit), may_give_up_(give_up), progress_(progress) {
    limit_.cost += kTieMargin * limit_.cost;
    open_.push({0, programme.start_count(), {0.0, 0.0}});
  }

  [[nodiscard]] Path find() {
    for (; !open_.empty() && !gave_up_ && !best_.cancelled; ++rounds_) {
      const Range range = open_.top();
      open_.pop();
      if (!promising(range.lower)) break;
      examine(range);
    }
    return std::move(best_);
  }

  [[nodiscard]] bool gave_up() const { return gave_up_; }

 private:
  struct Range {
    int first;
    int last;
    LexCost lower;
  };
  struct Worse {
    bool operator()(const Range& x, const Range& y) const {
      return y.lower < x.lower || (y.lower == x.lower && y.first < x.first);
    }
  };

  [[nodiscard]] bool promising(LexCost lower) const {
    if (best_.nodes.empty()) return lower.cost < kInfinity && !(limit_ < lower);
    return lower < LexCost{static_cast<double>(best_.invalid), best_.cost};
  }

  [[nodiscard]] bool run(int first, int last) {
    const auto share = [&](double done) {
      return progress_((rounds_ + done) / (rounds_ + 1.0 + static_cast<double>(open_.size())));
    };
    const bool done = programme_.run(first, last, progress_ ? Progress(share) : Progress());
    best_.cancelled = !done || (progress_ && !share(1.0));
    return !best_.cancelled;
  }

  void examine(const Range& range) {
    if (!run(range.first, range.last)) return;
    std::vector<std::pair<int, LexCost>> undecided = promising_ends(range);
    if (undecided.empty()) return;
    // A true path early cuts off most of the search: try the start that promises most.
    const auto likely =
        std::min_element(undecided.begin(), undecided.end(), [](const auto& x, const auto& y) {
          return x.second < y.second;
        })->first;
    if (range.last - range.first > 1) {
      if (!run(likely, likely + 1)) return;
      const LexCost cost = programme_.end_cost(likely);
      if (promising(cost)) best_ = programme_.path(likely);
      gave_up_ = may_give_up_ && best_.nodes.empty();
    }
    const auto decided = [&](const auto& start) { return start.first == likely || !promising(start.second); };
    undecided.erase(std::remove_if(undecided.begin(), undecided.end(), decided), undecided.end());
    if (undecided.empty()) return;
    const int first = undecided.front().first;
    const int last = undecided.back().first + 1;
    const int middle = first + (last - first + 1) / 2;
    for (const auto& [lo, hi] : {std::pair{first, middle}, std::pair{middle, last}}) {
      LexCost lower = LexCost::infinite();
      for (const auto& [start, cost] : undecided) {
        if (start >= lo && start < hi) lower = std::min(lower, cost);
      }
      if (lower.cost < kInfinity) open_.push({lo, hi, lower});
    }
  }

  /// Starts whose ends may belong to a better path than the best, after taking the true paths among them.
  [[nodiscard]] std::vector<std::pair<int, LexCost>> promising_ends(const Range& range) {
    std::vector<std::pair<int, LexCost>> ends;
    for (int start = range.first; start < range.last; ++start) {
      const LexCost cost = programme_.end_cost(start);
      if (promising(cost)) ends.emplace_back(start, cost);
    }
    std::stable_sort(ends.begin(), ends.end(),
                     [](const auto& x, const auto& y) { return x.second < y.second; });
    // By rising cost: the first true path decides about all that follow.
    for (const auto& [start, cost] : ends) {
      if (programme_.origin(start) != start) continue;
      best_ = programme_.path(start);
      break;
    }
    const auto settled = [&](const auto& end) { return !promising(end.second); };
    ends.erase(std::remove_if(ends.begin(), ends.end(), settled), ends.end());
    std::sort(ends.begin(), ends.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    return ends;
  }

  ElasticProgramme& programme_;
  LexCost limit_;
  bool may_give_up_;
  const Progress& progress_;
  Path best_;
  bool gave_up_ = false;
  int rounds_ = 0;
  std::priority_queue<Range, std::vector<Range>, Worse> open_;
};

/// The best path for one aggregate, with edges above the threshold barred.
Path find_path(EdgeRows& edges, Aggregate aggregate, const Band* band, double threshold,
               const Progress& progress, LexCost limit) {
  edges.hold(Counting::barred, threshold);
  {
    ElasticProgramme programme(edges, aggregate, band);
    edges.keep(programme.start_count() > 1 ? kKeptBytes : 0);
    BestStart search(programme, limit, limit.invalid > 0.0, progress);
    Path path = search.find();
    if (path.cancelled || !path.nodes.empty() || limit.invalid == 0.0) return path;
  }
  edges.hold(Counting::counted, threshold);
  ElasticProgramme programme(edges, aggregate, band);
  return BestStart(programme, limit, false, progress).find();
}

}  // namespace

Path best_elastic_path(EdgeRows& edges, Aggregate aggregate, const Band* band, const Progress& progress,
                       const Path* beat) {
  const LexCost limit = beat == nullptr || beat->nodes.empty()
                            ? LexCost::infinite()
                            : LexCost{static_cast<double>(beat->invalid), beat->cost};
  if (aggregate == Aggregate::sum) return find_path(edges, aggregate, band, kInfinity, progress, limit);
  // The least maximum first, then the least sum among the paths that stay below it.
  Path widest = find_path(edges, Aggregate::maximum, band, kInfinity, progress, limit);
  if (widest.cancelled || widest.nodes.empty()) return widest;
  Path path = find_path(edges, Aggregate::sum, band, widest.cost, progress, LexCost::infinite());
  path.cost = widest.cost;
  return path;
}

}  // namespace detail

namespace {

void check_table(const EdgeTable& table, bool rows_cyclic, bool cols_cyclic) {
  const std::size_t size = table.rows * table.cols * table.steps.size();
  if (size == 0 || table.cost.size() != size || table.invalid.size() != size) {
    throw InvalidArgument("an edge table needs rows * cols * steps > 0 costs and as many invalid lengths");
  }
  if (table.rows_cyclic != rows_cyclic || table.cols_cyclic != cols_cyclic) {
    throw InvalidArgument(
        "the edge table is cyclic where the programme wants it open, or the other way round");
  }
  for (double c : table.cost) {
    if (!(c >= 0.0)) throw InvalidArgument("an edge cost is negative or not a number");
  }
  for (const Step& s : table.steps) {
    if (s.a < 1 || s.b < 1) throw InvalidArgument("a step must advance on both curves");
  }
}

Path table_path(const EdgeTable& table, bool rows_cyclic, bool cols_cyclic, Aggregate aggregate,
                const Progress& progress, const Path* beat) {
  check_table(table, rows_cyclic, cols_cyclic);
  detail::EdgeRows edges(table);
  return detail::best_elastic_path(edges, aggregate, nullptr, progress, beat);
}

}  // namespace

std::vector<Step> coprime_steps(int longest) {
  if (longest < 1) throw InvalidArgument("the longest step must be at least 1");
  std::vector<Step> steps;
  for (int a = 1; a <= longest; ++a) {
    for (int b = 1; b <= longest; ++b) {
      if (std::gcd(a, b) == 1) steps.push_back({a, b});
    }
  }
  return steps;
}

Path open_path(const EdgeTable& table, Aggregate aggregate) {
  return table_path(table, false, false, aggregate, {}, nullptr);
}

Path closed_path(const EdgeTable& table, Aggregate aggregate, const Progress& progress, const Path* beat) {
  return table_path(table, true, true, aggregate, progress, beat);
}

Path cut_path(const EdgeTable& table, Aggregate aggregate, const Progress& progress, const Path* beat) {
  return table_path(table, true, false, aggregate, progress, beat);
}

}  // namespace v0
}  // namespace tandem
