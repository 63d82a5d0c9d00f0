#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "part/geometry_parameter.h"

namespace clevis::app {

/// Meshes a .geo with gmsh and returns the text of the .msh (4.1).
///
/// gmsh runs in a child process with fixed options, an empty folder as its
/// HOME and working folder and only PATH in its environment, so that neither
/// a user's options nor earlier runs matter: the same .geo gives the same
/// mesh. The folder is removed afterwards.
///
/// A last line without a newline is read whole, which gmsh (4.8.4) by itself
/// leaves out but for its first statement; where it names a file it is refused.
///
/// A .geo is a program: it can run shell commands. Call this only for a file
/// that the user asked to be meshed.
///
/// @param parameters  numbers in place of the .geo's DefineConstant.
/// @param timeout  gmsh and what it started are killed after this time.
/// @param program  name or path of gmsh.
/// @throws Error M010 with gmsh's first error line if gmsh is not there,
///   fails (else with its last line and how it ended), takes too long or writes
///   no mesh, or if its last line names a file and has no newline; I001 if the
///   .geo cannot be read.
std::string run_gmsh(
    const std::filesystem::path& geometry,
    const std::vector<part::GeometryParameter>& parameters = {},
    std::chrono::milliseconds timeout = std::chrono::seconds(120),
    const std::string& program = "gmsh");

}  // namespace clevis::app
