#include "tandem/morph/align.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "match/vector.h"
#include "shape/sub_path.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::distance;

// Joints nearer than this along the paths are one, whatever the options say.
constexpr double kSame = 1e-7;
// Two directions further apart than this, by the sine, make a corner.
constexpr double kCorner = 0.05;
// A joint where only one path has a corner should not be dragged as far as others.
constexpr double kMixedCost = 2.0;

// Parameters of paths are right to this.
constexpr double kRounding = 1e-9;

double wrapped(const CubicPath& path, double parameter) {
  const auto n = static_cast<double>(path.segment_count());
  return path.is_closed() ? parameter - std::floor(parameter / n) * n : std::clamp(parameter, 0.0, n);
}

double lerp(double x, double y, double t) {
  return (1.0 - t) * x + t * y;
}

/// Length along a path by its parameters, as a share of the whole: chords of equal parts of each segment.
class LengthShare {
 public:
  explicit LengthShare(const CubicPath& path)
      : n_(static_cast<double>(path.segment_count())), closed_(path.is_closed()) {
    sums_.push_back(0.0);
    Point from(path.segment(0)[0].begin(), path.segment(0)[0].end());
    for (std::size_t i = 0; i < path.segment_count(); ++i) {
      const auto p = path.segment(i);
      for (std::size_t k = 1; k <= kParts; ++k) {
        const double t = static_cast<double>(k) / kParts;
        Point to(from.size());
        for (std::size_t c = 0; c < to.size(); ++c) to[c] = cubic_at({p[0][c], p[1][c], p[2][c], p[3][c]}, t);
        sums_.push_back(sums_.back() + distance(from, to));
        from = std::move(to);
      }
    }
    if (sums_.back() > 0.0) {
      const double whole = sums_.back();
      for (double& sum : sums_) sum /= whole;
    }
  }

  /// Runs on, lap by lap, on a closed path.
  [[nodiscard]] double operator()(double parameter) const {
    const double laps = closed_ ? std::floor(parameter / n_) : 0.0;
    const double x = std::clamp(parameter - laps * n_, 0.0, n_) * kParts;
    const auto k = std::min(static_cast<std::size_t>(x), sums_.size() - 2);
    return laps + lerp(sums_[k], sums_[k + 1], x - static_cast<double>(k));
  }

 private:
  static constexpr std::size_t kParts = 16;
  double n_;
  bool closed_;
  std::vector<double> sums_;
};

/// A joint of the redrawn paths.
struct Joint {
  double u = 0.0;
  double v = 0.0;
  bool of_a = false;
  bool of_b = false;
  double along = 0.0;  ///< the lengths run through on both paths
};

/// The direction in which the path leaves (side +1) or reaches (-1) a joint; zero if it stands still.
Point direction(const CubicPath& path, std::size_t joint, int side) {
  const std::size_t n = path.segment_count();
  const std::size_t segment = side > 0 ? joint % n : (joint + n - 1) % n;
  const auto p = path.segment(segment);
  Point d(p[0].size());
  for (std::size_t k = 1; k < 4; ++k) {
    const auto from = side > 0 ? p[0] : p[3 - k];
    const auto to = side > 0 ? p[k] : p[3];
    for (std::size_t c = 0; c < d.size(); ++c) d[c] = to[c] - from[c];
    if (detail::normalize(d) > 0.0) break;
  }
  return d;
}

class Aligner {
 public:
  Aligner(const CubicPath& a, const CubicPath& b, const Correspondence& c, const AlignOptions& options)
      : a_(a), b_(b), c_(c), options_(options), length_a_(a), length_b_(b) {}

  AlignedPaths run() {
    collect();
    snap();
    add_where_it_strays();
    std::vector<double> cuts_a;
    std::vector<double> cuts_b;
    for (const Joint& joint : joints_) {
      cuts_a.push_back(joint.u);
      cuts_b.push_back(joint.v);
    }
    return {cut_at(a_, cuts_a, c_.closed), cut_at(b_, cuts_b, c_.closed), std::move(cuts_a),
            std::move(cuts_b)};
  }

 private:
  [[nodiscard]] double along(double u, double v) const {
    return length_a_(u) + (c_.reversed ? -length_b_(v) : length_b_(v));
  }
  [[nodiscard]] Joint joint_at(double u, double v, bool of_a, bool of_b) const {
    return {u, v, of_a, of_b, along(u, v)};
  }

