#include "surface/fine_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

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
constexpr std::size_t kMostInside = 3;

struct Split {
  bool u = false;
  bool v = false;
};

/// What a cell of the grid is judged by.
class CellJudge {
 public:
  CellJudge(const ScaledSurface& surface, double chord, double angle)
      : surface_(surface),
        chord_(kSampled * chord),
        cosine_(std::cos(std::min(angle, 3.14))),
        inside_u_(inside(Along::u)),
        inside_v_(inside(Along::v)) {}

  /// Along which parameters the cell must be split.
  [[nodiscard]] Split judge(Interval u, Interval v, bool angles) {
    sample(u, v);
    const CellCorners<Vector3> corners = {at(0, 0), at(inside_u_ + 1, 0), at(inside_u_ + 1, inside_v_ + 1),
                                          at(0, inside_v_ + 1)};
    const Vector3 middle = surface_.point(u.lo + u.length() / 2.0, v.lo + v.length() / 2.0);
    const CellCorners<Vector3> normals = {
        surface_.normal(u.lo, v.lo, {Side::right, Side::right}),
        surface_.normal(u.hi, v.lo, {Side::left, Side::right}),
        surface_.normal(u.hi, v.hi, {Side::left, Side::left}),
        surface_.normal(u.lo, v.hi, {Side::right, Side::left}),
    };
    const Vector3 normal = normals[0] + normals[1] + normals[2] + normals[3];
    const CellTriangles triangles = split_cell(corners, middle, normal);
    const double off = deviation(corners, triangles);
    if (off > chord_) return choose(corners, off);
    if (angles && !agree(corners, normals, triangles)) return choose_for_angle(corners, normals);
    return {};
  }

 private:
  [[nodiscard]] std::size_t inside(Along along) const {
    return std::min(static_cast<std::size_t>(surface_.surface().degree(along)), kMostInside);
  }

  [[nodiscard]] const Vector3& at(std::size_t i, std::size_t j) const { return samples_[i][j]; }

  void sample(Interval u, Interval v) {
    for (std::size_t i = 0; i <= inside_u_ + 1; ++i) {
      const double s = static_cast<double>(i) / static_cast<double>(inside_u_ + 1);
      for (std::size_t j = 0; j <= inside_v_ + 1; ++j) {
        const double t = static_cast<double>(j) / static_cast<double>(inside_v_ + 1);
        samples_[i][j] = surface_.point(u.lo + s * u.length(), v.lo + t * v.length());
      }
    }
  }

  [[nodiscard]] double deviation(const CellCorners<Vector3>& corners, const CellTriangles& triangles) const {
    double most = 0.0;
    for (std::size_t i = 0; i <= inside_u_ + 1; ++i) {
      for (std::size_t j = 0; j <= inside_v_ + 1; ++j) {
        double least = INFINITY;
        for (const auto& t : triangles) {
          least = std::min(least,
                           distance_to_triangle(at(i, j), {corners[t[0]], corners[t[1]], corners[t[2]]}));
        }
        most = std::max(most, least);
      }
    }
    return most;
  }

  /// How far the curves along a parameter are from their chords.
  [[nodiscard]] double bend(Along along) const {
    const bool by_u = along == Along::u;
    const std::size_t lines = by_u ? inside_v_ + 2 : inside_u_ + 2;
    const std::size_t inside = by_u ? inside_u_ : inside_v_;
    const auto sample = [&](std::size_t line, std::size_t k) -> const Vector3& {
      return by_u ? at(k, line) : at(line, k);
    };
    double most = 0.0;
    for (std::size_t line = 0; line < lines; ++line) {
      const Vector3& first = sample(line, 0);
      const Vector3& last = sample(line, inside + 1);
      for (std::size_t k = 1; k <= inside; ++k) {
        most = std::max(most, distance_to_triangle(sample(line, k), {first, last, last}));
      }
    }
    return most;
  }

