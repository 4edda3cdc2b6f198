#include "tandem/shape/intersections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
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

// Paths of which it is remembered who crosses whom.
constexpr std::size_t kMostRemembered = 48;

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
  /// A path's runs, and the box of them all.
  struct Runs {
    std::vector<MonotoneRun> runs;
    Interval2 box{};
    bool known = false;
  };
  /// What two paths do to each other, or one to itself.
  struct Meeting {
    std::size_t limit = 0;  ///< up to which crossings were looked for; 0: not yet
    std::vector<Crossing> found;

    void forget() {
      limit = 0;
      found.clear();
    }
  };

  IntersectionOptions options;
  std::span<const PathView> paths;
  Flattening flat;
  std::vector<Runs> runs;
  std::vector<std::size_t> order;  ///< of the paths, from left to right
  std::vector<Meeting> meetings;   ///< by the smaller and the larger path; of few paths
  Meeting unremembered;
  std::vector<Crossing> found;
  std::vector<Crossing> at_vertices;
  Meeting* meeting = nullptr;  ///< the one that is looked at
  Flattening flat_of_some;     ///< for fold_fraction() of other paths
  ScanRows rows;

  [[nodiscard]] bool full() const { return meeting->found.size() >= meeting->limit; }

  void search(std::size_t limit) {
    found.clear();
    const std::size_t count = flat.paths().size();
    const bool remembers = !meetings.empty();
    gather();
    for (std::size_t k = 0; k < count && found.size() < limit; ++k) {
      const Interval2& left = runs[order[k]].box;
      for (std::size_t l = k; l < count && found.size() < limit; ++l) {
        const Interval2& right = runs[order[l]].box;
        if (right.lo_x > left.hi_x + options.epsilon) break;
        if (right.lo_y > left.hi_y + options.epsilon || left.lo_y > right.hi_y + options.epsilon) continue;
        if (k != l && !options.between) continue;
        const auto [a, b] = std::minmax(order[k], order[l]);
        meeting = remembers ? &meetings[a * count + b] : &unremembered;
        // What was looked for up to more is known, and so is what there was less of.
        const bool known = remembers && (limit <= meeting->limit || meeting->found.size() < meeting->limit);
        if (!known) meet(a, b, limit);
        const std::size_t wanted = std::min(limit - found.size(), meeting->found.size());
        found.insert(found.end(), meeting->found.begin(),
                     meeting->found.begin() + static_cast<std::ptrdiff_t>(wanted));
      }
    }
  }

  // Flattens the paths and forgets what was known of others.
  void take(std::span<const PathView> given) {
    paths = given;
    flat.assign(paths, options.tolerance, options.scale);
    const std::size_t count = paths.size();
    const std::size_t remembered = count <= kMostRemembered ? count * count : 0;
    if (meetings.size() != remembered) meetings.assign(remembered, {});
    runs.resize(count);
    for (std::size_t p = 0; p < count; ++p) {
      if (!flat.has_changed(p)) continue;
      runs[p].known = false;
      for (std::size_t q = 0; q < count && remembered > 0; ++q) {
        meetings[std::min(p, q) * count + std::max(p, q)].forget();
      }
    }
  }

  void gather() {
    const std::size_t count = flat.paths().size();
    for (std::size_t p = 0; p < count; ++p) {
      if (runs[p].known) continue;
      runs[p].known = true;
      const FlatPath& path = flat.paths()[p];
      const std::span<const FlatVertex> vertices(vertices_of(p), path.edge_count() + 1);
      gather_runs(vertices, runs[p].runs);
      Interval2& box = runs[p].box;
      box = {vertices[0].x, vertices[0].x, vertices[0].y, vertices[0].y};
      for (const MonotoneRun& run : runs[p].runs) {
        box = {std::min(box.lo_x, run.lo_x), std::max(box.hi_x, run.hi_x), std::min(box.lo_y, run.lo_y),
               std::max(box.hi_y, run.hi_y)};
      }
    }
    order.resize(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
      return std::tie(runs[x].box.lo_x, x) < std::tie(runs[y].box.lo_x, y);
    });
  }

  [[nodiscard]] const FlatVertex* vertices_of(std::size_t path) const {
    return flat.vertices().data() + flat.paths()[path].first;
  }

  // Looks for the crossings of two paths, or of one with itself.
  void meet(std::size_t a, std::size_t b, std::size_t limit) {
    meeting->limit = limit;
    meeting->found.clear();
    at_vertices.clear();
    if (a == b) {
      sweep_one(a);
    } else {
      sweep_two(a, b);
    }
    add_vertex_crossings();
    if (a == b) add_turns(a);
  }

  void sweep_one(std::size_t p) {
    const std::vector<MonotoneRun>& own = runs[p].runs;
    for (std::size_t i = 0; i < own.size(); ++i) {
      for (std::size_t j = i + 1; j < own.size() && !full(); ++j) {
        if (own[j].lo_x > own[i].hi_x + options.epsilon) break;
        if (overlap_in_y(own[i], own[j])) try_runs(p, own[i], p, own[j]);
      }
    }
  }

  void sweep_two(std::size_t a, std::size_t b) {
    const Interval2& box = runs[b].box;
    for (const MonotoneRun& x : runs[a].runs) {
      if (x.lo_x > box.hi_x + options.epsilon) break;
      if (box.lo_x > x.hi_x + options.epsilon || box.lo_y > x.hi_y + options.epsilon ||
          x.lo_y > box.hi_y + options.epsilon) {
        continue;
      }
      for (const MonotoneRun& y : runs[b].runs) {
        if (full()) return;
        if (y.lo_x > x.hi_x + options.epsilon) break;
        if (x.lo_x > y.hi_x + options.epsilon || !overlap_in_y(x, y)) continue;
        if (x.lo_x <= y.lo_x) {
          try_runs(a, x, b, y);
        } else {
          try_runs(b, y, a, x);
        }
      }
    }
  }

  [[nodiscard]] bool overlap_in_y(const MonotoneRun& a, const MonotoneRun& b) const {
    return b.lo_y <= a.hi_y + options.epsilon && a.lo_y <= b.hi_y + options.epsilon;
  }

  void add_turns(std::size_t p) {
    const FlatPath& path = flat.paths()[p];
    for (std::size_t i = 1; i < path.edge_count() && !full(); ++i) {
      if (turns_back(flat, path, path.first + i, options.epsilon)) {
        meeting->found.push_back(crossing(p, p, i, 0.0, i, 0.0));
      }
    }
  }

  void try_runs(std::size_t path_a, const MonotoneRun& a, std::size_t path_b, const MonotoneRun& b) {
    const Interval2 common{
        std::max(a.lo_x, b.lo_x) - options.epsilon, std::min(a.hi_x, b.hi_x) + options.epsilon,
        std::max(a.lo_y, b.lo_y) - options.epsilon, std::min(a.hi_y, b.hi_y) + options.epsilon};
    const FlatVertex* v = vertices_of(path_a);
    const FlatVertex* w = vertices_of(path_b);
    for (std::size_t i = a.first; i < a.last; ++i) {
      if (!meets(v + i, common)) continue;
      const Interval2 box{
          std::min(v[i].x, v[i + 1].x) - options.epsilon, std::max(v[i].x, v[i + 1].x) + options.epsilon,
          std::min(v[i].y, v[i + 1].y) - options.epsilon, std::max(v[i].y, v[i + 1].y) + options.epsilon};
      for (std::size_t j = b.first; j < b.last; ++j) {
        if (meets(w + j, box) && !(path_a == path_b && are_neighbours(path_a, i, j))) {
          try_edges(path_a, i, path_b, j);
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
    const EdgeContact contact =
        find_contact(vertices_of(path_a) + i, vertices_of(path_b) + j, options.epsilon);
    const FlatPath& a = flat.paths()[path_a];
    const FlatPath& b = flat.paths()[path_b];
    if (contact.kind == EdgeContact::Kind::crossing) {
      meeting->found.push_back(crossing(path_a, path_b, i, contact.share_a, j, contact.share_b));
    } else if (contact.kind == EdgeContact::Kind::undecided &&
               passes_through(flat, {a, a.first + i, contact.share_a}, {b, b.first + j, contact.share_b},
                              options.epsilon)) {
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
    Crossing c{path_a,
               path_b,
               parameter_at(path_a, vertices_of(path_a) + i, share_i),
               parameter_at(path_b, vertices_of(path_b) + j, share_j),
               {}};
    const FlatPath& a = flat.paths()[path_a];
    const FlatPath& b = flat.paths()[path_b];
    // The end of a closed path is its start.
    if (a.closed && share_i == 1.0 && i + 1 == a.edge_count()) c.u = 0.0;
    if (b.closed && share_j == 1.0 && j + 1 == b.edge_count()) c.v = 0.0;
    if (path_b < path_a || (path_a == path_b && c.v < c.u)) {
      std::swap(c.path_a, c.path_b);
      std::swap(c.u, c.v);
      std::swap(i, j);
      std::swap(share_i, share_j);
    }
    const FlatVertex* v = vertices_of(c.path_a) + i;
    c.point = {v[0].x + share_i * (v[1].x - v[0].x), v[0].y + share_i * (v[1].y - v[0].y)};
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
      std::vector<Crossing>& known = meeting->found;
      if (!full() && std::none_of(known.begin(), known.end(), same)) known.push_back(c);
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
  w.take(paths);
  w.search(limit);
  for (Crossing& c : w.found) c.point = w.flat.from_flat(c.point);
  return w.found;
}

double CrossingFinder::fold_fraction(std::span<const PathView> paths) {
  Workspace& w = *workspace_;
  // What find() has looked at stays known.
  if (paths.size() == w.flat.paths().size()) {
    w.take(paths);
    return measure_folds(w.flat, w.rows);
  }
  w.flat_of_some.assign(paths, w.options.tolerance, w.options.scale);
  return measure_folds(w.flat_of_some, w.rows);
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
