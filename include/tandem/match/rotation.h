#pragma once

#include <span>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/match/match.h"
#include "tandem/match/samples.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// A proper rotation of R^n: no reflection, no scale.
class TANDEM_EXPORT Rotation {
 public:
  /// The identity. @throws InvalidArgument dim < 1
  explicit Rotation(int dim);
  /// From the form of MatchReport::rotation: cosine and sine in the plane, the row-major n x n matrix
  /// otherwise. @throws InvalidArgument the sizes disagree, or it is no proper rotation within 1e-5
  Rotation(int dim, std::span<const double> values);

  [[nodiscard]] int dim() const noexcept { return dim_; }
  /// Cosine and sine in the plane, the row-major n x n matrix otherwise.
  [[nodiscard]] const std::vector<double>& values() const noexcept { return values_; }
  [[nodiscard]] bool is_identity() const;
  [[nodiscard]] Rotation inverse() const;
  /// Plane: the angle from the first axis to the second, in (-180, 180]. Otherwise the size of the turn, the
  /// root of the sum of squares of the angles of its planes: in R^3 the angle about its axis, in [0, 180].
  [[nodiscard]] double degrees() const;
  /// The share s of the turn, evenly: the identity at 0, R at 1, any finite s. A half turn goes through the
  /// positive quarter turn in the plane, and through one of the two elsewhere.
  [[nodiscard]] Rotation fraction(double s) const;
  /// The matrix's trace, which falls as the turn grows.
  [[nodiscard]] double trace() const;

  /// R x. out may be x itself.
  void apply(std::span<const double> x, std::span<double> out) const;
  /// All points turned about the origin.
  [[nodiscard]] Points operator()(Points points) const;

  friend bool operator==(const Rotation&, const Rotation&) = default;

 private:
  int dim_;
  std::vector<double> values_;
};

/// The samples of the curve turned about its centre, the mean of its points over the length.
[[nodiscard]] TANDEM_EXPORT Samples turned(Samples samples, const Rotation& rotation);

/// The turn of several curves to several others under which pair i, a[i] with b[i], matches best, all
/// together and weighted with their lengths: as match() with MatchOptions::rotate looks for it.
///
/// least_gain: the identity comes back unless turning lowers the cost by this share (invalid lengths count
/// twice their size in it). The curves are only surveyed on a quarter of their samples then.
/// @throws InvalidArgument no curves or different numbers of them, and as match()
[[nodiscard]] TANDEM_EXPORT Rotation common_rotation(std::span<const Curve> a, std::span<const Curve> b,
                                                     const MatchOptions& options = {},
                                                     double least_gain = 0.0);

}  // namespace v0
}  // namespace tandem
