#include "match/find_rotation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <mutex>
#include <numeric>
#include <utility>

#include "match/matched_covariance.h"
#include "match/nearest_rotation.h"
#include "match/parallel_for.h"
#include "match/rotation_candidates.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

/// Candidates per pair and direction, and the pairs (the longest ones) that they are taken from.
constexpr int kMostCandidates = 3;
constexpr std::size_t kMostSources = 3;
/// Tangents that are correlated, at most: a candidate need only be near enough for the alternation.
constexpr std::size_t kMostTangents = 256;

/// Rounds of matching and Procrustes; mostly the path stays the same after two or three.
constexpr int kMostRounds = 12;
/// A round that lowers the cost by less than this share is the last.
constexpr double kWorthRound = 1e-4;

/// With coarse_to_fine, turns that start with a cost so much above the best one's are not improved: the first
/// match under a candidate is most of what there is to gain.
constexpr double kHopeful = 0.5;

/// With coarse_to_fine, the longest step on the coarse samples: tells turns as well, with a third of the
/// edges.
constexpr int kHastyStep = 3;

/// Candidates that the fine programme tries: those whose coarse cost is within this share, and this much, of
/// the best.
constexpr std::size_t kMostFinalists = 2;
constexpr double kFinalistShare = 0.1;
constexpr double kFinalistCost = 0.002;

/// Costs and invalid lengths this close are equal, and so are rotations whose numbers are. Invalid lengths
/// are counted in quanta, edge by edge.
constexpr double kSameCost = 1e-9;
constexpr double kSameInvalid = 1e-6;
constexpr double kSameRotation = 1e-9;
/// Rotations whose numbers are this close lead to one optimum.
constexpr double kSameOptimum = 1e-3;

/// How good matches are: mean cost and invalid share over all pairs, less is better.
struct Goodness {
  double invalid = 0.0;
  double cost = 0.0;

  /// One number of both, for comparisons that need a ratio: an invalid pair counts as opposite tangents.
  [[nodiscard]] double sum() const { return cost + 2.0 * invalid; }
};

bool clearly_better(const Goodness& x, const Goodness& y) {
  if (std::fabs(x.invalid - y.invalid) > kSameInvalid) return x.invalid < y.invalid;
  return x.cost < y.cost - kSameCost * (1.0 + y.cost);
}

bool same_rotation(const Rotation& x, const Rotation& y, double tolerance = kSameRotation) {
  for (std::size_t k = 0; k < x.values().size(); ++k) {
    if (std::fabs(x.values()[k] - y.values()[k]) > tolerance) return false;
  }
  return true;
}

/// A turn with the optima under it.
struct Trial {
  Rotation rotation;
  Direction direction = Direction::automatic;  ///< asked for
  std::vector<SearchResult> found;
  Goodness goodness;
  bool cancelled = false;
};

/// Better, or equally good with a smaller turn.
bool preferable(const Trial& x, const Trial& y) {
  if (clearly_better(x.goodness, y.goodness)) return true;
  return !clearly_better(y.goodness, x.goodness) && x.rotation.trace() > y.rotation.trace() + kSameRotation;
}

/// A progress of steps whose number nobody knows: each takes half of what is left. Calls may come from
/// several threads.
class RisingProgress {
 public:
  explicit RisingProgress(const Progress& progress) : progress_(progress) {}

  [[nodiscard]] Progress step() {
    if (!progress_) return {};
    const double from = done_;
    done_ += 0.5 * (1.0 - done_);
    return [this, from, to = done_](double fraction) {
      const std::lock_guard lock(mutex_);
      return progress_(from + (to - from) * fraction);
    };
  }
  /// For work that runs at once: asks whether to go on.
  [[nodiscard]] Progress standing() {
    if (!progress_) return {};
    return [this, at = done_](double) {
      const std::lock_guard lock(mutex_);
      return progress_(at);
    };
  }

 private:
  const Progress& progress_;
  std::mutex mutex_;
  double done_ = 0.0;
};

/// Matching under given turns, on one set of samples.
class Matcher {
 public:
  Matcher(std::span<const RotationTask> tasks, const MatchOptions& options, bool coarse)
      : tasks_(tasks), options_(options), coarse_(coarse) {
    double total = 0.0;
    // Halved, the sum of two huge lengths is finite.
    for (const RotationTask& task : tasks) {
      lengths_.push_back(0.5 * task.fine.a.length + 0.5 * task.fine.b.length);
      total = std::max(total, lengths_.back());
    }
    for (double& length : lengths_) length /= total;
    total = std::accumulate(lengths_.begin(), lengths_.end(), 0.0);
    for (double& length : lengths_) length /= total;
  }

  /// Share of each pair in the whole length.
  [[nodiscard]] const std::vector<double>& weights() const { return lengths_; }

