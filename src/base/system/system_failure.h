#pragma once

#include <exception>
#include <string>

#include "base/messages/errors.h"

namespace clevis {

/// Memory, processes or processor time that ran out: X002.
Error out_of_resources(const std::string& place, const std::string& what);

/// A library of clevis' own that could not be loaded: X002 if for want of
/// memory, else I001. @param reason  dlerror().
Error load_failure(const std::string& library, const std::string& reason);

/// What a library or the system threw, as a refusal: X002 of memory and
/// processes that ran out, I001 of paths, else X001.
/// @param place  where no path says more.
Error system_failure(const std::exception& failure, const std::string& place);

}  // namespace clevis