  /// The parameter along which the cell bends more; a twist has none, then the longer one.
  [[nodiscard]] Split choose(const CellCorners<Vector3>& corners, double off) const {
    const double u = bend(Along::u);
    const double v = bend(Along::v);
    // A bend of less than this share of what is wrong is not its cause.
    constexpr double kShare = 0.25;
    if (std::max(u, v) > kShare * off) return {u >= v || u > chord_, v > u || v > chord_};
    return longer(corners);
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
      const double longest = std::max({length(corners[t[1]] - corners[t[0]]),
                                       length(corners[t[2]] - corners[t[1]]),
                                       length(corners[t[0]] - corners[t[2]])});
      const double twice_area = length(n);
      if (!(twice_area > chord_ * longest)) continue;
      for (const std::size_t k : t) {
        const bool known = dot(normals[k], normals[k]) > 0.0;
        if (known && dot(n, normals[k]) < cosine_ * twice_area) return false;
      }
    }
    return true;
  }

  const ScaledSurface& surface_;
  double chord_;
  double cosine_;
  std::size_t inside_u_;
  std::size_t inside_v_;
  std::array<std::array<Vector3, kMostInside + 2>, kMostInside + 2> samples_{};
};

std::vector<double> first_lines(const Surface& surface, Along along) {
  const Interval domain = surface.domain(along);
  const auto pieces =
      (static_cast<std::size_t>(surface.degree(along)) + kSampledDegree - 1) / kSampledDegree;
  std::vector<double> lines{domain.lo};
  for (const double knot : surface.knots(along)) {
    if (!(knot > lines.back()) || knot > domain.hi) continue;
    const double from = lines.back();
    for (std::size_t k = 1; k < pieces; ++k) {
      const double t = from + (knot - from) * static_cast<double>(k) / static_cast<double>(pieces);
      if (t > lines.back() && t < knot) lines.push_back(t);
    }
    lines.push_back(knot);
  }
  return lines;
}

/// Lines with the intervals that are marked halved; fresh: the halves.
struct Halved {
  std::vector<double> lines;
  std::vector<std::uint8_t> fresh;
};

Halved halve(const std::vector<double>& lines, const std::vector<std::uint8_t>& marked) {
  Halved result;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    result.lines.push_back(lines[i]);
    const double middle = lines[i] + (lines[i + 1] - lines[i]) / 2.0;
    const bool splits = marked[i] != 0 && middle > lines[i] && middle < lines[i + 1];
    if (splits) result.lines.push_back(middle);
    result.fresh.insert(result.fresh.end(), splits ? 2 : 1, splits ? 1 : 0);
  }
  result.lines.push_back(lines.back());
  return result;
}

}  // namespace

ParameterGrid fine_grid(const ScaledSurface& surface, double chord, double angle) {
  CellJudge judge(surface, chord, angle);
  ParameterGrid grid{first_lines(surface.surface(), Along::u), first_lines(surface.surface(), Along::v)};
  std::vector<std::uint8_t> fresh_u(grid.u.size() - 1, 1);
  std::vector<std::uint8_t> fresh_v(grid.v.size() - 1, 1);
  for (;;) {
    if (grid.u.size() > kMostVertices / grid.v.size()) {
      throw InvalidArgument(fmt::format(
          "a chord distance of {} needs more than {} vertices, expected a larger one", chord, kMostVertices));
    }
    const bool angles = grid.u.size() * grid.v.size() <= kMostCellsForAngle;
    std::vector<std::uint8_t> split_u(fresh_u.size(), 0);
    std::vector<std::uint8_t> split_v(fresh_v.size(), 0);
    for (std::size_t i = 0; i < fresh_u.size(); ++i) {
      for (std::size_t j = 0; j < fresh_v.size(); ++j) {
        if (fresh_u[i] == 0 && fresh_v[j] == 0) continue;
        // A finer line is coming through here anyway.
        if (split_u[i] != 0 && split_v[j] != 0) continue;
        const Split split =
            judge.judge({grid.u[i], grid.u[i + 1]}, {grid.v[j], grid.v[j + 1]}, angles);
        if (split.u) split_u[i] = 1;
        if (split.v) split_v[j] = 1;
      }
    }
    Halved u = halve(grid.u, split_u);
    Halved v = halve(grid.v, split_v);
    const bool done = u.lines.size() == grid.u.size() && v.lines.size() == grid.v.size();
    if (done) return grid;
    grid = {std::move(u.lines), std::move(v.lines)};
    fresh_u = std::move(u.fresh);
    fresh_v = std::move(v.fresh);
  }
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
