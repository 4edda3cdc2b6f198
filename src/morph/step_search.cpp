#include "morph/step_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include "morph/clearance.h"
#include "morph/measures.h"
#include "morph/score.h"
#include "morph/settle_blend.h"
#include "morph/step_variants.h"
#include "morph/turn_price.h"
#include "morph/wants_turns.h"
#include "tandem/match/rotation.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// A turn smaller than this, in degrees, is left to the blend.
constexpr double kLeastTurn = 0.5;
// How many contours of the best candidates are sent on detours, all in all, when none is free of faults.
constexpr std::size_t kDetours = 300;
// Asymmetry, in shares of the length, that nobody sees.
constexpr double kSymmetric = 0.004;
// How many are sent on detours to avoid nothing but a turn, and the blemishes of what is worth it.
constexpr std::size_t kUprightDetours = 300;
constexpr double kDear = 0.4;
// How many of the best candidates are looked at with contours parted that have little in common, how many
// contours are sent on detours then, and which width of a detour asks for it.
constexpr std::size_t kParted = 6;
constexpr std::size_t kPartedDetours = 100;
constexpr double kWide = 0.02;
// When so many of the in-betweens stay at fault, nobody steps aside for the rest.
constexpr int kHopeless = 10;
// Where others are looked at to keep clear of them.
constexpr double kMeetings[] = {0.5, 0.3, 0.7};
// Widths of the smoothing, as shares of the length: each so much wider than the one before.
constexpr double kNarrowest = 0.003;
constexpr double kWidest = 0.2;
constexpr double kWiden = 1.35;
// Segments are cut to this share of the length to be smoothed.
constexpr double kLongestSegment = 0.04;

/// A candidate as it is blended, and what came of it.
struct Entry {
  std::size_t candidate;
  BlendKind kind;
  Score score;
};

class StepSearch {
 public:
  StepSearch(const StepKey& a, const StepKey& b, const MorphOptions& options)
      : keys_(a, b, options.pins),
        options_(options),
        blend_(settle_blend(options)),
        kinds_(kinds_of(blend_)),
        judge_(keys_.diagonal()) {}

  std::optional<FoundStep> run() {
    if (!try_all() || !try_mirrored() || !try_cuts() || !try_mirrored()) return std::nullopt;
    const bool may_detour = blend_ == BlendKind::automatic || blend_ == BlendKind::detour;
    const std::vector<Entry> plain = entries_;
    if (may_detour && best_score_.faults > 0 && !make_detours(kDetours)) return std::nullopt;
    if (may_detour && (best_score_.faults > 0 || width_of(best_) > kWide) && !part_unlike(plain))
      return std::nullopt;
    if (may_detour && is_turned_for_nothing() && !stay_upright()) return std::nullopt;
    return std::move(best_);
  }

 private:
  bool make_detours(std::size_t most) {
    // Pieces that shrink or step aside leave a gap: what has none comes first.
    const auto has_pieces = [&](const Entry& entry) {
      const std::vector<FoundContour>& all = candidates_[entry.candidate].contours;
      return std::any_of(all.begin(), all.end(), [](const FoundContour& c) { return c.is_piece(); });
    };
    std::stable_sort(entries_.begin(), entries_.end(), [&](const Entry& x, const Entry& y) {
      const bool pieces_x = has_pieces(x);
      return pieces_x != has_pieces(y) ? !pieces_x : x.score.better_than(y.score);
    });
    const std::size_t contours = candidates_.front().contours.size();
    entries_.resize(std::min(entries_.size(), std::max<std::size_t>(most / contours, 1)));
    return keep_clear() && smooth();
  }

  // Whether what is no turned copy turns visibly, maybe only to keep clear of faults.
  [[nodiscard]] bool is_turned_for_nothing() const {
    return best_score_.blemish > kDear && turns_much(best_.candidate);
  }
  static bool turns_much(const StepCandidate& candidate) {
    return detail::turns_much(candidate.frame.degrees());
  }

