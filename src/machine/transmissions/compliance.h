#pragma once

#include <string>
#include <variant>
#include <vector>

namespace clevis::machine {

// Elements of a drive train whose compliance a formula gives:
// [DriveLectures] (5.54)–(5.59).

/// Bar pulled along its axis.
struct Bar {
  double length{}, area{};  ///< [m], [m²]
  double youngs_modulus{};  ///< [Pa]
};

/// Round shaft in torsion.
struct Shaft {
  double length{}, diameter{};  ///< [m]
  double bore{};                ///< [m]; 0: solid
  double shear_modulus{};       ///< [Pa]
};

/// Keys or splines between shaft and hub.
struct Key {
  double diameter{}, length{}, height{};  ///< of the shaft, the key [m]
  int count = 1;
  double constant{};  ///< K of its form [m³/N]
  bool spline = false;
};

/// A pair of gears, seen from the wheel whose pitch radius is given.
struct GearTeeth {
  double radius{}, width{};  ///< [m]
  double modulus{};          ///< K_M of the material [Pa]
};

/// Turns of a thread.
struct Thread {
  double diameter{}, root_diameter{};  ///< [m]
  double constant{};                   ///< K_p of the material [m³/N]
};

/// Screw and nut with balls.
struct BallScrew {
  double circle_diameter{}, ball_diameter{};  ///< of the balls [m]
  double turns{};                             ///< that carry
  double preload{};                           ///< [N]
  double class_factor{};                      ///< K_R of the accuracy class
};

struct GivenCompliance {
  double value{};       ///< [m/N] or [rad/(N m)]
  bool angular = true;  ///< the latter
};

struct CompliantElement;

/// Elements that share a load (parallel) or carry the same one (series).
struct ElementGroup {
  bool parallel{};
  std::vector<CompliantElement> elements;
};

struct CompliantElement {
  std::string name;
  std::variant<Bar, Shaft, Key, GearTeeth, Thread, BallScrew, GivenCompliance,
               ElementGroup>
      law;
  std::string place;  ///< file:line:column
};

/// Unit of [DriveLectures] (5.59): mm/N is printed; exponents and values are
/// those of µm/N.
enum class BallScrewUnit { kCorrected, kPublished };

/// [m/N] or [rad/(N m)].
/// @pre lengths, moduli > 0; groups not empty and of one kind.
double compliance(const CompliantElement& element,
                  BallScrewUnit unit = BallScrewUnit::kCorrected);

/// Whether the element turns [rad/(N m)], else it moves along a line [m/N].
bool is_angular(const CompliantElement& element);

/// "shaft", and its formula, for tables.
const char* type_name(const CompliantElement& element);
const char* formula(const CompliantElement& element);

}  // namespace clevis::machine
