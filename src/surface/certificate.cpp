#include "tandem/surface/certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "surface/findings.h"
#include "surface/planar.h"
#include "surface/planar_patches.h"
#include "surface/planar_ruled.h"
#include "surface/regular_in_space.h"
#include "tandem/error.h"
#include "tandem/surface/edit.h"
#include "tandem/surface/simple_mesh.h"

namespace tandem {
inline namespace v0 {
namespace {

using detail::Findings;
using detail::Parameters;
using detail::PlaneAxes;

void check_dimension(int dim) {
  if (dim != 2 && dim != 3)
    throw InvalidArgument(fmt::format("certificates are for surfaces in R^2 and R^3, not in R^{}", dim));
}

Verdict overall(const Certificate& certificate) {
  std::vector<Verdict> parts = {certificate.regular};
  if (certificate.one_to_one) parts.push_back(*certificate.one_to_one);
  if (certificate.tessellation_simple) parts.push_back(*certificate.tessellation_simple);
  const auto is = [](Verdict v) { return [v](Verdict part) { return part == v; }; };
  if (std::any_of(parts.begin(), parts.end(), is(Verdict::violated))) return Verdict::violated;
  return std::all_of(parts.begin(), parts.end(), is(Verdict::certified)) ? Verdict::certified
                                                                         : Verdict::undecided;
}

/// The surface as a whole, or the one between two curves: points and derivatives by (u, v).
template <class Derivatives>
SurfacePlace place(const Parameters& at, int sign, const Derivatives& derivatives,
                   const std::optional<PlaneAxes>& plane) {
  const Points rows = derivatives(at[0], at[1]);
  SurfacePlace result{at[0], at[1], Point(rows[0].begin(), rows[0].end()), 0.0};
  if (sign == 0 || !plane) return result;
  const auto [x, y] = *plane;
  const double value = rows[1][x] * rows[2][y] - rows[1][y] * rows[2][x];
  // The sign was proved; the value may be too large for a double, or too small.
  const double size = std::isnan(value) ? std::numeric_limits<double>::max() : sign * value;
  result.jacobian =
      sign * std::clamp(size, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max());
  return result;
}

template <class Derivatives>
Certificate certificate(const Findings& findings, const Derivatives& derivatives,
                        const std::optional<PlaneAxes>& plane) {
  Certificate result;
  result.regular = findings.regular;
  result.one_to_one = findings.one_to_one;
  if (findings.witness) {
    Witness witness{*findings.witness, {}, {}};
    const std::size_t count = witness.kind == WitnessKind::zero ? 1 : 2;
    for (std::size_t i = 0; i < count; ++i)
      witness.places.push_back(place(findings.places[i], findings.signs[i], derivatives, plane));
    result.witness = std::move(witness);
  }
  result.verdict = overall(result);
  return result;
}

Curve in_plane(const Curve& curve, const PlaneAxes& axes) {
  return Curve(curve.degree(), curve.knots(), detail::in_plane(curve.control_points(), axes),
               curve.weights());
}

Surface in_plane(const Surface& surface, const PlaneAxes& axes) {
  return Surface({surface.degree(Along::u), surface.degree(Along::v)},
                 {surface.knots(Along::u), surface.knots(Along::v)},
                 detail::in_plane(surface.control_points(), axes), surface.weights());
}

// Row j of the control points, as a curve along u.
Curve row(const Surface& surface, std::size_t j) {
  Points points(surface.dim(), surface.size(Along::u));
  std::vector<double> weights;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto from = surface.control_point(i, j);
    std::copy(from.begin(), from.end(), points[i].begin());
    if (surface.is_rational()) weights.push_back(surface.weights()[i * surface.size(Along::v) + j]);
  }
  return Curve(surface.degree(Along::u), surface.knots(Along::u), std::move(points), std::move(weights));
}

// The weight function of a rational curve.
double weight_at(const Curve& curve, double u) {
  return Curve(curve.degree(), curve.knots(), Points(1, curve.weights())).evaluate(u)[0];
}

// A surface of degree 1 along v with one span is ruled between its edges, and at each u a rational one runs
// through the ruling in another way only: there the share t of b is v wb / ((1 - v) wa + v wb).
Findings examine_ruled(const Surface& surface) {
  const Curve a = row(surface, 0);
  const Curve b = row(surface, 1);
  Findings findings = detail::examine_planar_ruled(a, b);
  const Interval domain = surface.domain(Along::v);
  for (Parameters& at : findings.places) {
    double v = at[1];
    if (surface.is_rational() && v > 0.0 && v < 1.0) {
      const double of_a = (1.0 - v) * weight_at(b, at[0]);
      const double of_b = v * weight_at(a, at[0]);
      v = of_b / (of_a + of_b);
    }
    at[1] = domain.lo + v * domain.length();
    if (v == 1.0) at[1] = domain.hi;
  }
  return findings;
}

// Closed surfaces are those that are closed along u.
Findings examine_planar(const Surface& surface) {
  if (surface.degree(Along::v) == 1 && surface.size(Along::v) == 2) return examine_ruled(surface);
  if (!surface.is_closed(Along::v) || surface.is_closed(Along::u))
    return detail::examine_planar_patches(surface);
  Findings findings = detail::examine_planar_patches(transpose(surface));
  for (Parameters& at : findings.places) std::swap(at[0], at[1]);
  for (int& sign : findings.signs) sign = -sign;
  return findings;
}

SurfacePlace middle_of(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  SurfacePlace result{0.0, 0.0, Point(3), 0.0};
  for (const std::uint32_t corner : triangle) {
    for (std::size_t c = 0; c < 3; ++c) result.point[c] += mesh.vertices[corner][c] / 3.0;
    if (corner >= mesh.parameters.size()) continue;
    result.u += mesh.parameters[corner][0] / 3.0;
    result.v += mesh.parameters[corner][1] / 3.0;
  }
  return result;
}

}  // namespace

Certificate certify(const Curve& a, const Curve& b) {
  check_dimension(a.dim());
  if (a.dim() != b.dim()) {
    throw InvalidArgument(
        fmt::format("the first curve is in R^{}, the second one in R^{}: they must agree", a.dim(), b.dim()));
  }
  if (!(a.domain() == b.domain())) {
    throw InvalidArgument(
        fmt::format("the first curve is over [{}, {}], the second one over [{}, {}]: they must agree",
                    a.domain().lo, a.domain().hi, b.domain().lo, b.domain().hi));
  }
  const std::array<const Points*, 2> clouds = {&a.control_points(), &b.control_points()};
  const auto plane = detail::plane_axes(clouds);
  if (!plane)
    throw InvalidArgument(
        "the curves do not lie in one plane, within 1e-9 of their width: certify their ruled surface");
  const auto derivatives = [&](double u, double v) {
    const Points of_a = a.derivatives(u, 1);
    const Points of_b = b.derivatives(u, 1);
    Points rows(a.dim(), 3);
    for (std::size_t c = 0; c < of_a[0].size(); ++c) {
      rows[0][c] = (1.0 - v) * of_a[0][c] + v * of_b[0][c];
      rows[1][c] = (1.0 - v) * of_a[1][c] + v * of_b[1][c];
      rows[2][c] = of_b[0][c] - of_a[0][c];
    }
    return rows;
  };
  return certificate(detail::examine_planar_ruled(in_plane(a, *plane), in_plane(b, *plane)), derivatives,
                     plane);
}

Certificate certify(const Surface& surface) {
  check_dimension(surface.dim());
  const std::array<const Points*, 1> clouds = {&surface.control_points()};
  const auto plane = detail::plane_axes(clouds);
  const auto derivatives = [&](double u, double v) { return surface.derivatives(u, v, 1); };
  return certificate(plane ? examine_planar(in_plane(surface, *plane)) : detail::examine_in_space(surface),
                     derivatives, plane);
}

Certificate certify(const Surface& surface, const TriangleMesh& tessellation) {
  Certificate result = certify(surface);
  if (result.one_to_one) return result;
  const SimpleMesh simple = find_simple(tessellation);
  result.tessellation_simple = simple.verdict;
  if (simple.verdict == Verdict::violated && !result.witness) {
    result.witness = Witness{WitnessKind::triangles, {}, simple.triangles};
    for (const std::size_t t : simple.triangles)
      result.witness->places.push_back(middle_of(tessellation, tessellation.triangles[t]));
  }
  result.verdict = overall(result);
  return result;
}

}  // namespace v0
}  // namespace tandem
