#include "mechanism/force_elements/breakaway.h"

#include <variant>

namespace clevis::mechanism {

double sudden_breakaway(const ForceElement& element) {
  const auto* line = std::get_if<LineElement>(&element);
  const auto* law = line ? std::get_if<FrictionLaw>(&line->law) : nullptr;
  if (!law || law->model == FrictionModel::kLuGre ||
      law->stribeck_speed > 0.0 || !(law->breakaway > law->kinetic)) {
    return 1.0;
  }
  return law->breakaway / law->kinetic;
}

}  // namespace clevis::mechanism
