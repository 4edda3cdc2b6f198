#pragma once

#include <optional>
#include <span>
#include <vector>

#include "morph/step_candidate.h"
#include "morph/step_keys.h"
#include "tandem/morph/blend.h"
#include "tandem/morph/morph.h"
#include "tandem/shape/cubic_path.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// How a step is made.
struct FoundStep {
  BlendKind kind = BlendKind::affine;
  StepCandidate candidate;
};

/// Pairs the contours of two keys, finds their correspondences and the blend: the candidate whose in-betweens
/// score best. Nothing when cancelled.
[[nodiscard]] std::optional<FoundStep> find_step(const StepKey& a, const StepKey& b,
                                                 const MorphOptions& options);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
