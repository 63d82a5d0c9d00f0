#include "mesher/read_shape.h"

#include <algorithm>
#include <cmath>

#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepShape_Face.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::mesher {
namespace {

constexpr double kMillimetre = 1e-3;  // [m]

/// Coordinate [unit of the file] behind which doubles no longer resolve the
/// tolerance of OpenCASCADE, 1e-7: it searches for half a minute.
constexpr double kFarthest = 1e8;

[[noreturn]] void refuse(const cad::Request& request,
                         const std::string& problem) {
  throw Error("M010", request.file.string(), problem,
              "Export it again as one solid, and look at it in a CAD system.");
}

void take_millimetres() {
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
}

/// Name that a face's entity bears, as one line that a terminal can take; what
/// writers give for want of one is none.
std::string label_of(const StepShape_Face& face) {
  if (face.Name().IsNull()) return {};
  std::string name = face.Name()->ToCString();
  std::ranges::replace_if(
      name,
      [](unsigned char c) {
        return c < ' ' || c == 0x7F;
      },
      '?');
  return name == "NONE" ? std::string() : name;
}

std::vector<std::pair<TopoDS_Shape, std::string>> labels_of(
    const STEPControl_Reader& reader) {
  std::vector<std::pair<TopoDS_Shape, std::string>> labels;
  const auto model = reader.WS()->Model();
  const auto transferred = reader.WS()->TransferReader()->TransientProcess();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto face = Handle(StepShape_Face)::DownCast(model->Value(i));
    if (face.IsNull()) continue;
    const std::string label = label_of(*face);
    if (label.empty()) continue;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(transferred, face);
    if (!shape.IsNull()) labels.emplace_back(shape, label);
  }
  return labels;
}

/// Largest coordinate of a point [unit of the file], infinite if one is no
/// number.
double farthest_coordinate(const StepGeom_CartesianPoint& point) {
  double farthest = 0.0;
  for (int i = 1; i <= point.NbCoordinates(); ++i) {
    const double coordinate = std::abs(point.CoordinatesValue(i));
    farthest =
        std::max(farthest, std::isfinite(coordinate) ? coordinate : INFINITY);
  }
  return farthest;
}

/// @throws Error M010 if a point of the file has no coordinates that are
///   numbers, or lies too far out.
void require_sound_points(const STEPControl_Reader& reader,
                          const cad::Request& request) {
  const auto model = reader.WS()->Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto point =
        Handle(StepGeom_CartesianPoint)::DownCast(model->Value(i));
    if (point.IsNull()) continue;
    const double farthest = farthest_coordinate(*point);
    const auto entity = [&] {
      return std::string(model->StringLabel(point)->ToCString());
    };
    if (model->IsErrorEntity(i) || !std::isfinite(farthest)) {
      refuse(request,
             fmt::format("a coordinate of point {} is not a number", entity()));
    }
    if (farthest > kFarthest) {
      refuse(request,
             fmt::format("point {} has a coordinate of {:.3g} in the file's "
                         "unit, {:.0e} is the most",
                         entity(), farthest, kFarthest));
    }
  }
}

ReadShape read_step(const cad::Request& request) {
  STEPControl_Reader reader;
  take_millimetres();
  if (reader.ReadFile(request.file.c_str()) != IFSelect_RetDone) {
    refuse(request, "OpenCASCADE cannot read the STEP file: it is damaged");
  }
  require_sound_points(reader, request);
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  reader.TransferRoots();
  ReadShape read{reader.OneShape(), {}, labels_of(reader)};
  if (!lengths.IsEmpty()) read.unit = lengths.First().ToCString();
  return read;
}

TopoDS_Shape sewn(const TopoDS_Shape& surfaces) {
  constexpr double kGap = 1e-3;  // [mm]
  BRepBuilderAPI_Sewing sewing(kGap);
  sewing.Add(surfaces);
  sewing.Perform();
  TopExp_Explorer shell(sewing.SewedShape(), TopAbs_SHELL);
  if (!shell.More() || !BRep_Tool::IsClosed(shell.Current())) return surfaces;
  return BRepBuilderAPI_MakeSolid(TopoDS::Shell(shell.Current())).Solid();
}

ReadShape read_iges(const cad::Request& request) {
  IGESControl_Reader reader;
  take_millimetres();
  if (reader.ReadFile(request.file.c_str()) != IFSelect_RetDone) {
    refuse(request, "OpenCASCADE cannot read the IGES file: it is damaged");
  }
  reader.TransferRoots();
  ReadShape read{reader.OneShape(), {}};
  const auto unit = reader.IGESModel()->GlobalSection().UnitName();
  if (!unit.IsNull()) read.unit = unit->ToCString();
  if (!read.shape.IsNull() &&
      !TopExp_Explorer(read.shape, TopAbs_SOLID).More()) {
    read.shape = sewn(read.shape);
  }
  return read;
}

ReadShape read_brep(const cad::Request& request) {
  TopoDS_Shape shape;
  if (!BRepTools::Read(shape, request.file.c_str(), BRep_Builder())) {
    refuse(request, "OpenCASCADE cannot read the BREP file: it is damaged");
  }
  gp_Trsf scale;
  scale.SetScaleFactor(request.length_unit / kMillimetre);
  return {BRepBuilderAPI_Transform(shape, scale, true).Shape(), {}};
}

}  // namespace

ReadShape read_shape(const cad::Request& request) {
  ReadShape read;
  if (request.format == part::GeometryFormat::kStep) read = read_step(request);
  if (request.format == part::GeometryFormat::kIges) read = read_iges(request);
  if (request.format == part::GeometryFormat::kBrep) read = read_brep(request);
  if (read.shape.IsNull()) {
    refuse(request, "the file holds no shape that OpenCASCADE understands");
  }
  return read;
}

}  // namespace clevis::mesher
