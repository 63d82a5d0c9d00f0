#include "report/quantities/quantity_json.h"

#include <algorithm>
#include <utility>

namespace clevis::report {
namespace {

using nlohmann::ordered_json;

struct ToJson {
  std::string_view unit;

  ordered_json operator()(std::monostate) const { return {}; }
  ordered_json operator()(double value) const { return in_unit(value, unit); }
  ordered_json operator()(const Eigen::Vector3d& point) const {
    return {in_unit(point.x(), unit), in_unit(point.y(), unit),
            in_unit(point.z(), unit)};
  }
  template <class T>
  ordered_json operator()(const T& value) const {
    return value;
  }
};

}  // namespace

ordered_json json_value(const QuantityValue& value, const std::string& unit) {
  return std::visit(ToJson{unit}, value);
}

void put(const std::string& key, ordered_json value, ordered_json& object) {
  object[ordered_json::json_pointer(key)] = std::move(value);
}

void fold_nulls(ordered_json& document) {
  if (!document.is_structured() || document.empty()) return;
  for (auto& [key, value] : document.items()) fold_nulls(value);
  if (std::ranges::all_of(document, &ordered_json::is_null)) {
    document = nullptr;
  }
}

}  // namespace clevis::report
