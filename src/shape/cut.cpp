#include "tandem/shape/cut.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
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

/// A chord, and how many of the targets, in the order that share_out puts them in, go to one side of it.
struct Halving {
  double cost = 0.0;
  std::size_t a = 0;
  std::size_t b = 0;
  std::size_t count = 0;
  bool front = true;  ///< they go to the side from place a on to b; otherwise the others do
};

/// Targets that belong together.
struct Wish {
  double share = 0.0;
  Vec2 moment;  ///< sum of share times centre

  void add(double target_share, Vec2 center) {
    share += target_share;
    moment = plus(moment, times(target_share, center));
  }
  [[nodiscard]] Wish without(const Wish& other) const {
    return {share - other.share, minus(moment, other.moment)};
  }
};

struct Plan {
  double cost = std::numeric_limits<double>::infinity();
  std::map<std::size_t, CutPiece> pieces;  ///< by the target that each becomes
};

// Whether more than half of the hole's joints lie in the polygon through the path's control points: a hole
// that is clear of a chord lies on one side of it.
bool lies_in(const CubicPath& hole, const CubicPath& path) {
  std::size_t inside = 0;
  for (std::size_t i = 0; i < hole.segment_count(); ++i) {
    const Vec2 p{hole.segment(i)[0][0], hole.segment(i)[0][1]};
    bool in = false;
    const Points& q = path.control_points();
    for (std::size_t k = 0; k + 1 < q.size(); ++k) {
      const Vec2 a{q[k][0], q[k][1]};
      const Vec2 b{q[k + 1][0], q[k + 1][1]};
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) in = !in;
    }
    if (in) ++inside;
  }
  return 2 * inside > hole.segment_count();
}

