// A STEP file as other systems would write it: as IGES of solids or of the
// surfaces alone, or as STEP all of whose surfaces are rational splines.
//
//     cad_writer FILE.step OUT solids|surfaces|splines MM|INCH

#include <cstdio>
#include <string_view>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>

namespace {

bool write_step(const TopoDS_Shape& shape, const char* file, const char* unit) {
  STEPControl_Controller::Init();
  Interface_Static::SetCVal("write.step.unit", unit);
  STEPControl_Writer writer;
  return writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
         writer.Write(file) == IFSelect_RetDone;
}

bool write_iges(const TopoDS_Shape& shape, const char* file, const char* unit,
                bool as_solids) {
  IGESControl_Controller::Init();
  IGESControl_Writer writer(unit, as_solids ? 1 : 0);
  if (!writer.AddShape(shape)) return false;
  writer.ComputeModel();
  return writer.Write(file);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr,
                 "cad_writer FILE.step OUT solids|surfaces|splines "
                 "MM|INCH\n");
    return 2;
  }
  STEPControl_Reader reader;
  if (reader.ReadFile(argv[1]) != IFSelect_RetDone) return 1;
  reader.TransferRoots();
  const TopoDS_Shape shape = reader.OneShape();
  const std::string_view form = argv[3];
  const bool is_written =
      form == "splines"
          ? write_step(BRepBuilderAPI_NurbsConvert(shape, true).Shape(),
                       argv[2], argv[4])
          : write_iges(shape, argv[2], argv[4], form == "solids");
  return is_written ? 0 : 1;
}
