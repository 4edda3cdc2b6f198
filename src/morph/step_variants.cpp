#include "morph/step_variants.h"

#include <cstddef>
#include <utility>
#include <variant>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Ways of matching beside the caller's own: positions count, tangents turned away only cost.
struct Variant {
  double position_weight;
  double lambda;
};
constexpr Variant kVariants[] = {{0.0, 0.02}, {0.3, 0.02}, {1.0, 0.02}, {3.0, 0.02}, {1.0, 0.1}};
// Among the caller's own way and these, in this order.
constexpr std::size_t kMostHelpful = 3;

bool is_tangent_norm(const MatchOptions& options) {
  const auto* kind = std::get_if<NormKind>(&options.norm);
  return kind != nullptr && *kind == NormKind::tangent;
}

}  // namespace

// Variants stand in for the default only: what a caller asks for is what is done.
bool may_vary(const MatchOptions& options) {
  return is_tangent_norm(options) && options.method == Method::elastic && !options.features.curvature &&
         options.features.position_weight == 0.0;
}

// The ways of matching to be tried. In a hurry, first the one that helps most, on few samples; where
// positions do not count, few samples mislead one match in four, and all are looked at.
std::vector<MatchOptions> variants_of(const MatchOptions& own) {
  std::vector<MatchOptions> variants{own};
  if (!may_vary(own)) return variants;
  for (const Variant& variant : kVariants) {
    variants.push_back(own);
    variants.back().features.position_weight = variant.position_weight;
    variants.back().features.lenient = true;
    variants.back().elastic.lambda = variant.lambda;
    variants.back().coarse_to_fine = own.coarse_to_fine && variant.position_weight > 0.0;
  }
  if (!own.coarse_to_fine) return variants;
  variants.front().coarse_to_fine = false;
  std::swap(variants.front(), variants[kMostHelpful]);
  return variants;
}

std::vector<BlendKind> kinds_of(BlendKind kind) {
  switch (kind) {
    case BlendKind::automatic:
      return {BlendKind::affine, BlendKind::hermite, BlendKind::intrinsic};
    case BlendKind::detour:
      return {BlendKind::affine};
    default:
      return {kind};
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
