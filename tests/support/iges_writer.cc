// A STEP file as IGES: as solids, as the surfaces that most systems write, in
// millimetres or inches.
//
//     iges_writer FILE.step FILE.igs solids|surfaces MM|INCH

#include <cstdio>
#include <string_view>

#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <STEPControl_Reader.hxx>

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr,
                 "iges_writer FILE.step FILE.igs solids|surfaces MM|INCH\n");
    return 2;
  }
  STEPControl_Reader reader;
  if (reader.ReadFile(argv[1]) != IFSelect_RetDone) return 1;
  reader.TransferRoots();
  IGESControl_Controller::Init();
  const int solids = std::string_view(argv[3]) == "solids" ? 1 : 0;
  IGESControl_Writer writer(argv[4], solids);
  if (!writer.AddShape(reader.OneShape())) return 1;
  writer.ComputeModel();
  return writer.Write(argv[2]) ? 0 : 1;
}
