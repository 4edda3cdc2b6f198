#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "io/scratch_directory.h"
#include "tandem/io/cad.h"
#include "tandem/io/files.h"
#include "tandem/io/json.h"
#include "tandem/surface/skin.h"

namespace tandem {
namespace {

/// What OpenCASCADE's own loft makes of the edges of a STEP file: the share of its length on which both
/// sections' tangents disagree.
class LoftRepair : public test::ScratchDirectory {
 protected:
  [[nodiscard]] static std::vector<Curve> sections(const std::string& name) {
    return parse_json_curves(read_file(std::string(TANDEM_EXAMPLE_DATA) + "/" + name));
  }

  // Nothing when OpenCASCADE refuses the sections.
  [[nodiscard]] std::optional<double> twisted_share(const std::vector<Curve>& curves, bool ruled) const {
    const std::string name = path("sections.step");
    write_file(name, format_cad(CadFormat::step, curves));
    STEPControl_Reader reader;
    EXPECT_EQ(reader.ReadFile(name.c_str()), IFSelect_RetDone);
    reader.TransferRoots();
    BRepOffsetAPI_ThruSections loft(false, ruled);
    int wires = 0;
    for (TopExp_Explorer edges(reader.OneShape(), TopAbs_EDGE); edges.More(); edges.Next(), ++wires) {
      loft.AddWire(BRepBuilderAPI_MakeWire(TopoDS::Edge(edges.Current())).Wire());
    }
    EXPECT_EQ(wires, static_cast<int>(curves.size()));
    try {
      loft.Build();
    } catch (const Standard_Failure&) {
      return std::nullopt;
    }
    if (!loft.IsDone()) return std::nullopt;
    double twisted = 0.0;
    double whole = 0.0;
    for (TopExp_Explorer faces(loft.Shape(), TopAbs_FACE); faces.More(); faces.Next()) {
      const TopoDS_Face face = TopoDS::Face(faces.Current());
      const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
      double u0, u1, v0, v1;
      BRepTools::UVBounds(face, u0, u1, v0, v1);
      constexpr int kSamples = 4000;
      for (int i = 0; i < kSamples; ++i) {
        const double u = u0 + (u1 - u0) * (i + 0.5) / kSamples;
        gp_Pnt p;
        gp_Vec first, second, across;
        surface->D1(u, v0, p, first, across);
        surface->D1(u, v1, p, second, across);
        const double length = first.Magnitude() + second.Magnitude();
        whole += length;
        if (first.Dot(second) < 0.0) twisted += length;
      }
    }
    return twisted / whole;
  }
};

TEST_F(LoftRepair, LettersThatOpenCascadeRefusesLoft) {
  const std::vector<Curve> letters = sections("letters_ef.json");
  EXPECT_EQ(twisted_share(letters, true), std::nullopt);
  const SkinnedSurface repaired = skin(letters);
  for (const bool ruled : {true, false}) {
    const std::optional<double> share = twisted_share(repaired.sections, ruled);
    ASSERT_TRUE(share.has_value());
    // What is left is where an E and an F have nothing in common.
    EXPECT_LE(*share, 0.002);
  }
}

TEST_F(LoftRepair, NestedCurvesLoftWithoutFolds) {
  const std::vector<Curve> nested = sections("u_planar.json");
  EXPECT_GT(twisted_share(nested, true).value_or(1.0), 0.3);
  const SkinnedSurface repaired = skin(nested);
  EXPECT_EQ(twisted_share(repaired.sections, true), 0.0);
  EXPECT_EQ(twisted_share(repaired.sections, false), 0.0);
}

}  // namespace
}  // namespace tandem
