#include "morph/in_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "morph/wants_turns.h"
#include "tandem/curve/bounding_box.h"
#include "tandem/curve/compatible.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"
#include "tandem/shape/cubic_path.h"
#include "tandem/shape/cut_at.h"

namespace tandem {
inline namespace v0 {
namespace {

using Matches = std::vector<std::optional<Match>>;

// Curves that are no cubics are met within this share of their size.
constexpr double kFitTolerance = 1e-6;

CubicPath as_path(const Curve& curve) {
  const double size = curve.extent();
  return to_cubic_path(curve, size > 0.0 ? kFitTolerance * size : kFitTolerance);
}

std::vector<Shape> as_cubics(std::span<const Shape> keys) {
  std::vector<Shape> cubics(keys.begin(), keys.end());
  for (Shape& key : cubics) {
    for (Curve& contour : key.contours) contour = to_curve(as_path(contour));
  }
  return cubics;
}

// One contour through the keys so far; empty where a key has none, or a mere point.
struct Chain {
  std::vector<std::optional<Curve>> curves;
  std::optional<std::size_t> last;  // newest key that has the contour

  [[nodiscard]] const Curve& newest() const { return *curves[*last]; }
  [[nodiscard]] bool all_closed() const {
    return std::all_of(curves.begin(), curves.end(), [](const auto& c) { return !c || c->is_closed(); });
  }
  void set(std::size_t key, Curve curve) {
    // A match may have cut the closed curves open elsewhere: those before it follow.
    for (std::optional<Curve>& earlier : curves) {
      if (earlier && !(earlier->domain() == curve.domain())) {
        earlier = move_seam(*earlier, curve.domain().lo);
      }
    }
    curves[key] = std::move(curve);
    last = key;
  }
  // The same of a match of segments: all keys are cut where it says.
  void set_in_segments(std::size_t key, const Curve& curve, const Correspondence& c) {
    std::vector<double> u;
    std::vector<double> v;
    for (const ParameterPair& point : c.points) {
      u.push_back(point.u);
      v.push_back(point.v);
    }
    for (std::optional<Curve>& earlier : curves) {
      if (earlier) earlier = to_curve(cut_at(as_path(*earlier), u, c.closed));
    }
    curves[key] = to_curve(cut_at(as_path(curve), v, c.closed));
    last = key;
  }
};

const Curve* source(const Shape& key, std::size_t contour) {
  return contour < key.contours.size() ? &key.contours[contour] : nullptr;
}

bool has_extent(const Curve* curve) {
  return curve != nullptr && curve->extent() > 0.0;
}

// The whole work as equal parts, one per pair of neighbouring keys and contour.
class Work {
 public:
  Work(const Progress& progress, std::size_t parts) : progress_(progress), parts_(parts) {}

  [[nodiscard]] Progress part() const {
    if (!progress_) return {};
    return [this](double fraction) { return progress_((done_ + fraction) / parts_); };
  }
  // A part that has to be done again: asks whether to go on, without counting.
  [[nodiscard]] Progress again() const {
    if (!progress_) return {};
    return [this](double) { return progress_(std::min(done_ / parts_, 1.0)); };
  }
  void finish_part() { done_ += 1.0; }

 private:
  const Progress& progress_;
  double parts_;
  double done_ = 0.0;
};

Match match_next(const Chain& chain, const Curve& curve, std::size_t key, std::size_t contour,
                 MatchOptions options) {
  // A closed curve may be cut open for an open one only if the keys before it can be cut there too.
  if (options.closed == ClosedMode::automatic && !curve.is_closed() && !chain.all_closed()) {
    options.closed = ClosedMode::no;
  }
  try {
    return match(chain.newest(), curve, options);
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(
        fmt::format("contour {} of keys {} and {}: {}", contour, key - 1, key, error.what()));
  }
}

bool is_filled(const Match& found) {
  return found.correspondence.closed;
}

// The direction in which most of the length of the filled contours was matched; forward on a tie.
Direction common_direction(const Matches& matches) {
  double forward = 0.0;
  double reversed = 0.0;
  for (const std::optional<Match>& found : matches) {
    if (!found || !is_filled(*found)) continue;
    const double length = found->samples_a.length + found->samples_b.length;
    (found->report.direction == Direction::reversed ? reversed : forward) += length;
  }
  return reversed > forward ? Direction::reversed : Direction::forward;
}

// Index of the nearest key that has the contour, the earlier one on a tie.
std::size_t nearest_with(std::span<const Shape> keys, std::size_t contour, std::size_t key) {
  for (std::size_t distance = 0; distance < keys.size(); ++distance) {
    if (distance <= key && source(keys[key - distance], contour) != nullptr) return key - distance;
    if (key + distance < keys.size() && source(keys[key + distance], contour) != nullptr)
      return key + distance;
  }
  return key;
}

Curve collapsed(const Curve& like, std::span<const double> center) {
  Points points = like.control_points();
  for (std::size_t i = 0; i < points.size(); ++i) std::copy(center.begin(), center.end(), points[i].begin());
  return Curve(like.degree(), like.knots(), std::move(points), like.weights());
}

// The chain's curves in one function space, its gaps filled by points.
std::vector<Curve> completed(const Chain& chain, std::span<const Shape> keys, std::size_t contour) {
  std::vector<Curve> present;
  for (const std::optional<Curve>& curve : chain.curves) {
    if (curve) present.push_back(*curve);
  }
  if (present.empty()) {  // points throughout
    present.push_back(*source(keys[nearest_with(keys, contour, 0)], contour));
  } else {
    present = with_common_denominator(present);
  }
  std::vector<Curve> curves;
  std::size_t next = 0;
  for (std::size_t key = 0; key < keys.size(); ++key) {
    if (chain.curves[key]) {
      curves.push_back(present[next++]);
    } else {
      const Curve& stand_in = *source(keys[nearest_with(keys, contour, key)], contour);
      curves.push_back(collapsed(present.front(), bounding_box(stand_in).center()));
    }
  }
  return curves;
}

class KeyMatcher {
 public:
  KeyMatcher(std::span<const Shape> keys, bool one_direction, const MorphOptions& options,
             std::size_t contours)
      : keys_(keys),
        one_direction_(one_direction),
        least_gain_(options.least_gain),
        options_(options.match),
        chains_(contours, Chain{std::vector<std::optional<Curve>>(keys.size()), {}}),
        work_(options_.progress, (keys.size() - 1) * (contours + (detail::wants_turns(options_) ? 1 : 0))) {}

  // Puts `key` in step with the one before it, the first one with none; nothing when cancelled.
  std::optional<Matches> add(std::size_t key) {
    Matches matches(chains_.size());
    if (key > 0 && !find_turn(key)) return std::nullopt;
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      if (!is_pair(key, c)) continue;
      MatchOptions own = turned_options();
      own.progress = work_.part();
      matches[c] = match_next(chains_[c], *source(keys_[key], c), key, c, own);
      if (matches[c]->report.cancelled) return std::nullopt;
      work_.finish_part();
    }
    const Direction direction = one_direction_ ? common_direction(matches) : Direction::forward;
    if (one_direction_ && options_.direction == Direction::automatic && !turn_all(matches, key, direction)) {
      return std::nullopt;
    }
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      const Curve* curve = source(keys_[key], c);
      if (matches[c] && options_.method == Method::segments) {
        chains_[c].set_in_segments(key, *curve, matches[c]->correspondence);
      } else if (matches[c]) {
        chains_[c].set(key, matches[c]->curve);
      } else if (has_extent(curve)) {
        chains_[c].set(key, newcomer(chains_[c], *curve, direction));
      }
    }
    return matches;
  }

  [[nodiscard]] std::vector<std::vector<Curve>> take() const {
    std::vector<std::vector<Curve>> contours;
    for (std::size_t c = 0; c < chains_.size(); ++c) contours.push_back(completed(chains_[c], keys_, c));
    return contours;
  }
  // From each key to the next, as far as they were added.
  [[nodiscard]] const std::vector<Rotation>& rotations() const { return rotations_; }

 private:
  // Whether the contour is there in `key` and in the key before it.
  [[nodiscard]] bool is_pair(std::size_t key, std::size_t contour) const {
    return chains_[contour].last && *chains_[contour].last + 1 == key &&
           has_extent(source(keys_[key], contour));
  }

  // The common turn of all contours from the key before to `key`; false when cancelled.
  bool find_turn(std::size_t key) {
    const int dim = keys_[key].dim();
    rotations_.push_back(options_.rotation.empty() ? Rotation(dim) : Rotation(dim, options_.rotation));
    if (!detail::wants_turns(options_)) return true;
    std::vector<Curve> a;
    std::vector<Curve> b;
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      if (!is_pair(key, c)) continue;
      a.push_back(chains_[c].newest());
      b.push_back(*source(keys_[key], c));
    }
    bool cancelled = false;
    MatchOptions own = options_;
    if (own.progress) {
      own.progress = [&cancelled, part = work_.part()](double fraction) {
        cancelled = !part(fraction);
        return !cancelled;
      };
    }
    try {
      if (!a.empty()) rotations_.back() = common_rotation(a, b, own, least_gain_);
    } catch (const InvalidArgument& error) {
      throw InvalidArgument(fmt::format("keys {} and {}: {}", key - 1, key, error.what()));
    }
    work_.finish_part();
    return !cancelled;
  }

