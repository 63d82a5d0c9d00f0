#include "app/processes/error_text.h"

#include <nlohmann/json.hpp>

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

}  // namespace clevis::app
