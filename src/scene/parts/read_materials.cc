#include "scene/parts/read_materials.h"

#include <fmt/format.h>

#include "scene/text/names.h"

namespace clevis::scene {
namespace {

using part::Material;

/// @throws Error S011 unless low <= x <= high.
void require_plausible(double x, double low, double high, const Value& value,
                       const char* range) {
  if (low <= x && x <= high) return;
  throw value.refusal(
      "S011",
      fmt::format("= \"{}\" is outside {}, the range of real materials",
                  value.text(), range),
      "Check the number and its unit.");
}

// Nearer to -1 and 0.5 shear and bulk stiffness differ by more than what
// round-off leaves of the smaller one.
constexpr double kLeastRatio = -0.99;
constexpr double kLargestRatio = 0.4999999;

Material read_material(const std::string& name, StrictTable table) {
  Material material;
  material.name = name;
  const Value modulus = table["youngs_modulus"];
  material.youngs_modulus = modulus.positive(Dimension::kStress);
  require_plausible(material.youngs_modulus, 1e7, 1.2e12, modulus,
                    "0.01 GPa to 1200 GPa");
  const Value ratio = table["poissons_ratio"];
  material.poissons_ratio = ratio.number(-1.0, 0.5);
  if (material.poissons_ratio == -1.0 || material.poissons_ratio == 0.5) {
    throw ratio.refusal("S006", "makes the stiffness infinite",
                        "Poisson's ratio lies between -1 and 0.5, both "
                        "excluded.");
  }
  if (material.poissons_ratio < kLeastRatio ||
      material.poissons_ratio > kLargestRatio) {
    throw ratio.refusal(
        "S011",
        fmt::format("= {} is outside {} to {}, where double precision can "
                    "tell the stiffnesses apart",
                    material.poissons_ratio, kLeastRatio, kLargestRatio),
        "Rubber has 0.499 to 0.4999; foams reach -0.7.");
  }
  const Value density = table["density"];
  material.density = density.positive(Dimension::kDensity);
  require_plausible(material.density, 10.0, 25000.0, density,
                    "10 kg/m^3 to 25000 kg/m^3");
  const Value yield = table["yield_strength"];
  material.yield_strength = yield.positive(Dimension::kStress);
  require_plausible(material.yield_strength, 0.0, material.youngs_modulus,
                    yield, "0 to Young's modulus");
  return material;
}

}  // namespace

std::vector<Material> read_materials(StrictTable& root, Names& names) {
  std::vector<Material> materials;
  const auto tables = root.find("material");
  if (!tables) return materials;
  for (const auto& [name, value] : tables->entries()) {
    require_name(name, value);
    names.materials.add(name, value);
    materials.push_back(read_material(name, {value, "material"}));
  }
  return materials;
}

}  // namespace clevis::scene
