#include "cad/read.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <fstream>
#include <optional>

#include "cad/convert.h"
#include "cad/quiet.h"
#include "cad/wires.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace cad {
namespace {

template <class Reader>
std::vector<TopoDS_Shape> transferred(const std::string& path, const char* kind) {
  Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) {
    throw ParseError(path, 0, 0, std::string("is not a readable ") + kind + " file");
  }
  reader.TransferRoots();
  std::vector<TopoDS_Shape> shapes;
  for (int i = 1; i <= reader.NbShapes(); ++i) shapes.push_back(reader.Shape(i));
  return shapes;
}

std::vector<TopoDS_Shape> read_brep(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  // OpenCASCADE complains of other files on standard output.
  std::string line;
  while (line.find_first_not_of(" \t\r") == std::string::npos && std::getline(in, line)) {
  }
  TopoDS_Shape shape;
  if (line.rfind("DBRep_DrawableShape", 0) == 0 || line.rfind("CASCADE Topology", 0) == 0) {
    in.seekg(0);
    BRepTools::Read(shape, in, BRep_Builder());
  }
  if (shape.IsNull()) throw ParseError(path, 0, 0, "is not a readable BREP file");
  return {shape};
}

std::vector<TopoDS_Shape> read_shapes(const std::string& path, CadFormat format) {
  switch (format) {
    case CadFormat::step:
      return transferred<STEPControl_Reader>(path, "STEP");
    case CadFormat::iges:
      // Curves with corners stay whole, too.
      Interface_Static::SetIVal("read.iges.bspline.continuity", 0);
      return transferred<IGESControl_Reader>(path, "IGES");
    case CadFormat::brep:
      break;
  }
  return read_brep(path);
}

// An edge as a curve in the direction in which it is run through; nothing for one without a curve in space
// (of a pole).
std::optional<Curve> curve_of(const TopoDS_Edge& edge) {
  double first = 0.0;
  double last = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  if (curve.IsNull() || !(first < last)) return std::nullopt;
  const Handle(Geom_BSplineCurve) whole =
      GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(curve, first, last));
  if (edge.Orientation() == TopAbs_REVERSED) whole->Reverse();
  return from_occt(whole);
}

std::vector<Curve> edges_of(const TopoDS_Shape& shape) {
  std::vector<Curve> curves;
  TopTools_IndexedMapOfShape seen;  // an edge between two faces belongs to both
  for (TopExp_Explorer edges(shape, TopAbs_EDGE); edges.More(); edges.Next()) {
    const int before = seen.Extent();
    if (seen.Add(edges.Current()) <= before) continue;
    if (std::optional<Curve> curve = curve_of(TopoDS::Edge(edges.Current())))
      curves.push_back(*std::move(curve));
  }
  return curves;
}

void append(std::vector<Curve>& all, std::vector<Curve> more) {
  for (Curve& curve : more) all.push_back(std::move(curve));
}

// Wires and loose edges; those of faces, or all but those.
void collect(const TopoDS_Shape& shape, bool of_faces, std::vector<Curve>& curves) {
  switch (shape.ShapeType()) {
    case TopAbs_COMPOUND: {
      std::vector<Curve> loose;
      for (TopoDS_Iterator parts(shape); parts.More(); parts.Next()) {
        if (parts.Value().ShapeType() == TopAbs_EDGE) {
          if (!of_faces) append(loose, edges_of(parts.Value()));
        } else {
          collect(parts.Value(), of_faces, curves);
        }
      }
      append(curves, chained(std::move(loose)));
      return;
    }
    case TopAbs_WIRE:
    case TopAbs_EDGE:
      if (!of_faces) append(curves, chained(edges_of(shape)));
      return;
    default:
      if (!of_faces) return;
      for (TopExp_Explorer wires(shape, TopAbs_WIRE); wires.More(); wires.Next()) {
        append(curves, chained(edges_of(wires.Current())));
      }
  }
}

}  // namespace

std::vector<Curve> read_curves(const std::string& path, CadFormat format) {
  try {
    const Quiet quiet;
    const std::vector<TopoDS_Shape> shapes = read_shapes(path, format);
    std::vector<Curve> curves;
    for (const bool of_faces : {false, true}) {
      for (const TopoDS_Shape& shape : shapes) collect(shape, of_faces, curves);
      if (!curves.empty()) return curves;
    }
  } catch (const Standard_Failure& failure) {
    throw ParseError(path, 0, 0, std::string("cannot be read: ") + failure.GetMessageString());
  }
  throw ParseError(path, 0, 0, "has no edge or wire");
}

}  // namespace cad
}  // namespace v0
}  // namespace tandem
