// clevis-mesher REQUEST ANSWER: reads a CAD file, describes its faces and
// meshes it. It runs no script, whatever the file holds.
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include <Standard_Failure.hxx>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "base/system/allowed_program.h"
#include "cad/exchange.h"
#include "mesher/check_shape.h"
#include "mesher/describe_solid.h"
#include "mesher/facet_faces.h"
#include "mesher/mesh_solid.h"
#include "mesher/read_shape.h"

namespace {

using namespace clevis;

std::string answer(const cad::Request& request) {
  const std::string file = request.file.string();
  try {
    const mesher::ReadShape read = mesher::read_shape(request);
    const TopoDS_Solid solid = mesher::one_sound_solid(read.shape, file);
    cad::Solid described = mesher::describe(solid, request.points, file);
    described.unit = read.unit;
    mesher::add_labels(solid, read.labels, described);
    if (request.facets) described.facets = mesher::facets_of(solid);
    if (!request.mesh.empty()) mesher::mesh_solid(solid, described, request);
    return cad::answer(described);
  } catch (const Error& error) {
    return cad::refusal(error.code(), error.place(), error.problem(),
                        error.remedy());
  } catch (const Standard_Failure& failure) {
    return cad::refusal(
        "M010", file,
        fmt::format("OpenCASCADE says: {}", failure.GetMessageString()),
        "Repair the solid in the CAD system and export it again.");
  }
}

}  // namespace

int main(int argc, char** argv) {
  clevis::allow_only(nullptr);  // bubblewrap, which started it, could not
  if (argc != 3) {
    std::cerr << "clevis-mesher REQUEST ANSWER: run by clevis\n";
    return 2;
  }
  try {
    std::ifstream stream(argv[1], std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    std::ofstream(argv[2], std::ios::binary) << answer(cad::read_request(text));
    return 0;
  } catch (const std::exception& failure) {
    std::cerr << failure.what() << '\n';
    return 1;
  }
}
