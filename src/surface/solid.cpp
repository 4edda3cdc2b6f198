#include "tandem/surface/solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "surface/contour_band.h"
#include "surface/contour_links.h"
#include "surface/contour_rings.h"
#include "surface/cut_ring.h"
#include "surface/triangulate_region.h"
#include "tandem/error.h"
#include "tandem/surface/simple_mesh.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::ContourLink;
using detail::ContourStack;
using detail::CutRing;
using detail::Loop;
using detail::Ring;

/// What a ring is linked with on one side, and the loop for each partner: the ring itself, or its pieces.
struct Side {
  std::vector<std::size_t> partners;
  CutRing cut;
};

enum Facing { down, up };

class Assembly {
 public:
  Assembly(ContourStack stack, const SolidOptions& options) : stack_(std::move(stack)), options_(options) {
    for (const auto& level : stack_.levels) sides_.emplace_back(level.size());
  }

  Solid run() && {
    for (std::size_t l = 0; l + 1 < stack_.levels.size(); ++l) link(l);
    for (std::size_t l = 0; l < stack_.levels.size(); ++l) {
      for (std::size_t r = 0; r < stack_.levels[l].size(); ++r) {
        for (const Facing facing : {down, up}) cut(l, r, facing);
      }
    }
    count_left_out();
    for (std::size_t l = 0; l < stack_.levels.size(); ++l) {
      if (l + 1 < stack_.levels.size()) add_bands(l);
      for (const Facing facing : {down, up}) add_caps(l, facing);
    }
    if (solid_.mesh.triangles.empty()) {
      throw InvalidArgument("no contour overlaps one of the next level, seen along the levels' normal");
    }
    fill_vertices();
    solid_.report.volume = volume(solid_.mesh);
    const SimpleMesh simple = find_simple(solid_.mesh);
    solid_.report.simple = simple.verdict;
    solid_.report.crossing = simple.triangles;
    return std::move(solid_);
  }

 private:
  [[nodiscard]] Side& side(std::size_t level, std::size_t ring, Facing facing) {
    return sides_[level][ring][facing];
  }

  void link(std::size_t l) {
    for (const ContourLink& link :
         detail::link_levels(stack_.levels[l], stack_.levels[l + 1], stack_.vertices.places)) {
      side(l, link.below, up).partners.push_back(link.above);
      side(l + 1, link.above, down).partners.push_back(link.below);
    }
  }

  void cut(std::size_t l, std::size_t r, Facing facing) {
    Side& own = side(l, r, facing);
    if (own.partners.size() < 2) return;
    const std::size_t other = facing == up ? l + 1 : l - 1;
    std::vector<Loop> loops;
    for (const std::size_t p : own.partners) loops.push_back(stack_.levels[other][p].loop);
    own.cut = detail::cut_ring(stack_.levels[l], r, loops, stack_.vertices, options_.longest_edge);
    if (!own.cut.pieces.empty()) {
      ++solid_.report.branches;
      return;
    }
    // No chord fits: the first partner, which overlaps most, keeps the whole ring; the others end.
    for (std::size_t k = 1; k < own.partners.size(); ++k) {
      side(other, own.partners[k], facing == up ? down : up).partners.clear();
    }
    own.partners.resize(1);
  }

  void count_left_out() {
    for (const auto& level : sides_) {
      for (const auto& [below, above] : level) {
        if (below.partners.empty() && above.partners.empty()) ++solid_.report.left_out;
      }
    }
  }

  /// The loop of a ring towards its partner `k` on one side.
  [[nodiscard]] Loop loop_towards(std::size_t l, std::size_t r, Facing facing, std::size_t k) {
    const Side& own = side(l, r, facing);
    const Loop& ring = stack_.levels[l][r].loop;
    if (own.cut.pieces.empty()) return ring;
    std::vector<std::uint32_t> candidates = ring;
    candidates.insert(candidates.end(), own.cut.on_chords.begin(), own.cut.on_chords.end());
    return detail::with_vertices_on_edges(own.cut.pieces[k], candidates, stack_.vertices.places);
  }

