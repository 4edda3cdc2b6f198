#include "surface/boundary_arc.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "surface/bernstein_enclosure.h"

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

double cross(const PlaneVector& a, const PlaneVector& b) noexcept {
  return a[0] * b[1] - a[1] * b[0];
}
double dot(const PlaneVector& a, const PlaneVector& b) noexcept {
  return a[0] * b[0] + a[1] * b[1];
}

Enclosure along(const PlaneVector& n, const PlanePoint& p) noexcept {
  return Enclosure(n[0]) * p[0] + Enclosure(n[1]) * p[1];
}

PlaneVector chord(const std::vector<PlanePoint>& polygon) noexcept {
  return {polygon.back()[0].middle() - polygon.front()[0].middle(),
          polygon.back()[1].middle() - polygon.front()[1].middle()};
}

Enclosure extent(const std::vector<PlanePoint>& polygon, const PlaneVector& n) noexcept {
  Enclosure range = along(n, polygon.front());
  for (std::size_t i = 1; i < polygon.size(); ++i) range = hull(range, along(n, polygon[i]));
  return range;
}

bool are_apart(const Enclosure& a, const Enclosure& b) noexcept {
  return a.hi < b.lo || b.hi < a.lo;
}

std::unique_ptr<BoundaryArc> joined(std::vector<std::unique_ptr<BoundaryArc>>& pieces, std::size_t first,
                                    std::size_t last) {
  if (last - first == 1) return std::move(pieces[first]);
  const std::size_t middle = (first + last) / 2;
  return std::make_unique<BoundaryArc>(joined(pieces, first, middle), joined(pieces, middle, last));
}

}  // namespace

void DirectionRange::add(const PlaneVector& d) noexcept {
  if (!narrow_ || (d[0] == 0.0 && d[1] == 0.0)) return;
  if (empty_) {
    empty_ = false;
    right_ = left_ = d;
    return;
  }
  const double from_right = cross(right_, d);
  const double to_left = cross(d, left_);
  if (from_right >= 0.0 && to_left >= 0.0) {
    narrow_ = dot(right_, d) > 0.0 || dot(left_, d) > 0.0 || from_right > 0.0;
  } else if (from_right >= 0.0) {
    left_ = d;
  } else if (to_left >= 0.0) {
    right_ = d;
  } else {
    narrow_ = false;
  }
}

void DirectionRange::add(const DirectionRange& other) noexcept {
  narrow_ = narrow_ && other.narrow_;
  if (other.empty_) return;
  add(other.right_);
  add(other.left_);
}

PlaneVector DirectionRange::middle() const noexcept {
  if (empty_ || !narrow_) return {};
  const double r = std::sqrt(dot(right_, right_));
  const double l = std::sqrt(dot(left_, left_));
  if (!(r > 0.0 && l > 0.0)) return {};
  return {right_[0] / r + left_[0] / l, right_[1] / r + left_[1] / l};
}

BoundaryArc::BoundaryArc(const BoundaryEdge& edge, double from, double to, Enclosures coefficients)
    : edge_(&edge), from_(from), to_(to), coefficients_(std::move(coefficients)) {
  polygon_ = plane_points(coefficients_, edge.rational);
  box_ = polygon_.front();
  for (std::size_t i = 1; i < polygon_.size(); ++i) {
    for (std::size_t c = 0; c < 2; ++c) box_[c] = hull(box_[c], polygon_[i][c]);
    directions_.add(PlaneVector{polygon_[i][0].middle() - polygon_[i - 1][0].middle(),
                                polygon_[i][1].middle() - polygon_[i - 1][1].middle()});
  }
}

BoundaryArc::BoundaryArc(std::unique_ptr<BoundaryArc> first, std::unique_ptr<BoundaryArc> second)
    : directions_(first->directions_), halves_{std::move(first), std::move(second)} {
  for (std::size_t c = 0; c < 2; ++c) box_[c] = hull(halves_[0]->box_[c], halves_[1]->box_[c]);
  directions_.add(halves_[1]->directions_);
}

std::unique_ptr<BoundaryArc> BoundaryArc::of_loop(const BoundaryLoop& loop) {
  std::vector<std::unique_ptr<BoundaryArc>> pieces;
  for (const BoundaryEdge& edge : loop) {
    const std::vector<double> breaks = edge.spline.breaks();
    const std::size_t stride = edge.spline.stride();
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
      const std::size_t i = edge.reversed ? breaks.size() - 2 - k : k;
      Enclosures coefficients = edge.coefficients({breaks[i], breaks[i + 1]});
      if (!edge.reversed) {
        pieces.push_back(
            std::make_unique<BoundaryArc>(edge, breaks[i], breaks[i + 1], std::move(coefficients)));
        continue;
      }
      Enclosures backwards;
      for (std::size_t at = coefficients.size(); at > 0; at -= stride)
        backwards.insert(backwards.end(), coefficients.begin() + static_cast<std::ptrdiff_t>(at - stride),
                         coefficients.begin() + static_cast<std::ptrdiff_t>(at));
      pieces.push_back(std::make_unique<BoundaryArc>(edge, breaks[i + 1], breaks[i], std::move(backwards)));
    }
  }
  return joined(pieces, 0, pieces.size());
}

double BoundaryArc::size() const noexcept {
  return (box_[0].hi - box_[0].lo) + (box_[1].hi - box_[1].lo);
}

bool BoundaryArc::can_split() const noexcept {
  if (!is_piece() || halves_[0]) return true;
  const double middle = 0.5 * from_ + 0.5 * to_;
  return middle != from_ && middle != to_;
}

std::array<BoundaryArc*, 2> BoundaryArc::halves() {
  if (!halves_[0]) {
    const std::size_t stride = edge_->spline.stride();
    std::array<Enclosures, 2> parts = {Enclosures(coefficients_.size()), Enclosures(coefficients_.size())};
    for (std::size_t c = 0; c < stride; ++c) {
      const auto [left, right] = detail::halves(component(coefficients_, stride, c));
      for (std::size_t i = 0; i < left.size(); ++i) {
        parts[0][i * stride + c] = left[i];
        parts[1][i * stride + c] = right[i];
      }
    }
    const double middle = 0.5 * from_ + 0.5 * to_;
    halves_[0] = std::make_unique<BoundaryArc>(*edge_, from_, middle, std::move(parts[0]));
    halves_[1] = std::make_unique<BoundaryArc>(*edge_, middle, to_, std::move(parts[1]));
  }
  return {halves_[0].get(), halves_[1].get()};
}

bool BoundaryArc::runs_along(const PlaneVector& n) const {
  if (!is_piece()) return halves_[0]->runs_along(n) && halves_[1]->runs_along(n);
  bool moves = false;
  for (std::size_t i = 1; i < polygon_.size(); ++i) {
    const Enclosure step =
        along(n, PlanePoint{polygon_[i][0] - polygon_[i - 1][0], polygon_[i][1] - polygon_[i - 1][1]});
    if (!(step.lo >= 0.0)) return false;
    moves = moves || step.is_positive();
  }
  return moves;
}

bool BoundaryArc::is_apart_from(const BoundaryArc& other) const {
  if (are_apart(box_[0], other.box_[0]) || are_apart(box_[1], other.box_[1])) return true;
  if (!is_piece() || !other.is_piece()) return false;
  for (const PlaneVector& d : {chord(polygon_), chord(other.polygon_)}) {
    for (const PlaneVector& n : {PlaneVector{-d[1], d[0]}, d}) {
      if (are_apart(extent(polygon_, n), extent(other.polygon_, n))) return true;
    }
  }
  return false;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
