#include "surface/cut_ring.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tandem/shape/cubic_path.h"
#include "tandem/shape/cut.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Places this near, in the stack's units (its size is 1), are one: far above the rounding of a cut, far
/// below the edges of polylines.
constexpr double kSamePlace = 1e-9;

double distance(Vec2 a, Vec2 b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

/// Where p lies on the edge, strictly between its ends, as a share of it; -1 elsewhere.
double share_on_edge(Vec2 p, Vec2 a, Vec2 b) {
  const double length = distance(a, b);
  if (length == 0.0 || distance(p, a) <= kSamePlace || distance(p, b) <= kSamePlace) return -1.0;
  const double along = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length;
  const double across = ((p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x)) / length;
  return std::abs(across) <= kSamePlace && along > 0.0 && along < length ? along / length : -1.0;
}

CubicPath to_path(const Loop& loop, std::span<const Vec2> places) {
  std::vector<double> coordinates;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 a = places[loop[i]];
    const Vec2 b = places[loop[(i + 1) % loop.size()]];
    for (const double s : {0.0, 1.0 / 3.0, 2.0 / 3.0}) {
      coordinates.push_back((1.0 - s) * a.x + s * b.x);
      coordinates.push_back((1.0 - s) * a.y + s * b.y);
    }
  }
  coordinates.push_back(places[loop.front()].x);
  coordinates.push_back(places[loop.front()].y);
  return CubicPath(Points(2, std::move(coordinates)), true);
}

Vec2 centroid(const Loop& loop, std::span<const Vec2> places) {
  const Vec2 o = places[loop.front()];
  Vec2 sum;
  double area = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 a = places[loop[i]];
    const Vec2 b = places[loop[(i + 1) % loop.size()]];
    const double part = (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
    area += part;
    sum.x += part * ((a.x - o.x) + (b.x - o.x)) / 3.0;
    sum.y += part * ((a.y - o.y) + (b.y - o.y)) / 3.0;
  }
  return {o.x + sum.x / area, o.y + sum.y / area};
}

/// Gives the corners of pieces the numbers of the ring's vertices, and new ones to those that are new.
class Numbering {
 public:
  Numbering(Loop& ring, StackVertices& vertices) : ring_(ring), vertices_(vertices) {}

  std::uint32_t number(Vec2 p) {
    for (const auto* known : {&ring_, &inside_}) {
      for (const std::uint32_t v : *known) {
        if (distance(vertices_.places[v], p) <= kSamePlace) return v;
      }
    }
    const std::uint32_t added = vertices_.add(p, vertices_.heights[ring_.front()]);
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Vec2 a = vertices_.places[ring_[i]];
      const Vec2 b = vertices_.places[ring_[(i + 1) % ring_.size()]];
      if (share_on_edge(p, a, b) < 0.0) continue;
      ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(i) + 1, added);
      return added;
    }
    inside_.push_back(added);
    return added;
  }

 private:
  Loop& ring_;
  StackVertices& vertices_;
  Loop inside_;
};

}  // namespace

CutRing cut_ring(std::vector<Ring>& level, std::size_t ring, std::span<const Loop> partners,
                 StackVertices& vertices, double longest_edge) {
  std::vector<PieceTarget> targets;
  for (const Loop& partner : partners) {
    targets.push_back({std::abs(twice_area(partner, vertices.places)), centroid(partner, vertices.places)});
  }
  std::vector<CubicPath> holes;
  for (const Ring& other : level) {
    if (other.depth == level[ring].depth + 1 && other.parent == ring) {
      holes.push_back(to_path(other.loop, vertices.places));
    }
  }
  CutRing cut;
  Numbering numbering(level[ring].loop, vertices);
  for (const CutPiece& piece : cut_contour(to_path(level[ring].loop, vertices.places), targets, holes)) {
    Loop& loop = cut.pieces.emplace_back();
    for (std::size_t i = 0; i < piece.path.segment_count(); ++i) {
      const auto segment = piece.path.segment(i);
      const Vec2 a{segment[0][0], segment[0][1]};
      const Vec2 b{segment[3][0], segment[3][1]};
      const int parts = piece.chords[i] ? std::max(1, static_cast<int>(std::ceil(distance(a, b) / longest_edge))) : 1;
      for (int k = 0; k < parts; ++k) {
        const double s = static_cast<double>(k) / parts;
        loop.push_back(numbering.number({(1.0 - s) * a.x + s * b.x, (1.0 - s) * a.y + s * b.y}));
        if (piece.chords[i]) cut.on_chords.push_back(loop.back());
      }
      if (piece.chords[i]) cut.on_chords.push_back(numbering.number(b));
    }
  }
  return cut;
}

Loop with_vertices_on_edges(const Loop& loop, std::span<const std::uint32_t> candidates,
                            std::span<const Vec2> places) {
  Loop finer;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::uint32_t a = loop[i];
    const std::uint32_t b = loop[(i + 1) % loop.size()];
    std::vector<std::pair<double, std::uint32_t>> between;
    for (const std::uint32_t v : candidates) {
      if (v == a || v == b) continue;
      const double share = share_on_edge(places[v], places[a], places[b]);
      if (share > 0.0) between.emplace_back(share, v);
    }
    std::sort(between.begin(), between.end());
    between.erase(std::unique(between.begin(), between.end()), between.end());
    finer.push_back(a);
    for (const auto& [share, v] : between) finer.push_back(v);
  }
  return finer;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