  [[nodiscard]] Trial run(const Rotation& rotation, Direction direction, int threads,
                          const Progress& progress) const {
    Trial trial{rotation, direction, {}, {}, false};
    MatchOptions options = options_;
    options.threads = threads;
    options.progress = progress;
    if (coarse_ && options.coarse_to_fine) {
      options.elastic.longest_step = std::min(options.elastic.longest_step, kHastyStep);
    }
    if (direction != Direction::automatic) options.direction = direction;
    const Rotation back = rotation.inverse();
    for (std::size_t k = 0; k < tasks_.size(); ++k) {
      const SamplePair& pair = samples(k);
      trial.found.push_back(
          search(pair.a, turned(pair.b, back), options, tasks_[k].layout, nullptr, tasks_[k].plans.get()));
      const SearchResult& found = trial.found.back();
      if (found.path.cancelled) {
        trial.cancelled = true;
        return trial;
      }
      add(trial.goodness, lengths_[k], found, pair);
    }
    return trial;
  }

  /// The best turn for the paths of a trial.
  [[nodiscard]] Rotation fit(const Trial& trial) const {
    const int dim = trial.rotation.dim();
    std::vector<double> sums(static_cast<std::size_t>(dim) * static_cast<std::size_t>(dim));
    for (std::size_t k = 0; k < tasks_.size(); ++k) {
      const SearchResult& found = trial.found[k];
      const SamplePair& pair = samples(k);
      const std::vector<double> own =
          matched_covariance(pair.a, found.reversed ? reversed(pair.b) : pair.b, found.path, options_.method);
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += lengths_[k] * own[i];
    }
    return nearest_rotation(sums, dim).rotation;
  }

  /// Matching and Procrustes in alternation, from the trial on. step(): the progress of the next round.
  template <class Step>
  [[nodiscard]] Trial improve(Trial trial, int threads, const Step& step) const {
    for (int round = 0; round < kMostRounds && !trial.cancelled; ++round) {
      const Rotation rotation = fit(trial);
      if (same_rotation(rotation, trial.rotation)) break;
      Trial next = run(rotation, trial.direction, threads, step());
      if (next.cancelled) return next;
      if (!clearly_better(next.goodness, trial.goodness)) break;
      const bool last = next.goodness.invalid >= trial.goodness.invalid - kSameInvalid &&
                        next.goodness.cost > (1.0 - kWorthRound) * trial.goodness.cost;
      trial = std::move(next);
      if (last) break;
    }
    return trial;
  }

 private:
  [[nodiscard]] const SamplePair& samples(std::size_t k) const {
    return coarse_ ? tasks_[k].coarse : tasks_[k].fine;
  }

  void add(Goodness& goodness, double weight, const SearchResult& found, const SamplePair& pair) const {
    if (found.path.nodes.empty()) {  // no steps bridge these samples, whatever the turn
      goodness.invalid += weight;
      return;
    }
    const bool paper = options_.method == Method::paper;
    const double nodes = static_cast<double>(pair.a.size() + pair.b.size());
    goodness.invalid +=
        weight * static_cast<double>(found.path.invalid) * (paper ? 1.0 / nodes : kInvalidQuantum);
    goodness.cost += weight * (paper ? found.path.cost / nodes : found.path.cost);
  }

  std::span<const RotationTask> tasks_;
  const MatchOptions& options_;
  bool coarse_;
  std::vector<double> lengths_;
};

/// Mean tangents over m equal parts of the length, plane by plane.
std::vector<double> mean_tangents(const Samples& s, std::size_t m) {
  const auto dim = static_cast<std::size_t>(s.dim());
  std::vector<double> planes(dim * m);
  double at = 0.0;  // in parts
  for (std::size_t k = 0; k < s.chords(); ++k) {
    const double end = at + s.chord_lengths[k] * static_cast<double>(m);
    for (auto part = static_cast<std::size_t>(at); part < m && static_cast<double>(part) < end; ++part) {
      const double share =
          std::min(end, static_cast<double>(part + 1)) - std::max(at, static_cast<double>(part));
      for (std::size_t c = 0; c < dim; ++c) planes[c * m + part] += share * s.chord_tangents[k][c];
    }
    at = end;
  }
  return planes;
}

struct Start {
  Rotation rotation;
  Direction direction = Direction::automatic;
};

/// The turns that the tangents of one pair suggest.
void add_starts(std::vector<Start>& starts, const RotationTask& task, Direction allowed, bool alone) {
  const Samples& a = task.fine.a;
  const Samples& b = task.fine.b;
  const std::size_t m = std::min(kMostTangents, std::max(a.chords(), b.chords()));
  const std::vector<double> rows_a = mean_tangents(a, m);
  for (const Direction direction : {Direction::forward, Direction::reversed}) {
    if (allowed != Direction::automatic && allowed != direction) continue;
    const std::vector<double> rows_b = mean_tangents(direction == Direction::reversed ? reversed(b) : b, m);
    for (RotationCandidate& c :
         rotation_candidates(rows_a, rows_b, a.dim(), task.layout != Layout::open, kMostCandidates)) {
      const bool known = std::any_of(starts.begin(), starts.end(), [&](const Start& start) {
        return (!alone || start.direction == direction) && same_rotation(start.rotation, c.rotation);
      });
      // Several pairs need not run in one direction.
      if (!known) starts.push_back({std::move(c.rotation), alone ? direction : Direction::automatic});
    }
  }
}

