#pragma once

#include <functional>
#include <span>
#include <vector>

#include "surface/rail_norm.h"
#include "tandem/curve/curve.h"
#include "tandem/match/match.h"
#include "tandem/surface/law.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// What a surface between two rails wants of their pairing.
struct RailOptions {
  MatchOptions match;  ///< its reduction means nothing
  LawOptions law;
  /// What is wrong with rails in step; 0: nothing. Invalid length, say, or warp.
  std::function<double(const Curve& first, const Curve& second)> defect;
  double slack = 2e-4;  ///< defect that a fit may add to a path that has one already
  /// The norm of the refinement; `flipped` for the other sign of the signed test, where that makes sense.
  RailNorm refinement;
  RailNorm flipped;
  double strain = 0.02;  ///< of the refinement
  /// Does this second curve in step crease the surface more than it may? Corners of the rails do not count.
  std::function<bool(const Curve& second, std::span<const double> corners)> creases;
};

/// Rails in step. `match.curve` is the second one composed with the law.
struct PairedRails {
  Match match;
  LawReport law;
  std::vector<double> corners;  ///< u at which either rail has a corner
};

/// 1 - Validity::valid_share, 0 only where `valid`.
[[nodiscard]] double invalidity(const Validity& validity);

/// Matches, looks once more beside the path where that leaves a defect, and takes the first law of those that
/// options.law asks for, or finer, or of a lower order, that has no more of it than the path itself and does
/// not crease the surface; else one that does, else the least bad one. match.report.validity is to be set by
/// the caller.
[[nodiscard]] PairedRails pair_rails(const Curve& a, const Curve& b, const RailOptions& options);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