double outline_length(const CubicPath& path) {
  double sum = 0.0;
  const Points& p = path.control_points();
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    sum += distance({p[i][0], p[i][1]}, {p[i + 1][0], p[i + 1][1]});
  }
  return sum;
}

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
    CutPiece whole{contour, std::vector<bool>(contour.segment_count(), false)};
    if (options_.outlines) whole.outline = contour;
    return divide(std::move(whole), all);
  }

 private:
  Plan divide(CutPiece piece, const Group& group) const {
    const CutBoundary boundary(piece.path, holes_, scale_);
    Plan best;
    if (group.size() == 1) {
      best.cost = misfit(boundary.whole(), wish_of(boundary, group));
      best.pieces.emplace(group.front(), std::move(piece));
      return best;
    }
    for (const Halving& halving : choose(boundary, group)) {
      const double u = boundary.parameter(halving.a);
      const double v = boundary.parameter(halving.b);
      const Group row = put_in_order(boundary, halving.a, halving.b, group);
      const auto cut = row.begin() + static_cast<std::ptrdiff_t>(halving.count);
      const Group low(row.begin(), cut);
      const Group high(cut, row.end());
      Halves halves = halved(piece, u, v);
      Plan first = divide(std::move(halves.first), halving.front ? low : high);
      Plan second = divide(std::move(halves.second), halving.front ? high : low);
      const double cost = chord_cost(boundary, halving.a, halving.b) + first.cost + second.cost;
      if (!(cost < best.cost)) continue;
      best.cost = cost;
      best.pieces = std::move(first.pieces);
      best.pieces.merge(second.pieces);
    }
    return best;
  }

  // A chord is pushed onto the side without holes, else onto the one that has less to go round.
  Halves halved(const CutPiece& piece, double u, double v) const {
    Halves halves = cut_by_chord(piece, u, v);
    if (!options_.outlines) return halves;
    const auto holds = [&](const CutPiece& half) {
      return std::any_of(holes_.begin(), holes_.end(),
                         [&](const CubicPath& hole) { return lies_in(hole, half.path); });
    };
    const bool first = holds(halves.first);
    const bool second = holds(halves.second);
    if (first && second) return halves;
    const bool shorter = outline_length(halves.first.path) < outline_length(halves.second.path);
    return cut_and_push(piece, u, v, first == second ? shorter : second);
  }

  // The cheapest chords that fit, different from each other.
  std::vector<Halving> choose(const CutBoundary& boundary, const Group& group) const {
    std::vector<Halving> all;
    for (std::size_t a = 0; a < boundary.size(); ++a) {
      for (std::size_t b = a + 1; b < boundary.size(); ++b) {
        if (auto halving = share_out(boundary, a, b, group)) all.push_back(*halving);
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
    std::size_t last_block = 0;
    for (const Halving& halving : all) {
      if (chosen.size() == most) break;
      const bool known = std::any_of(chosen.begin(), chosen.end(), [&](const Halving& other) {
        return near(other.a, halving.a) && near(other.b, halving.b);
      });
      if (!known && boundary.admits(halving.a, halving.b, last_block)) chosen.push_back(halving);
    }
    return chosen;
  }

  // The targets from one side of a chord to the other when they have places, else from the smallest share to
  // the largest.
  Group put_in_order(const CutBoundary& boundary, std::size_t a, std::size_t b, const Group& group) const {
    const Region first = boundary.side(a, b);
    const Vec2 axis = minus(rest(boundary.whole(), first).centroid, first.centroid);
    Group row = group;
    std::sort(row.begin(), row.end(), [&](std::size_t i, std::size_t j) {
      const auto key = [&](std::size_t k) {
        return have_centers_ ? dot(axis, boundary.to_flat(*targets_[k].center)) : targets_[k].share;
      };
      return key(i) != key(j) ? key(i) < key(j) : i < j;
    });
    return row;
  }

  // The best of the ways to share out the targets: either end of the row to either side.
  std::optional<Halving> share_out(const CutBoundary& boundary, std::size_t a, std::size_t b,
                                   const Group& group) const {
    const Region first = boundary.side(a, b);
    const Region second = rest(boundary.whole(), first);
    // Beyond a chord outside the contour areas have other signs.
    if (!(first.area / area_ > 0.0 && second.area / area_ > 0.0)) return std::nullopt;
    const Group row = put_in_order(boundary, a, b, group);
    const Wish all = wish_of(boundary, row);
    const double length = chord_cost(boundary, a, b);
    std::optional<Halving> best;
    Wish low;
    for (std::size_t count = 1; count < row.size(); ++count) {
      low.add(targets_[row[count - 1]].share, center_of(boundary, row[count - 1]));
      const Wish high = all.without(low);
      for (const bool front : {true, false}) {
        const Wish& one = front ? low : high;
        const Wish& other = front ? high : low;
        if (first.area / area_ < kLeastShare * one.share || second.area / area_ < kLeastShare * other.share) {
          continue;
        }
        const double cost = length + misfit(first, one) + misfit(second, other);
        if (!best || cost < best->cost) best = Halving{cost, a, b, count, front};
      }
    }
    return best;
  }

  // The whole without a part of it.
  static Region rest(const Region& whole, const Region& part) {
    const double area = whole.area - part.area;
    if (area == 0.0) return {0.0, whole.centroid};
    return {area,
            times(1.0 / area, minus(times(whole.area, whole.centroid), times(part.area, part.centroid)))};
  }

  Vec2 center_of(const CutBoundary& boundary, std::size_t target) const {
    return have_centers_ ? boundary.to_flat(*targets_[target].center) : Vec2{};
  }

  Wish wish_of(const CutBoundary& boundary, const Group& group) const {
    Wish wish;
    for (const std::size_t i : group) wish.add(targets_[i].share, center_of(boundary, i));
    return wish;
  }

  double chord_cost(const CutBoundary& boundary, std::size_t a, std::size_t b) const {
    return options_.length_weight * distance(boundary.point(a), boundary.point(b));
  }

  // How far a region is from what its targets should have together.
  double misfit(const Region& region, const Wish& wish) const {
    const double cost = options_.share_weight * std::abs(region.area / area_ - wish.share);
    if (!have_centers_) return cost;
    const Vec2 center = times(1.0 / wish.share, wish.moment);
    return cost + options_.center_weight * wish.share * distance(center, region.centroid);
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
  std::vector<CutPiece> pieces;
  for (auto& [target, piece] : plan.pieces) pieces.push_back(std::move(piece));
  return pieces;
}

}  // namespace v0
}  // namespace tandem
