#include "cad/pin_bores.h"

#include <algorithm>
#include <array>
#include <cmath>
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
  }
  bore.middle += (low + high) / 2 * first.axis;
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

}  // namespace

std::vector<int> PinBore::faces() const {
  std::vector<int> numbers;
  for (const Cylinder& piece : pieces) {
    numbers.insert(numbers.end(), piece.faces.begin(), piece.faces.end());
  }
  std::ranges::sort(numbers);
  return numbers;
}

std::vector<PinBore> pin_bores(const Solid& solid) {
  std::vector<Cylinder> round = cylinders_of(solid);
  std::erase_if(round, [](const Cylinder& cylinder) {
    return !cylinder.hollow || !cylinder.is_round();
  });
  std::vector<PinBore> found;
  for (auto& pieces : by_axis(round)) {
    PinBore bore = bore_of(std::move(pieces));
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

}  // namespace clevis::cad
