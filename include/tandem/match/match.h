#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tandem/curve/curve.h"
#include "tandem/match/correspondence.h"
#include "tandem/match/elastic.h"
#include "tandem/match/norm.h"
#include "tandem/match/programme.h"
#include "tandem/match/reparametrization.h"
#include "tandem/match/samples.h"
#include "tandem/match/segment_rules.h"
#include "tandem/match/validity.h"
#include "tandem/progress.h"
#include "tandem/tandem_export.h"

namespace tandem {
inline namespace v0 {

enum class Method {
  elastic,   ///< integrated costs, steps up to six, nodes in arc length (spec, "The better formulation")
  paper,     ///< [C] as printed: three steps, node sums, uniform parameters
  segments,  ///< [D]: the curves' own cubic segments against each other, see match_segments()
};

enum class Direction { automatic, forward, reversed };

/// How closed curves are matched (spec C10).
enum class ClosedMode {
  automatic,  ///< toroidal when both are closed; one closed against one open: the closed one is cut where it
              ///< is best
  yes,        ///< toroidal; both must be closed
  no,         ///< both seams stay where they are
  pinned,     ///< the paper's form: shifts of the second curve with both ends pinned
};

/// Options with the defaults of the command line. An empty optional means: the method's default.
struct MatchOptions {
  /// `segments` takes the curves as cubic paths (exact to degree 3, else within 1e-6 of their size). Norm,
  /// sampling, features, low pass and coarse_to_fine mean nothing to it; a turn that is looked for is the
  /// elastic method's.
  Method method = Method::elastic;
  Norm norm = NormKind::tangent;
  /// Nodes per curve; 0: 128 for closed curves and 100 for open ones (paper: 100).
  std::array<int, 2> samples = {0, 0};
  std::optional<Sampling> sampling = {};  ///< elastic: arc, paper: parameter
  FeatureOptions features = {};
  ElasticOptions elastic = {};
  SegmentRules segments = {};
  /// elastic: tolerance 1e-3, order 2; paper: 20 coefficients, order 2.
  std::optional<ReductionOptions> reduction = {};
  Direction direction = Direction::automatic;
  /// Look for the turn of b against a under which they match best (spec C11). Empty: match() does not, Morph
  /// does.
  std::optional<bool> rotate = {};
  /// The turn to match under instead of one that is looked for, in the form of MatchReport::rotation.
  std::vector<double> rotation = {};
  ClosedMode closed = ClosedMode::automatic;
  /// Pairs of parameters (u of the first curve, v of the second) that the correspondence must go through, in
  /// any order. Both curves get nodes there, and the match is the optimum among the paths through those.
  /// Three pins on loops, or two on open curves, fix the direction. Not with ClosedMode::pinned, nor with a
  /// number of coefficients; `paper` reduces by tolerance then, and coarse_to_fine means nothing. `segments`
  /// splits segments at pins, and takes a pin within 1e-6 of a segment to a joint for that joint.
  std::vector<ParameterPair> pins = {};
  double corner_angle = 0.05;  ///< see SampleOptions
  double low_pass = 0.0;       ///< see SampleOptions
  bool coarse_to_fine =
      false;        ///< match a quarter of the samples first, then refine near that path: not exact
  int threads = 0;  ///< 0: all; the result does not depend on it
  Progress progress = {};
};

/// What was found and how good it is; the fields of `tandem match --json` (docs/interface.md).
struct MatchReport {
  Method method = Method::elastic;
  /// "tangent", "ruled", "distance", "bottleneck" or "user"; segments: "derivative" or "paper"
  std::string norm;
  Sampling sampling = Sampling::arc;
  std::array<int, 2> samples = {0, 0};  ///< the real number of nodes; segments: of joints
  double cost = 0.0;  ///< paper: [C] eq. (7) with 2m per invalid node; elastic: the integral; segments: D5
  double mean_cost = 0.0;       ///< per path node (paper), per unit of length (elastic), per pair of segments
  int invalid_nodes = 0;        ///< the programme's own test, at the path's nodes
  double invalid_length = 0.0;  ///< the same as a share of the length
  Validity validity;            ///< on the final curves, after the fit
  Direction direction = Direction::forward;
  int shift = 0;  ///< in samples of the second curve
  /// The turn from the first curve to the second: cosine and sine (planar), row-major n x n matrix otherwise.
  /// The second curve, turned back by it, was matched.
  std::vector<double> rotation;
  std::vector<Node> path;  ///< in A's own order; j counts along the reversed second curve if reversed
  bool exact = true;       ///< false with coarse_to_fine
  bool cancelled = false;
  struct Seconds {
    double sample = 0.0;
    double match = 0.0;
    double fit = 0.0;
    double compose = 0.0;
  } seconds;
};

/// Two curves in step.
struct Match {
  Correspondence correspondence;
  Reparametrization reparametrization;
  Curve curve;  ///< the second curve composed with v, over the first one's domain; exact
  MatchReport report;
  Samples samples_a;
  Samples samples_b;  ///< as matched: of the reversed curve when the direction is reversed
};

/// Finds the best correspondence of b to a.
///
/// Symmetric: match(b, a).correspondence is the inverse of match(a, b).correspondence.
///
/// With a rotation, b is turned back by it, about its own centre (the mean over its length) as far as
/// positions count; costs and validity are those of a against b turned back. The match is the exact optimum
/// for that rotation. One that is looked for is a local optimum: the best that alternation of matching and
/// Procrustes finds from the peaks of the cross-correlation of the tangents, and from the identity.
/// @throws InvalidArgument pins outside the domains, or that no path runs through; the dimensions differ, a
///         curve is a point, an open curve where ClosedMode wants
/// closed
///         ones, samples whose ratio the elastic steps cannot bridge, a rotation that is none, or one with
///         the ruled norm, whose rulings join the curves where they lie
[[nodiscard]] TANDEM_EXPORT Match match(const Curve& a, const Curve& b, const MatchOptions& options = {});

/// n curves in step (spec C14): match i brings curve i + 1 into step with the already reparametrised curve i,
/// so that the `curve` of every match runs over curves[0]'s domain. n - 1 matches.
/// @throws InvalidArgument fewer than two curves, and as match()
[[nodiscard]] TANDEM_EXPORT std::vector<Match> match_chain(std::span<const Curve> curves,
                                                           const MatchOptions& options = {});

}  // namespace v0
}  // namespace tandem
