#include "app/solving/part_loads.h"

#include <ranges>
#include <string_view>

#include <fmt/format.h>

#include "loads/history/motion_instants.h"
#include "report/text/csv_field.h"

namespace clevis::app {
namespace {

constexpr std::string_view kEnd = "\r\n";

std::string titles(const std::string& quantity, std::string_view unit) {
  std::string text;
  for (const char component : {'x', 'y', 'z'}) {
    text += "," + report::csv_field(
                      fmt::format("{}_{} [{}]", quantity, component, unit));
  }
  return text;
}

std::string values(const Eigen::Vector3d& vector) {
  return fmt::format(",{},{},{}", vector.x(), vector.y(), vector.z());
}

std::string header(const loads::LoadHistory& history) {
  std::string text = "time [s]";
  for (const loads::Seat& seat : history.seats) {
    text += titles(seat.name + ".force", "N");
    text += titles(seat.name + ".moment", "N m");
  }
  for (const auto& load : history.instants.front().surface_loads) {
    text += "," + report::csv_field(load.group + ".pressure [Pa]");
  }
  text += titles("acceleration", "m/s^2");
  text += titles("angular_velocity", "rad/s");
  text += titles("angular_acceleration", "rad/s^2");
  return text.append(kEnd);
}

}  // namespace

std::string loads_csv(const loads::LoadHistory& history) {
  std::string text = header(history);
  for (const loads::InstantLoad& instant :
       history.instants | std::views::take(loads::motion_length(history))) {
    text += fmt::format("{}", instant.time);
    for (const loads::Wrench& wrench : instant.wrenches) {
      text += values(wrench.force) + values(wrench.moment);
    }
    for (const auto& load : instant.surface_loads) {
      text += fmt::format(",{}", load.pressure);
    }
    text += values(instant.rigid.acceleration) + values(instant.rigid.omega) +
            values(instant.rigid.alpha);
    text += kEnd;
  }
  return text;
}

}  // namespace clevis::app
