#pragma once

#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>

#include "tandem/curve/curve.h"
#include "tandem/surface/surface.h"

namespace tandem {
inline namespace v0 {
namespace cad {

/// Between Tandem's curves and OpenCASCADE's, number by number. All of ours are clamped on the way.
/// @throws InvalidArgument a dimension other than 2 and 3, a degree above Geom_BSplineCurve::MaxDegree()
[[nodiscard]] Handle(Geom_BSplineCurve) to_occt(const Curve& curve);
[[nodiscard]] Handle(Geom_BSplineSurface) to_occt(const Surface& surface);
/// In R^3; periodic ones are cut open at their seam.
[[nodiscard]] Curve from_occt(const Handle(Geom_BSplineCurve) & curve);

}  // namespace cad
}  // namespace v0
}  // namespace tandem