/// The identity first.
std::vector<Start> list_starts(std::span<const RotationTask> tasks, const std::vector<double>& weights,
                               const MatchOptions& options) {
  std::vector<Start> starts = {{Rotation(tasks.front().fine.a.dim()), Direction::automatic}};
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t x, std::size_t y) { return weights[x] > weights[y]; });
  for (std::size_t k = 0; k < std::min(kMostSources, order.size()); ++k) {
    add_starts(starts, tasks[order[k]], options.direction, tasks.size() == 1);
  }
  return starts;
}

/// From every start to its local optimum, on the coarse samples. The first trial is the identity as it is.
std::vector<Trial> survey(const Matcher& matcher, const std::vector<Start>& starts,
                          const MatchOptions& options, RisingProgress& progress) {
  std::vector<Trial> trials(starts.size() + 1, Trial{starts.front().rotation, {}, {}, {}, false});
  const Progress standing = progress.standing();
  const auto ask = [&]() -> const Progress& { return standing; };
  parallel_for(static_cast<int>(starts.size()), options.threads, [&](int k) {
    const Start& start = starts[static_cast<std::size_t>(k)];
    trials[static_cast<std::size_t>(k) + 1] = matcher.run(start.rotation, start.direction, 1, standing);
  });
  trials.front() = trials[1];
  double limit = std::numeric_limits<double>::infinity();
  if (options.coarse_to_fine) {
    for (const Trial& trial : trials) limit = std::min(limit, (1.0 + kHopeful) * trial.goodness.sum());
  }
  parallel_for(static_cast<int>(starts.size()), options.threads, [&](int k) {
    Trial& trial = trials[static_cast<std::size_t>(k) + 1];
    if (trial.goodness.sum() <= limit) trial = matcher.improve(std::move(trial), 1, ask);
  });
  return trials;
}

/// The trials that may turn out best on the fine samples, best first, each optimum once.
std::vector<Trial> finalists(std::vector<Trial> trials) {
  std::vector<Trial> kept;
  while (!trials.empty() && kept.size() < kMostFinalists) {
    const auto best = std::min_element(trials.begin(), trials.end(), preferable);
    const Trial next = std::move(*best);
    trials.erase(best);
    kept.push_back(next);
    const double limit = (1.0 + kFinalistShare) * kept.front().goodness.sum() + kFinalistCost;
    std::erase_if(trials, [&](const Trial& trial) {
      return trial.goodness.sum() > limit || !clearly_better(next.goodness, trial.goodness) ||
             same_rotation(trial.rotation, next.rotation, kSameOptimum);
    });
  }
  return kept;
}

}  // namespace

void check_turnable(const Norm& norm) {
  const auto* kind = std::get_if<NormKind>(&norm);
  if (kind == nullptr || *kind != NormKind::ruled) return;
  throw InvalidArgument("the ruled norm knows no rotation: rulings join the curves where they lie");
}

FoundRotation find_rotation(std::span<const RotationTask> tasks, const MatchOptions& options,
                            double least_gain) {
  const Rotation identity(tasks.front().fine.a.dim());
  RisingProgress progress(options.progress);
  const Matcher coarse(tasks, options, true);
  std::vector<Trial> trials =
      survey(coarse, list_starts(tasks, coarse.weights(), options), options, progress);
  const auto stopped = [](const Trial& trial) { return trial.cancelled; };
  if (std::any_of(trials.begin(), trials.end(), stopped)) return {identity, {}, true};

  const double unturned = trials.front().goodness.sum();
  const std::vector<Trial> best = finalists(std::move(trials));
  if (least_gain > 0.0 && best.front().goodness.sum() > (1.0 - least_gain) * unturned) {
    return {identity, {}, false};
  }
  if (options.coarse_to_fine) return {best.front().rotation, {}, false};

  const Matcher fine(tasks, options, false);
  const auto step = [&] { return progress.step(); };
  std::optional<Trial> winner;
  for (const Trial& start : best) {
    Trial trial = fine.run(start.rotation, Direction::automatic, options.threads, step());
    trial = fine.improve(std::move(trial), options.threads, step);
    if (trial.cancelled) return {identity, {}, true};
    if (!winner || preferable(trial, *winner)) winner = std::move(trial);
  }
  // What the coarse samples promised need not hold for all of them.
  if (least_gain > 0.0) {
    const Trial straight = fine.run(identity, Direction::automatic, options.threads, step());
    if (straight.cancelled) return {identity, {}, true};
    if (winner->goodness.sum() > (1.0 - least_gain) * straight.goodness.sum()) return {identity, {}, false};
  }
  return {std::move(winner->rotation), std::move(winner->found), false};
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
