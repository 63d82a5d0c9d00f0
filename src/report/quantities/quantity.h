#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "report/quantities/tolerance_rule.h"

namespace clevis::report {

/// A value of a result in SI; without one it is not known.
using QuantityValue = std::variant<std::monostate, double, int, bool,
                                   std::string, Eigen::Vector3d>;

enum class QuantityKind { kNumber, kCount, kFlag, kText, kPoint };

/// Whether every file of the schema has it, or those written before it was
/// added lack it.
enum class Since { kSchema, kLater };

/// All that files and `clevis compare` know of one scalar of a result.
struct QuantityRow {
  /// Of `compare`, unique within its subject; the same name has the same unit
  /// and rule with every subject.
  std::string name;
  std::string key;     ///< JSON pointer from the subject: "/beam/deflection_mm"
  std::string unit{};  ///< of files; "1": a pure number; empty: text or count
  std::string column{};           ///< of the CSV, without unit; empty: none
  std::optional<Rule> compare{};  ///< absent: `compare` leaves it alone
  Since since = Since::kSchema;
};

/// A row of the table of a subject's quantities.
template <class Subject>
struct Quantity : QuantityRow {
  QuantityKind kind{};
  bool may_lack{};  ///< null in result.json where it is not known
  std::function<QuantityValue(const Subject&)> get;
};

template <class Subject>
using Quantities = std::vector<Quantity<Subject>>;

namespace detail {

template <class T>
struct WithoutOptional {
  using type = T;
  static constexpr bool may_lack = false;
};
template <class T>
struct WithoutOptional<std::optional<T>> {
  using type = T;
  static constexpr bool may_lack = true;
};

template <class T>
constexpr QuantityKind kind_of() {
  if constexpr (std::is_same_v<T, double>) return QuantityKind::kNumber;
  if constexpr (std::is_same_v<T, int>) return QuantityKind::kCount;
  if constexpr (std::is_same_v<T, bool>) return QuantityKind::kFlag;
  if constexpr (std::is_same_v<T, Eigen::Vector3d>) return QuantityKind::kPoint;
  return QuantityKind::kText;
}

template <class T>
QuantityValue value_of(const T& value) {
  if constexpr (WithoutOptional<T>::may_lack) {
    return value ? value_of(*value) : QuantityValue();
  } else if constexpr (kind_of<T>() == QuantityKind::kText) {
    return std::string(value);
  } else {
    return value;
  }
}

}  // namespace detail

/// @param get  of a subject its value in SI, a text, a flag or a count; an
///   optional where it may be unknown. A member or a function.
template <class Subject, class Get>
Quantity<Subject> quantity(QuantityRow row, Get get) {
  using Value = std::decay_t<std::invoke_result_t<Get, const Subject&>>;
  using Known = detail::WithoutOptional<Value>;
  return {std::move(row), detail::kind_of<typename Known::type>(),
          Known::may_lack, [get](const Subject& subject) {
            return detail::value_of<Value>(std::invoke(get, subject));
          }};
}

template <class Subject>
void append(Quantities<Subject> rows, Quantities<Subject>& to) {
  for (Quantity<Subject>& row : rows) to.push_back(std::move(row));
}

/// Rows of something that a subject holds as rows of the subject.
/// @param prefix  JSON pointer to it.
/// @param member  of a subject a pointer to it, null where it has none.
/// @param may_lack  whether it may have none.
template <class Subject, class Held, class Member>
void add_rows_of(const Quantities<Held>& rows, const std::string& prefix,
                 bool may_lack, Member member, Quantities<Subject>& to) {
  for (const Quantity<Held>& row : rows) {
    Quantity<Subject> lifted{row, row.kind, row.may_lack || may_lack,
                             [member, get = row.get](const Subject& subject) {
                               const Held* held = member(subject);
                               return held ? get(*held) : QuantityValue();
                             }};
    lifted.key = prefix + row.key;
    to.push_back(std::move(lifted));
  }
}

/// The rows of a member that every subject has.
template <class Subject, class Held>
void add_member_rows(const Quantities<Held>& rows, const std::string& prefix,
                     Held Subject::*member, Quantities<Subject>& to) {
  add_rows_of(
      rows, prefix, false,
      [member](const Subject& subject) {
        return &(subject.*member);
      },
      to);
}

/// From SI; units are those of result.json: "MPa", "mm", "deg", "percent" …
/// @pre `unit` is known, SI or "1".
double in_unit(double value, std::string_view unit);

}  // namespace clevis::report
