#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "tandem/curve/arc_length.h"
#include "tandem/curve/curve.h"
#include "tandem/curve/interval.h"
#include "tandem/match/correspondence.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// An axis about which a closed planar outline is its own mirror image.
struct Mirror {
  double u = 0.0;         ///< where the outline meets it, a parameter of the outline
  double opposite = 0.0;  ///< and where it meets it again, half the length on
  double degrees = 0.0;   ///< direction of the axis, towards u
};

/// The axes of symmetry of a closed planar curve, within 1 % of its radius of gyration. A circle has as many
/// as are looked for: one every 0.7 degrees.
[[nodiscard]] std::vector<Mirror> find_mirrors(const Curve& outline);

/// Axes that two outlines share: where both meet them, end by end.
struct SharedMirror {
  std::array<ParameterPair, 2> ends;
};

/// The axes of a and b that are most nearly parallel, and point the same way, when b is turned back by
/// `degrees`; of several, the most upright one in a. Nothing when there are none within 2 degrees.
[[nodiscard]] std::optional<SharedMirror> shared_mirror(std::span<const Mirror> a, std::span<const Mirror> b,
                                                        double degrees);

/// Lengths and parameters of an outline, and its reflection.
class Reflection {
 public:
  /// outline: closed; u: where the axis meets it
  Reflection(const Curve& outline, double u);
  /// Share of the length from the axis on to the parameter, in [0, 1).
  [[nodiscard]] double share(double u) const;
  /// The parameter of the mirror image.
  [[nodiscard]] double parameter(double share) const;

 private:
  Interval domain_;
  ArcLength lengths_;
  double start_;
};

/// How far a correspondence of two closed outlines is from its own mirror image: the root mean square over
/// the outlines, in shares of their length. One tip that is off is seen, however short.
[[nodiscard]] double asymmetry(const Correspondence& correspondence, const Reflection& a,
                               const Reflection& b);

/// The same correspondence from the axis to the axis, and on from there as its mirror image.
/// correspondence: forward, through both ends of the axis
[[nodiscard]] Correspondence mirrored(const Correspondence& correspondence, const Reflection& a,
                                      const Reflection& b);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
