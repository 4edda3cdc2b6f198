#pragma once

#include <vector>

#include "tandem/curve/curve.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Parameters of a curve, the seam of a closed one as its start, at which it goes on in the same direction
/// (within `angle`, in radians) with another speed: the joints of most drawings. A law that is smooth there
/// would leave the jump in the section, and the surface a crease between this section and another that is
/// turned against it.
[[nodiscard]] std::vector<double> smooth_joints(const Curve& curve, double angle);

/// The law with slopes that make up for the jumps of speed: at the smooth joints of `section`, at its own
/// knots of full multiplicity (less one), and across the seam of a loop, if the section has the same
/// direction on both sides. The law keeps its values there, and increases. section: what is composed with it.
[[nodiscard]] Curve with_even_speed(const Curve& law, const Curve& section, bool loop, double angle);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
