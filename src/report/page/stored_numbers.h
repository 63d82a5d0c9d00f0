#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "report/text/json_node.h"

namespace clevis::report {

/// Numbers that a view holds in base 64, whatever their type.
/// @throws Error I003.
std::vector<double> stored_numbers(const JsonNode& packed);

/// A packed field: points × instants, in the unit of its key.
/// @throws Error I003.
Eigen::MatrixXd stored_field(const JsonNode& field);

}  // namespace clevis::report
