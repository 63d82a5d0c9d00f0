#include "report/variants/collection_csv.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/text/csv_field.h"

namespace clevis::report {
namespace {

constexpr double kMegapascal = 1e6, kMillimetre = 1e-3;

using Row = std::vector<std::string>;

void add_number(Row& row, double value, double unit = 1.0) {
  row.push_back(fmt::format("{:.9g}", value / unit));
}

void add_banded(Row& row, const Banded& banded, double unit) {
  for (const double value : {banded.value, banded.low, banded.high}) {
    add_number(row, value, unit);
  }
}

constexpr const char* kPartColumns[] = {
    "verdict",       "mass_kg",           "peak_MPa",
    "peak_low_MPa",  "peak_high_MPa",     "safety_factor",
    "deflection_mm", "deflection_low_mm", "deflection_high_mm"};

Row header(const Collection& collection) {
  Row row{"variant"};
  for (const std::string& path : collection.paths()) row.push_back(path);
  for (const char* name : {"verdict", "missing", "mass_kg", "governing_part",
                           "peak_MPa", "peak_low_MPa", "peak_high_MPa",
                           "safety_factor", "largest_deflection_mm"}) {
    row.emplace_back(name);
  }
  for (const std::string& part : collection.part_names()) {
    for (const char* name : kPartColumns) {
      row.push_back(fmt::format("{}_{}", part, name));
    }
  }
  return row;
}

void add_summary(Row& row, const Variant& variant) {
  constexpr std::size_t kColumns = 7;
  if (variant.parts.empty()) {
    row.resize(row.size() + kColumns);
    return;
  }
  const VariantPart& part = variant.governing();
  add_number(row, variant.mass());
  row.push_back(part.name);
  add_banded(row, part.peak, kMegapascal);
  add_number(row, part.safety_factor);
  add_number(row, variant.largest_deflection(), kMillimetre);
}

void add_part(Row& row, const Variant& variant, const std::string& name) {
  const auto part = std::ranges::find(variant.parts, name, &VariantPart::name);
  if (part == variant.parts.end()) {
    row.resize(row.size() + std::size(kPartColumns));
    return;
  }
  row.emplace_back(part::text(part->verdict));
  add_number(row, part->mass);
  add_banded(row, part->peak, kMegapascal);
  add_number(row, part->safety_factor);
  add_banded(row, part->deflection, kMillimetre);
}

std::string line(Row row) {
  std::ranges::transform(row, row.begin(), csv_field);
  return fmt::format("{}\n", fmt::join(row, ","));
}

}  // namespace

std::string collection_csv(const Collection& collection) {
  std::string csv = line(header(collection));
  const auto names = collection.part_names();
  for (const Variant& variant : collection.variants) {
    Row row{variant.name};
    for (const std::string& path : collection.paths()) {
      row.push_back(setting_of(variant, path));
    }
    row.emplace_back(variant.is_known() ? part::text(variant.verdict)
                                        : "no result");
    row.push_back(variant.missing);
    add_summary(row, variant);
    for (const std::string& name : names) add_part(row, variant, name);
    csv += line(row);
  }
  return csv;
}

}  // namespace clevis::report
