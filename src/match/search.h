#pragma once

#include "match/band.h"
#include "match/edge_plan.h"
#include "tandem/match/match.h"
#include "tandem/match/programme.h"
#include "tandem/match/samples.h"

namespace tandem {
inline namespace v0 {
namespace detail {

/// How the ends of the two curves are tied together.
enum class Layout {
  open,      ///< start to start, end to end
  toroidal,  ///< two loops, any start
  pinned,    ///< two loops, the paper's form: the first keeps its start, the second is shifted
  cut_a,     ///< the first is a loop, cut where it is best
  cut_b,     ///< the second is a loop, cut where it is best
};

/// Whether both curves are run round once, so that the correspondence goes on past the end.
[[nodiscard]] constexpr bool is_closed_layout(Layout layout) {
  return layout == Layout::toroidal || layout == Layout::pinned;
}

/// Whether the programme has the second curve's samples in its rows. The elastic pinned form cuts the second
/// loop against the first, which is open at its seam.
[[nodiscard]] constexpr bool is_transposed(Layout layout, Method method) {
  return layout == Layout::cut_b || (layout == Layout::pinned && method == Method::elastic);
}

/// The better direction of two matched curves.
struct SearchResult {
  Path path;  ///< nodes of a and of b as matched (reversed if `reversed`); loops: i starts in [0, m1)
  bool reversed = false;
  Samples samples_b;  ///< as matched
};

/// Runs the programme for every direction (and sign of the ruled norm) that the options allow, and keeps the
/// best: forward on a tie. band: the nodes that may be used, of a x b as matched, or of b x a where
/// is_transposed(). plans: of those who match these samples several times.
/// @throws InvalidArgument no path exists
[[nodiscard]] SearchResult search(const Samples& a, const Samples& b, const MatchOptions& options,
                                  Layout layout, const Band* band = nullptr, EdgePlans* plans = nullptr);

}  // namespace detail
}  // namespace v0
}  // namespace tandem
