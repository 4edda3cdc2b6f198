#include "tandem/morph/path_morph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "morph/chosen_times.h"
#include "morph/length_center.h"
#include "morph/made_steps.h"
#include "morph/smooth_steps.h"
#include "morph/step_blend.h"
#include "morph/step_search.h"
#include "morph/winding.h"
#include "tandem/error.h"
#include "tandem/morph/align.h"
#include "tandem/shape/intersections.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::ContourDetour;
using detail::ContourEnds;
using detail::FoundContour;
using detail::FoundStep;
using detail::GivenKey;
using detail::MadeStep;
using detail::StepBlend;

// How far a line's handles may stand off the thirds, as a share of the diagonal: the same bound by which ends
// count as meeting, well above rounding and far below anything drawn.
constexpr double kLineTolerance = 1e-9;

// In-betweens per pair of keys that the box is taken from: between two of them the frame turns by no more
// than 12 degrees, and what sticks out of the box by then is less than the margin of a picture.
constexpr std::size_t kBoxSamples = 16;

void check_keys(std::span<const Shape> keys) {
  if (keys.size() < 2) {
    throw InvalidArgument(fmt::format("path morph: {} key shapes, expected at least 2", keys.size()));
  }
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].contours.empty()) throw InvalidArgument(fmt::format("path morph: key {} has no contours", i));
    for (const Curve& contour : keys[i].contours) {
      if (contour.dim() == 2) continue;
      throw InvalidArgument(
          fmt::format("path morph: the contours of key {} have dimension {}, expected 2", i, contour.dim()));
    }
  }
}

// Contours of no extent draw nothing; a key that has no others keeps one.
std::vector<std::size_t> drawn_contours(const Shape& shape) {
  std::vector<std::size_t> drawn;
  for (std::size_t i = 0; i < shape.contours.size(); ++i) {
    if (shape.contours[i].extent() > 0.0) drawn.push_back(i);
  }
  if (drawn.empty()) drawn.push_back(0);
  return drawn;
}

std::vector<CubicPath> to_paths(const Shape& shape, double tolerance, bool close) {
  const double diagonal = bounding_box(shape).diagonal();
  const double absolute = std::max(tolerance * diagonal, std::numeric_limits<double>::min());
  std::vector<CubicPath> paths;
  for (const std::size_t i : drawn_contours(shape)) {
    paths.push_back(to_cubic_path(shape.contours[i], absolute));
  }
  if (close) {
    for (CubicPath& path : paths) path = detail::closed_by_line(std::move(path));
  }
  return detail::wound(std::move(paths), shape.fill_rule);
}

// A contour through all keys so far.
struct Track {
  std::vector<CubicPath> keys;
  std::size_t source = 0;  ///< which contour of the last key it is
  bool alive = true;
  /// Of a piece of a contour, in a morph of two keys: what is blended.
  std::optional<ContourEnds> piece = {};
};

Vec2 center_of(const Shape& shape) {
  const Point center = length_center(shape.contours);
  return {center[0], center[1]};
}

}  // namespace

struct PathMorph::State {
  std::size_t key_count = 0;
  FillRule fill_rule = FillRule::nonzero;
  std::vector<PathContour> contours;
  std::vector<bool> closed;
  std::vector<FramePose> poses;
  std::vector<MorphStep> steps;
  std::vector<StepBlend> blends;
  std::vector<double> times;  ///< of the keys
  std::optional<detail::SmoothSteps> smooth;
  std::vector<double> pace;  ///< of the keys
  bool turns = false;
  bool linear = true;
  bool cancelled = false;
  Box box;

  // One contour, `local` of the way from a key to the next.
  void contour_at(std::size_t key, double local, std::size_t contour, std::span<double> points) const {
    if (smooth) {
      smooth->at(blends[key], key, local, contour, points);
    } else {
      blends[key].at(local, contour, points);
    }
    if (closed[contour]) std::copy_n(points.begin(), 2, points.end() - 2);
  }

  [[nodiscard]] std::vector<CubicPath> at(double s) const {
    const auto [key, local] = locate_key(s, times);
    std::vector<CubicPath> paths;
    paths.reserve(contours.size());
    for (std::size_t c = 0; c < contours.size(); ++c) {
      Points points(2, blends[key].size(c) / 2);
      contour_at(key, local, c, points.data());
      paths.emplace_back(std::move(points), closed[c]);
    }
    return paths;
  }

