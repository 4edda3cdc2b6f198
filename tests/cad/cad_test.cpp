#include "tandem/io/cad.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Surface.hxx>
#include <IGESControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <array>
#include <cmath>
#include <gp_Circ.hxx>
#include <string>

#include "curve/random_curves.h"
#include "io/scratch_directory.h"
#include "surface/random_surfaces.h"
#include "tandem/curve/edit.h"
#include "tandem/error.h"
#include "tandem/io/files.h"
#include "tandem/surface/edit.h"

namespace tandem {
namespace {

using testing::RandomCurves;
using testing::RandomSurfaces;

// Of the size: what the issue of exchange asks of a file that is read back.
constexpr double kReadBack = 1e-9;

struct Kind {
  CadFormat format;
  const char* ending;
};

class Exchange : public test::ScratchDirectory, public ::testing::WithParamInterface<Kind> {
 protected:
  [[nodiscard]] std::string write(std::span<const Curve> curves,
                                  std::span<const Surface> surfaces = {}) const {
    const std::string name = path(std::string("made") + GetParam().ending);
    write_file(name, format_cad(GetParam().format, curves, surfaces));
    return name;
  }
  [[nodiscard]] TopoDS_Shape read(const std::string& name) const {
    TopoDS_Shape shape;
    if (GetParam().format == CadFormat::brep) {
      BRepTools::Read(shape, name.c_str(), BRep_Builder());
      return shape;
    }
    const auto transferred = [&](auto reader) {
      EXPECT_EQ(reader.ReadFile(name.c_str()), IFSelect_RetDone);
      reader.TransferRoots();
      return reader.OneShape();
    };
    return GetParam().format == CadFormat::step ? transferred(STEPControl_Reader())
                                                : transferred(IGESControl_Reader());
  }
};

class Cad : public test::ScratchDirectory {};

TEST_P(Exchange, CurvesReadBackTheSame) {
  RandomCurves random(7);
  for (int trial = 0; trial < 30; ++trial) {
    const Curve curve = clamp(random.any(3));
    const std::array<Curve, 1> curves = {curve};
    const std::vector<Curve> back = read_cad_curves(write(curves));
    ASSERT_EQ(back.size(), 1U) << trial;
    const Curve same = with_domain(back[0], curve.domain());
    EXPECT_LE(testing::largest_gap(curve, same), kReadBack * curve.extent()) << trial;
  }
}

TEST_P(Exchange, SeveralCurvesStayApart) {
  // Two that meet at an end, and a loop.
  const std::array<Curve, 3> curves = {
      Curve::bezier({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}}), Curve::bezier({{2, 1, 0}, {3, 1, 1}}),
      Curve::clamped_uniform(2, {{0, 0, 5}, {2, 0, 5}, {1, 2, 5}, {0, 0, 5}})};
  const std::vector<Curve> back = read_cad_curves(write(curves));
  ASSERT_EQ(back.size(), 3U);
  EXPECT_TRUE(back[2].is_closed());
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LE(testing::largest_gap(curves[i], with_domain(back[i], curves[i].domain())), kReadBack);
}

TEST_P(Exchange, SurfacesReadBackTheSame) {
  RandomSurfaces random(8);
  for (int trial = 0; trial < 10; ++trial) {
    const Surface surface = clamp(random.any(3));
    const std::array<Surface, 1> surfaces = {surface};
    const TopoDS_Shape shape = read(write({}, surfaces));
    // Formats may cut faces where they have corners: their points lie on ours at the same parameters.
    int faces = 0;
    for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next()) {
      ++faces;
      const Handle(Geom_Surface) read_back = BRep_Tool::Surface(TopoDS::Face(e.Current()));
      double u0, u1, v0, v1;
      BRepTools::UVBounds(TopoDS::Face(e.Current()), u0, u1, v0, v1);
      for (int i = 1; i < 8; ++i) {
        for (int j = 1; j < 8; ++j) {
          const double u = u0 + (u1 - u0) * i / 8;
          const double v = v0 + (v1 - v0) * j / 8;
          const gp_Pnt p = read_back->Value(u, v);
          const Point q = surface.evaluate(u, v);
          EXPECT_LE(std::hypot(p.X() - q[0], p.Y() - q[1], p.Z() - q[2]), kReadBack * surface.extent())
              << trial;
        }
      }
    }
    EXPECT_GE(faces, 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, Exchange,
                         ::testing::Values(Kind{CadFormat::step, ".step"}, Kind{CadFormat::iges, ".igs"},
                                           Kind{CadFormat::brep, ".brep"}),
                         [](const auto& kind) { return std::string(kind.param.ending).substr(1); });

TEST_F(Cad, WiresAreOneCurveEach) {
  // A square with a round corner, its edges in any order and direction.
  const gp_Circ circle(gp_Ax2(gp_Pnt(3, 3, 0), gp::DZ()), 1.0);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(4, 0, 0), gp_Pnt(4, 3, 0)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(circle, gp_Pnt(4, 3, 0), gp_Pnt(3, 4, 0)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 4, 0), gp_Pnt(3, 4, 0)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 4, 0), gp_Pnt(0, 0, 0)).Edge());
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(4, 0, 0), gp_Pnt(0, 0, 0)).Edge());
  const std::string name = path("wire.brep");
  BRepTools::Write(wire.Wire(), name.c_str());
  const std::vector<Curve> curves = read_cad_curves(name);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].is_closed());
  // 3 + 3 + 4 + 4 + pi / 2 of length, and each edge has its share of the domain.
  const double length = 14.0 + std::acos(-1.0) / 2.0;
  EXPECT_NEAR(curves[0].domain().length(), length, 1e-5);
  EXPECT_NEAR(curves[0].evaluate(3.0)[0], 4.0, 1e-5);
  EXPECT_NEAR(curves[0].evaluate(3.0)[1], 3.0, 1e-5);
  const Point on_arc = curves[0].evaluate(3.0 + std::acos(-1.0) / 4.0);
  EXPECT_NEAR(std::hypot(on_arc[0] - 3.0, on_arc[1] - 3.0), 1.0, 1e-12);
}

TEST_F(Cad, SaysWhatIsWrong) {
  EXPECT_THROW((void)read_cad_curves(path("none.step")), IoError);
  for (const char* name : {"bad.step", "bad.igs", "bad.brep"}) {
    EXPECT_THROW((void)read_cad_curves(put(name, "no such thing\n")), ParseError) << name;
  }
  const std::array<Curve, 1> flat4 = {Curve::bezier({{0, 0, 0, 0}, {1, 0, 0, 0}})};
  EXPECT_THROW((void)format_cad(CadFormat::step, flat4), InvalidArgument);
  const std::array<Curve, 1> high = {Curve::bezier(Points(3, std::vector<double>(81, 0.5)))};
  EXPECT_THROW((void)format_cad(CadFormat::step, high), InvalidArgument);
  EXPECT_THROW((void)format_cad(CadFormat::step, {}), InvalidArgument);
  const std::array<Curve, 1> tiny = {Curve::bezier({{0, 0, 0}, {1e-9, 0, 0}})};
  EXPECT_THROW((void)format_cad(CadFormat::step, tiny), InvalidArgument);
  EXPECT_EQ(cad_format("A.STP"), CadFormat::step);
  EXPECT_THROW((void)cad_format("a.dwg"), InvalidArgument);
}

}  // namespace
}  // namespace tandem
