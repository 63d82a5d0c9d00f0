// clevis-importer MODEL ANSWER: reads an SDF or URDF file and says as JSON what
// is in it. It opens no other file and runs nothing, whatever the file holds.
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <new>
#include <string>

#include <fmt/format.h>
#include <sdf/Exception.hh>

#include "base/messages/errors.h"
#include "base/system/allowed_program.h"
#include "importer/model_xml.h"
#include "importer/read_sdf.h"
#include "importer/read_urdf.h"
#include "multibody/exchange.h"

namespace {

using namespace clevis;

multibody::Model read(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  importer::ModelXml xml = importer::model_xml(text, file);
  multibody::Model model = xml.is_urdf ? importer::read_urdf(xml.text, file)
                                       : importer::read_sdf(xml.text, file);
  model.told.insert(model.told.begin(), xml.lost.begin(), xml.lost.end());
  return model;
}

std::string answer(const std::string& file) {
  constexpr const char* kRemedy = "Repair the model, or export it again.";
  try {
    return multibody::answer(read(file));
  } catch (const Error& error) {
    return multibody::refusal(error);
  } catch (const sdf::Exception& failure) {
    return multibody::refusal(Error(
        "S014", file,
        fmt::format("libsdformat says: {}", failure.GetErrorStr()), kRemedy));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& failure) {
    return multibody::refusal(Error(
        "S014", file, fmt::format("not read: {}", failure.what()), kRemedy));
  }
}

}  // namespace

int main(int argc, char** argv) {
  clevis::allow_only(nullptr);  // bubblewrap, which started it, could not
  if (argc != 3) {
    std::cerr << "clevis-importer MODEL ANSWER: run by clevis\n";
    return 2;
  }
  try {
    std::ofstream(argv[2], std::ios::binary) << answer(argv[1]);
  } catch (const std::bad_alloc&) {  // clevis knows the limit that it set
    return int(ExitCode::kResourceLimit);
  }
  return 0;
}