  void at(double s, std::span<double> coordinates) const {
    const auto [key, local] = locate_key(s, times);
    for (std::size_t c = 0; c < contours.size(); ++c) {
      const std::size_t size = blends[key].size(c);
      contour_at(key, local, c, coordinates.first(size));
      coordinates = coordinates.subspan(size);
    }
  }

  [[nodiscard]] FramePose pose_at(double s) const {
    const auto [key, local] = locate_key(s, times);
    if (smooth && turns) return smooth->pose_at(key, local);
    const FramePose& first = poses[key];
    const FramePose& second = poses[key + 1];
    return {{(1.0 - local) * first.center.x + local * second.center.x,
             (1.0 - local) * first.center.y + local * second.center.y},
            (1.0 - local) * first.degrees + local * second.degrees};
  }

  // The path as the frame sees it in this pose.
  [[nodiscard]] CubicPath seen(const FramePose& pose, const CubicPath& path) const {
    if (!turns) return path;
    Points points = path.control_points();
    const Transform back =
        Transform::rotate_degrees(-pose.degrees) * Transform::translate(-pose.center.x, -pose.center.y);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 p = back({points[i][0], points[i][1]});
      points[i][0] = p.x;
      points[i][1] = p.y;
    }
    return CubicPath(std::move(points), path.is_closed());
  }
};

namespace {

class Builder {
 public:
  explicit Builder(const MorphOptions& options) : options_(options) {}

  // False when cancelled.
  bool add(GivenKey key) {
    if (keys_.empty()) {
      for (const CubicPath& path : key.contours) tracks_.push_back({{path}, tracks_.size(), true});
    } else if (const auto again = find_again(keys_, key, [&](std::size_t k) { return joints_are_of(k); })) {
      repeat(again->step, again->back);
    } else if (!find(key)) {
      return false;
    }
    keys_.push_back(std::move(key));
    return true;
  }

  [[nodiscard]] const std::vector<Track>& tracks() const { return tracks_; }
  [[nodiscard]] const std::vector<MadeStep>& steps() const { return steps_; }

 private:
  // Whether every contour has the joints in the last key that it has in this one.
  [[nodiscard]] bool joints_are_of(std::size_t key) const {
    return std::all_of(tracks_.begin(), tracks_.end(),
                       [&](const Track& track) { return track.keys.back() == track.keys[key]; });
  }

  // A step that was made before, one way or the other: a loop there and back again closes.
  void repeat(std::size_t j, bool back) {
    MadeStep step = back ? reversed(steps_[j], keys_[j + 1].contours, options_.match) : steps_[j];
    step.contours.resize(tracks_.size());
    step.detours.resize(tracks_.size());
    for (std::size_t t = 0; t < tracks_.size(); ++t) {
      Track& track = tracks_[t];
      CubicPath path = track.keys[back ? j : j + 1];
      track.keys.push_back(std::move(path));
      track.alive = step.contours[t].b.has_value();
      if (track.alive) track.source = *step.contours[t].b;
    }
    steps_.push_back(std::move(step));
  }

  bool find(const GivenKey& key) {
    std::vector<CubicPath> a;
    std::vector<std::size_t> track_of;
    for (std::size_t t = 0; t < tracks_.size(); ++t) {
      if (!tracks_[t].alive) continue;
      a.push_back(tracks_[t].keys.back());
      track_of.push_back(t);
    }
    std::optional<FoundStep> found =
        detail::find_step({a, keys_.back().center}, {key.contours, key.center}, options_);
    if (!found) return false;
    std::vector<FoundContour> contours = std::move(found->candidate.contours);
    steps_.push_back({{}, found->kind, found->candidate.frame, {}, {}});
    if (keys_.size() == 1) {
      begin(std::move(contours), a);
    } else {
      append(std::move(contours), track_of);
    }
    return true;
  }

  // The first step makes the tracks: the first key's contours, or their pieces, in its order, then the
  // others.
  void begin(std::vector<FoundContour> found, const std::vector<CubicPath>& a) {
    tracks_.clear();
    std::stable_sort(found.begin(), found.end(), [](const FoundContour& x, const FoundContour& y) {
      return x.a && (!y.a || *x.a < *y.a);
    });
    MadeStep& step = steps_.back();
    for (FoundContour& contour : found) {
      ContourEnds drawn = contour.drawn();
      tracks_.push_back(
          {{std::move(drawn.a), std::move(drawn.b)}, contour.b.value_or(0), contour.b.has_value(), {}});
      if (contour.outline_a || contour.outline_b) tracks_.back().piece = std::move(contour.ends);
      step.firsts.push_back(contour.a ? std::optional(a[*contour.a]) : std::nullopt);
      step.contours.push_back({contour.a, contour.b, whole_match(contour)});
      step.detours.push_back(contour.detour);
    }
  }

