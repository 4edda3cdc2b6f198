#include "surface/fine_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "surface/grid_sampler.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

constexpr std::size_t kMostVertices = std::size_t{1} << 22U;
// Where a surface folds, no grid is fine enough for the angle; past this size only the distance counts.
constexpr std::size_t kMostCellsForAngle = std::size_t{1} << 18U;
// Distances are measured at samples; what lies between them is larger by less than this.
constexpr double kSampled = 0.85;
// Pieces of a span are sampled as if they were cubic at most: that high degrees count as several.
constexpr std::size_t kSampledDegree = 3;
// Inside a cell, along each parameter; whole spans, of which nothing is known yet, are looked at more
// closely.
constexpr std::size_t kInside = 3;
constexpr std::size_t kInsideSpan = 7;
// Triangles that are no higher than this share of the extent may lie askew: at cusps and folds all do.
constexpr double kThin = 1e-3;

// Grids larger than this are refused as soon as they are bound to end above kMostVertices: cells are small by
// then, and bends fall to a quarter with each halving. With a factor to spare, for features that halving
// singles out; less of it the finer the grid is.
struct Foresight {
  std::size_t cells;
  double to_spare;
};
constexpr std::array<Foresight, 2> kForesight = {
    {{std::size_t{1} << 15U, 2.0}, {std::size_t{1} << 18U, 1.0}}};

struct Split {
  bool u = false;
  bool v = false;
  // Into how many parts in the end, to go by the bend.
  double parts_u = 1.0;
  double parts_v = 1.0;
};

/// Between two lines of the grid.
struct GridInterval {
  Interval interval;
  bool is_span;  ///< as it was at first: nothing is known of it but its ends
  bool fresh;    ///< since the last round
};

/// What a cell of the grid is judged by.
class CellJudge {
 public:
  CellJudge(const ScaledSurface& surface, double chord, double angle)
      : surface_(surface),
        sampler_(surface),
        chord_(kSampled * chord),
        thin_(std::min(chord, kThin)),
        cosine_(std::cos(std::min(angle, 3.14))) {}

  /// Along which parameters the cell must be split.
  [[nodiscard]] Split judge(const GridInterval& across_u, const GridInterval& across_v, bool angles) {
    const Interval u = across_u.interval;
    const Interval v = across_v.interval;
    inside_u_ = inside(Along::u, across_u);
    inside_v_ = inside(Along::v, across_v);
    sample(u, v);
    const CellCorners<Vector3> corners = {at(0, 0), at(inside_u_ + 1, 0), at(inside_u_ + 1, inside_v_ + 1),
                                          at(0, inside_v_ + 1)};
    const bool near = is_near(corners);
    if (near && !angles) return {};
    const Vector3 middle = surface_.point(u.lo + u.length() / 2.0, v.lo + v.length() / 2.0);
    const CellCorners<Vector3> normals = {
        surface_.normal(u.lo, v.lo, {Side::right, Side::right}),
        surface_.normal(u.hi, v.lo, {Side::left, Side::right}),
        surface_.normal(u.hi, v.hi, {Side::left, Side::left}),
        surface_.normal(u.lo, v.hi, {Side::right, Side::left}),
    };
    const Vector3 normal = normals[0] + normals[1] + normals[2] + normals[3];
    const CellTriangles triangles = split_cell(corners, middle, normal);
    // The edges count by themselves: where a flat surface ends, its triangles would stand out beyond a
    // hollow.
    if (!near) {
      const double off = std::max({deviation(corners, triangles), edge_bend(Along::u), edge_bend(Along::v)});
      if (off > chord_) return choose(corners, off);
    }
    if (angles && !agree(corners, normals, triangles)) return choose_for_angle(corners, normals);
    return {};
  }

 private:
  [[nodiscard]] std::size_t inside(Along along, const GridInterval& across) const {
    const Surface& surface = surface_.surface();
    const bool even = surface.degree(along) == 1 && !surface.is_rational();
    return across.is_span && !even ? kInsideSpan : kInside;
  }

  [[nodiscard]] const Vector3& at(std::size_t i, std::size_t j) const { return samples_[i][j]; }

  void sample(Interval u, Interval v) {
    std::array<double, kInsideSpan + 2> places{};
    const auto spread = [&](Interval whole, std::size_t inside) {
      for (std::size_t k = 0; k <= inside + 1; ++k)
        places[k] = whole.lo + static_cast<double>(k) / static_cast<double>(inside + 1) * whole.length();
      return std::span<const double>(places).first(inside + 2);
    };
    // Cells come row by row.
    if (!rows_ || !(*rows_ == u)) sampler_.set_rows(spread(u, inside_u_));
    rows_ = u;
    sampler_.set_columns(spread(v, inside_v_));
    for (std::size_t i = 0; i <= inside_u_ + 1; ++i) {
      for (std::size_t j = 0; j <= inside_v_ + 1; ++j) samples_[i][j] = sampler_.at(i, j);
    }
  }

