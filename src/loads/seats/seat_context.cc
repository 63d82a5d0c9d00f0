#include "loads/seats/seat_context.h"

#include <fmt/format.h>

namespace clevis::loads {

std::string SeatContext::place(const std::string& seat) const {
  return fmt::format("{}: part {}, {}", part.place, part.name, seat);
}

}  // namespace clevis::loads
