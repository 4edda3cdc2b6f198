#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/curve/points.h"
#include "tandem/shape/shape.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// What recognition keeps of a shape: the unit tangents of its outline, uniform in arc length. Position and
/// scale are gone, and so are the seam of a closed curve and, in the plane, its direction.
///
/// An immutable regular value. All numbers are rounded to float, so that an index file (io/tdx.h) holds them
/// without loss.
class TANDEM_EXPORT ShapeDescriptor {
 public:
  /// tangents: dim x m, unit, of the chords one after the other; lengths: m, the chords' shares of the whole
  /// length, scaled here to sum to 1. A closed planar curve that runs clockwise is reversed.
  /// @throws InvalidArgument m is not within [1, 10,000] (closed: 3), a size disagrees, a tangent is not a
  ///         unit vector within 1e-3, or a length is not positive and finite
  ShapeDescriptor(bool closed, Points tangents, std::vector<double> lengths, std::string name = {},
                  std::string label = {});

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// The class it belongs to, where that is known; else empty.
  [[nodiscard]] const std::string& label() const noexcept { return label_; }
  [[nodiscard]] bool is_closed() const noexcept { return closed_; }
  /// The curve has a direction of its own, counter-clockwise, so that two of them are compared in that
  /// direction only. False of open curves, outside the plane, and where the signed area is too small to tell
  /// (a figure eight): below 1 % of that of a circle of the same length.
  [[nodiscard]] bool is_oriented() const noexcept { return oriented_; }
  [[nodiscard]] int dim() const noexcept { return tangents_.dim(); }
  /// Number of chords.
  [[nodiscard]] std::size_t size() const noexcept { return lengths_.size(); }
  [[nodiscard]] const Points& tangents() const noexcept { return tangents_; }
  [[nodiscard]] const std::vector<double>& lengths() const noexcept { return lengths_; }

  friend bool operator==(const ShapeDescriptor&, const ShapeDescriptor&) = default;

 private:
  std::string name_;
  std::string label_;
  bool closed_;
  bool oriented_ = false;
  Points tangents_;
  std::vector<double> lengths_;
};

struct DescribeOptions {
  /// Chords wanted; every corner gets a node, so the real number may differ a little (see SampleOptions).
  int samples = 100;
  std::string name = {};
  std::string label = {};
};

/// @throws InvalidArgument the curve is a point, or samples is not within [3, 10,000]
[[nodiscard]] TANDEM_EXPORT ShapeDescriptor describe(const Curve& curve, const DescribeOptions& options = {});

/// The contour that stands for the shape: the closed one that encloses the largest area, or the longest one
/// when none is closed (or the curves are not planar). The first on a tie.
/// @throws InvalidArgument the shape has no contour
[[nodiscard]] TANDEM_EXPORT std::size_t outer_contour(const Shape& shape);

/// Describes the shape's outer contour.
[[nodiscard]] TANDEM_EXPORT ShapeDescriptor describe(const Shape& shape, const DescribeOptions& options = {});

}  // namespace v0
}  // namespace tandem