  // A small detour of an upright morph is less to be seen than a turn.
  bool stay_upright() {
    const auto turned = [&](const Entry& entry) { return turns_much(candidates_[entry.candidate]); };
    entries_.erase(std::remove_if(entries_.begin(), entries_.end(), turned), entries_.end());
    if (entries_.empty()) return true;
    for (Entry& entry : entries_) {  // they were looked at until they were known to be worse
      const StepCandidate& candidate = candidates_[entry.candidate];
      entry.score = judge_.judge(candidate.blend(entry.kind), {}, candidate.asymmetry);
    }
    FoundStep known = std::exchange(best_, {});
    const Score score = std::exchange(best_score_, {});
    if (!make_detours(kUprightDetours)) return false;
    if (is_better_upright(best_score_, width_of(best_), score)) return true;
    best_ = std::move(known);
    best_score_ = score;
    return true;
  }

  static double width_of(const FoundStep& step) {
    double width = 0.0;
    for (const FoundContour& contour : step.candidate.contours) width = std::max(width, contour.detour.width);
    return width;
  }

  // Looks at the candidate with more and more of its pairs parted, until that frees it of faults.
  void part(const Entry& entry) {
    for (std::size_t count = 1; best_score_.faults > 0; ++count) {
      auto parted = keys_.parted(candidates_[entry.candidate], *turned_[entry.candidate], count);
      if (!parted) break;
      candidates_.push_back(*std::move(parted));
      consider(candidates_.back(), entry.kind, candidates_.size() - 1);
    }
  }

