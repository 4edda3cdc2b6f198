#pragma once

#include <cstddef>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// How the nodes are spread over a curve (spec C4).
enum class Sampling {
  arc,        ///< nearly uniform in arc length, with a node at every corner
  parameter,  ///< uniform in the parameter ([C] section 3)
  curvature,  ///< as arc, but denser where the curve turns: half of the nodes by length, half by turning
};

struct SampleOptions {
  /// Nodes wanted: both ends included on an open curve, distinct ones on a cyclic one. With `arc` and
  /// `curvature` every corner gets a node, and the real number may differ a little.
  int count = 100;
  Sampling sampling = Sampling::arc;
  /// Sample a closed curve as a loop: no node is doubled at the seam, and with `arc` and `curvature` the
  /// nodes do not depend on where the seam lies (their phase comes from the corners, else from the shape's
  /// harmonics).
  bool cyclic = false;
  /// Smallest turn of the tangent at a knot that counts as a corner, in radians. 0.05 lies well above the
  /// joints of real icons that are meant to be smooth (about 1e-3) and below anything that is seen as a
  /// corner.
  double corner_angle = 0.05;
  /// Standard deviation of a Gaussian low-pass over the samples, as a share of the length; 0: none (spec
  /// C17).
  double low_pass = 0.0;
  /// Parameters inside the domain, increasing, that get a node in any case.
  std::vector<double> nodes = {};
};

/// Nodes on a curve with what the norms need: positions, one-sided tangents, lengths.
///
/// Chord i leads from node i to node i + 1 (on a cyclic curve the last one leads back to node 0).
struct TANDEM_EXPORT Samples {
  bool cyclic = false;
  std::vector<double>
      parameters;       ///< n, increasing; cyclic: may start anywhere and run past the end of the domain
  double period = 0.0;  ///< cyclic: length of the domain
  Interval domain;      ///< of the curve
  Points positions;     ///< dim x n
  Points tangents_in;   ///< dim x n, unit, one-sided limit from the left; zero where there is none
  Points tangents_out;  ///< dim x n, unit, one-sided limit from the right
  std::vector<double>
      speeds;  ///< n, |C'| from the right, relative to length / period; 0: the curve stands still
  std::vector<bool> corners;          ///< n
  Points chord_tangents;              ///< dim x chords, unit; zero for a chord of no length
  std::vector<double> chord_lengths;  ///< arc length of each chord, as a share of the whole; sums to 1
  std::vector<double>
      curvatures;       ///< per chord, turning per unit of (normalised) length; signed in the plane
  double length = 0.0;  ///< arc length of the curve

  [[nodiscard]] std::size_t size() const noexcept { return parameters.size(); }
  [[nodiscard]] std::size_t chords() const noexcept { return chord_lengths.size(); }
  [[nodiscard]] int dim() const noexcept { return positions.dim(); }
};

/// @throws InvalidArgument count < 2 (cyclic: < 3), cyclic on an open curve, or the curve is a point
[[nodiscard]] TANDEM_EXPORT Samples sample(const Curve& curve, const SampleOptions& options = {});

/// The samples of the curve run through backwards, over the same domain (t' = lo + hi - t), exactly: the same
/// nodes in the other order.
[[nodiscard]] TANDEM_EXPORT Samples reversed(const Samples& samples);

}  // namespace v0
}  // namespace tandem
