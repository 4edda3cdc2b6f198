#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "match/match_samples.h"
#include "morph/contour_pairs.h"
#include "morph/cut_keys.h"
#include "morph/mirror.h"
#include "morph/step_candidate.h"
#include "tandem/curve/curve.h"
#include "tandem/match/match.h"
#include "tandem/match/rotation.h"
#include "tandem/morph/morph.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/nesting.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A key of a step.
struct StepKey {
  std::span<const CubicPath> contours;  ///< none empty; consistently wound, see orient()
  Vec2 center;                          ///< what the frame turns about
};

/// A turn, and who becomes whom under it.
struct Turned {
  Rotation turn;
  std::vector<ContourPair> pairs;
};

/// The contours of the two keys of a step, and what candidates need to know of them.
class StepKeys {
 public:
  /// @throws InvalidArgument pins that want a contour to become two
  StepKeys(const StepKey& a, const StepKey& b, std::span<const MorphPin> pins);
  /// The same keys in parts.
  StepKeys(const StepKeys& whole, CutKeys cut);

  /// The keys cut for these pairs, see cut_keys().
  [[nodiscard]] std::optional<CutKeys> cut(const Turned& turned) const;

  /// Diagonal of the box of both keys.
  [[nodiscard]] double diagonal() const;
  [[nodiscard]] Turned pair(const Rotation& turn, const MatchOptions& options) const;
  /// The common turn of all contours, found from the longest ones first, which tell who becomes whom.
  [[nodiscard]] Rotation find_turn(const MatchOptions& options) const;
  /// Matches the pairs, each in the parameters of the paths, and aligns them; nothing when cancelled.
  /// mirrored: contours with a common axis of symmetry axis on axis, one half as the other's mirror image.
  [[nodiscard]] std::optional<StepCandidate> match(const Turned& turned, const MatchOptions& options,
                                                   bool mirrored = false) const;
  /// The candidate with the pairs that have least in common parted, so many of them: one dies, the other one
  /// is born. Never the longest pair, nor lines, and none where pins hold them: nothing when there are not as
  /// many. candidate: of match() under this turn
  [[nodiscard]] std::optional<StepCandidate> parted(const StepCandidate& candidate, const Turned& turned,
                                                    std::size_t parted) const;
  /// Whether a pair has an axis of symmetry in common under its turn.
  [[nodiscard]] bool has_mirror(const Turned& turned) const;

 private:
  struct Key {
    explicit Key(const StepKey& key);
    [[nodiscard]] std::size_t longest() const;
    [[nodiscard]] Vec2 on_strokes(Vec2 point) const;

    Key(std::vector<KeyPart> parts, const Key& whole);

    std::vector<CubicPath> paths;
    std::vector<std::size_t> sources;  ///< whose piece each is, or itself
    std::vector<std::optional<CubicPath>> outlines;
    std::vector<Curve> curves;
    std::vector<std::vector<Mirror>> mirrors;
    std::vector<NestedContour> nesting;
    Vec2 center;
    double gyration;  ///< radius of gyration about the centre
  };
  /// A pin on the outlines.
  struct Pin {
    std::size_t a;
    std::size_t b;
    ParameterPair at;
  };
  void locate(const MorphPin& pin);
  void add_lonely(StepCandidate& candidate, const Turned& turned) const;
  /// Whether all matches with options like these look at the same samples.
  [[nodiscard]] static bool can_share(const MatchOptions& options);
  [[nodiscard]] const MatchSamples& samples_of(std::size_t a, std::size_t b,
                                               const MatchOptions& options) const;
  /// Nothing where options leave no choice.
  [[nodiscard]] std::optional<SharedMirror> shared_mirror_of(const ContourPair& pair,
                                                             const Rotation& turn) const;
  void add_asymmetry(StepCandidate& candidate, const Turned& turned) const;
  /// match() of two contours.
  [[nodiscard]] FoundMatch match_pair(std::size_t a, std::size_t b, const MatchOptions& options) const;

  Key a_;
  Key b_;
  std::vector<Pin> pins_;
  /// By contours: taken once for all candidates. Not for several threads at once.
  mutable std::map<std::pair<std::size_t, std::size_t>, MatchSamples> samples_;
};

}  // namespace detail
}  // namespace v0
}  // namespace tandem
