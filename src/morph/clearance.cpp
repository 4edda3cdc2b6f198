#include "morph/clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "morph/measures.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Chords of a segment that stand for it.
constexpr int kChords = 6;
// Places tried, in rows and columns over the box of the others.
constexpr int kGrid = 28;
// A place must be better by this share of the way to it to be worth going there.
constexpr double kWayCost = 0.35;
// How much of the room a contour takes.
constexpr double kRoom = 0.85;
constexpr double kMostShrink = 0.95;
// Squares this much smaller than another one are smaller whatever rounding made of them.
constexpr double kUnseen = 1.0 - 1e-12;

double square_distance(Vec2 p, Vec2 from, Vec2 to) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double square = dx * dx + dy * dy;
  double t = square > 0.0 ? ((p.x - from.x) * dx + (p.y - from.y) * dy) / square : 0.0;
  t = std::clamp(t, 0.0, 1.0);
  const double x = p.x - from.x - t * dx;
  const double y = p.y - from.y - t * dy;
  return x * x + y * y;
}

}  // namespace

void Clearance::flatten(const std::vector<double>& p, bool closed) {
  Vec2 from{p[0], p[1]};
  for (std::size_t i = 0; i + 7 < p.size(); i += 6) {
    for (int k = 1; k <= kChords; ++k) {
      const double t = static_cast<double>(k) / kChords;
      const double u = 1.0 - t;
      const auto at = [&](std::size_t c) {
        return u * u * u * p[i + c] + 3.0 * u * u * t * p[i + 2 + c] + 3.0 * u * t * t * p[i + 4 + c] +
               t * t * t * p[i + 6 + c];
      };
      const Vec2 to{at(0), at(1)};
      edges_.push_back({from, to});
      from = to;
    }
  }
  if (!closed) edges_.push_back({from, {p[0], p[1]}});
}

ContourDetour Clearance::find(const StepBlend& blend, std::size_t contour, double s) {
  edges_.clear();
  std::vector<double> own(blend.size(contour));
  blend.at(s, contour, own);
  if (!blend.is_closed(contour)) return {};
  std::vector<double> other;
  for (std::size_t c = 0; c < blend.contour_count(); ++c) {
    if (c == contour) continue;
    other.resize(blend.size(c));
    blend.at(s, c, other);
    flatten(other, blend.is_closed(c));
  }
  if (edges_.empty()) return {};
  const Vec2 center = center_of_edges(own);
  double radius = 0.0;
  for (std::size_t i = 0; i + 1 < own.size(); i += 6) {
    const double x = own[i] - center.x;
    const double y = own[i + 1] - center.y;
    radius = std::max(radius, std::sqrt(x * x + y * y));
  }
  if (!(radius > 0.0)) return {};
  // Solids want to be where nothing is filled, holes where something is.
  const int wanted = signed_area(own) < 0.0 ? 1 : 0;
  Vec2 lo = center;
  Vec2 hi = center;
  for (const Edge& edge : edges_) {
    lo = {std::min(lo.x, edge.to.x), std::min(lo.y, edge.to.y)};
    hi = {std::max(hi.x, edge.to.x), std::max(hi.y, edge.to.y)};
  }
  // -1 where it may not be, or where the room is no more than `least`, which is seen before all is looked at.
  const auto room_at = [&](Vec2 p, double least) {
    int winding = 0;
    double nearest = std::numeric_limits<double>::infinity();
    const double enough = least > 0.0 ? kUnseen * least * least : 0.0;
    for (const Edge& edge : edges_) {
      nearest = std::min(nearest, square_distance(p, edge.from, edge.to));
      if (nearest < enough) return -1.0;
      if ((edge.from.y <= p.y) == (edge.to.y <= p.y)) continue;
      const double x =
          edge.from.x + (p.y - edge.from.y) / (edge.to.y - edge.from.y) * (edge.to.x - edge.from.x);
      if (x > p.x) winding += edge.to.y > edge.from.y ? 1 : -1;
    }
    return winding == wanted ? std::sqrt(nearest) : -1.0;
  };
  Vec2 best = center;
  double best_room = room_at(center, 0.0);
  double best_value = std::min(best_room, 1.1 * radius);
  for (int i = 0; i <= kGrid; ++i) {
    for (int j = 0; j <= kGrid; ++j) {
      const Vec2 p{lo.x + (hi.x - lo.x) * i / kGrid, lo.y + (hi.y - lo.y) * j / kGrid};
      const double way = std::sqrt((p.x - center.x) * (p.x - center.x) + (p.y - center.y) * (p.y - center.y));
      const double most = 1.1 * radius - kWayCost * way;
      if (most <= best_value) continue;
      const double room = room_at(p, best_room > 0.0 ? best_value + kWayCost * way : 0.0);
      const double value = std::min(room, 1.1 * radius) - kWayCost * way;
      if (room > 0.0 && (best_room <= 0.0 || value > best_value)) {
        best = p;
        best_room = room;
        best_value = value;
      }
    }
  }
  ContourDetour detour;
  detour.offset = {best.x - center.x, best.y - center.y};
  if (best_room <= 0.0) {
    detour.shrink = kMostShrink;
  } else {
    detour.shrink = std::clamp(1.0 - kRoom * best_room / radius, 0.0, kMostShrink);
  }
  // What the bump is at s, so that the whole of it is there.
  const double off = (2.0 * s - 1.0) * (2.0 * s - 1.0);
  const double bump = 1.0 - off * off;
  detour.offset = {detour.offset.x / bump, detour.offset.y / bump};
  detour.shrink = std::min(detour.shrink / bump, kMostShrink);
  return detour;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
