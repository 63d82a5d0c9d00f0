#pragma once

#include <span>
#include <string_view>

#include "app/request/command_options.h"

namespace clevis::app {

/// Ranks of mpirun that run a command; the others end at once.
enum class Ranks { kFirst, kAll };

/// What a command needs: matrices come and go by the megabyte, or not.
enum class Memory { kLittle, kMuch };

/// A command of clevis.
struct Command {
  const char* name;
  const char* about;                 ///< one line of --help
  Run (*declare)(CLI::App& parser);  ///< declares its options
  Memory memory = Memory::kLittle;
  Ranks ranks = Ranks::kFirst;
};

/// All commands, in the order of --help; also those of completion.
std::span<const Command> commands();

/// Null if there is none of this name.
const Command* find_command(std::string_view name);

}  // namespace clevis::app
