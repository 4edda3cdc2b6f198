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
/// A round that brings less than this, relative to the cost, is the last.
constexpr double kWorthARound = 1e-3;

/// The best that was found so far.
struct Best {
  double cost = kInfinity;
  const Variant* variant = nullptr;
  Rotation rotation = Rotation(2);
  Fit fit;
};

/// One query variant after the other against one candidate.
class Search {
 public:
  Search(const ShapeDescriptor& candidate, const Variant& own, const CompareOptions& options, bool turns)
      : candidate_(candidate), own_(own), options_(options), turns_(turns) {}

  /// Every turn to begin with; `limit` of those that are not improved afterwards.
  void begin(const Variant& variant, double limit) {
    if (!turns_) {
      attempt(variant, Rotation(candidate_.dim()), std::min(limit, best_.cost));
      return;
    }
    const std::vector<detail::RotationCandidate> turns = detail::rotation_candidates(
        variant.stretches, own_.stretches, candidate_.dim(), candidate_.is_closed(), kTurns);
    for (const detail::RotationCandidate& turn : turns) attempt(variant, turn.rotation, best_.cost);
    // Tangents that cancel out favour no turn.
    if (turns.empty()) attempt(variant, Rotation(candidate_.dim()), best_.cost);
  }

  /// Turns the best path's tangents onto one another and matches again, until that brings no more.
  void improve() {
    for (int round = 0; round < kRounds && turns_ && best_.variant != nullptr; ++round) {
      const double before = best_.cost;
      const Variant& variant = *best_.variant;
      const detail::TangentPlanes query = detail::turned(variant.tangents, best_.rotation);
      const std::vector<double> sum =
          detail::covariance({query, variant.lengths}, chords(), options_, best_.fit);
      const Rotation further = detail::nearest_rotation(sum, candidate_.dim()).rotation;
      attempt(variant, detail::product(further, best_.rotation), before);
      if (!(best_.cost < before * (1.0 - kWorthARound))) return;
    }
  }

  [[nodiscard]] const Best& best() const { return best_; }

 private:
  [[nodiscard]] Chords chords() const { return {own_.tangents, own_.lengths}; }

  void attempt(const Variant& variant, const Rotation& rotation, double limit) {
    const detail::TangentPlanes query =
        turns_ ? detail::turned(variant.tangents, rotation) : variant.tangents;
    std::optional<Fit> fit =
        detail::fit_pair({query, variant.lengths}, chords(), candidate_.is_closed(), options_, limit);
    if (!fit || !(fit->cost < best_.cost)) return;
    best_ = {fit->cost, &variant, rotation, *std::move(fit)};
  }

  const ShapeDescriptor& candidate_;
  const Variant& own_;
  const CompareOptions& options_;
  bool turns_;
  Best best_;
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

  /// Certain to cost more, before anything is matched.
  [[nodiscard]] bool is_hopeless(const ShapeDescriptor& candidate, const Variant& own, double limit) const {
    if (candidate.dim() != 2 || limit == kInfinity) return false;
    return std::all_of(variants.begin(), variants.end(), [&](const Variant& variant) {
      return !applies(variant, candidate) ||
             detail::DirectionBound::lower_bound(variant.bound, own.bound, options) > limit;
    });
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

std::optional<Comparison> ShapeComparer::compare(const ShapeDescriptor& candidate, double limit) const {
  if (!is_comparable(candidate)) {
    const auto words = [](const ShapeDescriptor& shape) {
      return fmt::format("{} curve of dimension {}", shape.is_closed() ? "a closed" : "an open", shape.dim());
    };
    throw InvalidArgument(
        fmt::format("{} cannot be compared with {}", words(impl_->query), words(candidate)));
  }
  const Variant own = detail::make_variant(candidate, false, false, impl_->options);
  if (impl_->is_hopeless(candidate, own, limit)) return std::nullopt;
  Search search(candidate, own, impl_->options, impl_->turns);
  for (const Variant& variant : impl_->variants) {
    if (impl_->applies(variant, candidate)) search.begin(variant, limit);
  }
  search.improve();
  const Best& best = search.best();
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
