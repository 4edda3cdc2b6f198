#include <algorithm>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "match/elastic_programme.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

namespace detail {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Edges are kept for the next programme up to this many bytes. Beyond, computing them again takes no longer
/// than fetching them from memory.
constexpr std::size_t kKeptBytes = std::size_t{1} << 28;

/// Costs this close are one when a search is bounded by another search's result: the caller decides on ties,
/// so they must be found.
constexpr double kTieMargin = 1e-9;

/// Paths this much better, relative to their cost, are as good: what rounding may hide.
constexpr double kSameCost = 1e-13;

LexCost difference(LexCost x, LexCost y) {
  return {x.invalid - y.invalid, x.cost - y.cost};
}

/// The best start of a path, exact, by potentials and branch and bound.
///
/// A run from many starts at once gives for each of them a cost that no path from it to its own end can
/// undercut. Where the best path at an end really comes from the start that it belongs to, the bound is
/// attained. The other starts may be promised too much, because paths drift: they end at another start than
/// they began with. So each start k gets a potential p(k), charged to paths that begin there and paid back to
/// those that end there: nothing changes for a path that returns to its start, and drifting is no longer
/// free. As in the method of Bellman and Ford, p(k) falls by what the bound of k lacks of the best path
/// found; if it stops falling, no closed path of any number of laps is better. Where it does not, the starts
/// are searched in halves. In the order of pairs everything holds likewise: pairs are subtracted by part.
class BestStart {
 public:
  /// limit: paths that cost more are not wanted. give_up: nothing is found, and gave_up() says so, when the
  /// likeliest start has no path to its end.
  BestStart(ElasticProgramme& programme, Aggregate aggregate, LexCost limit, bool give_up,
            const Progress& progress)
      : programme_(programme),
        has_potentials_(aggregate == Aggregate::sum),
        limit_(limit),
        may_give_up_(give_up),
        progress_(progress) {
    limit_.cost += kTieMargin * limit_.cost;
    std::vector<ProgrammeStart> all(static_cast<std::size_t>(programme.start_count()));
    for (std::size_t k = 0; k < all.size(); ++k) all[k].number = static_cast<int>(k);
    if (!all.empty()) open_.push_back(std::move(all));
  }

  [[nodiscard]] Path find() {
    while (!open_.empty() && !gave_up_ && !best_.cancelled) {
      const std::vector<ProgrammeStart> starts = std::move(open_.back());
      open_.pop_back();
      search(starts);
    }
    return std::move(best_);
  }

  [[nodiscard]] bool gave_up() const { return gave_up_; }

 private:
  struct Bound {
    ProgrammeStart start;
    LexCost lower;
  };

  [[nodiscard]] bool promising(LexCost lower) const {
    if (best_.nodes.empty()) return lower.cost < kInfinity && !(limit_ < lower);
    return lower < LexCost{static_cast<double>(best_.invalid), best_.cost - kSameCost * best_.cost};
  }

  [[nodiscard]] bool run(std::span<const ProgrammeStart> starts) {
    ++runs_;
    const auto share = [&](double done) {
      return progress_((runs_ - 1 + done) / (runs_ + 1.0 + 2.0 * static_cast<double>(open_.size())));
    };
    const bool done = programme_.run(starts, progress_ ? Progress(share) : Progress());
    best_.cancelled = !done || (progress_ && !share(1.0));
    return !best_.cancelled;
  }

  /// Looks for a better path from one of these starts, again and again until none is left, or until halves
  /// of them promise more.
  void search(std::vector<ProgrammeStart> starts) {
    while (!starts.empty()) {
      if (!run(starts)) return;
      std::vector<Bound> bounds = bound(starts);
      if (!bounds.empty() && starts.size() > 1 && !try_likeliest(bounds)) return;
      // One start alone is settled: what rounding leaves between its path and its bound would never close.
      if (starts.size() == 1) return;
      drop_settled(bounds);
      const std::size_t before = starts.size();
      starts.clear();
      for (const Bound& b : bounds) starts.push_back({b.start.number, potential(b)});
      if (!has_potentials_ || starts.size() > before / 2) {
        split(starts);
        return;
      }
    }
  }