  [[nodiscard]] static std::optional<Match> whole_match(const FoundContour& contour) {
    if (!contour.match) return std::nullopt;
    return contour.match->finish();
  }

  void append(std::vector<FoundContour> contours, const std::vector<std::size_t>& track_of) {
    const std::size_t before = tracks_.front().keys.size();
    MadeStep& step = steps_.back();
    step.firsts.resize(tracks_.size());
    step.contours.resize(tracks_.size());
    step.detours.resize(tracks_.size());
    for (Track& track : tracks_) {  // those that are dead stay where they died
      if (!track.alive) track.keys.push_back(track.keys.back());
    }
    for (FoundContour& found : contours) {
      ContourStep told{{}, found.b, whole_match(found)};
      if (!found.a) {  // a point in all keys before
        Track track;
        track.keys.assign(before, found.ends.a);
        track.keys.push_back(found.ends.b);
        track.source = *found.b;
        tracks_.push_back(std::move(track));
        step.firsts.emplace_back();
        step.contours.push_back(std::move(told));
        step.detours.push_back(found.detour);
        continue;
      }
      const std::size_t t = track_of[*found.a];
      Track& track = tracks_[t];
      step.firsts[t] = track.keys.back();
      if (!found.cuts.empty()) {
        for (CubicPath& earlier : track.keys) earlier = cut_at(earlier, found.cuts, found.ends.a.is_closed());
      }
      track.keys.push_back(found.ends.b);
      told.a = track.source;
      track.alive = found.b.has_value();
      if (found.b) track.source = *found.b;
      step.contours[t] = std::move(told);
      step.detours[t] = found.detour;
    }
  }

  const MorphOptions& options_;
  std::vector<GivenKey> keys_;
  std::vector<Track> tracks_;
  std::vector<MadeStep> steps_;
};

}  // namespace

PathMorph::PathMorph(std::span<const Shape> keys, const MorphOptions& options, double tolerance) {
  check_keys(keys);
  if (!options.pins.empty() && keys.size() != 2) {
    throw InvalidArgument(fmt::format("path morph: pins between {} keys, expected 2", keys.size()));
  }
  auto state = std::make_unique<State>();
  state->key_count = keys.size();
  state->times = detail::chosen_times(options.times, keys.size());
  MorphOptions own = options;
  own.cuts = options.cuts && keys.size() == 2;  // keys before and after a cut would have to follow it
  Builder builder(own);
  std::vector<double> line_tolerances;
  for (const Shape& key : keys) {
    std::vector<CubicPath> paths = to_paths(key, tolerance, options.match.closed == ClosedMode::yes);
    if (key.fill_rule == FillRule::evenodd && !is_simple(paths)) state->fill_rule = FillRule::evenodd;
    line_tolerances.push_back(kLineTolerance * bounding_box(key).diagonal());
    if (!builder.add({std::move(paths), center_of(key)})) {
      state->cancelled = true;
      state_ = std::move(state);
      return;
    }
  }
  state->poses.resize(keys.size());
  for (std::size_t k = 0; k + 1 < keys.size(); ++k) {
    const MadeStep& made = builder.steps()[k];
    std::vector<ContourEnds> ends;
    for (const Track& track : builder.tracks()) {
      ends.push_back(track.piece ? *track.piece : ContourEnds{track.keys[k], track.keys[k + 1]});
    }
    state->blends.emplace_back(made.kind, made.frame, ends);
    const double degrees = made.kind == BlendKind::bezier ? 0.0 : made.frame.degrees();
    state->turns = state->turns || degrees != 0.0;
    state->poses[k + 1].degrees = state->poses[k].degrees + degrees;
    MorphStep step{made.kind,
                   std::any_of(made.detours.begin(), made.detours.end(),
                               [](const ContourDetour& d) { return !d.is_none(); }),
                   made.contours};
    step.contours.resize(builder.tracks().size());
    const std::vector<std::size_t> of_a = drawn_contours(keys[k]);
    const std::vector<std::size_t> of_b = drawn_contours(keys[k + 1]);
    for (ContourStep& contour : step.contours) {
      if (contour.a) contour.a = of_a[*contour.a];
      if (contour.b) contour.b = of_b[*contour.b];
    }
    state->steps.push_back(std::move(step));
  }
  std::vector<FramePose> centered = state->poses;
  for (std::size_t k = 0; k < keys.size(); ++k) centered[k].center = center_of(keys[k]);
  if (state->turns) state->poses = centered;
  const bool smooth = options.smooth && keys.size() > 2;
  if (smooth) state->smooth.emplace(state->blends, state->times, std::move(centered));
  for (std::size_t k = 0; k < state->blends.size(); ++k) {
    const std::vector<ContourDetour>& detours = builder.steps()[k].detours;
    for (std::size_t t = 0; t < detours.size(); ++t) {
      state->blends[k].set_detour(t, detours[t]);
      const Track& track = builder.tracks()[t];
      if (track.piece) state->blends[k].set_outlines(t, {track.keys[k], track.keys[k + 1]});
    }
    if (smooth) state->blends[k].make_detours_gentle();
    state->linear = state->linear && !smooth && state->blends[k].is_linear();
  }
  state->pace.assign(keys.size(), 1.0);
  if (smooth) {
    state->smooth->find_pace(state->blends);
    state->pace = state->smooth->pace();
  }
  for (const Track& track : builder.tracks()) {
    PathContour contour;
    state->closed.push_back(track.keys.front().is_closed());
    for (std::size_t k = 0; k < keys.size(); ++k) {
      state->box.include(bounding_box(to_curve(track.keys[k])));
      contour.keys.push_back(state->seen(state->poses[k], track.keys[k]));
    }
    for (std::size_t i = 0; i < contour.keys.front().segment_count(); ++i) {
      bool line = true;
      for (const StepBlend& blend : state->blends) line = line && blend.keeps_line(state->contours.size(), i);
      for (std::size_t k = 0; k < keys.size(); ++k)
        line = line && track.keys[k].is_line(i, line_tolerances[k]);
      contour.lines.push_back(line);
    }
    state->contours.push_back(std::move(contour));
  }
  if (state->turns || !state->linear) {
    const std::size_t samples = kBoxSamples * (keys.size() - 1);
    for (std::size_t i = 1; i < samples; ++i) {
      for (const CubicPath& path : state->at(static_cast<double>(i) / static_cast<double>(samples))) {
        state->box.include(bounding_box(to_curve(path)));
      }
    }
  }
  state_ = std::move(state);
}

