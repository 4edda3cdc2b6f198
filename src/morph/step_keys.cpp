#include "morph/step_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "match/find_rotation.h"
#include "match/found_match.h"
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

Rotation turn_by(double degrees) {
  const CosSin turn = cos_sin_degrees(degrees);
  const double values[] = {turn.cosine, turn.sine};
  return Rotation(2, values);
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

}  // namespace

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
    FoundMatch found = match_pair(*pair.a, *pair.b, own);
    if (found.report.cancelled) return std::nullopt;
    const Curve& first = a_.curves[*pair.a];
    const Curve& second = b_.curves[*pair.b];
    const Correspondence& correspondence = found.path.correspondence;
    if (shared) {
      follow(found, mirrored(correspondence, Reflection(first, shared->ends[0].u),
                             Reflection(second, shared->ends[0].v)));
    }
    AlignedPaths aligned = own.method == Method::segments ? cut_in_step(a, b, correspondence)
                                                          : align(a, b, correspondence, joints);
    candidate.contours.push_back({a_.sources[*pair.a],
                                  b_.sources[*pair.b],
                                  std::make_shared<MatchedPair>(MatchedPair{first, second, std::move(found)}),
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

FoundMatch StepKeys::match_pair(std::size_t a, std::size_t b, const MatchOptions& options) const {
  const Curve& first = a_.curves[a];
  const Curve& second = b_.curves[b];
  if (!can_share(options)) return find_match(first, second, options);
  return find_match(first, second, options, samples_of(a, b, options));
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
