#include "cad/convert.h"

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Pnt.hxx>
#include <string>
#include <utility>
#include <vector>

#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"
#include "tandem/error.h"
#include "tandem/surface/edit.h"

namespace tandem {
inline namespace v0 {
namespace cad {
namespace {

gp_Pnt to_point(std::span<const double> p) {
  return {p[0], p[1], p.size() > 2 ? p[2] : 0.0};
}

void check(int dim, int degree) {
  if (dim != 2 && dim != 3) {
    throw InvalidArgument("a CAD file holds curves and surfaces of dimension 2 or 3, not " +
                          std::to_string(dim));
  }
  if (degree > Geom_BSplineCurve::MaxDegree()) {
    throw InvalidArgument("degree " + std::to_string(degree) + " is above " +
                          std::to_string(Geom_BSplineCurve::MaxDegree()) +
                          ", the highest that a CAD file takes; laws of --order 2 do not raise it");
  }
}

/// A knot vector as OpenCASCADE has it.
struct OcctKnots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger multiplicities;

  explicit OcctKnots(const std::vector<Knot>& knots)
      : values(1, static_cast<int>(knots.size())), multiplicities(1, static_cast<int>(knots.size())) {
    for (int i = 1; i <= values.Length(); ++i) {
      values(i) = knots[static_cast<std::size_t>(i - 1)].value;
      multiplicities(i) = knots[static_cast<std::size_t>(i - 1)].multiplicity;
    }
  }
};

}  // namespace

Handle(Geom_BSplineCurve) to_occt(const Curve& given) {
  check(given.dim(), given.degree());
  const Curve curve = clamp(given);
  const OcctKnots knots(distinct_knots(curve.knots()));
  const int n = static_cast<int>(curve.size());
  TColgp_Array1OfPnt poles(1, n);
  TColStd_Array1OfReal weights(1, n);
  for (int i = 1; i <= n; ++i) {
    const auto at = static_cast<std::size_t>(i - 1);
    poles(i) = to_point(curve.control_points()[at]);
    weights(i) = curve.is_rational() ? curve.weights()[at] : 1.0;
  }
  if (!curve.is_rational())
    return new Geom_BSplineCurve(poles, knots.values, knots.multiplicities, curve.degree());
  return new Geom_BSplineCurve(poles, weights, knots.values, knots.multiplicities, curve.degree());
}

Handle(Geom_BSplineSurface) to_occt(const Surface& given) {
  check(given.dim(), std::max(given.degree(Along::u), given.degree(Along::v)));
  const Surface surface = clamp(given);
  const OcctKnots u(distinct_knots(surface.knots(Along::u)));
  const OcctKnots v(distinct_knots(surface.knots(Along::v)));
  const int m = static_cast<int>(surface.size(Along::u));
  const int n = static_cast<int>(surface.size(Along::v));
  TColgp_Array2OfPnt poles(1, m, 1, n);
  TColStd_Array2OfReal weights(1, m, 1, n);
  for (int i = 1; i <= m; ++i) {
    for (int j = 1; j <= n; ++j) {
      const auto at = static_cast<std::size_t>((i - 1) * n + j - 1);
      poles(i, j) = to_point(surface.control_points()[at]);
      weights(i, j) = surface.is_rational() ? surface.weights()[at] : 1.0;
    }
  }
  const int p = surface.degree(Along::u);
  const int q = surface.degree(Along::v);
  if (!surface.is_rational()) {
    return new Geom_BSplineSurface(poles, u.values, v.values, u.multiplicities, v.multiplicities, p, q);
  }
  return new Geom_BSplineSurface(poles, weights, u.values, v.values, u.multiplicities, v.multiplicities, p,
                                 q);
}

Curve from_occt(const Handle(Geom_BSplineCurve) & given) {
  Handle(Geom_BSplineCurve) curve = given;
  if (curve->IsPeriodic()) {
    curve = Handle(Geom_BSplineCurve)::DownCast(given->Copy());
    curve->SetNotPeriodic();
  }
  std::vector<double> knots;
  for (int i = 1; i <= curve->NbKnots(); ++i) {
    knots.insert(knots.end(), static_cast<std::size_t>(curve->Multiplicity(i)), curve->Knot(i));
  }
  const auto n = static_cast<std::size_t>(curve->NbPoles());
  Points points(3, n);
  std::vector<double> weights(curve->IsRational() ? n : 0);
  for (std::size_t i = 0; i < n; ++i) {
    const gp_Pnt p = curve->Pole(static_cast<int>(i) + 1);
    points[i][0] = p.X();
    points[i][1] = p.Y();
    points[i][2] = p.Z();
    if (!weights.empty()) weights[i] = curve->Weight(static_cast<int>(i) + 1);
  }
  return Curve(curve->Degree(), std::move(knots), std::move(points), std::move(weights));
}

}  // namespace cad
}  // namespace v0
}  // namespace tandem
