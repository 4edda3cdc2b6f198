#pragma once

#include <variant>

#include "tandem/match/match.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// Whether a morph is to look for turns: when the caller says so, or says nothing and the norm is the tangent
/// norm or the caller's own. A turn that is given is not looked for.
inline bool wants_turns(const MatchOptions& options) {
  if (!options.rotation.empty()) return false;
  const auto* kind = std::get_if<NormKind>(&options.norm);
  return options.rotate.value_or(kind == nullptr || *kind == NormKind::tangent);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