  // All joints of both, in order; first and last the ends.
  void collect() {
    const ParameterPair front = c_.points.front();
    const ParameterPair back = c_.points.back();
    double u0 = front.u;
    double u1 = back.u;
    double v0 = front.v;
    double v1 = back.v;
    if (c_.closed) {  // from a joint of the first path, so that no joint is added at the seam
      u0 = std::ceil(front.u);
      u1 = u0 + static_cast<double>(a_.segment_count());
      v0 = c_.v_at(u0);
      v1 = v0 + (c_.reversed ? -1.0 : 1.0) * static_cast<double>(b_.segment_count());
    }
    joints_.push_back(joint_at(u0, v0, true, !c_.closed));
    for (double u = std::floor(u0) + 1.0; u < u1; u += 1.0)
      joints_.push_back(joint_at(u, c_.v_at(u), true, false));
    const double lo = std::min(v0, v1);
    const double hi = std::max(v0, v1);
    for (double v = c_.closed ? std::ceil(lo) : std::floor(lo) + 1.0; v < hi; v += 1.0) {
      double u = c_.u_at(v);
      if (c_.closed) u = std::clamp(u, u0, u1);
      joints_.push_back(joint_at(u, v, false, true));
    }
    joints_.push_back(joint_at(u1, v1, true, !c_.closed));
    for (const ParameterPair& pin : options_.pins) add_pin(pin, {u0, u1});
    std::stable_sort(joints_.begin() + 1, joints_.end() - 1,
                     [](const Joint& x, const Joint& y) { return x.along < y.along; });
  }

  // In place of the joints that are there already.
  void add_pin(ParameterPair pin, const Interval& range) {
    if (c_.closed) {
      const double lap = static_cast<double>(a_.segment_count());
      const double other = static_cast<double>(b_.segment_count());
      pin.u += std::ceil((range.lo - pin.u) / lap) * lap;
      pin.v += std::floor((c_.v_at(pin.u) - pin.v) / other + 0.5) * other;
    }
    const Joint joint = joint_at(pin.u, pin.v, true, true);
    const auto same = [&](const Joint& x) { return std::fabs(x.along - joint.along) <= kSame; };
    if (same(joints_.front()) || same(joints_.back())) {  // the seam, which stays where it is
      joints_.front().of_b = joints_.back().of_b = true;
      const auto there = [&](const Joint& x) {
        return x.along - joints_.front().along <= kSame || joints_.back().along - x.along <= kSame;
      };
      joints_.erase(std::remove_if(joints_.begin() + 1, joints_.end() - 1, there), joints_.end() - 1);
      return;
    }
    joints_.erase(std::remove_if(joints_.begin(), joints_.end(), same), joints_.end());
    joints_.insert(joints_.end() - 1, joint);
  }

  [[nodiscard]] bool is_corner(const CubicPath& path, double parameter) const {
    const double n = static_cast<double>(path.segment_count());
    const double at = wrapped(path, parameter);
    if (!path.is_closed() && (at <= 0.0 || at >= n)) return true;
    const auto joint = static_cast<std::size_t>(at);
    const Point in = direction(path, joint, -1);
    const Point out = direction(path, joint, +1);
    return detail::dot(in, out) < std::sqrt(1.0 - kCorner * kCorner);
  }

  [[nodiscard]] double snap_cost(const Joint& x, const Joint& y) const {
    const double gap = 0.5 * (y.along - x.along);
    const Joint& a = x.of_a ? x : y;
    const Joint& b = x.of_a ? y : x;
    return is_corner(a_, a.u) == is_corner(b_, b.v) ? gap : kMixedCost * gap;
  }

