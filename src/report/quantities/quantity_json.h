#pragma once

#include <nlohmann/json.hpp>

#include "report/quantities/quantity.h"

namespace clevis::report {

/// Treatment of keys without a value.
enum class Unknown {
  kNull,     ///< null; an object or list of nothing else as a whole
  kLeftOut,  ///< no key
};

/// In the unit of files; null if it is not known.
nlohmann::ordered_json json_value(const QuantityValue& value,
                                  const std::string& unit);

/// Puts a value in its place in an object.
/// @param key  JSON pointer.
void put(const std::string& key, nlohmann::ordered_json value,
         nlohmann::ordered_json& object);

/// Puts null in the place of each object and list that holds nothing else.
void fold_nulls(nlohmann::ordered_json& document);

/// A subject's quantities as a JSON object, units in the keys.
template <class Subject>
nlohmann::ordered_json quantities_json(const Subject& subject,
                                       const Quantities<Subject>& rows,
                                       Unknown unknown = Unknown::kNull) {
  auto object = nlohmann::ordered_json::object();
  for (const Quantity<Subject>& row : rows) {
    auto value = json_value(row.get(subject), row.unit);
    if (value.is_null() && unknown == Unknown::kLeftOut) continue;
    put(row.key, std::move(value), object);
  }
  for (auto& [key, value] : object.items()) fold_nulls(value);
  return object;
}

}  // namespace clevis::report
