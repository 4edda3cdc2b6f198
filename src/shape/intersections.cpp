#include "tandem/shape/intersections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "shape/edge_contact.h"
#include "shape/flattening.h"
#include "shape/measure_folds.h"
#include "shape/monotone_runs.h"
#include "shape/refine_crossing.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace {

// Two crossings of the same paths this near each other (in epsilons), one of them through a vertex, are one
// that was found from the edges on both sides of the vertex.
constexpr double kSameCrossing = 16.0;

// Halvings of an edge's parameters: 1e-6 of an edge, below what the polyline itself is worth.
constexpr int kParameterHalvings = 20;

void check(const IntersectionOptions& options) {
  const auto refuse = [](const char* name, double value, const char* expected) {
    throw InvalidArgument(fmt::format("crossings: {} is {}, expected {}", name, value, expected));
  };
  if (!(options.tolerance > 0.0 && options.tolerance < 1.0)) {
    refuse("tolerance", options.tolerance, "a share between 0 and 1");
  }
  if (!(options.epsilon > 0.0 && options.epsilon < 1.0)) {
    refuse("epsilon", options.epsilon, "a share between 0 and 1");
  }
  if (!(options.scale >= 0.0 && std::isfinite(options.scale))) {
    refuse("scale", options.scale, "0 or a length");
  }
}

struct Interval2 {
  double lo_x, hi_x, lo_y, hi_y;
};

bool meets(const FlatVertex* edge, const Interval2& box) {
  return std::min(edge[0].x, edge[1].x) <= box.hi_x && std::max(edge[0].x, edge[1].x) >= box.lo_x &&
         std::min(edge[0].y, edge[1].y) <= box.hi_y && std::max(edge[0].y, edge[1].y) >= box.lo_y;
}

}  // namespace

struct CrossingFinder::Workspace {
  IntersectionOptions options;
  std::span<const PathView> paths;
  Flattening flat;
  std::vector<MonotoneRun> runs;
  std::vector<Crossing> found;
  std::vector<Crossing> at_vertices;
  std::vector<std::vector<ScanCrossing>> rows;
  std::size_t limit = 0;

  [[nodiscard]] bool full() const { return found.size() >= limit; }

  void search() {
    found.clear();
    at_vertices.clear();
    gather_runs(flat, runs);
    for (std::size_t a = 0; a < runs.size() && !full(); ++a) {
      for (std::size_t b = a + 1; b < runs.size() && !full(); ++b) {
        if (runs[b].lo_x > runs[a].hi_x + options.epsilon) break;
        if (runs[b].lo_y > runs[a].hi_y + options.epsilon || runs[a].lo_y > runs[b].hi_y + options.epsilon) {
          continue;
        }
        if (runs[a].path == runs[b].path || options.between) try_runs(runs[a], runs[b]);
      }
    }
    add_vertex_crossings();
    for (std::size_t p = 0; p < flat.paths().size(); ++p) {
      const FlatPath& path = flat.paths()[p];
      for (std::size_t i = path.first + 1; i < path.last && !full(); ++i) {
        if (turns_back(flat, path, i, options.epsilon)) found.push_back(crossing(p, p, i, 0.0, i, 0.0));
      }
    }
  }

  void try_runs(const MonotoneRun& a, const MonotoneRun& b) {
    const Interval2 common{
        std::max(a.lo_x, b.lo_x) - options.epsilon, std::min(a.hi_x, b.hi_x) + options.epsilon,
        std::max(a.lo_y, b.lo_y) - options.epsilon, std::min(a.hi_y, b.hi_y) + options.epsilon};
    const FlatVertex* v = flat.vertices().data();
    for (std::size_t i = a.first; i < a.last; ++i) {
      if (!meets(v + i, common)) continue;
      const Interval2 box{
          std::min(v[i].x, v[i + 1].x) - options.epsilon, std::max(v[i].x, v[i + 1].x) + options.epsilon,
          std::min(v[i].y, v[i + 1].y) - options.epsilon, std::max(v[i].y, v[i + 1].y) + options.epsilon};
      for (std::size_t j = b.first; j < b.last; ++j) {
        if (meets(v + j, box) && !(a.path == b.path && are_neighbours(a.path, i, j))) {
          try_edges(a.path, i, b.path, j);
          if (full()) return;
        }
      }
    }
  }

  [[nodiscard]] bool are_neighbours(std::size_t p, std::size_t i, std::size_t j) const {
    const FlatPath& path = flat.paths()[p];
    const std::size_t apart = i < j ? j - i : i - j;
    return apart <= 1 || (path.closed && apart == path.edge_count() - 1);
  }

