#include "tandem/curve/compatible.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "curve/common_knots.h"
#include "curve/spline.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

// Knots of different curves closer than this share of the domain are meant to be one.
constexpr double kSameKnot = 1e-10;

struct Place {
  double value = 0.0;
  std::size_t spline = 0;
};

// Interior knots of all splines, ascending, each distinct one once per spline.
std::vector<Place> interior_places(std::span<const Spline> splines) {
  std::vector<Place> places;
  for (std::size_t s = 0; s < splines.size(); ++s) {
    const Interval domain = splines[s].domain();
    for (const double knot : splines[s].knots) {
      const bool again = !places.empty() && places.back().spline == s && places.back().value == knot;
      if (domain.lo < knot && knot < domain.hi && !again) places.push_back({knot, s});
    }
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.value < b.value; });
  return places;
}

// Every knot at `from` goes to `to`, unless another knot of the same spline stands there or on the way: the
// two together could exceed the multiplicity that the degree allows.
void move_knot(std::vector<double>& knots, double from, double to) {
  const auto [first, last] = std::equal_range(knots.begin(), knots.end(), from);
  const bool blocked =
      to > from ? last != knots.end() && *last <= to : first != knots.begin() && *(first - 1) >= to;
  if (!blocked || to == from) std::fill(first, last, to);
}

}  // namespace

void snap_knots(std::span<Spline> splines) {
  const Interval domain = splines.front().domain();
  const std::vector<Place> places = interior_places(splines);
  for (std::size_t begin = 0; begin < places.size();) {
    // A cluster holds at most one knot of each spline: a spline's own near knots stay apart.
    std::size_t end = begin + 1;
    std::size_t leader = begin;
    while (end < places.size() && places[end].value - places[begin].value <= kSameKnot * domain.length()) {
      const bool taken = std::any_of(places.begin() + static_cast<std::ptrdiff_t>(begin),
                                     places.begin() + static_cast<std::ptrdiff_t>(end),
                                     [&](const Place& place) { return place.spline == places[end].spline; });
      if (taken) break;
      if (places[end].spline < places[leader].spline) leader = end;
      ++end;
    }
    const double value = places[leader].value;
    for (std::size_t i = begin; i < end; ++i)
      move_knot(splines[places[i].spline].knots, places[i].value, value);
    begin = end;
  }
}

std::vector<double> united_knots(std::span<const Spline> splines) {
  std::vector<double> united = splines.front().knots;
  std::vector<double> both;
  for (std::size_t s = 1; s < splines.size(); ++s) {
    const std::vector<double>& knots = splines[s].knots;
    both.clear();
    std::set_union(united.begin(), united.end(), knots.begin(), knots.end(), std::back_inserter(both));
    united.swap(both);
  }
  return united;
}

std::vector<Spline> over_one_domain(std::span<const Curve> curves, bool any_rational) {
  if (curves.empty()) throw InvalidArgument("no curves given, expected at least one");
  std::vector<Spline> splines;
  for (const Curve& curve : curves) {
    if (curve.dim() != curves.front().dim()) {
      throw InvalidArgument(fmt::format("curves of dimension {} and {} cannot share a function space",
                                        curves.front().dim(), curve.dim()));
    }
    const Curve moved = with_domain(clamp(curve), curves.front().domain());
    splines.push_back(premultiplied(moved, any_rational || curve.is_rational()));
  }
  return splines;
}

}  // namespace detail

std::vector<Curve> make_compatible(std::span<const Curve> curves) {
  const bool rational =
      std::any_of(curves.begin(), curves.end(), [](const Curve& c) { return c.is_rational(); });
  std::vector<detail::Spline> splines = detail::over_one_domain(curves, rational);
  int degree = 1;
  for (const detail::Spline& spline : splines) degree = std::max(degree, spline.degree);
  for (detail::Spline& spline : splines) {
    const int times = degree - spline.degree;
    spline = detail::elevated(std::move(spline), times);
  }
  detail::snap_knots(splines);
  const std::vector<double> knots = detail::united_knots(splines);
  std::vector<Curve> result;
  result.reserve(splines.size());
  for (detail::Spline& spline : splines) {
    result.push_back(
        detail::euclidean(spline.knots == knots ? std::move(spline) : detail::over_knots(spline, knots)));
  }
  return result;
}

}  // namespace v0
}  // namespace tandem
