// OpenCASCADE's own loft of the sections that BM_Skin (skin_bench.cpp) puts in step, in the same run. Here by
// itself, for only this file needs its headers.
#include <benchmark/benchmark.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <ctime>
#include <vector>

#include "bell_sections.h"
#include "tandem/curve/edit.h"
#include "tandem/curve/knots.h"
#include "tandem/surface/skin.h"

namespace tandem::bench {
namespace {

TopoDS_Wire wire_of(const Curve& given) {
  const Curve curve = clamp(given);
  const int n = static_cast<int>(curve.size());
  TColgp_Array1OfPnt poles(1, n);
  for (int i = 1; i <= n; ++i) {
    const auto p = curve.control_points()[static_cast<std::size_t>(i - 1)];
    poles(i) = gp_Pnt(p[0], p[1], p[2]);
  }
  const std::vector<Knot> distinct = distinct_knots(curve.knots());
  TColStd_Array1OfReal knots(1, static_cast<int>(distinct.size()));
  TColStd_Array1OfInteger multiplicities(1, static_cast<int>(distinct.size()));
  for (int i = 1; i <= knots.Length(); ++i) {
    knots(i) = distinct[static_cast<std::size_t>(i - 1)].value;
    multiplicities(i) = distinct[static_cast<std::size_t>(i - 1)].multiplicity;
  }
  const Handle(Geom_BSplineCurve) spline =
      new Geom_BSplineCurve(poles, knots, multiplicities, curve.degree());
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(spline)).Wire();
}

// The shape of a loft, smooth as ours.
void loft_by_occt(const std::vector<TopoDS_Wire>& wires) {
  BRepOffsetAPI_ThruSections loft(Standard_False, Standard_False);
  for (const TopoDS_Wire& wire : wires) loft.AddWire(wire);
  loft.Build();
  benchmark::DoNotOptimize(loft.IsDone());
}

// Of all threads, in milliseconds: what else the machine does matters less.
double processor_time() {
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// The best of a few calls.
double skin_time(const std::vector<Curve>& sections) {
  constexpr int kCalls = 7;
  double best = 1e300;
  for (int i = 0; i < kCalls; ++i) {
    const double start = processor_time();
    benchmark::DoNotOptimize(skin(sections));
    best = std::min(best, processor_time() - start);
  }
  return best;
}

// skin_ms: our whole skin(), matching and report included; skin_per_loft: as a multiple of the loft here,
// both the best of several calls.
void BM_SkinByOcct(benchmark::State& state) {
  const std::vector<Curve> given = bell_sections(10, 50, state.range(0) != 0);
  std::vector<TopoDS_Wire> wires;
  for (const Curve& curve : given) wires.push_back(wire_of(curve));
  double best = 1e300;
  for (auto _ : state) {
    const double start = processor_time();
    loft_by_occt(wires);
    best = std::min(best, processor_time() - start);
  }
  const double own = skin_time(given);
  state.counters["skin_ms"] = own;
  state.counters["skin_per_loft"] = own / best;
}
BENCHMARK(BM_SkinByOcct)
    ->Name("skin_by_occt")
    ->ArgName("closed")
    ->Arg(0)
    ->Arg(1)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tandem::bench