  void try_edges(std::size_t path_a, std::size_t i, std::size_t path_b, std::size_t j) {
    const FlatVertex* v = flat.vertices().data();
    const EdgeContact contact = find_contact(v + i, v + j, options.epsilon);
    if (contact.kind == EdgeContact::Kind::crossing) {
      found.push_back(crossing(path_a, path_b, i, contact.share_a, j, contact.share_b));
    } else if (contact.kind == EdgeContact::Kind::undecided &&
               passes_through(flat, {flat.paths()[path_a], i, contact.share_a},
                              {flat.paths()[path_b], j, contact.share_b}, options.epsilon)) {
      at_vertices.push_back(crossing(path_a, path_b, i, contact.share_a, j, contact.share_b));
    }
  }

  // Where the path comes by a point of its edge; its speed may be anything along it.
  [[nodiscard]] double parameter_at(std::size_t path, const FlatVertex* edge, double share) const {
    if (share == 0.0 || share == 1.0) return edge[share == 0.0 ? 0 : 1].u;
    const Vec2 along{edge[1].x - edge[0].x, edge[1].y - edge[0].y};
    const double target = share * (along.x * along.x + along.y * along.y);
    double lo = edge[0].u;
    double hi = edge[1].u;
    for (int halving = 0; halving < kParameterHalvings; ++halving) {
      const double middle = 0.5 * (lo + hi);
      const Vec2 p = flat.point(paths[path], middle);
      const double reached = along.x * (p.x - edge[0].x) + along.y * (p.y - edge[0].y);
      (reached < target ? lo : hi) = middle;
    }
    return 0.5 * (lo + hi);
  }

  [[nodiscard]] Crossing crossing(std::size_t path_a, std::size_t path_b, std::size_t i, double share_i,
                                  std::size_t j, double share_j) const {
    const FlatVertex* v = flat.vertices().data();
    Crossing c{
        path_a, path_b, parameter_at(path_a, v + i, share_i), parameter_at(path_b, v + j, share_j), {}};
    // The end of a closed path is its start.
    if (flat.paths()[path_a].closed && share_i == 1.0 && i + 1 == flat.paths()[path_a].last) c.u = 0.0;
    if (flat.paths()[path_b].closed && share_j == 1.0 && j + 1 == flat.paths()[path_b].last) c.v = 0.0;
    if (path_b < path_a || (path_a == path_b && c.v < c.u)) {
      std::swap(c.path_a, c.path_b);
      std::swap(c.u, c.v);
      std::swap(i, j);
      std::swap(share_i, share_j);
    }
    c.point = {v[i].x + share_i * (v[i + 1].x - v[i].x), v[i].y + share_i * (v[i + 1].y - v[i].y)};
    return c;
  }

  // Found from the edges on both sides of the vertex, or beside it as a plain crossing, it is still one.
  void add_vertex_crossings() {
    const double near = kSameCrossing * options.epsilon;
    for (const Crossing& c : at_vertices) {
      const auto same = [&](const Crossing& other) {
        return other.path_a == c.path_a && other.path_b == c.path_b &&
               std::abs(other.point.x - c.point.x) <= near && std::abs(other.point.y - c.point.y) <= near;
      };
      if (!full() && std::none_of(found.begin(), found.end(), same)) found.push_back(c);
    }
  }
};

CrossingFinder::CrossingFinder(const IntersectionOptions& options)
    : workspace_(std::make_unique<Workspace>()) {
  check(options);
  workspace_->options = options;
}
CrossingFinder::~CrossingFinder() = default;
CrossingFinder::CrossingFinder(CrossingFinder&&) noexcept = default;
CrossingFinder& CrossingFinder::operator=(CrossingFinder&&) noexcept = default;

std::span<const Crossing> CrossingFinder::find(std::span<const PathView> paths, std::size_t limit) {
  Workspace& w = *workspace_;
  w.limit = limit;
  w.paths = paths;
  w.flat.assign(paths, w.options.tolerance, w.options.scale);
  w.search();
  for (Crossing& c : w.found) c.point = w.flat.from_flat(c.point);
  return w.found;
}

double CrossingFinder::fold_fraction(std::span<const PathView> paths) {
  Workspace& w = *workspace_;
  w.flat.assign(paths, w.options.tolerance, w.options.scale);
  return measure_folds(w.flat, w.rows);
}

std::vector<Crossing> find_crossings(std::span<const CubicPath> paths, const IntersectionOptions& options) {
  const std::vector<PathView> views = view_paths(paths);
  CrossingFinder finder(options);
  const std::span<const Crossing> found = finder.find(views);
  std::vector<Crossing> crossings(found.begin(), found.end());
  for (Crossing& c : crossings) refine_crossing(c, paths[c.path_a], paths[c.path_b]);
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return std::tie(a.path_a, a.path_b, a.u, a.v) < std::tie(b.path_a, b.path_b, b.u, b.v);
  });
  return crossings;
}

bool is_simple(std::span<const CubicPath> paths, const IntersectionOptions& options) {
  return CrossingFinder(options).is_simple(view_paths(paths));
}

double fold_fraction(std::span<const CubicPath> paths) {
  return CrossingFinder().fold_fraction(view_paths(paths));
}

}  // namespace v0
}  // namespace tandem
