#include "surface/pair_rails.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "match/second_curve.h"
#include "surface/refine_path.h"
#include "tandem/curve/compose.h"
#include "tandem/curve/edit.h"
#include "tandem/progress.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Laws are fitted ever closer to the path, by this factor, while the fit is what makes the rails invalid.
constexpr double kFiner = 4.0;
constexpr int kFinest = 3;
/// What counts as invalid where corners backtrack though all of the length is valid.
constexpr double kSomewhere = 1e-12;
/// For the path itself: a polyline as near to it as it makes sense.
constexpr double kOnPath = 1e-6;

/// u of the corners of either curve.
std::vector<double> corner_parameters(const Match& match) {
  std::vector<double> corners;
  const Samples& a = match.samples_a;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a.corners[i]) corners.push_back(a.parameters[i]);
  }
  const Samples& b = match.samples_b;
  const Correspondence& c = match.correspondence;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (!b.corners[i]) continue;
    const double v = c.reversed ? b.domain.lo + (b.domain.hi - b.parameters[i]) : b.parameters[i];
    corners.push_back(c.u_at(v));
  }
  return corners;
}

/// Corners come back from the correspondence's inverse, rounded: the nearest points of the path.
std::vector<double> on_path(std::vector<double> corners, const Correspondence& c) {
  // Far above the rounding of a parameter, far below the distance of nodes.
  const double near = 1e-9 * c.domain_u.length();
  for (double& u : corners) {
    if (c.closed) u -= std::floor((u - c.domain_u.lo) / c.domain_u.length()) * c.domain_u.length();
    for (const ParameterPair& point : c.points) {
      double v = point.u;
      if (c.closed) v -= std::floor((v - c.domain_u.lo) / c.domain_u.length()) * c.domain_u.length();
      if (std::fabs(v - u) <= near) u = v;
    }
  }
  return corners;
}

class Pairing {
 public:
  Pairing(const Curve& a, const Curve& b, const RailOptions& options)
      : a_(a), b_(b), options_(options), match_(first_match()) {
    path_ = fit_path(match_.correspondence, on_path(corner_parameters(match_), match_.correspondence));
  }

  PairedRails run() {
    if (is_cancelled()) return finish({match_.reparametrization, match_.curve}, {});
    const Candidate on_path = candidate({2, kOnPath, options_.law.min_slope});
    defect_ = on_path.defect;
    const bool was_cut = !(match_.correspondence.domain_v == b_.domain());
    if (defect_ > 0.0 && !was_cut) refine(on_path);
    return choose_law();
  }

 private:
  /// Asked before anything that may take long: curves of high degree are slow to compose and to look at.
  [[nodiscard]] bool is_cancelled() {
    const Progress& progress = options_.match.progress;
    if (progress && !progress(1.0)) match_.report.cancelled = true;
    return match_.report.cancelled;
  }

  struct Candidate {
    Reparametrization r;
    Curve curve;
    double defect = 0.0;
  };

  [[nodiscard]] Match first_match() const {
    MatchOptions options = options_.match;
    options.reduction = ReductionOptions{{}, kOnPath, 2, options_.law.min_slope};
    return match(a_, b_, options);
  }

  [[nodiscard]] Candidate candidate(const LawOptions& law) const {
    const Correspondence& c = match_.correspondence;
    Reparametrization r =
        in_own_domain(smooth_law(path_, law, c.closed, c.reversed), c.domain_v, b_.domain());
    Curve curve = compose(second_curve(b_, c, r), r.v);
    const double defect = options_.defect(first(curve), curve);
    return {std::move(r), std::move(curve), defect};
  }

  /// The first rail, as long as the second one leaves it.
  [[nodiscard]] Curve first(const Curve& second) const {
    const bool was_cut =
        a_.is_closed() && !match_.correspondence.closed && !(match_.correspondence.domain_u == a_.domain());
    return was_cut ? move_seam(a_, second.domain().lo) : a_;
  }