  // Where contours that have little in common get into each other's way for being pairs: they die and are
  // born instead. entries: before detours
  bool part_unlike(std::vector<Entry> entries) {
    FoundStep known = std::exchange(best_, {});
    const Score score = std::exchange(best_score_, {});
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& x, const Entry& y) { return x.score.better_than(y.score); });
    std::vector<Entry> tight = std::exchange(entries_, {});
    // What is turned parts only where nothing upright comes of it.
    for (const bool turned : {false, true}) {
      std::size_t looked_at = 0;
      for (const Entry& entry : entries) {
        if (entry.candidate >= turned_.size() || !turned_[entry.candidate]) continue;
        if (turns_much(candidates_[entry.candidate]) != turned) continue;
        if (++looked_at > kParted) break;
        part(entry);
      }
      if (!entries_.empty() && best_score_.faults > 0 && !make_detours(kPartedDetours)) return false;
      tight.insert(tight.end(), entries_.begin(), entries_.end());
      entries_.clear();
      if (best_score_.faults == 0) break;
    }
    entries_ = std::move(tight);
    const auto price = [](const Score& of, const FoundStep& step) {
      return of.blemish + width_price(width_of(step));
    };
    const bool better = best_score_.faults != score.faults ? best_score_.faults < score.faults
                                                           : price(best_score_, best_) < price(score, known);
    if (better) return true;
    best_ = std::move(known);
    best_score_ = score;
    return true;
  }

  // False when the caller wants to stop.
  [[nodiscard]] bool go_on(double fraction) const {
    return !options_.match.progress || options_.match.progress(fraction);
  }

  bool try_all() {
    const MatchOptions& own = options_.match;
    std::vector<MatchOptions> variants = variants_of(own);
    const Rotation given = own.rotation.empty() ? Rotation(2) : Rotation(2, own.rotation);
    std::vector<Turned> turns{keys_.pair(given, own)};
    if (wants_turns(own)) {
      const Rotation turn = keys_.find_turn(own);
      if (std::fabs(turn.degrees()) > kLeastTurn) turns.push_back(keys_.pair(turn, own));
    }
    for (const Turned& turned : turns) trials_.push_back({&keys_, turned});
    variants_ = std::move(variants);
    return try_trials(0.0, 0.4);
  }

  // One against several, cut into as many pieces. The papers' methods match what is there.
  bool try_cuts() {
    if (!options_.cuts || !options_.pins.empty() || options_.match.method != Method::elastic) return true;
    std::vector<Trial> trials;
    for (const Trial& whole : trials_) {
      std::optional<CutKeys> cut = keys_.cut(whole.turned);
      if (!cut) continue;
      cut_.push_back(std::make_unique<StepKeys>(keys_, *std::move(cut)));
      trials.push_back({cut_.back().get(), cut_.back()->pair(whole.turned.turn, options_.match)});
    }
    trials_ = std::move(trials);
    return try_trials(0.4, 0.1);
  }

  // Halves that are each other's mirror images, where the best correspondence so far does not keep a symmetry
  // that both keys have.
  bool try_mirrored() {
    if (!may_vary(options_.match) || best_.candidate.asymmetry <= kSymmetric) return true;
    return try_trials(0.4, 0.0, true);
  }

  // done, share: of the whole work, for the progress.
  bool try_trials(double done, double share, bool mirrored = false) {
    const Progress& progress = options_.match.progress;
    const double part =
        share / static_cast<double>(variants_.size() * std::max<std::size_t>(trials_.size(), 1));
    for (MatchOptions& variant : variants_) {
      for (const Trial& trial : trials_) {
        if (mirrored && !trial.keys->has_mirror(trial.turned)) continue;
        if (progress) {
          variant.progress = [&, done](double fraction) { return progress(done + part * fraction); };
        }
        std::optional<StepCandidate> candidate = trial.keys->match(trial.turned, variant, mirrored);
        done += part;
        if (!candidate || !go_on(done)) return false;
        if (options_.match.coarse_to_fine) mark_inexact(*candidate);
        const bool known = is_known(*candidate);
        turned_.resize(candidates_.size());
        turned_.push_back(trial.keys == &keys_ ? std::optional(trial.turned) : std::nullopt);
        candidates_.push_back(*std::move(candidate));
        if (known) continue;
        for (const BlendKind kind : kinds_) consider(candidates_.back(), kind, candidates_.size() - 1);
      }
      // Whoever is in a hurry turns no more when the first way of matching was better without.
      if (!mirrored && options_.match.coarse_to_fine && candidates_.size() == 2 && trials_.size() == 2 &&
          best_index_ == 0) {
        trials_.pop_back();
      }
    }
    return true;
  }

  // Whether another way of matching has led to the same joints: the in-betweens are the same, too.
  [[nodiscard]] bool is_known(const StepCandidate& candidate) const {
    const auto same = [](const FoundContour& x, const FoundContour& y) {
      return x.ends.a == y.ends.a && x.ends.b == y.ends.b;
    };
    return std::any_of(candidates_.begin(), candidates_.end(), [&](const StepCandidate& other) {
      return other.frame.degrees() == candidate.frame.degrees() &&
             std::equal(other.contours.begin(), other.contours.end(), candidate.contours.begin(),
                        candidate.contours.end(), same);
    });
  }

  // Some of the matches may be the optimum: that they were chosen, and under which turn, is not.
  static void mark_inexact(StepCandidate& candidate) {
    for (FoundContour& contour : candidate.contours) {
      if (contour.match) contour.match->found.report.exact = false;
    }
  }

  void consider(const StepCandidate& candidate, BlendKind kind, std::size_t index) {
    const Score score = judge_.judge(candidate.blend(kind), best_score_, candidate.asymmetry);
    entries_.push_back({index, kind, score});
    if (score.better_than(best_score_)) best_index_ = index;
    keep(candidate, kind, score);
  }

  void keep(const StepCandidate& candidate, BlendKind kind, const Score& score) {
    if (!score.better_than(best_score_)) return;
    best_score_ = score;
    best_ = {kind, candidate};
  }

  // Contours that get into each other's way shrink and step aside, until one candidate is free of faults.
  bool keep_clear() {
    for (std::size_t e = 0; e < entries_.size() && best_score_.faults > 0; ++e) {
      Entry& entry = entries_[e];
      StepCandidate own = candidates_[entry.candidate];
      if (own.contours.size() < 2) return true;
      const double done = 0.5 + 0.25 * static_cast<double>(e) / static_cast<double>(entries_.size());
      Score score = judge_.judge(own.blend(entry.kind), {}, own.asymmetry);
      const Score plain = score;
      StepCandidate late = own;
      if (!clear(own, entry.kind, score, done)) return false;
      if (score.faults > kHopeless) {
        own = late;
        score = plain;
      }
      if (score.faults > 0 && keep_lonely_small(late)) {
        Score now = judge_.judge(late.blend(entry.kind), {}, late.asymmetry);
        if (!clear(late, entry.kind, now, done)) return false;
        if (now.better_than(score)) {
          score = now;
          own = std::move(late);
        }
      }
      keep(own, entry.kind, score);
      // What is left may be smoothed.
      entry = {candidates_.size(), entry.kind, score};
      candidates_.push_back(std::move(own));
    }
    return true;
  }

  bool clear(StepCandidate& own, BlendKind kind, Score& score, double done) {
    const std::vector<std::size_t> order = all_but_the_largest(own);
    StepBlend blend = own.blend(kind);
    for (const double s : kMeetings) {
      for (const std::size_t c : order) {
        if (score.faults == 0) return true;
        if (!go_on(done)) return false;
        const bool late = own.contours[c].detour.late;
        blend.set_detour(c, {.late = late});
        ContourDetour detour = clearance_.find(blend, c, s);
        detour.late = late;
        blend.set_detour(c, detour);
        if (const std::optional<Score> now = judge_.beat(blend, score, own.asymmetry)) {
          score = *now;
          own.contours[c].detour = detour;
        } else {
          blend.set_detour(c, own.contours[c].detour);
        }
      }
    }
    return true;
  }

  // What is born or dies keeps small for longer, but for lines, which may cross. False when nothing does.
  static bool keep_lonely_small(StepCandidate& candidate) {
    bool any = false;
    for (FoundContour& contour : candidate.contours) {
      contour.detour.late = !contour.match && contour.ends.a.is_closed();
      any = any || contour.detour.late;
    }
    return any;
  }

  // The largest first.
  static std::vector<std::size_t> all_but_the_largest(const StepCandidate& candidate) {
    std::vector<std::pair<double, std::size_t>> sizes;
    for (std::size_t c = 0; c < candidate.contours.size(); ++c) {
      const ContourEnds& ends = candidate.contours[c].ends;
      sizes.emplace_back(
          -path_length(ends.a.control_points().data()) - path_length(ends.b.control_points().data()), c);
    }
    std::sort(sizes.begin(), sizes.end());
    std::vector<std::size_t> order;
    for (std::size_t k = 1; k < sizes.size(); ++k) order.push_back(sizes[k].second);
    return order;
  }

  // The least smoothing of any candidate that leaves no fault.
  bool smooth() {
    if (best_score_.faults == 0) return true;
    double least = kWidest;
    for (std::size_t e = 0; e < entries_.size(); ++e) {
      StepCandidate fine = subdivided(candidates_[entries_[e].candidate], kLongestSegment);
      StepBlend blend = fine.blend(entries_[e].kind);
      for (double width = kNarrowest; width < least; width *= kWiden) {
        if (!go_on(0.75 + 0.25 * static_cast<double>(e) / static_cast<double>(entries_.size()))) return false;
        for (std::size_t c = 0; c < fine.contours.size(); ++c) {
          fine.contours[c].detour.width = width;
          blend.set_detour(c, fine.contours[c].detour);
        }
        const std::optional<Score> score = judge_.find_faultless(blend, fine.asymmetry);
        if (!score) continue;
        least = width;
        best_score_ = *score;
        best_ = {entries_[e].kind, fine};
      }
    }
    return true;
  }

  /// Keys, whole or in pieces, under a turn.
  struct Trial {
    const StepKeys* keys;
    Turned turned;
  };

  StepKeys keys_;
  std::vector<std::unique_ptr<const StepKeys>> cut_;
  std::vector<Trial> trials_;
  std::vector<MatchOptions> variants_;
  const MorphOptions& options_;
  BlendKind blend_;
  std::vector<BlendKind> kinds_;
  Judge judge_;
  Clearance clearance_;
  std::vector<StepCandidate> candidates_;
  std::vector<std::optional<Turned>> turned_;  ///< of candidates: who becomes whom, where nobody is in pieces
  std::vector<Entry> entries_;
  Score best_score_;
  std::size_t best_index_ = 0;  ///< of the best candidate, before detours
  FoundStep best_;
};

}  // namespace

std::optional<FoundStep> find_step(const StepKey& a, const StepKey& b, const MorphOptions& options) {
  return StepSearch(a, b, options).run();
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
