#include "machine/devices/slide_lever_closed_form.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace clevis::machine {

SlideLeverPosition slide_lever_position(const SlideLever& lever, double l_x,
                                        SlideLeverForm form) {
  // the source's symbols
  const double l1 = lever.FD, l2 = lever.ED, l3 = lever.DC, l4 = lever.EC;
  const double l5 = lever.AD;
  assert(l_x > std::abs(l1 - l2) && l_x < l1 + l2 && lever.DD1 <= l1 &&
         "the triangle FED does not close");
  SlideLeverPosition p;
  p.q1 = std::acos((l1 * l1 + l2 * l2 - l_x * l_x) / (2.0 * l1 * l2));
  p.q2 = std::acos(lever.DD1 / l1);
  p.q3 = p.q1 - p.q2;
  p.q4 = std::numbers::pi - p.q3;
  p.q5 = std::acos((l2 * l2 + l4 * l4 - l3 * l3) / (2.0 * l2 * l4));
  p.q7 = p.q3 - p.q5;
  const double sign = form == SlideLeverForm::kPublished ? 1.0 : -1.0;
  p.C = {l2 * std::cos(p.q4) + l4 * std::cos(p.q7),
         l5 + l2 * std::sin(p.q4) + sign * l4 * std::sin(p.q7)};
  p.DC = (p.C - Eigen::Vector2d(0.0, l5)).norm();
  p.J << -l2 * std::sin(p.q4), -l4 * std::sin(p.q7),  //
      l2 * std::cos(p.q4), sign * l4 * std::cos(p.q7);
  const double q3_rate = l_x / (l1 * l2 * std::sin(p.q1));
  p.C_rate = p.J * Eigen::Vector2d(-q3_rate, q3_rate);
  return p;
}

}  // namespace clevis::machine
