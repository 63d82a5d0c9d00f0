#pragma once

#include "base/messages/errors.h"

namespace clevis::app {

enum class ErrorFormat { kText, kJson };

/// Two lines on stderr, the first "error[S002]: file:3:1: problem", the second
/// the remedy; with kJson also error_document() on stdout.
void print_error(const Error& error, ErrorFormat format);

}  // namespace clevis::app
