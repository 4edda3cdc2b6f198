#include "morph/step_candidate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "match/find_rotation.h"
#include "match/match_along.h"
#include "morph/mean_value.h"
#include "morph/measures.h"
#include "shape/trigonometry.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/curve/nearest_point.h"
#include "tandem/error.h"
#include "tandem/morph/align.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Share of the cost of pairing contours at which another turn is taken.
constexpr double kMuchLess = 0.5;

CubicPath collapsed(const CubicPath& like, Vec2 point) {
  Points points = like.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i][0] = point.x;
    points[i][1] = point.y;
  }
  return CubicPath(std::move(points), like.is_closed());
}

Rotation turn_by(double degrees) {
  const CosSin turn = cos_sin_degrees(degrees);
  const double values[] = {turn.cosine, turn.sine};
  return Rotation(2, values);
}

Vec2 to_vec(const Point& p) {
  return {p[0], p[1]};
}

double radius_of_gyration(std::span<const CubicPath> paths, Vec2 center) {
  double sum = 0.0;
  double whole = 0.0;
  for (const CubicPath& path : paths) {
    const Points& p = path.control_points();
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
      const double length = std::hypot(p[i + 1][0] - p[i][0], p[i + 1][1] - p[i][1]);
      const double x = 0.5 * (p[i + 1][0] + p[i][0]) - center.x;
      const double y = 0.5 * (p[i + 1][1] + p[i][1]) - center.y;
      sum += length * (x * x + y * y);
      whole += length;
    }
  }
  return whole > 0.0 ? std::sqrt(sum / whole) : 0.0;
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

std::vector<ContourEnds> StepCandidate::ends() const {
  std::vector<ContourEnds> all;
  all.reserve(contours.size());
  for (const FoundContour& contour : contours) all.push_back(contour.ends);
  return all;
}

StepBlend StepCandidate::blend(BlendKind kind) const {
  StepBlend made(kind, frame, ends());
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const FoundContour& contour = contours[c];
    if (!contour.detour.is_none()) made.set_detour(c, contour.detour);
    if (contour.outline_a || contour.outline_b) made.set_outlines(c, contour.drawn());
  }
  return made;
}

StepKeys::Key::Key(const StepKey& key)
    : paths(key.contours.begin(), key.contours.end()),
      nesting(find_nesting(key.contours, FillRule::nonzero)),
      center(key.center) {
  for (std::size_t i = 0; i < paths.size(); ++i) sources.push_back(i);
  outlines.resize(paths.size());
  for (const CubicPath& path : paths) curves.push_back(to_curve(path));
  for (const Curve& curve : curves) mirrors.push_back(find_mirrors(curve));
  gyration = radius_of_gyration(paths, center);
}

StepKeys::Key::Key(std::vector<KeyPart> parts, const Key& whole)
    : center(whole.center), gyration(whole.gyration) {
  for (KeyPart& part : parts) {
    curves.push_back(to_curve(part.path));
    paths.push_back(std::move(part.path));
    sources.push_back(part.source);
    outlines.push_back(std::move(part.outline));
  }
  for (const Curve& curve : curves) mirrors.push_back(find_mirrors(curve));
  nesting = find_nesting(paths, FillRule::nonzero);
}

std::size_t StepKeys::Key::longest() const {
  const auto length = [](const CubicPath& path) { return path_length(path.control_points().data()); };
  const auto found =
      std::max_element(paths.begin(), paths.end(),
                       [&](const CubicPath& x, const CubicPath& y) { return length(x) < length(y); });
  return static_cast<std::size_t>(found - paths.begin());
}

StepKeys::StepKeys(const StepKey& a, const StepKey& b, std::span<const MorphPin> pins) : a_(a), b_(b) {
  for (const MorphPin& pin : pins) locate(pin);
}

StepKeys::StepKeys(const StepKeys& whole, CutKeys cut)
    : a_(std::move(cut.a), whole.a_), b_(std::move(cut.b), whole.b_) {}

std::optional<CutKeys> StepKeys::cut(const Turned& turned) const {
  return cut_keys(a_.paths, b_.paths, turned.pairs, turned.turn);
}

