#pragma once

#include <filesystem>
#include <optional>

#include "app/request/options.h"
#include "base/messages/errors.h"

namespace clevis::app {

/// If the folder of results holds a whole result of the same inputs, without a
/// part that could not be computed: tells it and returns its exit code.
/// @throws Error S…, I001 as check_inputs().
std::optional<ExitCode> finished_check(const Options& options);

/// Notes in the folder of results why there is none, for `clevis collect`.
void write_refusal(const Options& options, const Error& error);

}  // namespace clevis::app
