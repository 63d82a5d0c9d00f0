#include "app/request/error_text.h"

#include <nlohmann/json.hpp>

#include "report/text/json_text.h"

namespace clevis::app {

std::string encode_error(const Error& error) {
  return nlohmann::json{{"code", error.code()},
                        {"place", error.place()},
                        {"problem", error.problem()},
                        {"remedy", error.remedy()}}
      .dump();
}

Error decode_error(std::string_view text) {
  const auto json = nlohmann::json::parse(text);
  return {json.at("code").get<std::string>(),
          json.at("place").get<std::string>(),
          json.at("problem").get<std::string>(),
          json.at("remedy").get<std::string>()};
}

std::string error_document(const Error& error) {
  const nlohmann::ordered_json document = {
      {"schema", report::kSchema},
      {"error",
       {{"code", error.code()},
        {"place", error.place()},
        {"problem", error.problem()},
        {"remedy", error.remedy()},
        {"exit_code", static_cast<int>(error.exit_code())}}}};
  constexpr int kIndent = 2;
  // A file name may hold bytes that are no UTF-8: replace, never throw.
  return document.dump(kIndent, ' ', false,
                       nlohmann::json::error_handler_t::replace) +
         "\n";
}

}  // namespace clevis::app
