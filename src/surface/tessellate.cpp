#include "tandem/surface/tessellate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "surface/fine_grid.h"
#include "surface/grid_cell.h"
#include "surface/vector3.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Normals of both sides of a knot that differ by less, in radians, are one: no eye sees that edge.
constexpr double kCrease = 1e-3;
// Neighbours that are nearer than this share of the extent are one point: an edge that is none.
constexpr double kPoint = 1e-10;

/// A parameter line of the grid, seen from one side.
struct Line {
  double t;
  Side side;
};

/// Vertices that turn out to be one.
class Merger {
 public:
  explicit Merger(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }

  [[nodiscard]] std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  /// The smaller index stands for both.
  void merge(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

class Tessellation {
 public:
  Tessellation(const Surface& surface, const TessellateOptions& options)
      : scaled_(surface),
        grid_(fine_grid(scaled_, options.chord, options.angle)),
        u_(lines(Along::u)),
        v_(lines(Along::v)),
        places_(u_.size() * v_.size()) {
    for (const Line& u : u_) {
      for (const Line& v : v_) {
        points_.push_back(scaled_.point(u.t, v.t));
        normals_.push_back(scaled_.normal(u.t, v.t, {u.side, v.side}));
      }
    }
    merge_places();
    make_triangles();
    fill_missing_normals();
  }

  [[nodiscard]] TriangleMesh mesh(Joints joints) {
    if (joints == Joints::welded) weld();
    return compact();
  }

 private:
  [[nodiscard]] const Surface& surface() const noexcept { return scaled_.surface(); }
  [[nodiscard]] std::uint32_t at(std::size_t i, std::size_t j) const {
    return static_cast<std::uint32_t>(i * v_.size() + j);
  }

  /// The lines of the grid; those along which the surface is creased twice, once for each side.
  [[nodiscard]] std::vector<Line> lines(Along along) const {
    const std::vector<double>& own = along == Along::u ? grid_.u : grid_.v;
    std::vector<Line> result;
    for (const double t : own) {
      const bool first = t == own.front();
      const bool last = t == own.back();
      if (last || (!first && is_creased(along, t))) result.push_back({t, Side::left});
      if (!last) result.push_back({t, Side::right});
    }
    return result;
  }

  [[nodiscard]] bool is_creased(Along along, double t) const {
    const std::vector<double>& knots = surface().knots(along);
    if (std::count(knots.begin(), knots.end(), t) < surface().degree(along)) return false;
    const std::vector<double>& others = along == Along::u ? grid_.v : grid_.u;
    return std::any_of(others.begin(), others.end(), [&](double o) {
      const Side inside = o == others.back() ? Side::left : Side::right;
      const auto normal = [&](Side side) {
        return along == Along::u ? scaled_.normal(t, o, {side, inside})
                                 : scaled_.normal(o, t, {inside, side});
      };
      return length(normal(Side::left) - normal(Side::right)) > kCrease;
    });
  }

  /// Which vertices are at one place: both sides of a crease, both ends of a closed parameter, and the ends
  /// of edges that are a point.
  void merge_places() {
    const std::size_t m = u_.size();
    const std::size_t n = v_.size();
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if (i + 1 < m && is_one_place({i, j}, {i + 1, j})) places_.merge(at(i, j), at(i + 1, j));
        if (j + 1 < n && is_one_place({i, j}, {i, j + 1})) places_.merge(at(i, j), at(i, j + 1));
      }
    }
    for (std::size_t j = 0; surface().is_closed(Along::u) && j < n; ++j)
      places_.merge(at(0, j), at(m - 1, j));
    for (std::size_t i = 0; surface().is_closed(Along::v) && i < m; ++i)
      places_.merge(at(i, 0), at(i, n - 1));
  }

  /// Of neighbours in the grid: the same parameters, or an edge that is a point. Its middle counts, too: a
  /// closed curve of one span has ends that meet.
  [[nodiscard]] bool is_one_place(std::array<std::size_t, 2> a, std::array<std::size_t, 2> b) const {
    const double u0 = u_[a[0]].t;
    const double u1 = u_[b[0]].t;
    const double v0 = v_[a[1]].t;
    const double v1 = v_[b[1]].t;
    if (u0 == u1 && v0 == v1) return true;
    const Vector3& p = points_[at(a[0], a[1])];
    if (length(points_[at(b[0], b[1])] - p) > kPoint) return false;
    return length(scaled_.point(u0 + (u1 - u0) / 2.0, v0 + (v1 - v0) / 2.0) - p) <= kPoint;
  }

  void make_triangles() {
    for (std::size_t i = 0; i + 1 < u_.size(); ++i) {
      if (u_[i].t == u_[i + 1].t) continue;
      for (std::size_t j = 0; j + 1 < v_.size(); ++j) {
        if (v_[j].t != v_[j + 1].t) make_cell(i, j);
      }
    }
  }

