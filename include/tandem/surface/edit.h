#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/surface/surface.h"
#include "tandem/tandem_export.h"

/// Exact editing of surfaces, along one of their parameters at a time: the same geometry, or the part of it
/// that is named. What curve/edit.h says of curves holds here.
namespace tandem {
inline namespace v0 {

/// The curve along `along` at `t` of the other parameter, clamped to the domain.
[[nodiscard]] TANDEM_EXPORT Curve iso_curve(const Surface& surface, Along along, double t);

/// Knot t inserted `times` times. @throws InvalidArgument t outside the domain, or the multiplicity would
/// exceed the degree
[[nodiscard]] TANDEM_EXPORT Surface insert_knot(const Surface& surface, Along along, double t, int times = 1);

/// All `knots` (non-decreasing, inside the domain) inserted at once.
[[nodiscard]] TANDEM_EXPORT Surface refine(const Surface& surface, Along along,
                                           std::span<const double> knots);

/// Degree raised by `times`.
[[nodiscard]] TANDEM_EXPORT Surface elevate_degree(const Surface& surface, Along along, int times = 1);

/// The part over `part` of one parameter, clamped there.
/// @throws InvalidArgument part is empty or reaches outside the domain
[[nodiscard]] TANDEM_EXPORT Surface part_of(const Surface& surface, Along along, Interval part);

/// End knots of multiplicity degree + 1 in both parameters.
[[nodiscard]] TANDEM_EXPORT Surface clamp(const Surface& surface);

/// Traversed backwards along one parameter over the same domain. Turns the normal round.
[[nodiscard]] TANDEM_EXPORT Surface reverse(const Surface& surface, Along along);

/// The same surface over another domain of one parameter. @throws InvalidArgument the domain is empty
[[nodiscard]] TANDEM_EXPORT Surface with_domain(const Surface& surface, Along along, Interval domain);

/// Parameters exchanged: S(v, u). Turns the normal round.
[[nodiscard]] TANDEM_EXPORT Surface transpose(const Surface& surface);

/// A surface cut at all its knots.
struct BezierPatches {
  std::size_t rows = 0;          ///< spans along u
  std::size_t columns = 0;       ///< spans along v
  std::vector<Surface> patches;  ///< patch (i, j) at i * columns + j, each over its spans
};
[[nodiscard]] TANDEM_EXPORT BezierPatches bezier_patches(const Surface& surface);

}  // namespace v0
}  // namespace tandem
