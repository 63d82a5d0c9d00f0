#include "report/quantities/quantity.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numbers>

#include "report/text/units.h"

namespace clevis::report {
namespace {

struct UnitOfFiles {
  std::string_view name;
  double (*from_si)(double);
};

double same(double value) {
  return value;
}

constexpr auto kUnits = std::to_array<UnitOfFiles>({
    {"1", same},
    {"kg", same},
    {"s", same},
    {"N", same},
    {"Nm", same},
    {"J", same},
    {"Hz", same},
    {"m/s", same},
    {"rad/s", same},
    {"MPa", megapascals},
    {"mm",
     [](double metres) {
       return millimetres(metres);
     }},
    {"mJ", millijoules},
    {"h",
     [](double seconds) {
       return seconds / 3600.0;
     }},
    {"%",
     [](double share) {
       return 100.0 * share;
     }},
    {"deg",
     [](double radians) {
       return radians * 180.0 / std::numbers::pi;
     }},
});

}  // namespace

double in_unit(double value, std::string_view unit) {
  const auto found = std::ranges::find(kUnits, unit, &UnitOfFiles::name);
  assert(found != kUnits.end() && "unit that files do not use");
  return found->from_si(value);
}

}  // namespace clevis::report
