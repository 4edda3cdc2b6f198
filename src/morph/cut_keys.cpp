#include "morph/cut_keys.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "shape/plane.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/curve/nearest_point.h"
#include "tandem/shape/cut.h"
#include "tandem/shape/measures.h"
#include "tandem/shape/nesting.h"
#include "tandem/shape/transform.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Pieces of one contour at most: more are lumps that nobody follows, and the search for cuts gets slow.
constexpr std::size_t kMostPieces = 6;

// Pieces go to where they belong rather than be cut by the shortest chords: what moves across others on the
// way is seen, a chord is not.
constexpr double kCenterWeight = 6.0;

// How far what is pushed out onto a contour may be off it, as a share of its size.
constexpr double kOnContour = 1e-6;

struct Extent {
  Vec2 lo;
  Vec2 hi;

  [[nodiscard]] Vec2 center() const { return middle(lo, hi); }
  void include(const Extent& other) {
    lo = {std::min(lo.x, other.lo.x), std::min(lo.y, other.lo.y)};
    hi = {std::max(hi.x, other.hi.x), std::max(hi.y, other.hi.y)};
  }
  [[nodiscard]] double distance_to(Vec2 p) const {
    const double x = std::max({lo.x - p.x, 0.0, p.x - hi.x});
    const double y = std::max({lo.y - p.y, 0.0, p.y - hi.y});
    return length({x, y});
  }
  // Where p is when this box becomes another one.
  [[nodiscard]] Vec2 moved(Vec2 p, const Extent& other) const {
    const auto along = [](double x, double from_lo, double from_hi, double to_lo, double to_hi) {
      const double size = from_hi - from_lo;
      return size > 0.0 ? to_lo + (x - from_lo) / size * (to_hi - to_lo) : 0.5 * (to_lo + to_hi);
    };
    return {along(p.x, lo.x, hi.x, other.lo.x, other.hi.x), along(p.y, lo.y, hi.y, other.lo.y, other.hi.y)};
  }
};

Extent extent_of(const CubicPath& path) {
  const Box box = bounding_box(to_curve(path));
  return {{box.lo[0], box.lo[1]}, {box.hi[0], box.hi[1]}};
}

/// A drawing's outermost solids and their holes.
struct Solids {
  std::vector<Extent> extents;  // of all contours
  std::vector<NestedContour> nesting;
  Extent whole;

  explicit Solids(std::span<const CubicPath> paths) : nesting(find_nesting(paths, FillRule::nonzero)) {
    for (const CubicPath& path : paths) extents.push_back(extent_of(path));
    whole = extents.front();
    for (const Extent& extent : extents) whole.include(extent);
  }
  [[nodiscard]] bool is_outer(std::size_t i) const {
    return nesting[i].role == ContourRole::solid && nesting[i].depth == 0 && !nesting[i].changes_nothing;
  }
};

// Between two pieces with holes a chord is not pushed out onto the contour, nor, maybe but for an end that
// lies on another chord: it would be a line that the key does not have.
bool shows_chord(const CutPiece& piece, const Curve& contour) {
  const double tolerance = kOnContour * contour.extent();
  for (std::size_t i = 0; i < piece.chords.size(); ++i) {
    if (!piece.chords[i]) continue;
    const auto q = piece.outline->segment(i);
    Point middle(2);
    for (std::size_t c = 0; c < 2; ++c) middle[c] = 0.125 * (q[0][c] + 3.0 * (q[1][c] + q[2][c]) + q[3][c]);
    if (nearest_point(contour, middle).distance > tolerance) return true;
  }
  return false;
}

std::vector<CubicPath> turned(std::span<const CubicPath> paths, double degrees) {
  const Transform turn = Transform::rotate_degrees(degrees);
  std::vector<CubicPath> all;
  for (const CubicPath& path : paths) {
    Points points = path.control_points();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 p = turn({points[i][0], points[i][1]});
      points[i][0] = p.x;
      points[i][1] = p.y;
    }
    all.emplace_back(std::move(points), path.is_closed());
  }
  return all;
}

/// One key with few solids, and one with many.
class Sharing {
 public:
  // many: turned to lie as `few` does. partner: of each contour of many, in few.
  Sharing(std::span<const CubicPath> few, std::vector<CubicPath> many,
          std::vector<std::optional<std::size_t>> partner)
      : few_(few),
        many_paths_(std::move(many)),
        one_(few),
        many_(many_paths_),
        partner_(std::move(partner)) {}

