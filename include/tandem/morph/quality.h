#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>

#include "tandem/morph/key_frames.h"
#include "tandem/morph/path_morph.h"
#include "tandem/shape/path_view.h"
#include "tandem/shape/transform.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// What may be wrong with an in-between.
enum class MorphFault {
  crossing,          ///< a contour crosses itself (CrossingFinder)
  crossing_between,  ///< two contours cross
  fold,              ///< closed contours lie over themselves or each other (CrossingFinder::fold_fraction)
};

struct QualityOptions {
  std::size_t key_count = 2;     ///< keys stand at equal distances in s, from 0 to 1
  std::size_t in_betweens = 20;  ///< between two keys, evenly spaced
  double largest_fold = 0.005;   ///< fold fraction above which an in-between counts as folded
  /// Joints that turn by no more than this (radians) in every key count as smooth.
  double smooth_angle = 0.05;
  /// The measurement ends when more in-betweens than this have a fault: of several candidates only those need
  /// be looked at to the end that may be the best.
  std::size_t most_faulty = std::numeric_limits<std::size_t>::max();
};

/// Where a morph has its first fault.
struct FaultPlace {
  MorphFault fault = MorphFault::crossing;
  double s = 0.0;
  std::optional<Vec2> point;  ///< of a crossing
};

/// How good the in-betweens of a planar morph are.
struct MorphQuality {
  std::size_t in_betweens = 0;       ///< measured
  std::size_t crossing = 0;          ///< of those: in which a contour crosses itself
  std::size_t crossing_between = 0;  ///< in which two contours cross
  std::size_t folded = 0;            ///< in which the contours lie over themselves or each other
  std::size_t faulty = 0;            ///< with any of the three
  std::size_t faulty_keys = 0;       ///< keys, that is inputs, with any of the three
  std::optional<FaultPlace> first;   ///< of the in-betweens, not of the keys
  /// By how much (radians) a joint that is smooth in every key turns on the spot in an in-between, beyond the
  /// worst of the keys.
  double g1_defect = 0.0;
  /// Largest |ratio - 1| of the length of all contours to the linear blend of the keys' lengths.
  double length_deviation = 0.0;
  /// The same of the area that the closed contours enclose, counted with its sign; 0 without any.
  double area_deviation = 0.0;
  /// Largest movement of a control point from one in-between to the next, by the mean over all steps between
  /// the same two keys of the largest movement in each: 1 when everything moves evenly, large when it jumps.
  double step_ratio = 1.0;
  bool complete = true;  ///< false: ended at most_faulty; the other numbers are those of what was measured
};

/// The contours of a morph at s in [0, 1]: the same number of contours and of segments at every s. Read
/// before the next call.
using PathSampler = std::function<std::span<const PathView>(double s)>;

/// Measures the in-betweens of anything that blends paths.
/// @throws InvalidArgument fewer than two keys, no in-betweens, a sample that differs from the first one in
/// contours or segments, a bound that is not >= 0
[[nodiscard]] TANDEM_EXPORT MorphQuality measure_quality(const PathSampler& sampler,
                                                         const QualityOptions& options = {});

/// The same of a motion that makes its paths anew.
[[nodiscard]] TANDEM_EXPORT MorphQuality measure_quality(const Motion& motion,
                                                         const QualityOptions& options = {});

/// The same of a morph of paths, with its own number of keys.
[[nodiscard]] TANDEM_EXPORT MorphQuality measure_quality(const PathMorph& morph, QualityOptions options = {});

}  // namespace v0
}  // namespace tandem