  void split(const std::vector<ProgrammeStart>& starts) {
    if (starts.empty()) return;
    const auto middle = starts.begin() + static_cast<std::ptrdiff_t>((starts.size() + 1) / 2);
    open_.emplace_back(starts.begin(), middle);
    if (middle != starts.end()) open_.emplace_back(middle, starts.end());
  }

  [[nodiscard]] LexCost potential(const Bound& b) const {
    if (!has_potentials_) return {0.0, 0.0};
    const LexCost most = best_.nodes.empty() ? (limit_.cost < kInfinity ? limit_ : LexCost{0.0, 0.0})
                                             : LexCost{static_cast<double>(best_.invalid), best_.cost};
    // The end's cost, less the best path's.
    return difference(difference(b.lower, {-b.start.value.invalid, -b.start.value.cost}), most);
  }

  /// The bounds of the last run that promise a better path than the best, after taking true paths among them.
  [[nodiscard]] std::vector<Bound> bound(const std::vector<ProgrammeStart>& starts) {
    std::vector<Bound> bounds;
    for (const ProgrammeStart& start : starts) {
      const Bound b{start, difference(programme_.end_cost(start.number), start.value)};
      if (promising(b.lower)) bounds.push_back(b);
    }
    std::vector<const Bound*> rising;
    rising.reserve(bounds.size());
    for (const Bound& b : bounds) rising.push_back(&b);
    std::stable_sort(rising.begin(), rising.end(),
                     [](const Bound* x, const Bound* y) { return x->lower < y->lower; });
    // The first true path decides about all that follow.
    for (const Bound* b : rising) {
      if (starts.size() > 1 && programme_.origin(b->start.number) != b->start.number) continue;
      best_ = programme_.path(b->start.number);
      break;
    }
    drop_settled(bounds);
    return bounds;
  }

  void drop_settled(std::vector<Bound>& bounds) const {
    bounds.erase(
        std::remove_if(bounds.begin(), bounds.end(), [&](const Bound& b) { return !promising(b.lower); }),
        bounds.end());
  }

  /// A true path early cuts off most of the search: tries the start that promises most, and drops it. False:
  /// cancelled or given up.
  [[nodiscard]] bool try_likeliest(std::vector<Bound>& bounds) {
    const auto likely = std::min_element(bounds.begin(), bounds.end(),
                                         [](const Bound& x, const Bound& y) { return x.lower < y.lower; });
    const ProgrammeStart start{likely->start.number, {0.0, 0.0}};
    bounds.erase(likely);
    if (!run({&start, 1})) return false;
    if (promising(programme_.end_cost(start.number))) best_ = programme_.path(start.number);
    gave_up_ = may_give_up_ && best_.nodes.empty();
    return !gave_up_;
  }

  ElasticProgramme& programme_;
  bool has_potentials_;
  LexCost limit_;
  bool may_give_up_;
  const Progress& progress_;
  Path best_;
  bool gave_up_ = false;
  int runs_ = 0;
  std::vector<std::vector<ProgrammeStart>> open_;  ///< sets of starts still to be searched
};

/// The best path for one aggregate, with edges above the threshold barred.
Path find_path(EdgeRows& edges, Aggregate aggregate, const Band* band, double threshold,
               const Progress& progress, LexCost limit) {
  edges.hold(Counting::barred, threshold);
  {
    ElasticProgramme programme(edges, aggregate, band);
    edges.keep(programme.start_count() > 1 ? kKeptBytes : 0, band == nullptr);
    BestStart search(programme, aggregate, limit, limit.invalid > 0.0, progress);
    Path path = search.find();
    if (path.cancelled || !path.nodes.empty() || limit.invalid == 0.0) return path;
  }
  edges.hold(Counting::counted, threshold);
  ElasticProgramme programme(edges, aggregate, band);
  return BestStart(programme, aggregate, limit, false, progress).find();
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
