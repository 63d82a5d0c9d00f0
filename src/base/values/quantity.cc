#include "base/values/quantity.h"

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <system_error>

#include <fmt/format.h>
#include <udunits2.h>

#include "base/messages/errors.h"

namespace clevis {
namespace {

struct DimensionEntry {
  std::string_view noun;
  const char* si_unit;
  std::string_view accepted;
};

const DimensionEntry& entry_of(Dimension dimension) {
  static constexpr auto kEntries = std::to_array<DimensionEntry>({
      {"length", "m", "mm, cm, m, um, in"},
      {"angle", "radian", "deg, rad, arcmin"},
      {"time", "s", "s, ms, min"},
      {"mass", "kg", "kg, g, t"},
      {"moment of inertia", "kg m^2", "kg m^2, g mm^2"},
      {"force", "N", "N, kN, MN, lbf"},
      {"torque", "N m", "N m, N mm, kN m"},
      {"stress", "Pa", "MPa, GPa, kPa, Pa, bar, N/mm^2"},
      {"density", "kg/m^3", "kg/m^3, g/cm^3"},
      {"velocity", "m/s", "m/s, mm/s"},
      {"acceleration", "m/s^2", "m/s^2, mm/s^2"},
      {"frequency", "1/s", "Hz, kHz, 1/s, 1/min"},
      {"angular velocity", "radian/s", "rpm, rad/s, deg/s"},
      {"angular acceleration", "radian/s^2", "rad/s^2, deg/s^2"},
      {"ratio", "1", "%, 1"},
      {"compliance", "m/N", "m/N, um/N, mm/kN"},
      {"angular compliance", "radian/(N m)", "rad/(N m), deg/(N m)"},
      {"stiffness", "N/m", "N/m, N/mm, kN/m"},
      {"angular stiffness", "N m/radian", "N m/rad, N m/deg"},
      {"damping", "N s/m", "N s/m, N s/mm"},
      {"angular damping", "N m s/radian", "N m s/rad"},
      {"inverse velocity", "s/m", "s/m, s/mm"},
      {"inverse angular velocity", "s/radian", "s/rad"},
      {"volume per force", "m^3/N", "mm^3/N, m^3/N"},
      {"area", "m^2", "mm^2, cm^2, m^2"},
      {"volume", "m^3", "mm^3, cm^3, m^3"},
      {"temperature", "K", "K"},
      {"specific heat", "J/(kg K)", "J/(kg K), kJ/(kg K)"},
      {"thermal conductance", "W/K", "W/K, mW/K"},
      {"volume flow", "m^3/s", "m^3/h, m^3/s"},
      {"sonic conductance", "m^3/(s Pa)", "m^3/(s Pa), m^3/(s bar)"},
      {"voltage", "V", "V, mV, kV"},
      {"resistance", "ohm", "ohm, mohm"},
      {"inductance", "H", "H, mH, uH"},
      {"magnetic flux", "Wb", "Wb, mWb, V s"},
      {"bedding", "N/m^3", "N/mm^3, MN/m^3, N/m^3"},
  });
  return kEntries.at(static_cast<std::size_t>(dimension));
}

/// A unit as a multiple of base units, by udunits2's visitor.
struct UnitContent {
  double scale = 1.0;
  bool is_proportional = true;  ///< false for °C, decibel, dates
  std::map<std::string, int, std::less<>> powers;  ///< radian included

