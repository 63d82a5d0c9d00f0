#include "mechanism/integration/law_breaks.h"

#include <algorithm>

#include "mechanism/drives/drive_law.h"

namespace clevis::mechanism {

LawBreaks::LawBreaks(const MechanismDefinition& definition,
                     const ForceModel& forces, double duration)
    : duration_(duration),
      times_(forces.breakpoint_times()),
      jumps_(drive_jumps(definition.drives, duration)) {
  for (const DriveDefinition& drive : definition.drives) {
    times_.push_back(drive.start);
    times_.push_back(drive.start + drive.duration);
    for (const double t : drive.table.times) {
      times_.push_back(drive.start + t);
    }
  }
  std::ranges::sort(times_);
}

double LawBreaks::after(double t) const {
  const auto next = std::ranges::upper_bound(times_, t);
  return next == times_.end() ? duration_ : *next;
}

bool LawBreaks::is_jump(double t) const {
  return std::ranges::find(jumps_, t, &DriveJump::t) != jumps_.end();
}

}  // namespace clevis::mechanism