  /// Whether the samples are as near as they must be to the points of the triangles, cut either way, that
  /// have the same share of the cell: then they are as near to the triangles.
  [[nodiscard]] bool is_near(const CellCorners<Vector3>& c) const {
    const double limit = chord_ * chord_;
    for (std::size_t i = 0; i <= inside_u_ + 1; ++i) {
      const double s = static_cast<double>(i) / static_cast<double>(inside_u_ + 1);
      for (std::size_t j = 0; j <= inside_v_ + 1; ++j) {
        const double t = static_cast<double>(j) / static_cast<double>(inside_v_ + 1);
        const Vector3 along = t <= s ? c[0] + s * (c[1] - c[0]) + t * (c[2] - c[1])
                                     : c[0] + t * (c[3] - c[0]) + s * (c[2] - c[3]);
        const Vector3 across = s + t <= 1.0 ? c[0] + s * (c[1] - c[0]) + t * (c[3] - c[0])
                                            : c[2] + (1.0 - s) * (c[3] - c[2]) + (1.0 - t) * (c[1] - c[2]);
        const Vector3 off_along = at(i, j) - along;
        const Vector3 off_across = at(i, j) - across;
        if (std::max(dot(off_along, off_along), dot(off_across, off_across)) > limit) return false;
      }
    }
    return true;
  }

  [[nodiscard]] double deviation(const CellCorners<Vector3>& corners, const CellTriangles& triangles) const {
    double most = 0.0;
    for (std::size_t i = 0; i <= inside_u_ + 1; ++i) {
      for (std::size_t j = 0; j <= inside_v_ + 1; ++j) {
        double least = INFINITY;
        for (const auto& t : triangles) {
          least =
              std::min(least, distance_to_triangle(at(i, j), {corners[t[0]], corners[t[1]], corners[t[2]]}));
        }
        most = std::max(most, least);
      }
    }
    return most;
  }

  /// How far the curves along a parameter are from their chords, of every step-th line.
  [[nodiscard]] double bend(Along along, std::size_t step = 1) const {
    const bool by_u = along == Along::u;
    const std::size_t lines = by_u ? inside_v_ + 2 : inside_u_ + 2;
    const std::size_t inside = by_u ? inside_u_ : inside_v_;
    const auto sample = [&](std::size_t line, std::size_t k) -> const Vector3& {
      return by_u ? at(k, line) : at(line, k);
    };
    double most = 0.0;
    for (std::size_t line = 0; line < lines; line += step) {
      const Vector3& first = sample(line, 0);
      const Vector3& last = sample(line, inside + 1);
      for (std::size_t k = 1; k <= inside; ++k) {
        most = std::max(most, distance_to_triangle(sample(line, k), {first, last, last}));
      }
    }
    return most;
  }

  [[nodiscard]] double edge_bend(Along along) const {
    return bend(along, along == Along::u ? inside_v_ + 1 : inside_u_ + 1);
  }

  /// The parameter along which the cell bends more; a twist has none, then the longer one.
  [[nodiscard]] Split choose(const CellCorners<Vector3>& corners, double off) const {
    const double u = bend(Along::u);
    const double v = bend(Along::v);
    // A bend of less than this share of what is wrong is not its cause.
    constexpr double kShare = 0.25;
    if (std::max(u, v) <= kShare * off) {
      // Twisted: halving either parameter halves what it is off.
      Split split = longer(corners);
      split.parts_u = split.parts_v = std::sqrt(off / chord_);
      return split;
    }
    return {u >= v || u > chord_, v > u || v > chord_, halved_parts(u / chord_), halved_parts(v / chord_)};
  }

  /// Into how many parts halving cuts a curve that bends by `bend` times as much as it may: a quarter is left
  /// of it each time.
  [[nodiscard]] static double halved_parts(double bend) {
    return bend > 1.0 ? std::exp2(std::ceil(0.5 * std::log2(bend))) : 1.0;
  }

  [[nodiscard]] static Split longer(const CellCorners<Vector3>& c) {
    const double u = std::max(length(c[1] - c[0]), length(c[2] - c[3]));
    const double v = std::max(length(c[3] - c[0]), length(c[2] - c[1]));
    return {u >= v, v > u};
  }

  /// The parameter along which the normals turn more.
  [[nodiscard]] static Split choose_for_angle(const CellCorners<Vector3>& corners,
                                              const CellCorners<Vector3>& n) {
    const double along_u = std::min(dot(n[0], n[1]), dot(n[2], n[3]));
    const double along_v = std::min(dot(n[0], n[3]), dot(n[1], n[2]));
    constexpr double kEqual = 1e-6;  // cosines of angles that differ by less are equal
    if (std::fabs(along_u - along_v) < kEqual) return longer(corners);
    return {along_u < along_v, along_v < along_u};
  }

