#include "surface/contour_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tandem/curve/bounding_box.h"
#include "tandem/curve/knots.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// How far contours may lie out of their plane, and planes be out of parallel, as a share of the size of all:
/// what files with six digits leave.
constexpr double kFlatness = 1e-5;
/// Levels nearer than this are one.
constexpr double kLeastHeight = 1e-9;
/// Halvings of a span: as many as any tolerance in use needs.
constexpr int kMostHalvings = 12;
/// Of a contour's area against its extent squared: less is a line that is run through twice.
constexpr double kLeastArea = 1e-9;

std::string name_of(std::size_t level, std::size_t contour) {
  return fmt::format("contour {} of level {}", contour, level);
}

Vector3 to_vector(std::span<const double> p) {
  return {p[0], p[1], p[2]};
}

void check(std::span<const std::vector<Curve>> levels) {
  if (levels.size() < 2) {
    throw InvalidArgument(fmt::format("{} level{} of contours, expected at least 2", levels.size(),
                                      levels.size() == 1 ? "" : "s"));
  }
  for (std::size_t l = 0; l < levels.size(); ++l) {
    if (levels[l].empty()) throw InvalidArgument(fmt::format("level {} has no contours", l));
    for (std::size_t c = 0; c < levels[l].size(); ++c) {
      if (levels[l][c].dim() != 3) {
        throw InvalidArgument(
            fmt::format("{} has dimension {}, expected 3", name_of(l, c), levels[l][c].dim()));
      }
      if (!levels[l][c].is_closed()) {
        throw InvalidArgument(fmt::format("{} is open, expected a closed one", name_of(l, c)));
      }
    }
  }
}

/// Points of a curve such that no chord is farther from it than `tolerance`, without the last, which is the
/// first.
class Polyline {
 public:
  Polyline(const Curve& curve, double tolerance, double longest_share)
      : curve_(curve), tolerance_(tolerance) {
    std::vector<Knot> knots = distinct_knots(curve.knots());
    const Interval domain = curve.domain();
    knots.erase(
        std::remove_if(knots.begin(), knots.end(), [&](const Knot& k) { return !domain.contains(k.value); }),
        knots.end());
    points_.push_back(at(domain.lo));
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      add(knots[i].value, points_.back(), knots[i + 1].value, at(knots[i + 1].value), kMostHalvings);
    }
    points_.pop_back();
    split_long_edges(longest_share);
  }

  [[nodiscard]] const std::vector<Vector3>& points() const { return points_; }

 private:
  [[nodiscard]] Vector3 at(double t) const { return to_vector(curve_.evaluate(t)); }

  [[nodiscard]] bool is_near(double a, const Vector3& pa, double b, const Vector3& pb) const {
    if (curve_.degree() == 1 && !curve_.is_rational()) return true;
    const Vector3 chord = pb - pa;
    const double square = dot(chord, chord);
    for (const double share : {0.25, 0.5, 0.75}) {
      const Vector3 d = at((1.0 - share) * a + share * b) - pa;
      const double along = square > 0.0 ? dot(d, chord) / square : 0.0;
      if (length(d - std::clamp(along, 0.0, 1.0) * chord) > tolerance_) return false;
    }
    return true;
  }

  void add(double a, const Vector3& pa, double b, const Vector3& pb, int halvings) {
    if (halvings == 0 || is_near(a, pa, b, pb)) {
      points_.push_back(pb);
      return;
    }
    const double middle = 0.5 * (a + b);
    const Vector3 pm = at(middle);
    add(a, pa, middle, pm, halvings - 1);
    add(middle, pm, b, pb, halvings - 1);
  }

  void split_long_edges(double share) {
    double whole = 0.0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      whole += length(points_[(i + 1) % points_.size()] - points_[i]);
    }
    std::vector<Vector3> finer;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vector3& a = points_[i];
      const Vector3& b = points_[(i + 1) % points_.size()];
      const double edge = length(b - a);
      if (edge == 0.0) continue;
      const int parts = std::max(1, static_cast<int>(std::ceil(edge / (share * whole) - 1e-9)));
      for (int k = 0; k < parts; ++k) {
        const double s = static_cast<double>(k) / parts;
        finer.push_back((1.0 - s) * a + s * b);
      }
    }
    points_ = std::move(finer);
  }

  const Curve& curve_;
  double tolerance_;
  std::vector<Vector3> points_;
};

/// Twice the vector area.
Vector3 area_vector(const std::vector<Vector3>& points) {
  Vector3 sum{};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    sum = sum + cross(points[i] - points[0], points[i + 1] - points[0]);
  }
  return sum;
}

Vector3 any_perpendicular(const Vector3& n) {
  std::size_t least = 0;
  for (std::size_t c = 1; c < 3; ++c) {
    if (std::abs(n[c]) < std::abs(n[least])) least = c;
  }
  Vector3 axis{};
  axis[least] = 1.0;
  return unit(axis - dot(axis, n) * n);
}

