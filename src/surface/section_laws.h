#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/match/correspondence.h"
#include "tandem/match/match.h"
#include "tandem/match/reparametrization.h"
#include "tandem/surface/skin.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// A section against the parameter u of the first one.
struct SectionPath {
  Correspondence correspondence;
  std::vector<double> corners;  ///< u at which the section has a corner of its own
  std::vector<double> pins;     ///< u of the pins
};

/// The first section against itself.
[[nodiscard]] SectionPath identity_path(const Curve& first);

/// The paths of all sections, each matched with the one before it. Empty when cancelled.
[[nodiscard]] std::vector<SectionPath> match_in_sequence(std::span<const Curve> sections,
                                                         const SkinOptions& options);

/// The path of the section that `match` matched with the one whose path is `before`.
[[nodiscard]] SectionPath follow(const SectionPath& before, const Match& match);

/// A section and the law that puts it in step.
struct SectionInStep {
  Curve curve;  ///< exact, over the first section's domain
  Reparametrization law;
};

[[nodiscard]] SectionInStep put_in_step(const Curve& section, const SectionPath& path, double tolerance);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
