#pragma once

#include <span>
#include <vector>

#include "tandem/match/rotation.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A turn that lays two rows of tangents on one another at one alignment: the second row, read from `shift`
/// on, is nearly the first one turned.
struct PlanarCandidate {
  double cosine = 1.0;  ///< of the turn from the first row to the second
  double sine = 0.0;
  int shift = 0;       ///< tangent i of the first row belongs to tangent i + shift of the second
  double score = 0.0;  ///< mean inner product after the turn: 1 for unit tangents that agree throughout
};

/// The best turns between two rows of m planar tangents each, given by their coordinates, best first: the
/// local maxima of the modulus of the complex cross-correlation over all shifts (cyclic), or the one of shift
/// 0 (open). At most `most`. Among turns as good as the best left (within 1e-9) the smaller goes first, so a
/// shape with a symmetry of its own gives its smallest turn. O(m^2), + - * / sqrt only.
///
/// The tangents should stand for equal lengths; they need not be unit vectors (the mean tangent over a
/// stretch that turns is shorter than 1). Spec C11.
[[nodiscard]] std::vector<PlanarCandidate> planar_rotation_candidates(std::span<const double> ax,
                                                                      std::span<const double> ay,
                                                                      std::span<const double> bx,
                                                                      std::span<const double> by, bool cyclic,
                                                                      int most);

/// The same in R^n.
struct RotationCandidate {
  Rotation rotation;
  int shift = 0;
  double score = 0.0;
};

/// a, b: dim planes of m coordinates each (plane c starts at c * m). In R^n, n > 2, the cross-covariance of
/// the tangents at every shift gives the turn (Kabsch) and the score.
[[nodiscard]] std::vector<RotationCandidate> rotation_candidates(std::span<const double> a,
                                                                 std::span<const double> b, int dim,
                                                                 bool cyclic, int most);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
