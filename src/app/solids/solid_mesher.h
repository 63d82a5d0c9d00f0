#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "cad/exchange.h"

namespace clevis::app {

/// The program's name, beside clevis or in lib/clevis.
inline constexpr const char* kMesher = "clevis-mesher";

/// That the mesher is given by the clock.
inline constexpr std::chrono::seconds kMostToMesh{120};

/// What the mesher found, and the .msh if one was asked for.
struct MesherAnswer {
  cad::Solid solid;
  std::string mesh;
};

/// Reads a CAD file, and meshes it if `request.mesh` names a file, by the
/// program clevis-mesher: a child process with limits of time and memory, an
/// empty folder as its HOME and working folder and hardly any environment. The
/// file's head is looked at before; nothing in it is ever run.
/// @param timeout  the child is killed after this time.
/// @param memory  address space of the child [byte].
/// @throws Error M015, I001 of the file's head; as the mesher refuses; M010
///   if it takes too long, more memory or dies.
MesherAnswer run_mesher(cad::Request request,
                        std::chrono::milliseconds timeout = kMostToMesh,
                        std::size_t memory = std::size_t{4} << 30,
                        const std::filesystem::path& program = {});

}  // namespace clevis::app
