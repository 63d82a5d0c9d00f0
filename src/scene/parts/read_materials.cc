#include "scene/parts/read_materials.h"

#include <fmt/format.h>

#include "scene/text/names.h"

namespace clevis::scene {
namespace {

using part::Material;

// Nearer to -1 and 0.5 shear and bulk stiffness differ by more than what
// round-off leaves of the smaller one.
constexpr double kLeastRatio = -0.99;
constexpr double kLargestRatio = 0.4999999;

Material read_material(const std::string& name, StrictTable table) {
  Material material;
  material.name = name;
  material.youngs_modulus = table["youngs_modulus"].elastic_modulus();
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
  density.require_material(material.density, 10.0, 25000.0,
                           "10 kg/m^3 to 25000 kg/m^3");
  const Value yield = table["yield_strength"];
  material.yield_strength = yield.positive(Dimension::kStress);
  yield.require_material(material.yield_strength, 0.0, material.youngs_modulus,
                         "0 to Young's modulus");
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