PathMorph::PathMorph(PathMorph&&) noexcept = default;
PathMorph& PathMorph::operator=(PathMorph&&) noexcept = default;
PathMorph::~PathMorph() = default;

std::vector<CubicPath> PathMorph::at(double s) const {
  return state_->at(s);
}

std::size_t PathMorph::coordinate_count() const noexcept {
  std::size_t count = 0;
  for (const PathContour& contour : state_->contours) count += 6 * contour.lines.size() + 2;
  return count;
}

void PathMorph::at(double s, std::span<double> coordinates) const {
  if (coordinates.size() != coordinate_count()) {
    throw InvalidArgument(fmt::format("path morph: room for {} coordinates, expected {}", coordinates.size(),
                                      coordinate_count()));
  }
  state_->at(s, coordinates);
}

std::vector<CubicPath> PathMorph::in_frame(double s) const {
  std::vector<CubicPath> paths = state_->at(s);
  const FramePose pose = state_->pose_at(s);
  for (CubicPath& path : paths) path = state_->seen(pose, path);
  return paths;
}

FramePose PathMorph::pose_at(double s) const {
  return state_->pose_at(s);
}

const std::vector<PathContour>& PathMorph::contours() const noexcept {
  return state_->contours;
}

bool PathMorph::turns() const noexcept {
  return state_->turns;
}

const std::vector<FramePose>& PathMorph::poses() const noexcept {
  return state_->poses;
}

const std::vector<double>& PathMorph::key_times() const noexcept {
  return state_->times;
}

bool PathMorph::is_smooth() const noexcept {
  return state_->smooth.has_value();
}

const std::vector<double>& PathMorph::pace() const noexcept {
  return state_->pace;
}

bool PathMorph::is_linear() const noexcept {
  return state_->linear;
}

const std::vector<MorphStep>& PathMorph::steps() const noexcept {
  return state_->steps;
}

std::size_t PathMorph::key_count() const noexcept {
  return state_->key_count;
}

FillRule PathMorph::fill_rule() const noexcept {
  return state_->fill_rule;
}

const Box& PathMorph::box() const noexcept {
  return state_->box;
}

bool PathMorph::cancelled() const noexcept {
  return state_->cancelled;
}

}  // namespace v0
}  // namespace tandem
