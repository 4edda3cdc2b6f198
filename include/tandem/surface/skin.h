#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/match/match.h"
#include "tandem/match/reparametrization.h"
#include "tandem/match/validity.h"
#include "tandem/surface/law.h"
#include "tandem/surface/loft.h"
#include "tandem/surface/surface.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

/// How n sections are matched (spec C14).
enum class SkinMatching {
  sequence,  ///< each with the one before it, along the chain
  joint,  ///< in sequence first, then each again with both of its neighbours, as long as the total cost falls
};

struct SkinOptions {
  /// How neighbours are matched. `reduction` and `pins` are not used: see below.
  MatchOptions match = {};
  /// Empty: jointly where the loft is closed, else in sequence, which is some ten times as fast.
  std::optional<SkinMatching> matching = {};
  LoftOptions loft = {};
  /// One parameter per section each: points of all sections that belong together. They are met exactly, and
  /// the sections are matched in sequence. A pin that the laws could meet only with a jump of their slope
  /// gives a crease.
  std::vector<std::vector<double>> pins = {};
  /// Of order 3 by default: C1 is enough for normals without jumps, and the degree of a section is multiplied
  /// by that of its law. The tolerance is a fifth of the distance of nodes: what is finer in a path is their
  /// noise (measured: from 1e-3 to 2e-3 total costs fall by 1 to 2 %, and heights of bells are kept better).
  /// The slopes are those at which no section nearly stands still; where they keep a law off its path by more
  /// than the tolerance, or make it invalid, slopes of 1e-3 to 1e3 are tried.
  LawOptions law = {.order = 3, .tolerance = 2e-3, .min_slope = 0.02};
};

/// What became of one section and the next; of a closed loft the last pair is that of the last and the first.
struct SkinPair {
  Validity validity;  ///< on the final sections of the surface, after the fit
  /// Integral of 1 - <T1,T2> over the mean length, plus the strain, as the elastic match counts it, on the
  /// final sections.
  double cost = 0.0;
  Direction direction = Direction::forward;  ///< of the second section as given against the first as given
};

struct SkinReport {
  std::vector<SkinPair> pairs;
  bool valid = false;       ///< all pairs are
  double total_cost = 0.0;  ///< sum of the pairs' costs
  /// The same after matching in sequence; `joint` does not end above it, but for what makes it less invalid.
  double sequence_cost = 0.0;
  int sweeps = 0;   ///< of joint matching that lowered the cost
  int refined = 0;  ///< sections, counted again when found again, whose paths were looked for once more
  /// Largest angle between the normals on both sides of a line u = const on which no section has a corner but
  /// the speed of one jumps, in radians: what the laws are to blame for. 0 if the surface is not in R^3.
  double crease_angle = 0.0;
  /// The same where all speeds are even: there sections turn themselves, by no more than match.corner_angle.
  double section_crease_angle = 0.0;
  /// In R^2: the share of the area on which the surface folds over, where S_u x S_v has the rarer sign; by
  /// samples. Validity is of tangents, and sees none of that.
  double wrong_sign_share = 0.0;
  double law_deviation = 0.0;  ///< largest |v(u) - path| of all laws, as a share of a section's domain
  /// Largest distance of a section from the surface's curve at its v, as a share of the size of all.
  double interpolation_error = 0.0;
  bool cancelled = false;  ///< the sections are paired by their parameters, and nothing was measured
};

/// A surface through matched sections.
struct SkinnedSurface {
  Surface surface;
  std::vector<double> parameters;  ///< v of each section
  /// The sections in step, over the first one's domain: reparametrised exactly.
  std::vector<Curve> sections;
  std::vector<Reparametrization>
      laws;  ///< of each section; the first one's is the identity unless its speed jumps
  SkinReport report;
};

/// The surface through n curves that run along u, put in step (spec C14, C15e).
///
/// Sections are all open or all closed; seams and directions are found. Their laws v(u) are monotone, and C1
/// but where a section's speed jumps, for which they make up: the surface has no creases but where sections
/// turn; sections keep their geometry exactly. Neighbours in a chain depend on each other through nothing but
/// their own law, so that for an open chain matching in sequence is the optimum already, but for samples and
/// fits; a closed loft is a ring, and there joint matching finds what sequence cannot.
/// @throws InvalidArgument as match() and loft(); sections that coincide; pins whose number of parameters is
///         not that of the sections
[[nodiscard]] TANDEM_EXPORT SkinnedSurface skin(std::span<const Curve> sections,
                                                const SkinOptions& options = {});

}  // namespace v0
}  // namespace tandem