  /// Takes the refined path if it is better.
  void refine(const Candidate& before) {
    const Curve second = second_curve(b_, match_.correspondence, before.r);
    const FitPath kept = path_;
    const auto take_better = [&](FitPath refined) {
      const FitPath previous = std::exchange(path_, std::move(refined));
      const Candidate after = candidate({2, kOnPath, options_.law.min_slope});
      if (after.defect < defect_) {
        defect_ = after.defect;
        report_.refined = true;
      } else {
        path_ = previous;
      }
    };
    for (const RailNorm* norm : {&options_.refinement, &options_.flipped}) {
      if (!*norm) continue;
      take_better(refine_path(a_, second, kept, *norm, {options_.strain}));
      if (defect_ > options_.slack)
        take_better(refine_path_along_first(a_, second, kept, *norm, {options_.strain}));
    }
  }

  /// A law that was tried, and how it does: higher ranks first, then the smaller defect.
  struct Tried {
    Candidate candidate;
    LawReport report;
    int rank = 0;  ///< 2: good; 1: as good as the path, but creased; 0: worse

    [[nodiscard]] bool beats(const Tried& other) const {
      if (rank != other.rank) return rank > other.rank;
      return rank == 0 && candidate.defect < other.candidate.defect;
    }
  };

  [[nodiscard]] Tried try_law(const LawOptions& law, LawOutcome outcome) const {
    Tried tried{candidate(law), report_, 0};
    tried.report.outcome = outcome;
    tried.report.order = law.order;
    tried.report.tolerance = law.tolerance;
    tried.report.max_deviation = tried.candidate.r.max_deviation;
    if (tried.candidate.defect <= defect_ + (defect_ > 0.0 ? options_.slack : 0.0)) {
      const bool creased =
          options_.creases && options_.creases({match_.correspondence, tried.candidate.r,
                                                tried.candidate.curve, path_.corner_parameters});
      tried.rank = creased ? 1 : 2;
    }
    return tried;
  }

  [[nodiscard]] PairedRails choose_law() {
    std::optional<Tried> best;
    for (int order = options_.law.order; order >= 2; order = std::min(order - 1, 4)) {
      for (int step = 0; step <= kFinest; ++step) {
        LawOptions law = options_.law;
        law.order = order;
        law.tolerance /= std::pow(kFiner, step);
        const LawOutcome outcome = order < options_.law.order ? LawOutcome::lower_order
                                   : step > 0                 ? LawOutcome::finer
                                                              : LawOutcome::as_asked;
        if (best && is_cancelled()) return finish(std::move(best->candidate), best->report);
        Tried next = try_law(law, outcome);
        const bool missed = next.report.max_deviation > law.tolerance;
        if (!best || next.beats(*best)) best = std::move(next);
        if (best->rank == 2) return finish(std::move(best->candidate), told_apart(best->report));
        // A smaller tolerance would change nothing.
        if (missed) break;
      }
    }
    if (best->rank == 0) best->report.outcome = LawOutcome::least_bad;
    return finish(std::move(best->candidate), told_apart(best->report));
  }

  /// A good law may still be one that is not as near to the path as was asked.
  [[nodiscard]] LawReport told_apart(LawReport report) const {
    const bool is_as_asked = report.outcome == LawOutcome::as_asked || report.outcome == LawOutcome::finer;
    if (is_as_asked && report.max_deviation > options_.law.tolerance) {
      report.outcome = LawOutcome::beyond_tolerance;
    }
    return report;
  }

  [[nodiscard]] PairedRails finish(Candidate taken, const LawReport& report) {
    std::vector<double> corners = path_.corner_parameters;
    if (report.refined) match_.correspondence.points = correspondence_points();
    match_.reparametrization = std::move(taken.r);
    match_.curve = std::move(taken.curve);
    return {std::move(match_), report, std::move(corners)};
  }

  [[nodiscard]] std::vector<ParameterPair> correspondence_points() const {
    std::vector<ParameterPair> points = path_.points;
    const Correspondence& c = match_.correspondence;
    if (c.reversed) {
      for (ParameterPair& point : points) point.v = c.domain_v.lo + (c.domain_v.hi - point.v);
    }
    return points;
  }

  const Curve& a_;
  const Curve& b_;
  const RailOptions& options_;
  Match match_;
  FitPath path_;
  double defect_ = 0.0;  ///< of the path itself
  LawReport report_;
};

}  // namespace

double invalidity(const Validity& validity) {
  return validity.valid ? 0.0 : std::max(kSomewhere, 1.0 - validity.valid_share);
}

PairedRails pair_rails(const Curve& a, const Curve& b, const RailOptions& options) {
  return Pairing(a, b, options).run();
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
