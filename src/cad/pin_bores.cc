#include "cad/pin_bores.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace clevis::cad {
namespace {

PinBore bore_of(std::vector<Cylinder> pieces) {
  const Cylinder& first = pieces.front();
  PinBore bore;
  bore.middle = first.point;
  bore.axis = first.axis;
  bore.diameter = 2 * first.radius;
  double low = 0.0, high = 0.0;  // from the first one's middle
  for (const Cylinder& piece : pieces) {
    const double at = first.axis.dot(piece.point - first.point);
    low = std::min(low, at - piece.length / 2);
    high = std::max(high, at + piece.length / 2);
    bore.length += piece.length;
    bore.wall += piece.wall;
  }
  bore.middle += (low + high) / 2 * first.axis;
  bore.extent = high - low;
  bore.pieces = std::move(pieces);
  return bore;
}

/// To the micrometre: what differs by less is meant equal.
std::array<long long, 4> rank(const PinBore& bore) {
  const auto micrometres = [](double length) {
    return std::llround(1e6 * length);
  };
  return {-micrometres(bore.diameter), micrometres(bore.middle.x()),
          micrometres(bore.middle.y()), micrometres(bore.middle.z())};
}

/// Of the hollow cylinders, whose ends of slots and fillets are left out.
std::vector<PinBore> hollow_bores(const Solid& solid) {
  constexpr double kLeast = 0.6;  // of a turn; the end of a slot is a half
  std::vector<Cylinder> hollow = cylinders_of(solid);
  std::erase_if(hollow, [](const Cylinder& cylinder) {
    return !cylinder.hollow || cylinder.angle < kLeast * 2 * std::numbers::pi;
  });
  std::vector<PinBore> bores;
  for (auto& pieces : by_axis(hollow)) {
    bores.push_back(bore_of(std::move(pieces)));
  }
  std::ranges::sort(bores, {}, rank);
  return bores;
}

}  // namespace

double PinBore::share() const {
  return wall.area / (std::numbers::pi * diameter * length);
}

bool PinBore::is_whole() const {
  return part::is_whole_wall({.p_LC = middle,
                              .axis_L = axis,
                              .radius = diameter / 2,
                              .length = extent},
                             wall);
}

bool PinBore::takes_pin() const {
  constexpr double kLeast = 0.6;  // cross bores and sloped ends count, too
  return std::ranges::all_of(pieces, &Cylinder::closes_about_pin) &&
         share() > kLeast;
}

std::vector<int> PinBore::faces() const {
  std::vector<int> numbers;
  for (const Cylinder& piece : pieces) {
    numbers.insert(numbers.end(), piece.faces.begin(), piece.faces.end());
  }
  std::ranges::sort(numbers);
  return numbers;
}

std::vector<PinBore> pin_bores(const Solid& solid) {
  std::vector<PinBore> found;
  for (PinBore& bore : hollow_bores(solid)) {
    if (!bore.takes_pin()) continue;
    const auto same = std::ranges::find_if(found, [&](const PinBore& other) {
      return are_coaxial(other.pieces.front(), bore.middle, bore.axis);
    });
    if (same == found.end()) {
      found.push_back(std::move(bore));
    } else if (bore.bearing_area() > same->bearing_area()) {
      *same = std::move(bore);
    }
  }
  std::ranges::sort(found, {}, rank);
  return found;
}

std::vector<PinBore> open_bores(const Solid& solid) {
  std::vector<PinBore> found = hollow_bores(solid);
  std::erase_if(found, &PinBore::takes_pin);
  return found;
}

}  // namespace clevis::cad