  void make_cell(std::size_t i, std::size_t j) {
    const std::array<std::uint32_t, 4> c = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
    const Vector3 normal = normals_[c[0]] + normals_[c[1]] + normals_[c[2]] + normals_[c[3]];
    const Vector3 middle =
        scaled_.point(u_[i].t + (u_[i + 1].t - u_[i].t) / 2.0, v_[j].t + (v_[j + 1].t - v_[j].t) / 2.0);
    const auto triangles =
        split_cell({points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]]}, middle, normal);
    for (const auto& t : triangles) {
      const std::array<std::uint32_t, 3> triangle = {c[t[0]], c[t[1]], c[t[2]]};
      const std::uint32_t a = places_.find(triangle[0]);
      const std::uint32_t b = places_.find(triangle[1]);
      const std::uint32_t d = places_.find(triangle[2]);
      if (a != b && b != d && d != a) triangles_.push_back(triangle);
    }
  }

  /// Where the surface has no normal the triangles around have one.
  void fill_missing_normals() {
    std::vector<Vector3> sums(points_.size());
    for (const auto& t : triangles_) {
      const Vector3 n = cross(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]]);
      for (const std::uint32_t k : t) sums[k] = sums[k] + n;
    }
    for (std::size_t k = 0; k < points_.size(); ++k) {
      if (dot(normals_[k], normals_[k]) > 0.0) continue;
      normals_[k] = unit(sums[k]);
      if (!(dot(normals_[k], normals_[k]) > 0.0)) normals_[k] = {0.0, 0.0, 1.0};
    }
  }

  void weld() {
    // One normal each of those that differ: the cells around a pole are many and see the same.
    std::vector<Vector3> sums(points_.size());
    for (std::uint32_t k = 0; k < points_.size(); ++k) {
      const std::uint32_t place = places_.find(k);
      sums[place] = sums[place] + normals_[k];
    }
    for (std::uint32_t k = 0; k < points_.size(); ++k) {
      const Vector3 mean = unit(sums[k]);
      if (places_.find(k) == k && dot(mean, mean) > 0.0) normals_[k] = mean;
    }
    for (auto& t : triangles_) {
      for (std::uint32_t& k : t) k = places_.find(k);
    }
  }

  /// Without the vertices that no triangle has.
  [[nodiscard]] TriangleMesh compact() {
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(points_.size(), kNone);
    for (const auto& t : triangles_) {
      for (const std::uint32_t k : t) number[k] = 0;
    }
    const auto count = static_cast<std::size_t>(std::count(number.begin(), number.end(), 0U));
    TriangleMesh mesh{Points(3, count), Points(3, count), Points(2, count), {}};
    std::uint32_t next = 0;
    for (std::uint32_t k = 0; k < points_.size(); ++k) {
      if (number[k] == kNone) continue;
      const std::uint32_t n = number[k] = next++;
      // Vertices at one place are equal to the last bit, as the one that stands for them.
      const std::uint32_t place = places_.find(k);
      const Point p = surface().evaluate(u_[place / v_.size()].t, v_[place % v_.size()].t);
      std::copy(p.begin(), p.end(), mesh.vertices[n].begin());
      std::copy(normals_[k].begin(), normals_[k].end(), mesh.normals[n].begin());
      mesh.parameters[n][0] = u_[k / v_.size()].t;
      mesh.parameters[n][1] = v_[k % v_.size()].t;
    }
    mesh.triangles = std::move(triangles_);
    for (auto& t : mesh.triangles) {
      for (std::uint32_t& k : t) k = number[k];
    }
    return mesh;
  }

  ScaledSurface scaled_;
  ParameterGrid grid_;
  std::vector<Line> u_;
  std::vector<Line> v_;
  Merger places_;
  std::vector<Vector3> points_;
  std::vector<Vector3> normals_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace
}  // namespace detail

TriangleMesh tessellate(const Surface& surface, const TessellateOptions& options) {
  if (surface.dim() != 2 && surface.dim() != 3) {
    throw InvalidArgument(
        fmt::format("a surface in dimension {} has no triangles, expected 2 or 3", surface.dim()));
  }
  if (!(options.chord > 0.0)) {
    throw InvalidArgument(fmt::format("the chord distance is {}, expected more than 0", options.chord));
  }
  if (!(options.angle > 0.0)) {
    throw InvalidArgument(fmt::format("the angle is {}, expected more than 0", options.angle));
  }
  double most = 0.0;
  for (const double x : surface.control_points().data()) most = std::max(most, std::fabs(x));
  // Of the extent; points are not known better, and triangles would be made of that.
  const double rounding = most * std::numeric_limits<double>::epsilon() / surface.extent();
  if (surface.extent() > 0.0 && options.chord < rounding) {
    throw InvalidArgument(
        fmt::format("at coordinates of {:.3g} doubles know a surface of size {:.3g} to {:.1g} of its size: "
                    "expected a larger chord distance than {}, or a surface nearer to the origin",
                    most, surface.extent(), rounding, options.chord));
  }
  return detail::Tessellation(surface, options).mesh(options.joints);
}

}  // namespace v0
}  // namespace tandem
