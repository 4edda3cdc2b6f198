#pragma once

#include <vector>

#include "tandem/match/correspondence.h"
#include "tandem/match/cost_table.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A path as a correspondence of parameters.
struct PathParameters {
  Correspondence correspondence;
  std::vector<double> corners;  ///< u of the points at which either curve has a corner
};

/// b: samples as matched. elastic: the edges between the path's nodes are linear in arc length, and get a
/// point at every node of either curve that they pass; otherwise the nodes alone are the points. closed: the
/// correspondence runs once round both curves.
[[nodiscard]] PathParameters path_parameters(const Samples& a, const Samples& b,
                                             const std::vector<Node>& nodes, bool reversed, bool closed,
                                             bool elastic);

/// Makes the pins corners, and drops the points that share one parameter with a pin: v(u) can then pass
/// through the pin itself. The pins are points of the path, on loops some laps on.
void keep_pins(PathParameters& path, const std::vector<ParameterPair>& pins);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
