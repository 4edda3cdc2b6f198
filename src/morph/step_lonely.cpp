#include <algorithm>
#include <limits>
#include <utility>

#include "morph/mean_value.h"
#include "morph/measures.h"
#include "morph/step_keys.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/curve/nearest_point.h"

namespace tandem {
inline namespace v0 {
namespace detail {

namespace {

CubicPath collapsed(const CubicPath& like, Vec2 point) {
  Points points = like.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i][0] = point.x;
    points[i][1] = point.y;
  }
  return CubicPath(std::move(points), like.is_closed());
}

Vec2 to_vec(const Point& p) {
  return {p[0], p[1]};
}

/// The pair that contour `index` of the first key (else of the second) belongs to.
const FoundContour* find_pair(const StepCandidate& candidate, std::span<const ContourPair> pairs,
                              std::size_t index, bool of_first) {
  std::size_t k = 0;  // the candidate's contours are those of the pairs, in their order
  for (const ContourPair& pair : pairs) {
    if (!pair.a || !pair.b) continue;
    if ((of_first ? *pair.a : *pair.b) == index) return &candidate.contours[k];
    ++k;
  }
  return nullptr;
}

}  // namespace

std::optional<StepCandidate> StepKeys::parted(const StepCandidate& candidate, const Turned& turned,
                                              std::size_t parted) const {
  // The longest pair stays, whatever it costs, and so do lines.
  std::vector<std::size_t> order;
  std::size_t longest = 0;
  double most = -1.0;
  const auto length = [](const CubicPath& path) { return path_length(path.control_points().data()); };
  for (std::size_t p = 0; p < turned.pairs.size(); ++p) {
    const ContourPair& pair = turned.pairs[p];
    // Lines may cross.
    if (!pair.a || !pair.b || !a_.paths[*pair.a].is_closed() || !b_.paths[*pair.b].is_closed()) continue;
    order.push_back(p);
    const double both = length(a_.paths[*pair.a]) + length(b_.paths[*pair.b]);
    if (both > most) {
      most = both;
      longest = p;
    }
  }
  if (parted >= order.size() || !pins_.empty()) return std::nullopt;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
    const auto rank = [&](std::size_t p) { return p == longest ? -1.0 : turned.pairs[p].cost; };
    return rank(x) > rank(y);
  });
  order.resize(parted);
  StepCandidate made{candidate.frame, {}, candidate.asymmetry};
  Turned loose{turned.turn, {}};
  std::size_t k = 0;
  for (std::size_t p = 0; p < turned.pairs.size(); ++p) {
    const ContourPair& pair = turned.pairs[p];
    const bool both = pair.a && pair.b;
    if (both && std::find(order.begin(), order.end(), p) != order.end()) {
      loose.pairs.push_back({pair.a, {}, 0.0});
      loose.pairs.push_back({{}, pair.b, 0.0});
    } else {
      loose.pairs.push_back(pair);
      if (both) made.contours.push_back(candidate.contours[k]);
    }
    k += both ? 1 : 0;
  }
  add_lonely(made, loose);
  return made;
}

// The nearest point of the strokes, which hides there what has no extent, whatever its caps.
Vec2 StepKeys::Key::on_strokes(Vec2 point) const {
  const Point from{point.x, point.y};
  NearestPoint best{0.0, std::numeric_limits<double>::infinity()};
  Vec2 found = point;
  for (const Curve& curve : curves) {
    if (curve.is_closed()) continue;
    const NearestPoint near = nearest_point(curve, from);
    if (!(near.distance < best.distance)) continue;
    best = near;
    found = to_vec(curve.evaluate(near.parameter));
  }
  return found;
}

// Contours that nobody becomes: each dies to, or is born from, the point to which the contour around it
// carries its centre; outside of all, its own centre. Strokes do so on another stroke.
void StepKeys::add_lonely(StepCandidate& candidate, const Turned& turned) const {
  for (const ContourPair& pair : turned.pairs) {
    if (pair.a && pair.b) continue;
    const bool dies = pair.a.has_value();
    const Key& key = dies ? a_ : b_;
    const std::size_t index = dies ? *pair.a : *pair.b;
    // The outermost contour that shares its fate, and what that one lies in.
    std::size_t outermost = index;
    const FoundContour* around = nullptr;
    for (std::optional<std::size_t> parent = key.nesting[outermost].parent; parent;
         parent = key.nesting[outermost].parent) {
      around = find_pair(candidate, turned.pairs, *parent, dies);
      if (around != nullptr) break;
      outermost = *parent;
    }
    Vec2 point = to_vec(bounding_box(key.curves[outermost]).center());
    if (around != nullptr) {
      point = dies ? carried_along(point, around->ends.a, around->ends.b)
                   : carried_along(point, around->ends.b, around->ends.a);
    }
    const CubicPath& path = key.paths[index];
    if (!path.is_closed()) point = (dies ? b_ : a_).on_strokes(point);
    ContourEnds ends =
        dies ? ContourEnds{path, collapsed(path, point)} : ContourEnds{collapsed(path, point), path};
    candidate.contours.push_back({{}, {}, {}, {}, std::move(ends), {}});
    FoundContour& made = candidate.contours.back();
    (dies ? made.a : made.b) = key.sources[index];
    (dies ? made.outline_a : made.outline_b) = key.outlines[index];
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
