#include "tandem/shape/cut.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "shape/cut_boundary.h"
#include "shape/plane.h"
#include "shape/sub_path.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

// Distinct chords that are followed at each halving of up to kFewTargets targets; beyond that only one.
constexpr std::size_t kBranches = 3;
constexpr std::size_t kFewTargets = 4;

// Places by which an end of a chord must differ from one that is followed already.
constexpr std::size_t kDistinct = 4;

// Share of the contour that the smallest piece must have at least, as a share of what it should have.
constexpr double kLeastShare = 0.05;

// Area, in squared diagonals, up to which a contour encloses nothing but rounding.
constexpr double kNothing = 1e-12;

void check(const CubicPath& contour, std::span<const PieceTarget> targets, std::span<const CubicPath> holes,
           const CutOptions& options) {
  if (targets.empty()) throw InvalidArgument("cut: no targets, expected one per piece");
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (!(targets[i].share > 0.0 && std::isfinite(targets[i].share))) {
      throw InvalidArgument(fmt::format("cut: share {} is {}, expected > 0", i, targets[i].share));
    }
  }
  if (!contour.is_closed()) throw InvalidArgument("cut: the contour is open, expected a closed one");
  for (std::size_t i = 0; i < holes.size(); ++i) {
    if (!holes[i].is_closed()) throw InvalidArgument(fmt::format("cut: hole {} is open, expected closed", i));
  }
  for (const double weight : {options.length_weight, options.share_weight, options.center_weight}) {
    if (!(weight >= 0.0)) throw InvalidArgument(fmt::format("cut: a weight is {}, expected >= 0", weight));
  }
}

using Group = std::vector<std::size_t>;  // of targets

/// A chord, and which targets go to which side of it.
struct Halving {
  double cost = 0.0;
  std::size_t a = 0;
  std::size_t b = 0;
  Group first;  ///< from place a on to b
  Group second;
};

struct Plan {
  double cost = std::numeric_limits<double>::infinity();
  std::vector<std::pair<std::size_t, CutPiece>> pieces;
};

class Cutter {
 public:
  Cutter(const CubicPath& contour, std::span<const PieceTarget> targets, std::span<const CubicPath> holes,
         const CutOptions& options)
      : holes_(holes), targets_(targets.begin(), targets.end()), options_(options) {
    scale_ = bounding_box(to_curve(contour)).diagonal();
    double sum = 0.0;
    for (const PieceTarget& target : targets_) sum += target.share;
    for (PieceTarget& target : targets_) target.share /= sum;
    have_centers_ = std::all_of(targets_.begin(), targets_.end(),
                                [](const PieceTarget& target) { return target.center.has_value(); });
    if (scale_ > 0.0) area_ = CutBoundary(contour, holes_, scale_).whole().area;
  }

