#pragma once

#include <string>

#include "assessment/job/part_result.h"
#include "part/part_definition.h"
#include "report/text/junit.h"

namespace clevis::report {

/// "buckling 2.31 [2.29, 2.32] at t = 1 s (Euler 1.22)"; empty if nothing is
/// known of it.
std::string buckling_text(const assessment::BucklingResult& buckling);

JunitCase buckling_case(const assessment::PartResult& part,
                        const part::Limits& limits);

}  // namespace clevis::report
