#include "tandem/rank/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "match/nearest_rotation.h"
#include "match/rotation_candidates.h"
#include "rank/pair_cost.h"
#include "rank/tangent_planes.h"
#include "rank/variant.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {

namespace {

using detail::Chords;
using detail::Fit;
using detail::Variant;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Turns to begin with, per variant. Beyond four the best one is hardly ever another.
constexpr int kTurns = 4;
/// Matching and turning in alternation: it mostly ends after two rounds, and need not go on for ever.
constexpr int kRounds = 8;
/// What brings less than this is not worth another round; and turns this close are equally good, so that the
/// first stays: the one that is not mirrored, and the smaller one of a symmetric shape. Relative, and
/// absolute (the cost of being turned by 0.8 degrees).
constexpr double kWorthIt = 1e-3;
constexpr double kLeastGain = 1e-4;

/// The query as it is laid on the candidate.
struct Pose {
  const Variant* variant = nullptr;
  Rotation rotation = Rotation(2);
  double cost = kInfinity;
  Fit fit;
};

/// The best turn of the query's variants against one candidate: found with few chords, improved with all.
class Search {
 public:
  Search(const ShapeDescriptor& candidate, const Variant& own, const CompareOptions& options)
      : dim_(candidate.dim()), closed_(candidate.is_closed()), own_(own), options_(options) {}

  /// Without turns: the variant as it lies.
  void compare(const Variant& variant, double limit) {
    std::optional<Fit> fit = fit_pair({variant.tangents, variant.lengths}, chords(Level::all), closed_,
                                      options_, std::min(limit, best_.cost));
    if (fit && fit->cost < best_.cost) best_ = {&variant, Rotation(dim_), fit->cost, *std::move(fit)};
  }

  /// The variant at every turn that cross-correlation suggests.
  void suggest(const Variant& variant) {
    const std::vector<detail::RotationCandidate> turns =
        detail::rotation_candidates(joined(variant.coarse), joined(own_.coarse), dim_, closed_, kTurns);
    for (const detail::RotationCandidate& turn : turns)
      attempt(Level::few, variant, turn.rotation, worth_it());
    // Tangents that cancel out favour no turn.
    if (turns.empty()) attempt(Level::few, variant, Rotation(dim_), 0.0);
  }

  void improve() {
    if (best_.variant == nullptr) return;
    alternate(Level::few);
    const Pose coarse = std::exchange(best_, {});
    attempt(Level::all, *coarse.variant, coarse.rotation, 0.0);
    if (best_.variant != nullptr) alternate(Level::all);
  }

  [[nodiscard]] const Pose& best() const { return best_; }

 private:
  enum class Level { few, all };

  [[nodiscard]] static Chords chords_of(Level level, const Variant& variant) {
    if (level == Level::few) return {variant.coarse, variant.coarse_lengths};
    return {variant.tangents, variant.lengths};
  }
  [[nodiscard]] double worth_it() const {
    return best_.variant == nullptr ? 0.0 : std::max(kWorthIt * best_.cost, kLeastGain);
  }
  [[nodiscard]] Chords chords(Level level) const { return chords_of(level, own_); }

  [[nodiscard]] static std::vector<double> joined(const detail::TangentPlanes& tangents) {
    std::vector<double> planes;
    for (const std::vector<double>& plane : tangents.planes)
      planes.insert(planes.end(), plane.begin(), plane.end());
    return planes;
  }

  void attempt(Level level, const Variant& variant, const Rotation& rotation, double least_gain) {
    const Chords as_it_lies = chords_of(level, variant);
    const detail::TangentPlanes turned = detail::turned(as_it_lies.tangents, rotation);
    const double limit = best_.variant == nullptr ? kInfinity : best_.cost - least_gain;
    std::optional<Fit> fit = fit_pair({turned, as_it_lies.lengths}, chords(level), closed_, options_, limit);
    if (fit && fit->cost < best_.cost) best_ = {&variant, rotation, fit->cost, *std::move(fit)};
  }

  /// Turns the best path's tangents onto one another and matches again, until that brings no more.
  void alternate(Level level) {
    for (int round = 0; round < kRounds; ++round) {
      const Variant& variant = *best_.variant;
      const Chords as_it_lies = chords_of(level, variant);
      const detail::TangentPlanes turned = detail::turned(as_it_lies.tangents, best_.rotation);
      const std::vector<double> sum =
          detail::covariance({turned, as_it_lies.lengths}, chords(level), options_, best_.fit);
      const Rotation further = detail::nearest_rotation(sum, dim_).rotation;
      const double before = best_.cost;
      const double gain = worth_it();
      attempt(level, variant, detail::product(further, best_.rotation), 0.0);
      if (!(best_.cost < before - gain)) return;
    }
  }

