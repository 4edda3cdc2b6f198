#include "surface/boundary.h"

#include <algorithm>
#include <cmath>

#include "surface/boundary_arc.h"
#include "surface/boundary_crossing.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Pairs of arcs looked at. Ordinary boundaries take some ten times the number of their pieces; curves that
// touch, or nearly so, take as many as they are given.
constexpr int kMostPairs = 40000;
// Crossings that are tried to prove: ones that fail are places where edges touch.
constexpr int kMostCrossings = 200;
// Halvings below the pieces of the edges.
constexpr int kLargestDepth = 50;

/// The end of the one arc is the start of the other.
struct Joints {
  bool first_to_second = false;
  bool second_to_first = false;

  [[nodiscard]] bool any() const noexcept { return first_to_second || second_to_first; }
  [[nodiscard]] bool both() const noexcept { return first_to_second && second_to_first; }
};

class SimpleSearch {
 public:
  SimpleBoundary run(const std::vector<BoundaryLoop>& loops) {
    std::vector<std::unique_ptr<BoundaryArc>> roots;
    for (const BoundaryLoop& loop : loops) {
      find_common_corners(loop);
      roots.push_back(BoundaryArc::of_loop(loop));
    }
    for (const auto& root : roots) within(*root, true, 0);
    for (std::size_t i = 0; i < roots.size(); ++i) {
      for (std::size_t j = i + 1; j < roots.size(); ++j) between(*roots[i], *roots[j], {}, 0);
    }
    if (!violated_) result_.verdict = unresolved_ ? Verdict::undecided : Verdict::certified;
    return result_;
  }

 private:
  // Edges that begin in the very same point without being consecutive ends.
  void find_common_corners(const BoundaryLoop& loop) {
    const auto start = [](const BoundaryEdge& edge) {
      const Interval domain = edge.spline.domain();
      return BoundaryPlace{&edge, edge.reversed ? domain.hi : domain.lo};
    };
    const auto point = [](const BoundaryEdge& edge) {
      const std::vector<PlanePoint> all = edge.polygon(edge.spline.domain());
      return edge.reversed ? all.back() : all.front();
    };
    for (std::size_t i = 0; i < loop.size(); ++i) {
      for (std::size_t j = i + 1; j < loop.size(); ++j) {
        const PlanePoint p = point(loop[i]);
        const PlanePoint q = point(loop[j]);
        const bool same = (p[0] - q[0]).is_zero() && (p[1] - q[1]).is_zero();
        if (same) report({start(loop[i]), start(loop[j])});
      }
    }
  }

  void report(const std::array<BoundaryPlace, 2>& places) {
    violated_ = true;
    result_.verdict = Verdict::violated;
    result_.places = places;
  }

  // The arc is simple (and, if it is closed, meets itself at the end only).
  void within(BoundaryArc& arc, bool closed, int depth) {
    if (violated_) return;
    if (!closed && arc.runs_along(arc.directions().middle())) return;
    if (gives_up(depth) || !arc.can_split()) {
      unresolved_ = true;
      return;
    }
    const auto [first, second] = arc.halves();
    const int below = arc.is_piece() ? depth + 1 : depth;
    within(*first, false, below);
    within(*second, false, below);
    between(*first, *second, {true, closed}, below);
  }

  // The arcs have nothing in common but the joints.
  void between(BoundaryArc& a, BoundaryArc& b, Joints joints, int depth) {
    if (violated_) return;
    if (joints.any() ? run_together(a, b, joints) : a.is_apart_from(b)) return;
    if (!joints.any() && cross(a, b)) return;
    if (gives_up(depth)) {
      unresolved_ = true;
      return;
    }
    // Where they are joined both must become smaller; else the larger one, lists of pieces first.
    const bool split_a = a.can_split() && (joints.any() || !b.can_split() || comes_first(a, b));
    const bool split_b = b.can_split() && (joints.any() || !split_a);
    if (!split_a && !split_b) {
      unresolved_ = true;
      return;
    }
    const int below = (split_a && a.is_piece()) || (split_b && b.is_piece()) ? depth + 1 : depth;
    for (int i = 0; i < (split_a ? 2 : 1); ++i) {
      for (int j = 0; j < (split_b ? 2 : 1); ++j) {
        const bool a_ends = !split_a || i == 1;
        const bool a_starts = !split_a || i == 0;
        const bool b_ends = !split_b || j == 1;
        const bool b_starts = !split_b || j == 0;
        between(split_a ? *a.halves()[static_cast<std::size_t>(i)] : a,
                split_b ? *b.halves()[static_cast<std::size_t>(j)] : b,
                {joints.first_to_second && a_ends && b_starts, joints.second_to_first && b_ends && a_starts},
                below);
      }
    }
  }

  static bool comes_first(const BoundaryArc& a, const BoundaryArc& b) {
    if (a.is_piece() != b.is_piece()) return !a.is_piece();
    return a.size() >= b.size();
  }

  // Both run forward in one direction: the first lies before the joint, the second behind it.
  static bool run_together(const BoundaryArc& a, const BoundaryArc& b, Joints joints) {
    if (joints.both()) return false;
    DirectionRange directions = a.directions();
    directions.add(b.directions());
    const PlaneVector n = directions.middle();
    if (n[0] == 0.0 && n[1] == 0.0) return false;
    return a.runs_along(n) && b.runs_along(n);
  }

  bool cross(const BoundaryArc& a, const BoundaryArc& b) {
    if (!a.is_piece() || !b.is_piece() || crossings_ >= kMostCrossings) return false;
    if (!seem_to_cross(a, b)) return false;
    ++crossings_;
    if (const auto places = prove_crossing(a, b)) report(*places);
    return violated_;
  }

  bool gives_up(int depth) { return ++pairs_ > kMostPairs || depth > 2 * kLargestDepth; }

  SimpleBoundary result_;
  bool violated_ = false;
  bool unresolved_ = false;
  int pairs_ = 0;
  int crossings_ = 0;
};

}  // namespace

std::vector<PlanePoint> plane_points(const Enclosures& coefficients, bool rational) {
  const std::size_t stride = rational ? 3 : 2;
  std::vector<PlanePoint> result(coefficients.size() / stride);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Enclosure* from = coefficients.data() + i * stride;
    for (std::size_t c = 0; c < 2; ++c) result[i][c] = rational ? from[c] / from[2] : from[c];
  }
  return result;
}

std::vector<PlanePoint> BoundaryEdge::polygon(Interval part) const {
  std::vector<PlanePoint> result;
  double lo = part.lo;
  for (const double knot : spline.breaks()) {
    const double hi = std::min(knot, part.hi);
    if (!(hi > lo)) continue;
    const std::vector<PlanePoint> points = plane_points(spline.bezier({lo, hi}), rational);
    result.insert(result.end(), points.begin(), points.end());
    lo = hi;
  }
  return result;
}

SimpleBoundary find_simple(const std::vector<BoundaryLoop>& loops) {
  return SimpleSearch().run(loops);
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
