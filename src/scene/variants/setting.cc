#include "scene/variants/setting.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::scene {

Setting parse_setting(std::string_view text, std::string place) {
  const std::size_t equals = text.find('=');
  const bool has_control = std::ranges::any_of(text, [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
  if (equals == text.npos || equals == 0 || equals + 1 == text.size() ||
      has_control) {
    throw Error("U001", std::move(place),
                fmt::format("{:?} is not PATH=VALUE", text.substr(0, 80)),
                "Write e.g. --set part.AB.thickness=\"10 mm\".");
  }
  const auto trimmed = [](std::string_view part) {
    const std::size_t start =
        std::min(part.find_first_not_of(' '), part.size());
    part.remove_prefix(start);
    return std::string(part.substr(0, part.find_last_not_of(' ') + 1));
  };
  return {trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1)),
          std::move(place)};
}

}  // namespace clevis::scene
