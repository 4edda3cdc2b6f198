#include "surface/contour_links.h"

#include <algorithm>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

/// Rows and columns of places at which it is seen how much of a contour lies in another one.
constexpr int kGrid = 24;
/// Share of the smaller contour that has to lie in the other: a few of the places.
constexpr double kLeastOverlap = 0.02;

/// Share of the smaller contour's area that lies in the other one.
double overlap(const Loop& a, const Loop& b, std::span<const Vec2> places) {
  const bool a_smaller = std::abs(twice_area(a, places)) < std::abs(twice_area(b, places));
  const Loop& smaller = a_smaller ? a : b;
  const Loop& larger = a_smaller ? b : a;
  Vec2 lo = places[smaller.front()];
  Vec2 hi = lo;
  for (const std::uint32_t v : smaller) {
    lo = {std::min(lo.x, places[v].x), std::min(lo.y, places[v].y)};
    hi = {std::max(hi.x, places[v].x), std::max(hi.y, places[v].y)};
  }
  int inside = 0;
  int both = 0;
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const Vec2 p{lo.x + (i + 0.5) / kGrid * (hi.x - lo.x), lo.y + (j + 0.5) / kGrid * (hi.y - lo.y)};
      if (!is_inside(smaller, places, p)) continue;
      ++inside;
      both += is_inside(larger, places, p) ? 1 : 0;
    }
  }
  return inside == 0 ? 0.0 : static_cast<double>(both) / inside;
}

struct Candidate {
  ContourLink link;
  double overlap = 0.0;
};

/// Links, most overlap first, that leave stars: a contour with several partners is the only one of each.
class Stars {
 public:
  Stars(std::size_t below, std::size_t above) : below_(below), above_(above) {}

  void add(std::vector<Candidate> candidates) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.overlap > b.overlap; });
    for (const Candidate& c : candidates) {
      if (!fits(c.link)) continue;
      below_[c.link.below].push_back(c.link.above);
      above_[c.link.above].push_back(c.link.below);
      links_.push_back(c.link);
    }
  }
  [[nodiscard]] const std::vector<ContourLink>& links() const { return links_; }
  [[nodiscard]] bool linked(std::size_t below, std::size_t above) const {
    return std::find(below_[below].begin(), below_[below].end(), above) != below_[below].end();
  }

 private:
  [[nodiscard]] bool fits(const ContourLink& link) const {
    const auto& up = below_[link.below];
    const auto& down = above_[link.above];
    if (!up.empty() && !down.empty()) return false;
    return std::all_of(up.begin(), up.end(), [&](std::size_t a) { return above_[a].size() == 1; }) &&
           std::all_of(down.begin(), down.end(), [&](std::size_t b) { return below_[b].size() == 1; });
  }

  std::vector<std::vector<std::size_t>> below_;
  std::vector<std::vector<std::size_t>> above_;
  std::vector<ContourLink> links_;
};

}  // namespace

std::vector<ContourLink> link_levels(std::span<const Ring> below, std::span<const Ring> above,
                                     std::span<const Vec2> places) {
  Stars stars(below.size(), above.size());
  std::size_t deepest = 0;
  for (const Ring& ring : below) deepest = std::max(deepest, ring.depth);
  // From outside inwards: what lies in contours that are not linked is not linked either.
  for (std::size_t depth = 0; depth <= deepest; ++depth) {
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < below.size(); ++i) {
      for (std::size_t k = 0; k < above.size(); ++k) {
        if (below[i].depth != depth || above[k].depth != depth) continue;
        if (depth > 0 && !stars.linked(below[i].parent, above[k].parent)) continue;
        candidates.push_back({{i, k}, overlap(below[i].loop, above[k].loop, places)});
      }
    }
    const bool only = depth == 0 && candidates.size() == 1;
    if (!only) {
      candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                      [](const Candidate& c) { return c.overlap < kLeastOverlap; }),
                       candidates.end());
    }
    stars.add(std::move(candidates));
  }
  return stars.links();
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
