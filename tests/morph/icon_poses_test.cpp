#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <random>
#include <utility>
#include <vector>

#include "morph/icons.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/curve/points.h"
#include "tandem/morph/path_morph.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/shape.h"
#include "tandem/shape/transform.h"

// An icon and the same icon drawn in another way, or standing elsewhere, morph into each other as what they
// are: one rigid body that moves, turns and grows.
namespace tandem {
namespace {

using test::Icon;
using test::kIcons;

using Paths = std::vector<CubicPath>;

// --- other ways to draw a contour ---

Vec2 point_of(const Points& points, std::size_t i) {
  return {points[i][0], points[i][1]};
}

Vec2 mix(Vec2 p, Vec2 q, double t) {
  return {(1.0 - t) * p.x + t * q.x, (1.0 - t) * p.y + t * q.y};
}

CubicPath path_through(const std::vector<Vec2>& points) {
  Points result(2, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    result[i][0] = points[i].x;
    result[i][1] = points[i].y;
  }
  return CubicPath(std::move(result), true);
}

/// Segment `i` in two, by de Casteljau's construction.
CubicPath split_segment(const CubicPath& path, std::size_t i, double t) {
  const Points& points = path.control_points();
  std::vector<Vec2> all;
  for (std::size_t k = 0; k <= 3 * i; ++k) all.push_back(point_of(points, k));
  const Vec2 a = mix(point_of(points, 3 * i), point_of(points, 3 * i + 1), t);
  const Vec2 b = mix(point_of(points, 3 * i + 1), point_of(points, 3 * i + 2), t);
  const Vec2 c = mix(point_of(points, 3 * i + 2), point_of(points, 3 * i + 3), t);
  const Vec2 ab = mix(a, b, t);
  const Vec2 bc = mix(b, c, t);
  all.insert(all.end(), {a, ab, mix(ab, bc, t), bc, c});
  for (std::size_t k = 3 * i + 3; k < points.size(); ++k) all.push_back(point_of(points, k));
  return path_through(all);
}

CubicPath start_at(const CubicPath& path, std::size_t joint) {
  const std::size_t n = 3 * path.segment_count();
  std::vector<Vec2> all;
  for (std::size_t k = 0; k <= n; ++k) all.push_back(point_of(path.control_points(), (3 * joint + k) % n));
  return path_through(all);
}

CubicPath start_at_another_vertex(const CubicPath& path) {
  return start_at(path, path.segment_count() / 3 + 1);
}

CubicPath start_in_mid_edge(const CubicPath& path) {
  const std::size_t edge = path.segment_count() / 2;
  return start_at(split_segment(path, edge, 0.4), edge + 1);
}

CubicPath reversed(const CubicPath& path) {
  std::vector<Vec2> all;
  for (std::size_t k = path.control_points().size(); k-- > 0;)
    all.push_back(point_of(path.control_points(), k));
  return path_through(all);
}

/// About half of the segments in two, at any place.
CubicPath resegmented(const CubicPath& path, std::mt19937& random) {
  CubicPath result = path;
  for (std::size_t i = path.segment_count(); i-- > 0;) {
    const bool splits = random() % 2 == 0;
    const double t = 0.2 + 0.6 * static_cast<double>(random() % 1000) / 1000.0;
    if (splits) result = split_segment(result, i, t);
  }
  return result;
}

CubicPath transformed(const CubicPath& path, const Transform& map) {
  std::vector<Vec2> all;
  for (std::size_t k = 0; k < path.control_points().size(); ++k)
    all.push_back(map(point_of(path.control_points(), k)));
  return path_through(all);
}

/// What is done to an icon.
struct Redrawing {
  const char* name;
  bool at_another_vertex = false;
  bool in_mid_edge = false;
  bool backwards = false;
  bool in_other_segments = false;
  bool in_other_order = false;  ///< the contours
  double degrees = 0.0;         ///< about the middle of the icon's square
  double scale = 1.0;           ///< about (0, 0)
  Vec2 move = {0.0, 0.0};

  [[nodiscard]] Transform placement() const {
    return Transform::translate(move.x, move.y) * Transform::scale(scale, scale) *
           Transform::translate(12.0, 12.0) * Transform::rotate_degrees(degrees) *
           Transform::translate(-12.0, -12.0);
  }

  [[nodiscard]] Paths operator()(const Paths& paths, unsigned seed) const {
    std::mt19937 random(seed);
    Paths result;
    for (CubicPath path : paths) {
      if (at_another_vertex) path = start_at_another_vertex(path);
      if (in_mid_edge) path = start_in_mid_edge(path);
      if (backwards) path = reversed(path);
      if (in_other_segments) path = resegmented(path, random);
      result.push_back(transformed(path, placement()));
    }
    if (in_other_order) std::reverse(result.begin(), result.end());
    return result;
  }
};

std::ostream& operator<<(std::ostream& out, const Redrawing& redrawing) {
  return out << redrawing.name;
}

// --- outlines ---

using Polyline = std::vector<Vec2>;

double apart(Vec2 p, Vec2 q) {
  return std::sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
}

/// Points on the path, no two neighbours further apart than `step`.
Polyline flattened(const CubicPath& path, double step) {
  const Points& points = path.control_points();
  Polyline line{point_of(points, 0)};
  for (std::size_t i = 0; i < path.segment_count(); ++i) {
    const Vec2 p = point_of(points, 3 * i);
    const Vec2 q = point_of(points, 3 * i + 1);
    const Vec2 r = point_of(points, 3 * i + 2);
    const Vec2 z = point_of(points, 3 * i + 3);
    const double fastest = 3.0 * std::max({apart(p, q), apart(q, r), apart(r, z)});
    const int parts = 1 + static_cast<int>(fastest / step);
    for (int k = 1; k <= parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      const Vec2 pqr = mix(mix(p, q, t), mix(q, r, t), t);
      const Vec2 qrz = mix(mix(q, r, t), mix(r, z, t), t);
      line.push_back(mix(pqr, qrz, t));
    }
  }
  return line;
}

std::vector<Polyline> flattened(const Paths& paths, double step) {
  std::vector<Polyline> lines;
  for (const CubicPath& path : paths) lines.push_back(flattened(path, step));
  return lines;
}

double diagonal(const Paths& paths) {
  Box box;
  for (const CubicPath& path : paths) box.include(bounding_box(to_curve(path)));
  return box.diagonal();
}

/// The mean of all points, over the length.
Vec2 center_of(const Paths& paths) {
  Vec2 sum;
  double whole = 0.0;
  for (const Polyline& line : flattened(paths, 0.05)) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double length = apart(line[i - 1], line[i]);
      const Vec2 middle = mix(line[i - 1], line[i], 0.5);
      sum = {sum.x + length * middle.x, sum.y + length * middle.y};
      whole += length;
    }
  }
  return {sum.x / whole, sum.y / whole};
}