  /// Whether the triangles that are not too thin for it look where the surface does.
  [[nodiscard]] bool agree(const CellCorners<Vector3>& corners, const CellCorners<Vector3>& normals,
                           const CellTriangles& triangles) const {
    const bool planar = surface_.surface().dim() == 2;
    if (planar && normals[0] + normals[1] + normals[2] + normals[3] != 4.0 * normals[0]) return true;
    for (const auto& t : triangles) {
      const Vector3 n = cross(corners[t[1]] - corners[t[0]], corners[t[2]] - corners[t[0]]);
      const double longest =
          std::max({length(corners[t[1]] - corners[t[0]]), length(corners[t[2]] - corners[t[1]]),
                    length(corners[t[0]] - corners[t[2]])});
      const double twice_area = length(n);
      if (!(twice_area > thin_ * longest)) continue;
      for (const std::size_t k : t) {
        const bool known = dot(normals[k], normals[k]) > 0.0;
        if (known && dot(n, normals[k]) < cosine_ * twice_area) return false;
      }
    }
    return true;
  }

  const ScaledSurface& surface_;
  GridSampler sampler_;
  std::optional<Interval> rows_;  ///< that the sampler has
  double chord_;
  double thin_;
  double cosine_;
  std::size_t inside_u_ = 0;
  std::size_t inside_v_ = 0;
  std::array<std::array<Vector3, kInsideSpan + 2>, kInsideSpan + 2> samples_{};
};

using Intervals = std::vector<GridInterval>;

Intervals first_intervals(const Surface& surface, Along along) {
  const Interval domain = surface.domain(along);
  const auto pieces = (static_cast<std::size_t>(surface.degree(along)) + kSampledDegree - 1) / kSampledDegree;
  Intervals result;
  double last = domain.lo;
  for (const double knot : surface.knots(along)) {
    if (!(knot > last) || knot > domain.hi) continue;
    const double from = last;
    for (std::size_t k = 1; k <= pieces; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(pieces);
      const double t = k == pieces ? knot : from + (knot - from) * share;
      if (t > last) result.push_back({{last, t}, true, true});
      last = std::max(last, t);
    }
  }
  return result;
}

/// With the intervals that are marked halved, as far as numbers go.
Intervals halve(const Intervals& intervals, const std::vector<std::uint8_t>& marked) {
  Intervals result;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const Interval whole = intervals[i].interval;
    const double middle = whole.lo + whole.length() / 2.0;
    if (marked[i] != 0 && middle > whole.lo && middle < whole.hi) {
      result.push_back({{whole.lo, middle}, false, true});
      result.push_back({{middle, whole.hi}, false, true});
    } else {
      result.push_back({whole, intervals[i].is_span, false});
    }
  }
  return result;
}

std::vector<double> lines_of(const Intervals& intervals) {
  std::vector<double> lines{intervals.front().interval.lo};
  for (const GridInterval& each : intervals) lines.push_back(each.interval.hi);
  return lines;
}

[[noreturn]] void refuse(double chord) {
  throw InvalidArgument(fmt::format(
      "a chord distance of {} needs more than {} vertices, expected a larger one", chord, kMostVertices));
}

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

ParameterGrid fine_grid(const ScaledSurface& surface, double chord, double angle) {
  CellJudge judge(surface, chord, angle);
  Intervals u = first_intervals(surface.surface(), Along::u);
  Intervals v = first_intervals(surface.surface(), Along::v);
  for (;;) {
    if (u.size() + 1 > kMostVertices / (v.size() + 1)) refuse(chord);
    const bool angles = u.size() * v.size() <= kMostCellsForAngle;
    std::vector<std::uint8_t> split_u(u.size(), 0);
    std::vector<std::uint8_t> split_v(v.size(), 0);
    std::vector<double> parts_u(u.size(), 1.0);
    std::vector<double> parts_v(v.size(), 1.0);
    for (std::size_t i = 0; i < u.size(); ++i) {
      for (std::size_t j = 0; j < v.size(); ++j) {
        // Seen before, or about to be split anyway.
        if ((!u[i].fresh && !v[j].fresh) || (split_u[i] != 0 && split_v[j] != 0)) continue;
        const Split split = judge.judge(u[i], v[j], angles);
        if (split.u) split_u[i] = 1;
        if (split.v) split_v[j] = 1;
        parts_u[i] = std::max(parts_u[i], split.parts_u);
        parts_v[j] = std::max(parts_v[j], split.parts_v);
      }
    }
    const double in_the_end = sum_of(parts_u) * sum_of(parts_v);
    for (const Foresight& look : kForesight) {
      if (u.size() * v.size() > look.cells && in_the_end > look.to_spare * kMostVertices) refuse(chord);
    }
    Intervals finer_u = halve(u, split_u);
    Intervals finer_v = halve(v, split_v);
    if (finer_u.size() == u.size() && finer_v.size() == v.size()) return {lines_of(u), lines_of(v)};
    u = std::move(finer_u);
    v = std::move(finer_v);
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
