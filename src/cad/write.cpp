#include "cad/write.h"

#include <fmt/format.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESData_Protocol.hxx>
#include <IGESSelect_WorkLibrary.hxx>
#include <Interface_FloatWriter.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <XSControl_WorkSession.hxx>
#include <sstream>
#include <vector>

#include "cad/convert.h"
#include "cad/quiet.h"
#include "tandem/error.h"

namespace tandem {
inline namespace v0 {
namespace cad {
namespace {

// How close edges of a face that meet must be (a closed seam, a pole), in millimetres.
constexpr double kPrecision = 1e-7;
// Control polygons may be longer than what they make.
constexpr double kSmallest = 10.0 * kPrecision;

// OpenCASCADE leaves out what is smaller than its precision, without a word.
void check_size(double extent, const char* what) {
  if (extent > kSmallest) return;
  throw InvalidArgument(fmt::format(
      "{} of size {:.3g} is too small for a CAD file, whose precision is 1e-7; scale it up", what, extent));
}

TopoDS_Shape to_shape(const Curve& curve) {
  check_size(curve.extent(), "a curve");
  BRepBuilderAPI_MakeEdge made(to_occt(curve));
  if (!made.IsDone()) throw InvalidArgument("a curve that OpenCASCADE makes no edge of: it is too short");
  // A wire, so that it stays apart from others that it meets.
  return BRepBuilderAPI_MakeWire(made.Edge()).Wire();
}

TopoDS_Shape to_shape(const Surface& surface) {
  check_size(surface.extent(), "a surface");
  BRepBuilderAPI_MakeFace made(to_occt(surface), kPrecision);
  if (!made.IsDone()) throw InvalidArgument("a surface that OpenCASCADE makes no face of: it is degenerate");
  return made.Face();
}

// Enough to read the same doubles back; OpenCASCADE writes 9 or 12 digits by itself. Zeros at the end are
// left out.
void write_all_digits(Interface_FloatWriter& writer) {
  writer.SetFormat("%.16E");
}

std::string format_step(const std::vector<TopoDS_Shape>& shapes) {
  STEPControl_Writer writer;
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.unit", "MM");
  Interface_Static::SetCVal("write.step.product.name", "tandem");
  for (const TopoDS_Shape& shape : shapes) {
    if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone)
      throw InvalidArgument("OpenCASCADE cannot write this as STEP");
  }
  const Handle(StepData_StepModel) model = writer.Model();
  StepData_StepWriter sender(model);
  write_all_digits(sender.FloatWriter());
  sender.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  std::ostringstream out;
  sender.Print(out);
  return out.str();
}

std::string format_iges(const std::vector<TopoDS_Shape>& shapes) {
  Interface_Static::SetIVal("write.iges.brep.mode", 0);
  IGESControl_Writer writer("MM", 0);
  for (const TopoDS_Shape& shape : shapes) {
    if (!writer.AddShape(shape)) throw InvalidArgument("OpenCASCADE cannot write this as IGES");
  }
  writer.ComputeModel();
  IGESData_IGESWriter sender(writer.Model());
  write_all_digits(sender.FloatWriter());
  sender.SendModel(IGESSelect_WorkLibrary::DefineProtocol());
  std::ostringstream out;
  sender.Print(out);
  return out.str();
}

std::string format_brep(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Compound compound;
  BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  std::ostringstream out;
  out.precision(17);
  BRepTools::Write(compound, out);
  return out.str();
}

}  // namespace

std::string format(CadFormat format, std::span<const Curve> curves, std::span<const Surface> surfaces) {
  if (curves.empty() && surfaces.empty()) throw InvalidArgument("neither curves nor surfaces to write");
  try {
    const Quiet quiet;
    std::vector<TopoDS_Shape> shapes;
    for (const Curve& curve : curves) shapes.push_back(to_shape(curve));
    for (const Surface& surface : surfaces) shapes.push_back(to_shape(surface));
    switch (format) {
      case CadFormat::step:
        return format_step(shapes);
      case CadFormat::iges:
        return format_iges(shapes);
      case CadFormat::brep:
        break;
    }
    return format_brep(shapes);
  } catch (const Standard_Failure& failure) {
    throw InvalidArgument(std::string("OpenCASCADE cannot write this: ") + failure.GetMessageString());
  }
}

}  // namespace cad
}  // namespace v0
}  // namespace tandem