  void add_bands(std::size_t l) {
    for (std::size_t r = 0; r < stack_.levels[l].size(); ++r) {
      const std::vector<std::size_t>& partners = side(l, r, up).partners;
      for (std::size_t k = 0; k < partners.size(); ++k) {
        const std::vector<std::size_t>& back = side(l + 1, partners[k], down).partners;
        const auto own = static_cast<std::size_t>(std::find(back.begin(), back.end(), r) - back.begin());
        const detail::ContourBand band =
            detail::make_band(loop_towards(l, r, up, k), loop_towards(l + 1, partners[k], down, own),
                              stack_.vertices.places, options_.match);
        add(band.triangles);
        solid_.report.valid_share = std::min(solid_.report.valid_share, band.valid_share);
        ++solid_.report.bands;
      }
    }
  }

  /// Flat regions between the rings that end on one side of a level.
  void add_caps(std::size_t l, Facing facing) {
    const std::vector<Ring>& rings = stack_.levels[l];
    const auto ends = [&](std::size_t r) {
      return side(l, r, facing).partners.empty() && !side(l, r, facing == up ? down : up).partners.empty();
    };
    std::vector<std::size_t> ending;
    for (std::size_t r = 0; r < rings.size(); ++r) {
      if (ends(r)) ending.push_back(r);
    }
    // The innermost ending ring around another one, and whether a region begins at it or ends there.
    const auto around = [&](std::size_t r) {
      std::size_t at = r;
      while (rings[at].depth > 0) {
        at = rings[at].parent;
        if (ends(at)) return at;
      }
      return r;
    };
    const auto depth = [&](std::size_t r) {
      std::size_t count = 0;
      for (std::size_t at = r; around(at) != at; at = around(at)) ++count;
      return count;
    };
    for (const std::size_t r : ending) {
      if (depth(r) % 2 != 0) continue;
      std::vector<Loop> holes;
      for (const std::size_t h : ending) {
        if (h != r && around(h) == r) holes.push_back(rings[h].loop);
      }
      auto triangles = detail::triangulate_region(rings[r].loop, std::move(holes), stack_.vertices.places);
      if (facing == down) {
        for (auto& t : triangles) std::swap(t[1], t[2]);
      }
      add(triangles);
      ++solid_.report.caps;
    }
  }

  void add(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    solid_.mesh.triangles.insert(solid_.mesh.triangles.end(), triangles.begin(), triangles.end());
  }

  /// The vertices that triangles use.
  void fill_vertices() {
    constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(stack_.vertices.places.size(), kUnused);
    solid_.mesh.vertices = Points(3, 0);
    for (auto& triangle : solid_.mesh.triangles) {
      for (std::uint32_t& v : triangle) {
        if (number[v] == kUnused) {
          number[v] = static_cast<std::uint32_t>(solid_.mesh.vertices.size());
          solid_.mesh.vertices.push_back(stack_.position(v));
        }
        v = number[v];
      }
    }
  }

  ContourStack stack_;
  const SolidOptions& options_;
  std::vector<std::vector<std::array<Side, 2>>> sides_;  // [level][ring][facing]
  Solid solid_;
};

void check(const SolidOptions& options) {
  if (!(options.chord > 0.0 && options.chord < 1.0)) {
    throw InvalidArgument(fmt::format("the chord tolerance is {}, expected between 0 and 1", options.chord));
  }
  if (!(options.longest_edge > 0.0 && options.longest_edge <= 1.0 / 3.0)) {
    throw InvalidArgument(fmt::format("the longest edge is {} of a contour, expected above 0, at most 1/3",
                                      options.longest_edge));
  }
}

}  // namespace

Solid contours_to_solid(std::span<const std::vector<Curve>> levels, const SolidOptions& options) {
  check(options);
  return Assembly(detail::make_stack(levels, options.chord, options.longest_edge), options).run();
}

}  // namespace v0
}  // namespace tandem