  [[nodiscard]] MatchOptions turned_options() const {
    MatchOptions own = options_;
    own.rotation = rotations_.back().values();
    return own;
  }

  // Matches the filled contours that went the other way once more; false when cancelled.
  bool turn_all(Matches& matches, std::size_t key, Direction direction) {
    for (std::size_t c = 0; c < matches.size(); ++c) {
      if (!matches[c] || !is_filled(*matches[c]) || matches[c]->report.direction == direction) continue;
      MatchOptions own = turned_options();
      own.direction = direction;
      own.progress = work_.again();
      matches[c] = match_next(chains_[c], *source(keys_[key], c), key, c, own);
      if (matches[c]->report.cancelled) return false;
    }
    return true;
  }

  // A contour that the key before does not have: nothing to be in step with but its own key.
  static Curve newcomer(const Chain& chain, const Curve& curve, Direction direction) {
    const bool turn = direction == Direction::reversed && curve.is_closed();
    const Curve turned = turn ? reverse(curve) : curve;
    return chain.last ? with_domain(clamp(turned), chain.newest().domain()) : turned;
  }

  std::span<const Shape> keys_;
  bool one_direction_;
  double least_gain_;
  const MatchOptions& options_;
  std::vector<Chain> chains_;
  std::vector<Rotation> rotations_;
  Work work_;
};

}  // namespace

InStep put_in_step(std::span<const Shape> keys, bool one_direction, const MorphOptions& options) {
  std::size_t contours = 0;
  for (const Shape& key : keys) contours = std::max(contours, key.contours.size());
  InStep result;
  result.matches.assign(keys.size() - 1, Matches(contours));
  std::vector<Shape> cubics;
  if (options.match.method == Method::segments) {
    cubics = as_cubics(keys);
    keys = cubics;
  }
  KeyMatcher matcher(keys, one_direction, options, contours);
  for (std::size_t key = 0; key < keys.size(); ++key) {
    std::optional<Matches> matches = matcher.add(key);
    if (!matches) {
      result.cancelled = true;
      return result;
    }
    if (key > 0) result.matches[key - 1] = std::move(*matches);
  }
  result.contours = matcher.take();
  result.rotations = matcher.rotations();
  return result;
}

}  // namespace v0
}  // namespace tandem