  int dim_;
  bool closed_;
  const Variant& own_;
  const CompareOptions& options_;
  Pose best_;
};

}  // namespace

struct ShapeComparer::Impl {
  ShapeDescriptor query;
  CompareOptions options;
  bool turns = false;
  std::vector<Variant> variants;

  /// Two closed planar curves that both run counter-clockwise are compared in that direction; a mirrored
  /// one has turned round and is reversed. Everything else may run either way.
  [[nodiscard]] bool applies(const Variant& variant, const ShapeDescriptor& candidate) const {
    return !(query.is_oriented() && candidate.is_oriented()) || variant.mirrored == variant.reversed;
  }

  /// @throws InvalidArgument
  void check_comparable(const ShapeDescriptor& candidate) const {
    if (candidate.dim() == query.dim() && candidate.is_closed() == query.is_closed()) return;
    const auto words = [](const ShapeDescriptor& shape) {
      return fmt::format("{} curve of dimension {}", shape.is_closed() ? "a closed" : "an open", shape.dim());
    };
    throw InvalidArgument(fmt::format("{} cannot be compared with {}", words(query), words(candidate)));
  }
};

ShapeComparer::ShapeComparer(ShapeDescriptor query, const CompareOptions& options) {
  if (!(options.charge >= 0.0 && std::isfinite(options.charge))) {
    throw InvalidArgument(
        fmt::format("the charge for a step that is not diagonal must be at least 0, not {}", options.charge));
  }
  Impl impl{std::move(query), options, false, {}};
  impl.turns = options.rotate && impl.query.dim() > 1;
  impl.options.rotate = impl.turns;
  for (const bool mirrored : {false, true}) {
    for (const bool reversed : {false, true}) {
      if (mirrored && !options.mirror) continue;
      impl.variants.push_back(detail::make_variant(impl.query, mirrored, reversed, impl.options));
    }
  }
  impl_ = std::make_unique<const Impl>(std::move(impl));
}

ShapeComparer::ShapeComparer(ShapeComparer&&) noexcept = default;
ShapeComparer& ShapeComparer::operator=(ShapeComparer&&) noexcept = default;
ShapeComparer::~ShapeComparer() = default;

const ShapeDescriptor& ShapeComparer::query() const noexcept {
  return impl_->query;
}

bool ShapeComparer::is_comparable(const ShapeDescriptor& candidate) const noexcept {
  return candidate.dim() == impl_->query.dim() && candidate.is_closed() == impl_->query.is_closed();
}

double ShapeComparer::lower_bound(const ShapeDescriptor& candidate) const {
  impl_->check_comparable(candidate);
  if (candidate.dim() != 2) return 0.0;
  const detail::DirectionBound own(detail::to_planes(candidate.tangents()),
                                   detail::node_weights(candidate.lengths(), impl_->options));
  double least = kInfinity;
  for (const Variant& variant : impl_->variants) {
    if (impl_->applies(variant, candidate))
      least = std::min(least, detail::DirectionBound::lower_bound(variant.bound, own, impl_->options));
  }
  return std::max(0.0, least);
}

std::optional<Comparison> ShapeComparer::compare(const ShapeDescriptor& candidate, double limit) const {
  impl_->check_comparable(candidate);
  const Variant own = detail::make_variant(candidate, false, false, impl_->options);
  Search search(candidate, own, impl_->options);
  for (const Variant& variant : impl_->variants) {
    if (!impl_->applies(variant, candidate)) continue;
    if (impl_->turns) {
      search.suggest(variant);
    } else {
      search.compare(variant, limit);
    }
  }
  if (impl_->turns) search.improve();
  const Pose& best = search.best();
  if (best.variant == nullptr || best.fit.path.empty() || best.cost > limit) {
    // No turn at all fits (tangents that cancel out), or no elastic path spans the numbers of nodes.
    if (limit < kInfinity) return std::nullopt;
    return Comparison{.cost = best.cost, .rotation = Rotation(candidate.dim())};
  }
  return Comparison{best.cost, best.rotation, best.variant->mirrored, best.variant->reversed,
                    best.fit.path.front().i};
}

Comparison compare(const ShapeDescriptor& query, const ShapeDescriptor& candidate,
                   const CompareOptions& options) {
  return *ShapeComparer(query, options).compare(candidate);
}

}  // namespace v0
}  // namespace tandem
