#include "surface/boundary_crossing.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tandem {
inline namespace v0 {
namespace detail {
namespace {

struct PointAndSpeed {
  PlaneVector p{};
  PlaneVector d{};
};

double cross(const PlaneVector& a, const PlaneVector& b) noexcept {
  return a[0] * b[1] - a[1] * b[0];
}

PlaneVector middle(const PlanePoint& p) noexcept {
  return {p[0].middle(), p[1].middle()};
}

PlaneVector minus(const PlaneVector& a, const PlaneVector& b) noexcept {
  return {a[0] - b[0], a[1] - b[1]};
}

// The point of a piece at its own parameter t, by de Casteljau; a bit outside of [0,1], too.
PointAndSpeed evaluate(const BoundaryArc& piece, double t) {
  const std::size_t stride = piece.edge()->spline.stride();
  std::vector<double> c;
  for (const Enclosure& x : piece.coefficients()) c.push_back(x.middle());
  const std::size_t n = c.size() / stride - 1;
  std::array<double, 3> before{};
  std::array<double, 3> after{};
  for (std::size_t r = n; r > 0; --r) {
    if (r == 1) {
      for (std::size_t k = 0; k < stride; ++k) {
        before[k] = c[k];
        after[k] = c[stride + k];
      }
    }
    for (std::size_t i = 0; i < r * stride; ++i) c[i] = (1.0 - t) * c[i] + t * c[i + stride];
  }
  PointAndSpeed result;
  const double w = stride == 3 ? c[2] : 1.0;
  for (std::size_t k = 0; k < 2; ++k) {
    result.p[k] = c[k] / w;
    result.d[k] = static_cast<double>(n) * (after[k] - before[k]) / w;
    if (stride == 3) result.d[k] -= static_cast<double>(n) * (after[2] - before[2]) / w * result.p[k];
  }
  return result;
}

// Newton's iteration for a(s) = b(t); false if it runs away or does not settle.
bool meet(const BoundaryArc& a, const BoundaryArc& b, double& s, double& t) {
  constexpr int kSteps = 12;         // doubling the digits each, from a fraction of the piece
  constexpr double kSettled = 1e-8;  // of the piece: the next step leaves what rounding leaves
  s = t = 0.5;
  double last = 1.0;
  for (int step = 0; step < kSteps; ++step) {
    const PointAndSpeed x = evaluate(a, s);
    const PointAndSpeed y = evaluate(b, t);
    const double det = cross(x.d, y.d);
    const PlaneVector gap = minus(y.p, x.p);
    const double ds = cross(gap, y.d) / det;
    const double dt = cross(gap, x.d) / det;
    last = std::max(std::abs(ds), std::abs(dt));
    if (!(last < 4.0)) return false;
    s += ds;
    t += dt;
  }
  return last < kSettled && s > -0.5 && s < 1.5 && t > -0.5 && t < 1.5;
}

double parameter(const BoundaryArc& piece, double t) {
  return piece.edge()->spline.domain().clamp(piece.from() + t * (piece.to() - piece.from()));
}

Interval around(const BoundaryArc& piece, double at, double share) {
  const Interval domain = piece.edge()->spline.domain();
  const double reach = share * std::abs(piece.to() - piece.from());
  return {domain.clamp(at - reach), domain.clamp(at + reach)};
}

// X passes from before all of Y to behind it.
bool passes(const std::vector<PlanePoint>& x, const std::vector<PlanePoint>& y, const PlaneVector& n) {
  const auto height = [&](const PlanePoint& p) { return Enclosure(n[0]) * p[0] + Enclosure(n[1]) * p[1]; };
  Enclosure all = height(y.front());
  for (const PlanePoint& p : y) all = hull(all, height(p));
  const Enclosure from = height(x.front());
  const Enclosure to = height(x.back());
  return (from.hi < all.lo && all.hi < to.lo) || (to.hi < all.lo && all.hi < from.lo);
}

bool do_cross(const std::vector<PlanePoint>& x, const std::vector<PlanePoint>& y) {
  const PlaneVector of_x = minus(middle(x.back()), middle(x.front()));
  const PlaneVector of_y = minus(middle(y.back()), middle(y.front()));
  return passes(x, y, {-of_y[1], of_y[0]}) && passes(y, x, {-of_x[1], of_x[0]});
}

// All control points within a fifth of the chord's length of it.
bool is_about_straight(const BoundaryArc& piece) {
  const PlaneVector first = middle(piece.polygon().front());
  const PlaneVector whole = minus(middle(piece.polygon().back()), first);
  const double square = whole[0] * whole[0] + whole[1] * whole[1];
  return std::all_of(piece.polygon().begin(), piece.polygon().end(), [&](const PlanePoint& p) {
    return std::abs(cross(whole, minus(middle(p), first))) <= 0.2 * square;
  });
}

}  // namespace

bool seem_to_cross(const BoundaryArc& a, const BoundaryArc& b) {
  if (!is_about_straight(a) || !is_about_straight(b)) return false;
  const auto sides = [](const BoundaryArc& x, const BoundaryArc& y) {
    const PlaneVector first = middle(x.polygon().front());
    const PlaneVector whole = minus(middle(x.polygon().back()), first);
    return cross(whole, minus(middle(y.polygon().front()), first)) *
           cross(whole, minus(middle(y.polygon().back()), first));
  };
  return sides(a, b) <= 0.0 && sides(b, a) <= 0.0;
}

std::optional<std::array<BoundaryPlace, 2>> prove_crossing(const BoundaryArc& a, const BoundaryArc& b) {
  double s = 0.0;
  double t = 0.0;
  if (!meet(a, b, s, t)) return std::nullopt;
  const BoundaryPlace at_a{a.edge(), parameter(a, s)};
  const BoundaryPlace at_b{b.edge(), parameter(b, t)};
  // Long arcs are seen through rounding errors, short ones are straight.
  for (double share = 0.25; share > 1e-6; share *= 0.25) {
    const Interval of_a = around(a, at_a.t, share);
    const Interval of_b = around(b, at_b.t, share);
    if (!(of_a.length() > 0.0 && of_b.length() > 0.0)) return std::nullopt;
    const bool overlap = a.edge() == b.edge() && of_a.lo <= of_b.hi && of_b.lo <= of_a.hi;
    if (overlap) continue;
    if (do_cross(a.edge()->polygon(of_a), b.edge()->polygon(of_b))) return std::array{at_a, at_b};
  }
  return std::nullopt;
}

}  // namespace detail
}  // namespace v0
}  // namespace tandem
