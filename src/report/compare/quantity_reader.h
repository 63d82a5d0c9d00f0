#pragma once

#include <optional>

#include "report/compare/stored_result.h"
#include "report/quantities/quantity.h"
#include "report/text/json_node.h"

namespace clevis::report {

/// Value at a row's key; absent where it may lack and does.
/// @param may_lack  as of the row; what was added later may, too.
/// @param node  the subject's.
/// @throws Error I003 if it is not of the row's kind, or lacks and may not.
std::optional<ResultValue> stored_value(const QuantityRow& row,
                                        QuantityKind kind, bool may_lack,
                                        const JsonNode& node);

/// Quantities of a subject for `compare`, by its rows.
/// @throws Error I003.
template <class Of>
Subject stored_subject(std::string name, const Quantities<Of>& rows,
                       const JsonNode& node) {
  Subject subject{std::move(name), {}};
  for (const Quantity<Of>& row : rows) {
    if (!row.compare) continue;
    const auto value = stored_value(row, row.kind, row.may_lack, node);
    if (value) subject.values[row.name] = *value;
  }
  return subject;
}

}  // namespace clevis::report
