#pragma once

#include <string>
#include <string_view>

#include "base/messages/errors.h"

namespace clevis::app {

/// A refusal as a worker process hands it over, and back.
std::string encode_error(const Error& error);
Error decode_error(std::string_view text);

/// A refusal as one JSON document, as --json prints it.
std::string error_document(const Error& error);

}  // namespace clevis::app
