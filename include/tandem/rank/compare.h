#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "tandem/match/rotation.h"
#include "tandem/rank/shape_descriptor.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// What two shapes in step cost (docs/recognition.md). All are per unit of path, so that shapes of different
/// numbers of nodes compare; 0: the same shape.
enum class RankCost {
  symmetric,  ///< three steps; a diagonal one counts twice, any other has a charge; per weight of the path
  paper,      ///< three steps, 1 - <T1,T2> summed over the nodes ([C] eq. (7)); per mean number of nodes
  elastic,    ///< the elastic integral; per unit of length
};

struct CompareOptions {
  RankCost cost = RankCost::symmetric;
  bool rotate = true;   ///< a turned shape is the same shape
  bool mirror = false;  ///< a mirrored shape is the same shape; without `rotate`: flipped left to right
  /// symmetric: the price of a step that is not diagonal, in units of the node cost 1 - <T1,T2>.
  double charge = 0.1;
};

/// How a candidate compares with the query.
struct Comparison {
  double cost = 0.0;
  Rotation rotation = Rotation(2);  ///< turns the (mirrored) query onto the candidate
  bool mirrored = false;
  bool reversed = false;  ///< the query runs against the direction of its descriptor
  int shift = 0;          ///< of the query's nodes against the candidate's node 0 (closed curves)
};

/// Compares one shape with others. Made once per query; compare() is a pure function of the two shapes and
/// the options, and may be called from several threads at once.
class TANDEM_EXPORT ShapeComparer {
 public:
  /// @throws InvalidArgument charge is negative or not finite
  explicit ShapeComparer(ShapeDescriptor query, const CompareOptions& options = {});
  ShapeComparer(ShapeComparer&&) noexcept;
  ShapeComparer& operator=(ShapeComparer&&) noexcept;
  ~ShapeComparer();

  [[nodiscard]] const ShapeDescriptor& query() const noexcept;
  /// Whether the two can be compared at all: of one dimension, both closed or both open.
  [[nodiscard]] bool is_comparable(const ShapeDescriptor& candidate) const noexcept;
  /// No more than the cost, for the price of a look at the directions; 0 outside the plane.
  /// @throws InvalidArgument the two are not comparable
  [[nodiscard]] double lower_bound(const ShapeDescriptor& candidate) const;
  /// Nothing when the cost is certain to be above `limit`; otherwise the result does not depend on it.
  /// @throws InvalidArgument the two are not comparable
  [[nodiscard]] std::optional<Comparison> compare(
      const ShapeDescriptor& candidate, double limit = std::numeric_limits<double>::infinity()) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

/// One pair. @throws InvalidArgument as ShapeComparer and its compare()
[[nodiscard]] TANDEM_EXPORT Comparison compare(const ShapeDescriptor& query, const ShapeDescriptor& candidate,
                                               const CompareOptions& options = {});

}  // namespace v0
}  // namespace tandem