  Plan run(const CubicPath& contour) const {
    if (std::abs(area_) <= kNothing) return {};
    Group all(targets_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return divide({contour, std::vector<bool>(contour.segment_count(), false)}, all);
  }

 private:
  Plan divide(CutPiece piece, const Group& group) const {
    const CutBoundary boundary(piece.path, holes_, scale_);
    Plan best;
    if (group.size() == 1) {
      best.cost = misfit(boundary, boundary.whole(), group);
      best.pieces.emplace_back(group.front(), std::move(piece));
      return best;
    }
    for (const Halving& halving : choose(boundary, group)) {
      const double u = boundary.parameter(halving.a);
      const double v = boundary.parameter(halving.b);
      Plan first = divide(close_by_chord(piece, u, v), halving.first);
      Plan second = divide(close_by_chord(piece, v, u), halving.second);
      const double cost = chord_cost(boundary, halving.a, halving.b) + first.cost + second.cost;
      if (!(cost < best.cost)) continue;
      best.cost = cost;
      best.pieces = std::move(first.pieces);
      std::move(second.pieces.begin(), second.pieces.end(), std::back_inserter(best.pieces));
    }
    return best;
  }

  // The cheapest chords that fit, different from each other.
  std::vector<Halving> choose(const CutBoundary& boundary, const Group& group) const {
    std::vector<Halving> all;
    for (std::size_t a = 0; a < boundary.size(); ++a) {
      for (std::size_t b = a + 1; b < boundary.size(); ++b) {
        if (auto halving = share_out(boundary, a, b, group)) all.push_back(std::move(*halving));
      }
    }
    std::sort(all.begin(), all.end(), [](const Halving& p, const Halving& q) {
      return p.cost != q.cost ? p.cost < q.cost : std::pair(p.a, p.b) < std::pair(q.a, q.b);
    });
    const std::size_t most = targets_.size() <= kFewTargets && group.size() > 2 ? kBranches : 1;
    const auto near = [&](std::size_t i, std::size_t j) {
      const std::size_t apart = i < j ? j - i : i - j;
      return std::min(apart, boundary.size() - apart) < kDistinct;
    };
    std::vector<Halving> chosen;
    for (Halving& halving : all) {
      if (chosen.size() == most) break;
      const bool known = std::any_of(chosen.begin(), chosen.end(), [&](const Halving& other) {
        return near(other.a, halving.a) && near(other.b, halving.b);
      });
      if (!known && boundary.admits(halving.a, halving.b)) chosen.push_back(std::move(halving));
    }
    return chosen;
  }

  // The best of the ways to share out the targets to both sides of a chord: from one side to the other when
  // they have places, else from the smallest share to the largest, and either end of the row to either side.
  std::optional<Halving> share_out(const CutBoundary& boundary, std::size_t a, std::size_t b,
                                   const Group& group) const {
    const Region whole = boundary.whole();
    const Region first = boundary.side(a, b);
    const Region second{whole.area - first.area, rest(whole, first)};
    // Beyond a chord outside the contour areas have other signs.
    if (!(first.area / area_ > 0.0 && second.area / area_ > 0.0)) return std::nullopt;
    const Vec2 axis = minus(second.centroid, first.centroid);
    Group row = group;
    std::sort(row.begin(), row.end(), [&](std::size_t i, std::size_t j) {
      const auto key = [&](std::size_t k) {
        return have_centers_ ? dot(axis, boundary.to_flat(*targets_[k].center)) : targets_[k].share;
      };
      return key(i) != key(j) ? key(i) < key(j) : i < j;
    });
    std::optional<Halving> best;
    for (std::size_t count = 1; count < row.size(); ++count) {
      for (const bool front : {true, false}) {
        const auto cut = row.begin() + static_cast<std::ptrdiff_t>(count);
        Group low(row.begin(), cut);
        Group high(cut, row.end());
        if (!front) std::swap(low, high);
        if (first.area / area_ < kLeastShare * share_of(low) ||
            second.area / area_ < kLeastShare * share_of(high)) {
          continue;
        }
        const double cost =
            chord_cost(boundary, a, b) + misfit(boundary, first, low) + misfit(boundary, second, high);
        if (!best || cost < best->cost) best = Halving{cost, a, b, std::move(low), std::move(high)};
      }
    }
    return best;
  }

  static Vec2 rest(const Region& whole, const Region& part) {
    const double area = whole.area - part.area;
    if (area == 0.0) return whole.centroid;
    return times(1.0 / area, minus(times(whole.area, whole.centroid), times(part.area, part.centroid)));
  }

  double chord_cost(const CutBoundary& boundary, std::size_t a, std::size_t b) const {
    return options_.length_weight * distance(boundary.point(a), boundary.point(b));
  }

  double share_of(const Group& group) const {
    double share = 0.0;
    for (const std::size_t i : group) share += targets_[i].share;
    return share;
  }

  // How far a region is from what a group of targets should have together.
  double misfit(const CutBoundary& boundary, const Region& region, const Group& group) const {
    const double share = share_of(group);
    double cost = options_.share_weight * std::abs(region.area / area_ - share);
    if (!have_centers_) return cost;
    Vec2 center;
    for (const std::size_t i : group) {
      center = plus(center, times(targets_[i].share / share, boundary.to_flat(*targets_[i].center)));
    }
    return cost + options_.center_weight * share * distance(center, region.centroid);
  }

  std::span<const CubicPath> holes_;
  std::vector<PieceTarget> targets_;
  CutOptions options_;
  bool have_centers_ = false;
  double scale_ = 0.0;
  double area_ = 0.0;
};

}  // namespace

std::vector<CutPiece> cut_contour(const CubicPath& contour, std::span<const PieceTarget> targets,
                                  std::span<const CubicPath> holes, const CutOptions& options) {
  check(contour, targets, holes, options);
  Plan plan = Cutter(contour, targets, holes, options).run(contour);
  std::sort(plan.pieces.begin(), plan.pieces.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<CutPiece> pieces;
  for (auto& [target, piece] : plan.pieces) pieces.push_back(std::move(piece));
  return pieces;
}

}  // namespace v0
}  // namespace tandem
