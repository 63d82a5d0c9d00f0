#include "app/start/first_case_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace clevis::app {
namespace {

using Eigen::Vector3d;

constexpr double kPressure = 10e6;  // [Pa]
constexpr double kKilo = 1e3, kMega = 1e6;
/// Below this share a component is none. Balance leaves 1e-3 of the load.
constexpr double kNoShare = 2e-4;

/// A number and its unit.
struct Amount {
  double value{};
  const char* unit;

  std::string text() const { return fmt::format("{:g} {}", value, unit); }
};

/// To one digit: it is seen to stand for another number.
Amount force_on(const cad::PinBore& bore) {
  const double force = kPressure * bore.bearing_area();
  const double step = std::pow(10.0, std::floor(std::log10(force)));
  const double value = std::round(force / step) * step;
  return value < kKilo ? Amount{value, "N"} : Amount{value / kKilo, "kN"};
}

Vector3d cleaned(const Vector3d& direction) {
  return direction.unaryExpr([](double share) {
    return std::abs(share) < kNoShare ? 0.0 : share;
  });
}

/// As a scene has it, with digits that leave no moment about a pin.
std::string vector_text(const Amount& amount, const Vector3d& direction) {
  std::string list;
  for (const double share : cleaned(direction)) {
    list += fmt::format("{}\"{:.7g} {}\"", list.empty() ? "" : ", ",
                        amount.value * share, amount.unit);
  }
  return "[" + list + "]";
}

/// "3 kN"; where that is not along an axis "3 kN along (0.6, 0.8, 0)".
std::string text_along(const Amount& amount, const Vector3d& direction) {
  const Vector3d d = cleaned(direction);
  if (d.cwiseAbs().maxCoeff() > 1.0 - kNoShare) return amount.text();
  return fmt::format("{} along ({:.7g}, {:.7g}, {:.7g})", amount.text(), d.x(),
                     d.y(), d.z());
}

constexpr const char* kBed =
    R"(# "{0}" stands on a bed as stiff as 100 mm of steel. It pulls as it presses.
foundation = {{ {0} = {{ normal = "2100 N/mm^3", tangential = "800 N/mm^3" }} }}
)";

constexpr const char* kForce =
    R"(# CHANGE the force to yours: x, y, z on the part, in the file's frame.
# {} is some 10 MPa on diameter times length of the bore.
)";

FirstCaseText between_bores(const cad::FirstCase& made) {
  const std::string held = bore_name(*made.held);
  const std::string pulled = bore_name(*made.pulled);
  const cad::PinBore& smaller =
      std::min(made.bores[*made.held], made.bores[*made.pulled],
               [](const cad::PinBore& a, const cad::PinBore& b) {
                 return a.bearing_area() < b.bearing_area();
               });
  const Amount force = force_on(smaller);
  return {
      fmt::format(
          "# The pin in {0} holds, the pin in {1} pulls away from it.\n"
          "{2}"
          "# It points through the axis of {0}, about which a pin takes "
          "no moment.\n"
          "[[part.case]]\nname = \"pull\"\npins = {{ {1} = {3} }}\n"
          "held_by_pin = [\"{0}\"]\n",
          held, pulled, fmt::format(kForce, text_along(force, made.direction)),
          vector_text(force, made.direction)),
      fmt::format("{} held by its pin, {} pulled by {} in place of your force",
                  held, pulled, force.text())};
}

FirstCaseText off_base(const cad::FirstCase& made) {
  const std::string pulled = bore_name(*made.pulled);
  const Amount force = force_on(made.bores[*made.pulled]);
  return {
      fmt::format("# The face \"{0}\" holds, the pin in {1} pulls.\n{2}"
                  "[[part.case]]\nname = \"pull\"\npins = {{ {1} = {3} }}\n",
                  kBase, pulled,
                  fmt::format(kForce, text_along(force, made.direction)),
                  vector_text(force, made.direction)) +
          fmt::format(kBed, kBase),
      fmt::format("a plane face held, {} pulled by {} in place of your force",
                  pulled, force.text())};
}

FirstCaseText between_ends(const cad::FirstCase& made) {
  const Amount traction{kPressure / kMega, "MPa"};
  return {
      fmt::format("# The face \"{0}\" holds, the face \"{1}\" is pulled.\n"
                  "# CHANGE the traction to yours: force over area, in the "
                  "file's frame.\n"
                  "[[part.case]]\nname = \"pull\"\n"
                  "traction = {{ {1} = {2} }}\n",
                  kBase, kEnd, vector_text(traction, made.direction)) +
          fmt::format(kBed, kBase),
      fmt::format("a plane face held, the one across from it pulled by {} in "
                  "place of your load",
                  traction.text())};
}

}  // namespace

std::string bore_name(std::size_t bore) {
  return fmt::format("bore_{}", static_cast<char>('A' + bore));
}

FirstCaseText first_case_text(const cad::FirstCase& made) {
  if (made.end) return between_ends(made);
  return made.held ? between_bores(made) : off_base(made);
}

}  // namespace clevis::app