void StepKeys::locate(const MorphPin& pin) {
  const auto on = [](const Key& key, Vec2 p, std::size_t& contour) {
    const Point point{p.x, p.y};
    NearestPoint best{0.0, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < key.curves.size(); ++i) {
      const NearestPoint found = nearest_point(key.curves[i], point);
      if (!(found.distance < best.distance)) continue;
      best = found;
      contour = i;
    }
    return best.parameter;
  };
  Pin located{0, 0, {}};
  located.at.u = on(a_, pin.a, located.a);
  located.at.v = on(b_, pin.b, located.b);
  for (const Pin& other : pins_) {
    if ((other.a == located.a) == (other.b == located.b)) continue;
    throw InvalidArgument(
        fmt::format("the pins ({}, {}) = ({}, {}) and another one want a contour to become two", pin.a.x,
                    pin.a.y, pin.b.x, pin.b.y));
  }
  pins_.push_back(located);
}

double StepKeys::diagonal() const {
  Box box;
  for (const Key* key : {&a_, &b_}) {
    for (const Curve& curve : key->curves) box.include(bounding_box(curve));
  }
  return box.diagonal();
}

Turned StepKeys::pair(const Rotation& turn, const MatchOptions& options) const {
  Turned turned{turn, {}};
  std::vector<ContourPair> pairs = pair_contours(a_.paths, b_.paths, turn, options).pairs;
  for (const Pin& pin : pins_) {
    // The two are paired, and those they leave behind become one another.
    const auto of_a =
        std::find_if(pairs.begin(), pairs.end(), [&](const ContourPair& p) { return p.a == pin.a; });
    const auto of_b =
        std::find_if(pairs.begin(), pairs.end(), [&](const ContourPair& p) { return p.b == pin.b; });
    if (of_a != of_b) std::swap(of_a->b, of_b->b);
  }
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), [](const ContourPair& p) { return !p.a && !p.b; }),
              pairs.end());
  for (const ContourPair& pair : pairs) {
    const auto is_point = [](const Key& key, std::size_t i) { return !(key.curves[i].extent() > 0.0); };
    if (pair.a && pair.b && (is_point(a_, *pair.a) || is_point(b_, *pair.b))) {
      // A point has no direction to match.
      turned.pairs.push_back({pair.a, {}, 0.0});
      turned.pairs.push_back({{}, pair.b, 0.0});
    } else {
      turned.pairs.push_back(pair);
    }
  }
  return turned;
}

Rotation StepKeys::find_turn(const MatchOptions& options) const {
  MatchOptions own = options;
  own.progress = {};
  own.samples = {0, 0};  // a turn is found as well from few
  const Curve& a = a_.curves[a_.longest()];
  const Curve& b = b_.curves[b_.longest()];
  if (a.is_closed() && b.is_closed() && own.direction == Direction::automatic) {
    own.direction = Direction::forward;
  }
  if (!(a.extent() > 0.0 && b.extent() > 0.0)) return Rotation(2);
  if (a_.curves.size() == 1 && b_.curves.size() == 1 && can_share(options)) {
    const MatchSamples& samples = samples_of(0, 0, options);
    const RotationTask task{samples.fine, samples.coarse, samples.layout, samples.plans};
    return find_rotation({&task, 1}, own, 0.0).rotation;
  }
  const Rotation alone = common_rotation({&a, 1}, {&b, 1}, own);
  if (a_.curves.size() == 1 && b_.curves.size() == 1) return alone;
  // A rectangle does not tell a turn from one by 180 degrees more, nor a square by 90: all contours do.
  double known = 0.0;
  ContourPairing pairing = pair_contours(a_.paths, b_.paths, alone, own);
  for (const double more : {90.0, 180.0, 270.0}) {
    const Rotation turn = turn_by(alone.degrees() + more);
    ContourPairing found = pair_contours(a_.paths, b_.paths, turn, own);
    if (found.cost > kMuchLess * pairing.cost) continue;
    known = turn.degrees();
    pairing = std::move(found);
  }
  // Seen turned back, the nearest of equal turns is the smallest one.
  const Transform back = Transform::rotate_degrees(-known);
  std::vector<Curve> first;
  std::vector<Curve> second;
  for (const ContourPair& pair : pairing.pairs) {
    if (!pair.a || !pair.b) continue;
    first.push_back(a_.curves[*pair.a]);
    second.push_back(transform(b_.curves[*pair.b], back));
  }
  return turn_by(known + common_rotation(first, second, own).degrees());
}

