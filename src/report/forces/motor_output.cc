#include "report/forces/motor_output.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/text/csv_field.h"
#include "report/text/text_table.h"

namespace clevis::report {
namespace {

using mechanism::MotorState;
using nlohmann::ordered_json;

constexpr std::array<const char*, 12> kTitles{
    "rotor_rad_per_s", "torque_N_m",  "voltage_d_V", "voltage_q_V",
    "current_d_A",     "current_q_A", "electric_W",  "loss_W",
    "supplied_J",      "lost_J",      "given_J",     "stored_J"};

struct Summary {
  double speed{}, torque{}, current{};  ///< largest [rad/s], [N m], [A]
  MotorState last;
  double balance_error{};  ///< of the energy, over the largest part [1]
};

Summary summary(const mechanism::Motion& motion, std::size_t element) {
  Summary result;
  double largest = 0.0;
  for (const auto& instant : motion.instants) {
    const MotorState& m = *instant.elements[element].motor;
    result.speed = std::max(result.speed, std::abs(m.speed));
    result.torque = std::max(result.torque, std::abs(m.torque));
    result.current =
        std::max(result.current, std::hypot(m.current_d, m.current_q));
    const double gap = m.supplied - m.lost - m.given - m.stored;
    result.balance_error = std::max(result.balance_error, std::abs(gap));
    largest = std::max(
        {largest, std::abs(m.supplied), m.lost, std::abs(m.given), m.stored});
    result.last = m;
  }
  if (largest > 0.0) result.balance_error /= largest;
  return result;
}

}  // namespace

void add_motor_titles(std::string& text,
                      const mechanism::ForceElement& element) {
  if (!properties(element).is_motor) return;
  for (const char* title : kTitles) {
    text += ',';
    text += csv_field(fmt::format("{}.{}", name_of(element), title));
  }
}

std::array<double, 12> motor_values(const MotorState& m) {
  return {m.speed, m.torque, m.voltage_d, m.voltage_q, m.current_d, m.current_q,
          m.power, m.loss,   m.supplied,  m.lost,      m.given,     m.stored};
}

ordered_json motor_json(const MotorState& motor) {
  ordered_json json;
  const auto values = motor_values(motor);
  for (std::size_t i = 0; i < values.size(); ++i) json[kTitles[i]] = values[i];
  return json;
}

ordered_json motor_summary_json(const mechanism::Motion& motion,
                                std::size_t element) {
  const Summary s = summary(motion, element);
  return {{"peak_rotor_rad_per_s", s.speed},
          {"peak_torque_N_m", s.torque},
          {"peak_current_A", s.current},
          {"supplied_J", s.last.supplied},
          {"lost_J", s.last.lost},
          {"given_J", s.last.given},
          {"stored_J", s.last.stored},
          {"energy_balance_error", s.balance_error}};
}

std::string motors_text(const MotionReport& report, Colour colour) {
  TextTable table({{"motor"},
                   {"peak rotor rad/s", Align::kRight},
                   {"peak torque N m", Align::kRight},
                   {"peak current A", Align::kRight},
                   {"supplied J", Align::kRight},
                   {"lost J", Align::kRight},
                   {"energy balance", Align::kRight}});
  bool any = false;
  const auto& elements = report.definition.elements;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (!properties(elements[e]).is_motor) continue;
    const Summary s = summary(report.motion, e);
    any = true;
    table.add_row({{name_of(elements[e])},
                   {fmt::format("{:.5g}", s.speed)},
                   {fmt::format("{:.5g}", s.torque)},
                   {fmt::format("{:.5g}", s.current)},
                   {fmt::format("{:.5g}", s.last.supplied)},
                   {fmt::format("{:.5g}", s.last.lost)},
                   {fmt::format("{:.1e}", s.balance_error)}});
  }
  return any ? table.text(colour) : std::string();
}

}  // namespace clevis::report
