#pragma once

#include "surface/rail_norm.h"
#include "tandem/curve/curve.h"
#include "tandem/match/reparametrization.h"

namespace tandem {
inline namespace v0 {
namespace detail {

struct RefineOptions {
  double strain = 0.02;  ///< as ElasticOptions::lambda
};

/// The path once more, on finer nodes beside it.
///
/// A match pairs nodes, so its path is off by up to half their distance, and what needs exact pairing
/// (tangents that are no more than perpendicular at one pair of points, rulings of a developable) is missed
/// by that much. Here every node of the path, and one between each two, may slide along the second curve: a
/// programme over a few places per node, in windows that shrink, looks for the least of elastic cost and
/// invalidity. Ends and corners stay.
/// second: the curve that the path's v refers to, over all of its range.
[[nodiscard]] FitPath refine_path(const Curve& first, const Curve& second, const FitPath& path,
                                  const RailNorm& norm, const RefineOptions& options);

/// The same with nodes that slide along the first curve: where that one has to all but stand still, for want
/// of a part like one of the second, there are too few nodes that slide along the second.
[[nodiscard]] FitPath refine_path_along_first(const Curve& first, const Curve& second, const FitPath& path,
                                              const RailNorm& norm, const RefineOptions& options);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