double distance_to_edge(Vec2 x, Vec2 p, Vec2 q) {
  const Vec2 edge{q.x - p.x, q.y - p.y};
  const double squared = edge.x * edge.x + edge.y * edge.y;
  if (!(squared > 0.0)) return apart(x, p);
  const double t = std::clamp(((x.x - p.x) * edge.x + (x.y - p.y) * edge.y) / squared, 0.0, 1.0);
  return apart(x, mix(p, q, t));
}

/// How far the vertices of `lines` get from the polylines `others`, at least `least`.
double farthest(const std::vector<Polyline>& lines, const std::vector<Polyline>& others, double least) {
  std::vector<std::pair<Vec2, Vec2>> edges;
  for (const Polyline& other : others) {
    for (std::size_t i = 1; i < other.size(); ++i) edges.emplace_back(other[i - 1], other[i]);
  }
  double worst = least;
  std::size_t near = 0;  // neighbours are near the same edge
  for (const Polyline& line : lines) {
    for (const Vec2 point : line) {
      double best = std::numeric_limits<double>::infinity();
      const std::size_t from = near;
      for (std::size_t k = 0; k < edges.size() && best > worst; ++k) {
        const std::size_t i = (from + k) % edges.size();
        const double distance = distance_to_edge(point, edges[i].first, edges[i].second);
        if (distance >= best) continue;
        best = distance;
        near = i;
      }
      worst = std::max(worst, best);
    }
  }
  return worst;
}

/// Hausdorff distance of two outlines, as a share of the second one's diagonal.
double difference(const Paths& paths, const Paths& expected) {
  const double size = diagonal(expected);
  constexpr double kStep = 0.004;   // of the diagonal
  constexpr double kUnseen = 2e-4;  // of the diagonal: what flattening leaves open
  const std::vector<Polyline> a = flattened(paths, kStep * size);
  const std::vector<Polyline> b = flattened(expected, kStep * size);
  return std::max(farthest(a, b, kUnseen * size), farthest(b, a, kUnseen * size)) / size;
}

// --- morphs ---

/// The body on its way: it turns and grows evenly (at s to 1 - s + s * scale times its size) about its
/// centre, which moves straight.
Paths true_between(const Paths& paths, const Redrawing& redrawing, double s) {
  const Vec2 first = center_of(paths);
  const Vec2 center = mix(first, redrawing.placement()(first), s);
  const double size = 1.0 - s + s * redrawing.scale;
  const Transform map = Transform::translate(center.x, center.y) * Transform::scale(size, size) *
                        Transform::rotate_degrees(s * redrawing.degrees) *
                        Transform::translate(-first.x, -first.y);
  Paths result;
  for (const CubicPath& path : paths) result.push_back(transformed(path, map));
  return result;
}

double worst_difference(const Paths& paths, const Redrawing& redrawing, unsigned seed) {
  const std::vector<Shape> keys{to_shape(paths), to_shape(redrawing(paths, seed))};
  const PathMorph morph(keys);
  double worst = 0.0;
  for (const double s : {0.25, 0.5, 0.75}) {
    worst = std::max(worst, difference(morph.at(s), true_between(paths, redrawing, s)));
  }
  return worst;
}

const Redrawing kRedrawings[] = {
    {.name = "StartAtAnotherVertex", .at_another_vertex = true},
    {.name = "StartInMidEdge", .in_mid_edge = true},
    {.name = "Reversed", .backwards = true},
    {.name = "Resegmented", .in_other_segments = true},
    {.name = "Moved", .move = {31.0, -17.0}},
    {.name = "Scaled", .scale = 2.5},
    {.name = "TurnedBy30", .degrees = 30.0},
    {.name = "TurnedBy90", .degrees = 90.0},
    {.name = "AllTogether",
     .in_mid_edge = true,
     .backwards = true,
     .in_other_segments = true,
     .in_other_order = true,
     .degrees = 75.0,
     .scale = 0.6,
     .move = {-13.0, 40.0}},
};

class IconPoses : public ::testing::TestWithParam<Redrawing> {};

TEST_P(IconPoses, MoveAsOneBody) {
  unsigned seed = 1;
  for (const Icon& icon : kIcons) {
    EXPECT_LT(worst_difference(paths_of(icon), GetParam(), seed++), 0.01) << icon.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Morph, IconPoses, ::testing::ValuesIn(kRedrawings),
                         [](const auto& redrawing) { return redrawing.param.name; });

}  // namespace
}  // namespace tandem