  // Joins neighbours of different paths, the nearest first.
  void snap() {
    struct Candidate {
      double cost;
      std::size_t first;
    };
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i + 1 < joints_.size(); ++i) {
      const Joint& x = joints_[i];
      const Joint& y = joints_[i + 1];
      if ((x.of_a && y.of_a) || (x.of_b && y.of_b)) continue;
      const double cost = snap_cost(x, y);
      if (cost <= std::max(options_.snap, kSame)) candidates.push_back({cost, i});
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& x, const Candidate& y) { return x.cost < y.cost; });
    std::vector<bool> dropped(joints_.size(), false);
    std::vector<bool> used(joints_.size(), false);
    const std::size_t last = joints_.size() - 1;
    for (const Candidate& candidate : candidates) {
      const std::size_t i = candidate.first;
      if (used[i] || used[i + 1]) continue;
      // The seam is one joint, at both ends of the list.
      if (c_.closed && ((i == 0 && used[last]) || (i + 1 == last && used[0]))) continue;
      used[i] = used[i + 1] = true;
      Joint& x = joints_[i];
      Joint& y = joints_[i + 1];
      const double period =
          c_.reversed ? -static_cast<double>(b_.segment_count()) : static_cast<double>(b_.segment_count());
      if (i + 1 == last) {
        if (c_.closed) {
          y.v = x.v;
          joints_[0].v = x.v - period;
          used[0] = used[last] = true;
        }
        dropped[i] = true;
      } else {
        if (x.of_a) {
          x.v = y.v;
        } else {
          x.u = y.u;
        }
        if (i == 0 && c_.closed) {
          joints_[last].v = x.v + period;
          used[0] = used[last] = true;
        }
        x.of_a = x.of_b = true;
        dropped[i + 1] = true;
      }
    }
    std::vector<Joint> kept;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (!dropped[i]) kept.push_back(joints_[i]);
    }
    joints_ = std::move(kept);
  }

  // How far, on the second path, a piece strays from the correspondence at (u, v).
  [[nodiscard]] double stray(const Joint& from, const Joint& to, ParameterPair at) const {
    const double du = to.u - from.u;
    const double share = du > 0.0 ? (at.u - from.u) / du : 0.5;
    const double on_b = std::fabs(length_b_(lerp(from.v, to.v, share)) - length_b_(at.v));
    const double dv = to.v - from.v;
    const double back = dv != 0.0 ? (at.v - from.v) / dv : 0.5;
    const double on_a = std::fabs(length_a_(lerp(from.u, to.u, back)) - length_a_(at.u));
    return std::min(on_a, on_b);
  }

  void add_where_it_strays() {
    std::vector<Joint> result{joints_.front()};
    for (std::size_t i = 0; i + 1 < joints_.size(); ++i) {
      refine(result, joints_[i], joints_[i + 1], path_between(joints_[i], joints_[i + 1]));
      result.push_back(joints_[i + 1]);
    }
    joints_ = std::move(result);
  }

  // The correspondence's own points strictly between two joints.
  [[nodiscard]] std::vector<ParameterPair> path_between(const Joint& from, const Joint& to) const {
    std::vector<ParameterPair> inside;
    const double lap_u = static_cast<double>(a_.segment_count());
    const double lap_v = (c_.reversed ? -1.0 : 1.0) * static_cast<double>(b_.segment_count());
    for (const double lap : {0.0, 1.0}) {
      if (lap > 0.0 && !c_.closed) break;
      for (const ParameterPair& p : c_.points) {
        const ParameterPair q{p.u + lap * lap_u, p.v + lap * lap_v};
        const bool between_u = from.u < q.u && q.u < to.u;
        const bool between_v = c_.reversed ? to.v < q.v && q.v < from.v : from.v < q.v && q.v < to.v;
        if (between_u && between_v) inside.push_back(q);
      }
    }
    return inside;
  }

  void refine(std::vector<Joint>& result, const Joint& from, const Joint& to,
              std::span<const ParameterPair> inside) const {
    double worst = options_.stray;
    std::size_t at = inside.size();
    for (std::size_t k = 0; k < inside.size(); ++k) {
      const double off = stray(from, to, inside[k]);
      if (off > worst) {
        worst = off;
        at = k;
      }
    }
    if (at == inside.size()) return;
    const Joint joint = joint_at(inside[at].u, inside[at].v, false, false);
    refine(result, from, joint, inside.first(at));
    result.push_back(joint);
    refine(result, joint, to, inside.subspan(at + 1));
  }

  const CubicPath& a_;
  const CubicPath& b_;
  const Correspondence& c_;
  const AlignOptions& options_;
  LengthShare length_a_;
  LengthShare length_b_;
  std::vector<Joint> joints_;
};

void check(const CubicPath& a, const CubicPath& b, const Correspondence& correspondence) {
  if (a.dim() != b.dim()) {
    throw InvalidArgument(fmt::format("align: the paths have dimensions {} and {}", a.dim(), b.dim()));
  }
  const auto fits = [](const CubicPath& path, const Interval& domain) {
    // A closed path that was cut has its domain elsewhere, with a rounding.
    return std::fabs(domain.length() - static_cast<double>(path.segment_count())) <= kRounding;
  };
  if (correspondence.points.size() < 2 || !fits(a, correspondence.domain_u) ||
      !fits(b, correspondence.domain_v)) {
    throw InvalidArgument("align: the correspondence is not one of these paths' own parameters");
  }
}

/// Whether a joint lies between two parameters.
bool reaches_over(double from, double to) {
  return std::floor(std::min(from, to) + kRounding) + 1.0 < std::max(from, to) - kRounding;
}

}  // namespace

AlignedPaths align(const CubicPath& a, const CubicPath& b, const Correspondence& correspondence,
                   const AlignOptions& options) {
  check(a, b, correspondence);
  return Aligner(a, b, correspondence, options).run();
}

AlignedPaths cut_in_step(const CubicPath& a, const CubicPath& b, const Correspondence& correspondence) {
  check(a, b, correspondence);
  std::vector<double> cuts_a;
  std::vector<double> cuts_b;
  for (const ParameterPair& point : correspondence.points) {
    if (!cuts_a.empty() && (reaches_over(cuts_a.back(), point.u) || reaches_over(cuts_b.back(), point.v))) {
      throw InvalidArgument(fmt::format(
          "align: the correspondence reaches over a joint between (u = {}, v = {}) and (u = {}, v = {})",
          cuts_a.back(), cuts_b.back(), point.u, point.v));
    }
    cuts_a.push_back(point.u);
    cuts_b.push_back(point.v);
  }
  return {cut_at(a, cuts_a, correspondence.closed), cut_at(b, cuts_b, correspondence.closed),
          std::move(cuts_a), std::move(cuts_b)};
}

}  // namespace v0
}  // namespace tandem