std::optional<StepCandidate> StepKeys::match(const Turned& turned, const MatchOptions& options,
                                             bool mirror) const {
  StepCandidate candidate;
  const double scale = a_.gyration > 0.0 && b_.gyration > 0.0 ? b_.gyration / a_.gyration : 1.0;
  candidate.frame = PlanarFrame(a_.center, b_.center, turned.turn.degrees(), scale);
  for (const ContourPair& pair : turned.pairs) {
    if (!pair.a || !pair.b) continue;
    const CubicPath& a = a_.paths[*pair.a];
    const CubicPath& b = b_.paths[*pair.b];
    MatchOptions own = options;
    own.rotation = turned.turn.values();
    // Both enclose what they enclose on the same side: turned round, the area would vanish on the way.
    if (a.is_closed() && b.is_closed() && own.direction == Direction::automatic) {
      own.direction = Direction::forward;
    }
    AlignOptions joints;
    for (const Pin& pin : pins_) {
      if (pin.a == *pair.a) joints.pins.push_back(pin.at);
    }
    const auto shared = mirror ? shared_mirror_of(pair, turned.turn) : std::nullopt;
    if (shared) joints.pins.assign(shared->ends.begin(), shared->ends.end());
    own.pins = joints.pins;
    Match found = match_pair(*pair.a, *pair.b, own);
    if (found.report.cancelled) return std::nullopt;
    if (shared) {
      const Curve& first = a_.curves[*pair.a];
      const Curve& second = b_.curves[*pair.b];
      Correspondence along = mirrored(found.correspondence, Reflection(first, shared->ends[0].u),
                                      Reflection(second, shared->ends[0].v));
      found = match_along(first, second, own, std::move(found), std::move(along));
    }
    AlignedPaths aligned = own.method == Method::segments ? cut_in_step(a, b, found.correspondence)
                                                          : align(a, b, found.correspondence, joints);
    candidate.contours.push_back({a_.sources[*pair.a],
                                  b_.sources[*pair.b],
                                  std::move(found),
                                  std::move(aligned.cuts),
                                  {std::move(aligned.a), std::move(aligned.b)},
                                  {}});
    FoundContour& made = candidate.contours.back();
    const bool closed = made.ends.a.is_closed();
    if (const auto& outline = a_.outlines[*pair.a]) made.outline_a = cut_at(*outline, made.cuts, closed);
    if (const auto& outline = b_.outlines[*pair.b]) {
      made.outline_b = cut_at(*outline, aligned.cuts_b, closed);
    }
  }
  if (options.method == Method::elastic) add_asymmetry(candidate, turned);
  add_lonely(candidate, turned);
  return candidate;
}

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

bool StepKeys::can_share(const MatchOptions& options) {
  return options.method == Method::elastic && options.pins.empty() &&
         options.samples == std::array<int, 2>{0, 0};
}

const MatchSamples& StepKeys::samples_of(std::size_t a, std::size_t b, const MatchOptions& options) const {
  const auto known = samples_.find({a, b});
  if (known != samples_.end()) return known->second;
  return samples_.emplace(std::pair{a, b}, sample_for_match(a_.curves[a], b_.curves[b], options))
      .first->second;
}

Match StepKeys::match_pair(std::size_t a, std::size_t b, const MatchOptions& options) const {
  const Curve& first = a_.curves[a];
  const Curve& second = b_.curves[b];
  if (!can_share(options)) return tandem::match(first, second, options);
  return match_sampled(first, second, options, samples_of(a, b, options));
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

StepCandidate subdivided(StepCandidate candidate, double longest) {
  for (FoundContour& contour : candidate.contours) {
    const double length_a = path_length(contour.ends.a.control_points().data());
    const double length_b = path_length(contour.ends.b.control_points().data());
    const auto share = [](const CubicPath& path, std::size_t segment, double whole) {
      return whole > 0.0 ? path_length(path.control_points().data().subspan(6 * segment, 8)) / whole : 0.0;
    };
    // In the parameters of the aligned paths, and of the first key's own.
    std::vector<double> cuts{0.0};
    std::vector<double> own{contour.cuts.empty() ? 0.0 : contour.cuts.front()};
    for (std::size_t k = 0; k < contour.ends.a.segment_count(); ++k) {
      const double parts = std::max(
          1.0, std::ceil(std::max(share(contour.ends.a, k, length_a), share(contour.ends.b, k, length_b)) /
                         longest));
      const double from = own.back();
      const double to = contour.cuts.empty() ? from + 1.0 : contour.cuts[k + 1];
      for (double p = 1.0; p <= parts; p += 1.0) {
        cuts.push_back(static_cast<double>(k) + p / parts);
        own.push_back(p == parts ? to : from + (to - from) * p / parts);
      }
    }
    for (CubicPath* path : {&contour.ends.a, &contour.ends.b}) *path = cut_at(*path, cuts, path->is_closed());
    for (auto* outline : {&contour.outline_a, &contour.outline_b}) {
      if (*outline) *outline = cut_at(**outline, cuts, (*outline)->is_closed());
    }
    if (contour.a) contour.cuts = std::move(own);
  }
  return candidate;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
