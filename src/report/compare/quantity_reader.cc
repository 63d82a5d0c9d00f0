#include "report/compare/quantity_reader.h"

#include <sstream>
#include <string>

namespace clevis::report {
namespace {

/// Ends of a band are keyed by their place in it.
bool is_index(const std::string& token) {
  return token == "0" || token == "1";
}

std::optional<JsonNode> find(const QuantityRow& row, bool may_lack,
                             JsonNode node) {
  std::istringstream tokens(row.key.substr(1));
  for (std::string token; std::getline(tokens, token, '/');) {
    if (is_index(token)) {
      node = node.element(std::stoul(token), 2);
    } else if (may_lack && !node.has(token.c_str())) {
      return std::nullopt;
    } else {
      node = node.at(token.c_str());
    }
  }
  return node;
}

}  // namespace

std::optional<ResultValue> stored_value(const QuantityRow& row,
                                        QuantityKind kind, bool may_lack,
                                        const JsonNode& node) {
  const std::optional<JsonNode> found =
      find(row, may_lack || row.since == Since::kLater, node);
  if (!found) return std::nullopt;
  switch (kind) {
    case QuantityKind::kNumber:
    case QuantityKind::kCount:
      return found->number();
    case QuantityKind::kFlag:
      return std::string(found->flag() ? "yes" : "no");
    case QuantityKind::kPoint:
      return found->numbers<3>();
    case QuantityKind::kText:
      break;
  }
  return found->text();
}

}  // namespace clevis::report
