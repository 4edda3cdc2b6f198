#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "tandem/shape/cubic_path.h"
#include "tandem/shape/path_view.h"
#include "tandem/shape/transform.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// How finely curves are looked at, as shares of `scale`.
struct IntersectionOptions {
  /// Largest distance of a curve from the polyline that stands for it. Its pieces turn by no more than 0.09
  /// rad as well, down to a length of 2e-5, so that loops smaller than the tolerance are seen.
  double tolerance = 1e-4;
  /// How far each of two edges must reach beyond the other on both sides to cross it. What stays within it,
  /// a touch or a stretch run through twice, is no crossing.
  double epsilon = 1e-5;
  /// The length (absolute) that the two are shares of; 0: the diagonal of the box of all control points.
  /// In-betweens of one morph should all be measured by the same.
  double scale = 0.0;
  /// Whether crossings of two different paths count.
  bool between = true;
};

/// Where a path crosses itself or another one.
struct Crossing {
  std::size_t path_a = 0;  ///< path_a <= path_b
  std::size_t path_b = 0;
  double u = 0.0;  ///< parameter in path_a, in [0, segment_count]; u <= v on the same path
  double v = 0.0;  ///< parameter in path_b; equals u where a path turns back on the spot and runs over itself
  Vec2 point;      ///< on path_a, at u

  friend bool operator==(const Crossing&, const Crossing&) = default;
};

/// Finds where planar paths cross, without an allocation once it has seen as many paths before. Paths that
/// are the same as in the last call, where all are measured by the same scale, are not looked at again.
///
/// The curves are halved until they are as good as their chords, the chords are gathered into runs that are
/// monotone in both coordinates, and the boxes of the runs are swept from left to right. Crossings right
/// through a vertex are decided on a small circle about it. Where a cubic turns back on the spot (a cusp) and
/// both its branches run within epsilon of each other for ten epsilons, that counts as a crossing, too; at a
/// joint it does not, as thin tips are drawn like that on purpose.
///
/// Not for several threads at once: each takes its own.
class TANDEM_EXPORT CrossingFinder {
 public:
  /// @throws InvalidArgument tolerance or epsilon is not in (0, 1), or scale is not finite and >= 0
  explicit CrossingFinder(const IntersectionOptions& options = {});
  ~CrossingFinder();
  CrossingFinder(CrossingFinder&&) noexcept;
  CrossingFinder& operator=(CrossingFinder&&) noexcept;
  CrossingFinder(const CrossingFinder&) = delete;
  CrossingFinder& operator=(const CrossingFinder&) = delete;

  /// Ends at the `limit`-th crossing found; valid until the next call. Parameters are within tolerance.
  [[nodiscard]] std::span<const Crossing> find(std::span<const PathView> paths,
                                               std::size_t limit = std::numeric_limits<std::size_t>::max());
  [[nodiscard]] bool is_simple(std::span<const PathView> paths) { return find(paths, 1).empty(); }

  /// Share of the region of nonzero winding number whose winding number is not the dominant one of +1 and -1:
  /// where closed contours that ought to be simple and oriented consistently lie over themselves or each
  /// other. From 160 scanlines; open paths count as closed by a line. 0 where nothing is enclosed.
  [[nodiscard]] double fold_fraction(std::span<const PathView> paths);

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

/// All crossings, sorted by path_a, path_b, u, v. Where the curves cross at a clear angle, u and v are
/// refined on the curves to rounding.
/// @throws InvalidArgument a path is not planar, or see CrossingFinder
[[nodiscard]] TANDEM_EXPORT std::vector<Crossing> find_crossings(std::span<const CubicPath> paths,
                                                                 const IntersectionOptions& options = {});

/// Whether there is none. @throws as find_crossings
[[nodiscard]] TANDEM_EXPORT bool is_simple(std::span<const CubicPath> paths,
                                           const IntersectionOptions& options = {});

/// CrossingFinder::fold_fraction. @throws InvalidArgument a path is not planar
[[nodiscard]] TANDEM_EXPORT double fold_fraction(std::span<const CubicPath> paths);

}  // namespace v0
}  // namespace tandem
