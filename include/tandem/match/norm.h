#pragma once

#include <functional>
#include <span>
#include <variant>

#include "tandem/match/cost_table.h"
#include "tandem/match/samples.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// The norms of the paper (spec C3, C13).
enum class NormKind {
  tangent,     ///< <T1,T2>, [C] eqs. (3), (5)
  ruled,       ///< [C] eqs. (4), (6); in R^n <T1,T2> - <T1,d><T2,d>/|d|^2 (anti-twist), d = C2 - C1
  distance,    ///< |C1 - C2|, summed; no validity
  bottleneck,  ///< the largest |C1 - C2| (discrete Frechet distance), then the least sum; no validity
};

/// What a user-defined norm is asked about: unit tangents and positions of one pair of nodes (or chords).
struct NormArguments {
  std::span<const double> tangent1;
  std::span<const double> tangent2;
  std::span<const double> point1;
  std::span<const double> point2;
};

struct NormValue {
  double cost = 0.0;     ///< >= 0 and finite, to be minimised
  bool invalid = false;  ///< this pair should be avoided whatever it costs
};

/// A norm of the caller's own. It must be symmetric in the two curves if match(a, b) and match(b, a) are to
/// agree.
using UserNorm = std::function<NormValue(const NormArguments&)>;

using Norm = std::variant<NormKind, UserNorm>;

/// One global orientation of the signed ruled test (spec C13): both products must have this sign.
enum class RuledSign { product, positive, negative };

/// Features beside the norm (spec C17), and how strictly its validity is taken.
struct FeatureOptions {
  bool curvature = false;          ///< add the difference of the curvatures to the cost
  double curvature_weight = 0.25;  ///< its weight; the difference itself lies in [0,1]
  /// Weight of |p1 - p2|^2, the positions relative to each curve's centre and in units of its radius of
  /// gyration: parts that lie alike are drawn to each other. 0: positions do not count.
  double position_weight = 0.0;
  /// No pair is invalid: what is turned away only costs what it costs.
  bool lenient = false;
};

/// Costs 1 - <T1,T2> (or the norm's) of all pairs of nodes, for the paper's programme: nodes(a) x nodes(b).
/// Invalid: the norm's value is < 0; such a node costs nothing beside its invalidity ([C] charges a flat 2m
/// for it). A node of zero speed carries no tangent cost (spec C18). `sign` is used by NormKind::ruled in the
/// plane.
/// @throws InvalidArgument the dimensions differ, or a user norm's cost is negative or not finite
[[nodiscard]] TANDEM_EXPORT NodeTable node_costs(const Samples& a, const Samples& b, const Norm& norm,
                                                 const FeatureOptions& features = {},
                                                 RuledSign sign = RuledSign::product);

/// Costs of all pairs of chords, the integrand of the elastic programme: chords(a) x chords(b).
/// Invalid: the norm's value is < -0.05. Distances count relative to the mean of the two lengths.
[[nodiscard]] TANDEM_EXPORT NodeTable chord_costs(const Samples& a, const Samples& b, const Norm& norm,
                                                  const FeatureOptions& features = {},
                                                  RuledSign sign = RuledSign::positive);

}  // namespace v0
}  // namespace tandem
