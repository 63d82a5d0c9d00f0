#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "assessment/job/part_result.h"
#include "part/part_definition.h"
#include "report/text/junit.h"

namespace clevis::report {

/// "buckling 2.31 [2.29, 2.32] at t = 1 s (Euler 1.22)"; empty if nothing is
/// known of it.
std::string buckling_text(const assessment::BucklingResult& buckling);

/// Null if nothing is known of it.
nlohmann::ordered_json buckling_json(
    const assessment::BucklingResult& buckling);
nlohmann::ordered_json finite_motion_json(
    const assessment::FiniteMotion& motion);

/// Columns of parts.csv: title and text.
std::vector<std::pair<std::string, std::string>> buckling_columns(
    const assessment::PartResult& part);

JunitCase buckling_case(const assessment::PartResult& part,
                        const part::Limits& limits);

}  // namespace clevis::report
