#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace clevis::elasticity {

/// Who solves the equations of plane stress and 3-D.
enum class Engine {
  kAuto,   ///< the cheaper one, as choose_engine() says
  kOwn,    ///< clevis' own factors and multigrid
  kDealii  ///< deal.II and PETSc
};

/// Words of `--engine`, in the order of Engine.
inline constexpr std::array<std::string_view, 3> kEngineWords = {"auto", "own",
                                                                 "dealii"};

constexpr std::string_view word_of(Engine engine) {
  return kEngineWords[static_cast<std::size_t>(engine)];
}

/// The engine that a word of `--engine` asks for; nothing if none has it.
constexpr std::optional<Engine> find_engine(std::string_view word) {
  for (std::size_t i = 0; i < kEngineWords.size(); ++i) {
    if (kEngineWords[i] == word) return static_cast<Engine>(i);
  }
  return std::nullopt;
}

/// The engine that solved, and why it was taken.
struct EngineChoice {
  Engine engine = Engine::kOwn;  ///< never kAuto
  std::string why;               ///< one line; empty: there was no choice
};

}  // namespace clevis::elasticity
