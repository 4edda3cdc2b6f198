#include "tandem/shape/nesting.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "shape/flattening.h"
#include "shape/interior_samples.h"
#include "shape/reversed.h"
#include "tandem/shape/path_view.h"

namespace tandem {
inline namespace v0 {
namespace {

// Share of the diagonal that contours are flattened to: what they enclose is told from hundreds of points.
constexpr double kTolerance = 1e-3;

// Area, in squared diagonals, up to which a contour encloses nothing but rounding.
constexpr double kNothing = 1e-12;

/// Who winds around whom.
class Containment {
 public:
  explicit Containment(std::span<const CubicPath> paths) : count_(paths.size()), areas_(paths.size(), 0.0) {
    flat_.assign(view_paths(paths), kTolerance, 0.0);
    directions_.resize(count_, 0);
    samples_.resize(count_);
    containers_.resize(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      if (!paths[i].is_closed()) continue;
      samples_[i] = sample_interior(flat_, flat_.paths()[i]);
      for (const InteriorSample& sample : samples_[i]) areas_[i] += sample.weight;
      if (areas_[i] <= kNothing) samples_[i].clear();
      directions_[i] = direction(i);
    }
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t j = 0; j < count_; ++j) {
        if (i != j && is_larger(j, i) && winds_around(j, i)) containers_[i].push_back(j);
      }
      // Outermost first.
      std::sort(containers_[i].begin(), containers_[i].end(),
                [this](std::size_t a, std::size_t b) { return is_larger(a, b); });
    }
  }

  /// Contours that wind around contour i, the innermost last.
  [[nodiscard]] const std::vector<std::size_t>& containers(std::size_t i) const { return containers_[i]; }
  /// 1 counter-clockwise, -1 clockwise, 0 for one that encloses nothing.
  [[nodiscard]] int direction_of(std::size_t i) const { return directions_[i]; }
  /// Sum of the directions of the containers: the winding number around the contour.
  [[nodiscard]] int winding_outside(std::size_t i) const {
    int winding = 0;
    for (const std::size_t j : containers_[i]) winding += directions_[j];
    return winding;
  }

 private:
  [[nodiscard]] int direction(std::size_t i) const {
    double sum = 0.0;
    for (const InteriorSample& sample : samples_[i]) {
      sum += sample.weight * winding_number(flat_, flat_.paths()[i], sample.point);
    }
    return samples_[i].empty() ? 0 : sum >= 0.0 ? 1 : -1;
  }
  // Equal ones, drawn in opposite directions perhaps, differ by rounding.
  [[nodiscard]] bool is_larger(std::size_t i, std::size_t j) const {
    const bool equal = std::abs(areas_[i] - areas_[j]) <= 1e-9 * (areas_[i] + areas_[j]);
    return equal ? i < j : areas_[i] > areas_[j];
  }
  [[nodiscard]] bool winds_around(std::size_t i, std::size_t j) const {
    if (directions_[i] == 0) return false;
    double inside = 0.0;
    double all = 0.0;
    for (const InteriorSample& sample : samples_[j]) {
      all += sample.weight;
      if (winding_number(flat_, flat_.paths()[i], sample.point) != 0) inside += sample.weight;
    }
    return inside > 0.5 * all;
  }

  std::size_t count_;
  Flattening flat_;
  std::vector<std::vector<InteriorSample>> samples_;
  std::vector<double> areas_;
  std::vector<int> directions_;
  std::vector<std::vector<std::size_t>> containers_;
};

NestedContour place(const Containment& containment, std::size_t i, FillRule fill_rule) {
  NestedContour contour;
  contour.depth = containment.containers(i).size();
  if (contour.depth > 0) contour.parent = containment.containers(i).back();
  const int direction = containment.direction_of(i);
  if (direction == 0) {
    contour.changes_nothing = true;
  } else if (fill_rule == FillRule::evenodd) {
    contour.role = contour.depth % 2 == 0 ? ContourRole::solid : ContourRole::hole;
  } else {
    const int outside = containment.winding_outside(i);
    contour.role = outside * direction < 0 ? ContourRole::hole : ContourRole::solid;
    contour.changes_nothing = outside != 0 && outside + direction != 0;
  }
  return contour;
}

// The solid on empty ground that contour i is or lies in: all windings up to it change sign together.
std::size_t find_root(const Containment& containment, std::size_t i) {
  if (containment.winding_outside(i) == 0) return i;
  const auto& containers = containment.containers(i);
  for (std::size_t k = containers.size(); k-- > 0;) {
    if (containment.winding_outside(containers[k]) == 0) return containers[k];
  }
  return i;
}

}  // namespace

std::vector<NestedContour> find_nesting(std::span<const CubicPath> paths, FillRule fill_rule) {
  const Containment containment(paths);
  std::vector<NestedContour> contours;
  contours.reserve(paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    contours.push_back(place(containment, i, fill_rule));
    if (!paths[i].is_closed()) contours.back() = {ContourRole::stroke, std::nullopt, 0, false};
  }
  return contours;
}

std::vector<CubicPath> orient(std::span<const CubicPath> paths, FillRule fill_rule) {
  const Containment containment(paths);
  std::vector<CubicPath> oriented;
  oriented.reserve(paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const int direction = containment.direction_of(i);
    bool turn = false;
    if (direction != 0 && fill_rule == FillRule::evenodd) {
      turn = direction != (containment.containers(i).size() % 2 == 0 ? 1 : -1);
    } else if (direction != 0) {
      turn = containment.direction_of(find_root(containment, i)) < 0;
    }
    oriented.push_back(turn ? reversed(paths[i]) : paths[i]);
  }
  return oriented;
}

}  // namespace v0
}  // namespace tandem