  bool operator==(const UnitContent& other) const {
    return is_proportional && other.is_proportional && powers == other.powers;
  }
};

extern "C" {

ut_status visit_basic(const ut_unit* unit, void* content) {
  ++static_cast<UnitContent*>(content)->powers[ut_get_symbol(unit, UT_ASCII)];
  return UT_SUCCESS;
}

ut_status visit_product(const ut_unit*, int count,
                        const ut_unit* const* basic_units, const int* powers,
                        void* content) {
  for (int i = 0; i < count; ++i) {
    static_cast<UnitContent*>(content)
        ->powers[ut_get_symbol(basic_units[i], UT_ASCII)] += powers[i];
  }
  return UT_SUCCESS;
}

ut_status visit_galilean(const ut_unit*, double scale,
                         const ut_unit* underlying, double offset,
                         void* content);

ut_status visit_timestamp(const ut_unit*, const ut_unit*, double,
                          void* content) {
  static_cast<UnitContent*>(content)->is_proportional = false;
  return UT_SUCCESS;
}

ut_status visit_logarithmic(const ut_unit*, double, const ut_unit*,
                            void* content) {
  static_cast<UnitContent*>(content)->is_proportional = false;
  return UT_SUCCESS;
}

}  // extern "C"

constexpr ut_visitor kVisitor{visit_basic, visit_product, visit_galilean,
                              visit_timestamp, visit_logarithmic};

extern "C" ut_status visit_galilean(const ut_unit*, double scale,
                                    const ut_unit* underlying, double offset,
                                    void* content) {
  auto* unit_content = static_cast<UnitContent*>(content);
  unit_content->scale *= scale;
  unit_content->is_proportional &= offset == 0.0;
  return ut_accept_visitor(underlying, &kVisitor, content);
}

/// The unit database, read at the first use and kept for the process.
ut_system* unit_system() {
  static ut_system* const kSystem = [] {
    ut_set_error_message_handler(ut_ignore);
    ut_system* system = ut_read_xml(nullptr);
    if (system == nullptr) {
      throw Error("I001", "unit database of udunits2",
                  "the file udunits2.xml cannot be read",
                  "Install libudunits2-data, or let UDUNITS2_XML_PATH name "
                  "the file.");
    }
    // udunits2 knows "degree" and "°" but not what engineers write.
    ut_unit* degree = ut_get_unit_by_name(system, "degree");
    ut_map_name_to_unit("deg", UT_ASCII, degree);
    ut_free(degree);
    return system;
  }();
  return kSystem;
}

/// @return content with is_proportional = false if `text` is no unit.
UnitContent parse_unit(const std::string& text) {
  UnitContent content;
  ut_unit* unit = ut_parse(unit_system(), text.c_str(), UT_UTF8);
  if (unit == nullptr ||
      ut_accept_visitor(unit, &kVisitor, &content) != UT_SUCCESS) {
    content.is_proportional = false;
  }
  ut_free(unit);
  std::erase_if(content.powers, [](const auto& power) {
    return power.second == 0;
  });
  return content;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  const auto last = text.find_last_not_of(" \t");
  return first == text.npos ? "" : text.substr(first, last - first + 1);
}

/// Units are short and start with no number but "1/": udunits2 itself would
/// take "2 mm" for a unit, read "140 2 mm" as 280 mm, and stop at \xff.
bool looks_like_unit(std::string_view text) {
  constexpr std::size_t kLongest = 48;
  if (text == "1") return true;
  if (text.starts_with("1/")) text.remove_prefix(2);
  return text.size() <= kLongest && text.find_first_of("0123456789+-.@") != 0 &&
         text.find_first_of(std::string_view("\0\n\r@\xff", 5)) == text.npos;
}

/// Of "8,5 mm" what is behind the 8.
bool has_decimal_comma(std::string_view rest) {
  return rest.size() > 1 && rest[0] == ',' && rest[1] >= '0' && rest[1] <= '9';
}

}  // namespace

std::string_view accepted_units(Dimension dimension) {
  return entry_of(dimension).accepted;
}

double parse_quantity(std::string_view text, Dimension dimension,
                      const std::string& place) {
  const DimensionEntry& entry = entry_of(dimension);
  const auto refuse = [&](std::string_view code, std::string_view problem) {
    return Error(code, place, fmt::format("\"{:.60}\" {}", text, problem),
                 fmt::format("Write a number with a unit of {}: {}.",
                             entry.noun, entry.accepted));
  };

  std::string_view rest = trimmed(text);
  if (rest.starts_with('+')) rest.remove_prefix(1);
  double number{};
  const auto [end, failure] =
      std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (failure == std::errc::invalid_argument) {
    throw refuse("S004", "does not start with a number");
  }
  if (failure == std::errc::result_out_of_range || !std::isfinite(number)) {
    throw refuse("S006", "is not a finite number");
  }
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  const std::string unit_text(trimmed(rest));
  if (unit_text.empty()) throw refuse("S004", "has no unit");
  if (has_decimal_comma(unit_text)) {
    throw refuse("S004", "has a comma where a decimal point belongs");
  }
  const auto unknown = [&] {
    return refuse("S004",
                  fmt::format("has no known unit: \"{:.60}\"", unit_text));
  };
  if (!looks_like_unit(unit_text)) throw unknown();
  const UnitContent unit = parse_unit(unit_text);
  if (!unit.is_proportional) throw unknown();
  if (!(unit == parse_unit(entry.si_unit))) {
    throw refuse("S004", fmt::format("is not of the dimension {}", entry.noun));
  }
  const double value = number * unit.scale;
  if (!std::isfinite(value)) throw refuse("S006", "is not a finite number");
  return value;
}

}  // namespace clevis