  std::optional<std::vector<KeyPart>> cut() const {
    const std::vector<std::vector<std::size_t>> groups = share_out();
    std::vector<KeyPart> parts;
    bool any = false;
    for (std::size_t i = 0; i < few_.size(); ++i) {
      if (groups[i].size() < 2) {
        parts.push_back({few_[i], i});
        continue;
      }
      std::vector<CutPiece> pieces = cut_contour(few_[i], targets_of(i, groups[i]), holes_of(i),
                                                 {.center_weight = kCenterWeight, .outlines = true});
      const Curve contour = to_curve(few_[i]);
      const auto shows = [&](const CutPiece& piece) { return shows_chord(piece, contour); };
      if (std::any_of(pieces.begin(), pieces.end(), shows)) pieces.clear();
      any = any || !pieces.empty();
      if (pieces.empty()) parts.push_back({few_[i], i});
      for (CutPiece& piece : pieces) parts.push_back({std::move(piece.path), i, std::move(piece.outline)});
    }
    if (!any) return std::nullopt;
    return parts;
  }

 private:
  // Per contour of few: those of many that it becomes.
  [[nodiscard]] std::vector<std::vector<std::size_t>> share_out() const {
    std::vector<std::vector<std::size_t>> groups(few_.size());
    for (std::size_t j = 0; j < partner_.size(); ++j) {
      if (partner_[j] && many_.is_outer(j) && one_.is_outer(*partner_[j])) groups[*partner_[j]].push_back(j);
    }
    std::vector<std::pair<double, std::pair<std::size_t, std::size_t>>> wishes;
    for (std::size_t j = 0; j < partner_.size(); ++j) {
      if (partner_[j] || !many_.is_outer(j)) continue;
      double nearest = std::numeric_limits<double>::infinity();
      std::size_t best = 0;
      for (std::size_t i = 0; i < few_.size(); ++i) {
        if (groups[i].empty()) continue;
        const double d =
            one_.extents[i].distance_to(many_.whole.moved(many_.extents[j].center(), one_.whole));
        if (d < nearest) {
          nearest = d;
          best = i;
        }
      }
      if (nearest < std::numeric_limits<double>::infinity()) wishes.push_back({nearest, {best, j}});
    }
    std::sort(wishes.begin(), wishes.end());
    for (const auto& [d, wish] : wishes) {
      if (groups[wish.first].size() < kMostPieces) groups[wish.first].push_back(wish.second);
    }
    return groups;
  }

  [[nodiscard]] std::vector<PieceTarget> targets_of(std::size_t i,
                                                    const std::vector<std::size_t>& group) const {
    Extent box = many_.extents[group.front()];
    for (const std::size_t j : group) box.include(many_.extents[j]);
    std::vector<PieceTarget> targets;
    for (const std::size_t j : group) {
      const double area = std::fabs(signed_area(many_paths_[j]));
      targets.push_back({std::max(area, std::numeric_limits<double>::min()),
                         box.moved(many_.extents[j].center(), one_.extents[i])});
    }
    return targets;
  }

  [[nodiscard]] std::vector<CubicPath> holes_of(std::size_t i) const {
    std::vector<CubicPath> holes;
    for (std::size_t h = 0; h < few_.size(); ++h) {
      if (one_.nesting[h].parent == i && few_[h].is_closed()) holes.push_back(few_[h]);
    }
    return holes;
  }

  std::span<const CubicPath> few_;
  std::vector<CubicPath> many_paths_;
  Solids one_;
  Solids many_;
  std::vector<std::optional<std::size_t>> partner_;
};

std::vector<KeyPart> whole_parts(std::span<const CubicPath> paths) {
  std::vector<KeyPart> parts;
  for (std::size_t i = 0; i < paths.size(); ++i) parts.push_back({paths[i], i});
  return parts;
}

}  // namespace

std::optional<CutKeys> cut_keys(std::span<const CubicPath> a, std::span<const CubicPath> b,
                                std::span<const ContourPair> pairs, const Rotation& turn) {
  if (a.size() == b.size() && a.size() == 1) return std::nullopt;
  std::vector<std::optional<std::size_t>> of_a(a.size());
  std::vector<std::optional<std::size_t>> of_b(b.size());
  for (const ContourPair& pair : pairs) {
    if (!pair.a || !pair.b) continue;
    of_a[*pair.a] = pair.b;
    of_b[*pair.b] = pair.a;
  }
  const double degrees = turn.degrees();
  auto cut_a = Sharing(a, turned(b, -degrees), std::move(of_b)).cut();
  auto cut_b = Sharing(b, turned(a, degrees), std::move(of_a)).cut();
  if (!cut_a && !cut_b) return std::nullopt;
  return CutKeys{cut_a ? *std::move(cut_a) : whole_parts(a), cut_b ? *std::move(cut_b) : whole_parts(b)};
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
