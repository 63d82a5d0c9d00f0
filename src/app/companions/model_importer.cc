#include "app/companions/model_importer.h"

#include "app/companions/companion_answer.h"
#include "app/processes/temporary_folder.h"
#include "base/messages/errors.h"
#include "multibody/exchange.h"
#include "multibody/source_file.h"

namespace clevis::app {

multibody::Model run_importer(const std::filesystem::path& file,
                              const std::filesystem::path& program) {
  multibody::require_model_file(file);
  const Companion importer{
      .name = kImporter,
      .role = "importer",
      .code = "S014",
      .remedy = "Import one mechanism alone, with fewer links.",
      .program = program,
      .timeout = std::chrono::seconds(8),
      .memory = std::size_t{2} << 30};
  const TemporaryFolder folder;
  const std::string answer = companion_answer(
      importer, file, std::filesystem::absolute(file), folder.path());
  try {
    return multibody::read_answer(answer);
  } catch (const Error& error) {
    // The child knows the file by its absolute path.
    const std::string absolute = std::filesystem::absolute(file).string();
    std::string place = error.place();
    if (place.starts_with(absolute)) {
      place.replace(0, absolute.size(), file.string());
    }
    throw Error(error.code(), place, error.problem(), error.remedy());
  } catch (const std::exception& failure) {
    refuse_answer(importer, file, failure);
  }
}

}  // namespace clevis::app
