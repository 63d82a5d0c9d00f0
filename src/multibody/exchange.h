#pragma once

#include <string>

#include "base/messages/errors.h"
#include "multibody/model.h"

namespace clevis::multibody {

/// As JSON in one line, which clevis-importer answers with.
std::string answer(const Model& model);
std::string refusal(const Error& error);

/// @throws Error as the importer refused; std::exception if the text is no
///   answer.
Model read_answer(const std::string& text);

}  // namespace clevis::multibody
