#include "calculix/deck.h"

#include <cctype>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace clevis::calculix {
namespace {

constexpr double kMillimetres = 1e3;                 // per metre
constexpr double kMegapascals = 1e-6;                // per pascal
constexpr double kNewtonsPerMillimetre = 1e-3;       // per N/m
constexpr double kTonnesPerCubicMillimetre = 1e-12;  // per kg/m³
constexpr double kNegligible = 1e-12;
// 13 digits: CalculiX reads no more than 20 characters of a number.

/// Upper case, as CalculiX reads names, unique, at most 70 characters.
std::string set_name(const std::string& name, std::set<std::string>& taken) {
  constexpr std::size_t kLongest = 70;
  std::string result;
  for (const char c : name.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    result += c != '_' && std::isalnum(byte) == 0
                  ? '_'
                  : static_cast<char>(std::toupper(byte));
  }
  const std::string base = result;
  for (int k = 2; !taken.insert(result).second; ++k) {
    result = fmt::format("{}_{}", base, k);
  }
  return result;
}

/// Numbers, 1 more than the indices, with at most 16 on a line.
void write_numbers(std::ostream& out, std::span<const int> indices) {
  constexpr std::size_t kPerLine = 16;
  for (std::size_t k = 0; k < indices.size(); ++k) {
    const bool ends = k + 1 == indices.size() || (k + 1) % kPerLine == 0;
    fmt::print(out, "{}{}", indices[k] + 1, ends ? "\n" : ", ");
  }
}

void write_elements(std::ostream& out, const Model& model) {
  // The element's number and 15 nodes fill the first line; a line that ends
  // in a comma is continued.
  constexpr std::size_t kFirst = 15;
  fmt::print(out, "*ELEMENT, TYPE={}, ELSET=EALL\n", model.element);
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    const auto& nodes = model.elements[e];
    fmt::print(out, "{}", e + 1);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      fmt::print(out, ",{}{}", k == kFirst ? "\n" : " ", nodes[k] + 1);
    }
    out << "\n";
  }
}

void write_groups(std::ostream& out, const Model& model) {
  std::set<std::string> taken;
  for (const Group& group : model.groups) {
    const std::string name = set_name(group.name, taken);
    fmt::print(out, "*NSET, NSET=N_{}\n", name);
    write_numbers(out, group.nodes);
    fmt::print(out, "*SURFACE, NAME=S_{}, TYPE=ELEMENT\n", name);
    for (const auto& face : group.faces) {
      fmt::print(out, "{}, S{}\n", face.element + 1, face.face);
    }
  }
}

/// Springs of one kind and stiffness share a set, as CalculiX wants one for
/// each stiffness.
void write_springs(std::ostream& out, const Model& model) {
  std::map<std::string, std::vector<const Spring*>> alike;
  for (const Spring& spring : model.springs) {
    const std::string degrees =
        spring.other < 0 ? fmt::format("{}", spring.component + 1)
                         : fmt::format("{}, {}", spring.component + 1,
                                       spring.other_component + 1);
    alike[fmt::format("{}\n{:.13g}\n", degrees,
                      kNewtonsPerMillimetre * spring.stiffness)]
        .push_back(&spring);
  }
  std::size_t number = model.elements.size(), set = 0;
  for (const auto& [law, springs] : alike) {
    const bool is_to_ground = springs.front()->other < 0;
    const std::string name = fmt::format("SPRINGS_{}", ++set);
    fmt::print(out, "*ELEMENT, TYPE=SPRING{}, ELSET={}\n", is_to_ground ? 1 : 2,
               name);
    for (const Spring* spring : springs) {
      fmt::print(out, "{}, {}", ++number, spring->node + 1);
      if (!is_to_ground) fmt::print(out, ", {}", spring->other + 1);
      out << "\n";
    }
    fmt::print(out, "*SPRING, ELSET={}\n{}", name, law);
  }
}

/// A label as a comment: control characters would end the line.
std::string comment(const std::string& label) {
  std::string result;
  for (const char c : label) {
    result += std::iscntrl(static_cast<unsigned char>(c)) != 0 ? ' ' : c;
  }
  return result;
}

void write_step(std::ostream& out, const Model& model, Eigen::Index step) {
  fmt::print(out, "** {}\n*STEP\n*STATIC\n*CLOAD, OP=NEW\n",
             comment(model.labels[static_cast<std::size_t>(step)]));
  const auto forces = model.loads.col(step);
  const double least = kNegligible * forces.cwiseAbs().maxCoeff();
  bool is_loaded = false;
  for (Eigen::Index dof = 0; dof < forces.size(); ++dof) {
    if (!(std::abs(forces[dof]) > least)) continue;
    is_loaded = true;
    fmt::print(out, "{}, {}, {:.13g}\n", dof / 3 + 1, dof % 3 + 1, forces[dof]);
  }
  // An empty *CLOAD is an error: say zero.
  if (!is_loaded) out << "1, 1, 0.\n";
  out << "*NODE FILE\nU\n*EL FILE\nS\n*END STEP\n";
}

}  // namespace

void write_deck(std::ostream& out, const Model& model) {
  fmt::print(out,
             "*HEADING\n{}, by clevis. Units: N, mm, MPa, t\n"
             "*NODE, NSET=NALL\n",
             comment(model.name));
  for (Eigen::Index n = 0; n < model.nodes.cols(); ++n) {
    const Eigen::Vector3d at = kMillimetres * model.nodes.col(n);
    fmt::print(out, "{}, {:.13g}, {:.13g}, {:.13g}\n", n + 1, at[0], at[1],
               at[2]);
  }
  write_elements(out, model);
  write_groups(out, model);
  fmt::print(out,
             "*MATERIAL, NAME=MATERIAL\n*ELASTIC\n{:.13g}, {:.13g}\n"
             "*DENSITY\n{:.13g}\n"
             "*SOLID SECTION, ELSET=EALL, MATERIAL=MATERIAL\n",
             kMegapascals * model.material.youngs_modulus,
             model.material.poissons_ratio,
             kTonnesPerCubicMillimetre * model.material.density);
  write_springs(out, model);
  if (!model.supports.empty()) out << "*BOUNDARY\n";
  for (const Support& support : model.supports) {
    fmt::print(out, "{}, {}, {}\n", support.node + 1, support.component + 1,
               support.component + 1);
  }
  for (Eigen::Index step = 0; step < model.loads.cols(); ++step) {
    write_step(out, model, step);
  }
}

}  // namespace clevis::calculix
