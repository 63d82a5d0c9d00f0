#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace clevis::multibody {

/// Names that a scene takes, made of those of a model: other characters become
/// "_", names that are taken get a number.
class Names {
 public:
  /// @param kind  for what is told: "link".
  Names(std::string kind, std::set<std::string> taken)
      : kind_(std::move(kind)), taken_(std::move(taken)) {}

  /// @param told  takes a line if the name is another one.
  std::string add(const std::string& name, std::vector<std::string>& told);

 private:
  std::string kind_;
  std::set<std::string> taken_;
};

/// At most that many bytes, cut between characters of UTF-8; control characters
/// become "?": for a terminal, a comment or a title.
std::string one_line(const std::string& text, std::size_t longest = 200);

/// As a TOML basic string, quotes included; control characters become spaces.
std::string toml_text(const std::string& text);

}  // namespace clevis::multibody