using Polylines = std::vector<std::vector<std::vector<Vector3>>>;  // [level][contour]

/// Axes from the first contour, along the normal from the first level to the second.
void set_axes(ContourStack& stack, const Polylines& contours) {
  const std::vector<Vector3>& first = contours.front().front();
  stack.origin = first.front();
  stack.normal = unit(area_vector(first));
  if (length(stack.normal) == 0.0) throw InvalidArgument(name_of(0, 0) + " encloses no area");
  if (dot(contours[1].front().front() - stack.origin, stack.normal) < 0.0) stack.normal = -1.0 * stack.normal;
  stack.axis_x = any_perpendicular(stack.normal);
  stack.axis_y = cross(stack.normal, stack.axis_x);
}

/// The common height of a level's contours.
double height_of(const ContourStack& stack, const std::vector<std::vector<Vector3>>& contours,
                 std::size_t level) {
  double lowest = 0.0;
  double highest = 0.0;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    for (const Vector3& p : contours[c]) {
      const double h = dot(p - stack.origin, stack.normal) / stack.scale;
      lowest = count == 0 ? h : std::min(lowest, h);
      highest = count == 0 ? h : std::max(highest, h);
      if (highest - lowest > kFlatness) {
        throw InvalidArgument(fmt::format(
            "{} does not lie in a plane parallel to the first contour's: off by {:.3g} of the size of all",
            name_of(level, c), highest - lowest));
      }
      sum += h;
      ++count;
    }
  }
  return sum / static_cast<double>(count);
}

Ring make_ring(ContourStack& stack, const std::vector<Vector3>& points, double height) {
  Ring ring;
  for (const Vector3& p : points) {
    const Vector3 d = (1.0 / stack.scale) * (p - stack.origin);
    ring.loop.push_back(stack.vertices.add({dot(d, stack.axis_x), dot(d, stack.axis_y)}, height));
  }
  return ring;
}

/// Depths by the even-odd rule, and with them directions.
void nest(std::vector<Ring>& rings, const std::vector<Vec2>& places) {
  std::vector<double> areas;
  areas.reserve(rings.size());
  for (const Ring& ring : rings) areas.push_back(std::abs(twice_area(ring.loop, places)));
  for (std::size_t i = 0; i < rings.size(); ++i) {
    double smallest = 0.0;
    for (std::size_t k = 0; k < rings.size(); ++k) {
      if (k == i || !(areas[k] > areas[i])) continue;
      // Contours may touch: most of the vertices decide.
      std::size_t within = 0;
      for (const std::uint32_t v : rings[i].loop)
        within += is_inside(rings[k].loop, places, places[v]) ? 1 : 0;
      if (2 * within <= rings[i].loop.size()) continue;
      if (rings[i].depth == 0 || areas[k] < smallest) {
        rings[i].parent = k;
        smallest = areas[k];
      }
      ++rings[i].depth;
    }
    rings[i].hole = rings[i].depth % 2 == 1;
    if ((twice_area(rings[i].loop, places) < 0.0) != rings[i].hole) {
      std::reverse(rings[i].loop.begin(), rings[i].loop.end());
    }
  }
}

}  // namespace

ContourStack make_stack(std::span<const std::vector<Curve>> levels, double chord, double longest_edge) {
  check(levels);
  ContourStack stack;
  Box box;
  for (const auto& level : levels) {
    for (const Curve& curve : level) box.include(bounding_box(curve));
  }
  stack.scale = box.diagonal();
  Polylines contours;
  for (const auto& level : levels) {
    contours.emplace_back();
    for (const Curve& curve : level) {
      contours.back().push_back(Polyline(curve, chord * stack.scale, longest_edge).points());
    }
  }
  set_axes(stack, contours);
  double below = 0.0;
  for (std::size_t l = 0; l < contours.size(); ++l) {
    const double height = height_of(stack, contours[l], l);
    if (l > 0 && !(height - below > kLeastHeight)) {
      throw InvalidArgument(
          fmt::format("level {} does not lie beyond level {}, expected levels in order", l, l - 1));
    }
    below = height;
    stack.levels.emplace_back();
    for (std::size_t c = 0; c < contours[l].size(); ++c) {
      stack.levels.back().push_back(make_ring(stack, contours[l][c], height));
      const double extent = levels[l][c].extent() / stack.scale;
      if (!(std::abs(twice_area(stack.levels.back().back().loop, stack.vertices.places)) >
            kLeastArea * extent * extent)) {
        throw InvalidArgument(name_of(l, c) + " encloses no area");
      }
    }
    nest(stack.levels.back(), stack.vertices.places);
  }
  return stack;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
