#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <toml++/toml.h>

#include "base/messages/errors.h"
#include "base/values/quantity.h"

namespace clevis::scene {

/// "file:line:column" in a scene file; of what an option gives, the option.
std::string place_of(const std::string& file, const toml::source_region& at);

/// A value of the scene with what its messages need: the key it stands under
/// and its place. Each reader refuses what it does not understand.
class Value {
 public:
  /// @param label  key with its table, e.g. "joint.axis".
  /// @param file   outlives the value, as `node` does.
  Value(const toml::node& node, std::string label, const std::string& file);

  const toml::node& node() const { return *node_; }
  const std::string& label() const { return label_; }
  const std::string& file() const { return *file_; }
  std::string place() const { return place_of(*file_, node_->source()); }
  bool is_table() const { return node_->is_table(); }
  bool is_array() const { return node_->is_array(); }

  /// An error at this place whose problem starts with the label.
  Error refusal(std::string_view code, std::string_view problem,
                std::string remedy) const;

  /// A text of 1 to 4096 printable characters. @throws Error S005, S006.
  std::string text() const;

  /// A short text of 1 to 64 bytes, for messages and tables only.
  /// @throws Error S005, S006.
  std::string title() const;

  /// A name that may become a file name: 1 to 64 of A–Z a–z 0–9 . _ -, the
  /// first neither . nor -. @throws Error S005, S006.
  std::string name() const;

  /// A pure number, finite and in [low, high]. @throws Error S005, S006.
  double number(double low, double high) const;
  int integer(int low, int high) const;

  /// SI value of a text with unit. @throws Error S004, S005, S006.
  double quantity(Dimension dimension) const;
  /// As quantity() [SI], and > 0.
  double positive(Dimension dimension) const;
  /// Likewise of what materials have: 0.01 to 1200 GPa [Pa].
  /// @throws also S011.
  double elastic_modulus() const;
  /// @throws Error S011 unless low <= x <= high.
  /// @param range  the same in a user's units: "0.01 GPa to 1200 GPa".
  void require_material(double x, double low, double high,
                        const char* range) const;
  /// Three quantities [SI]. @throws also S005 if there are not three.
  Eigen::Vector3d vector(Dimension dimension) const;

  /// A unit vector of three numbers, normalised. @throws Error S006 if all are
  /// zero.
  Eigen::Vector3d direction() const;

  /// The choice that the text names. @throws Error S009 with the nearest one.
  template <typename Choice>
  Choice choice(std::initializer_list<std::pair<std::string_view, Choice>>
                    choices) const {
    return choice(std::vector(choices));
  }
  template <typename Choice>
  Choice choice(
      const std::vector<std::pair<std::string_view, Choice>>& choices) const;

  /// Elements of an array. @throws Error S005 if it is none.
  std::vector<Value> elements() const;
  /// As elements(), and exactly `count`.
  std::vector<Value> elements(std::size_t count) const;

  /// Entries of a table that is indexed by the user's own names, in the order
  /// of the file. @throws Error S005 if it is none.
  std::vector<std::pair<std::string, Value>> entries() const;

 private:
  [[noreturn]] void refuse_choice(
      const std::string& found,
      const std::vector<std::string_view>& choices) const;
  Error wrong_type(std::string_view needed) const;

  const toml::node* node_;
  std::string label_;
  const std::string* file_;
};

/// Whether a text may be a name of a part, joint, body or material.
bool is_name(std::string_view text);

/// Refuses a table key that is no name. @throws Error S006.
void require_name(const std::string& key, const Value& value);

template <typename Choice>
Choice Value::choice(
    const std::vector<std::pair<std::string_view, Choice>>& choices) const {
  const std::string found = text();
  std::vector<std::string_view> names;
  for (const auto& [name, meaning] : choices) {
    if (name == found) return meaning;
    names.push_back(name);
  }
  refuse_choice(found, names);
}

}  // namespace clevis::scene
