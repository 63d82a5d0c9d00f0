#include "report/variants/collection_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "report/text/text_table.h"

namespace clevis::report {
namespace {

using part::Verdict;

constexpr double kMegapascal = 1e6, kMillimetre = 1e-3;

TextTable empty_table(const Collection& collection) {
  std::vector<TextTable::Column> columns{{"variant"}};
  for (const std::string& path : collection.paths()) {
    columns.push_back({path, Align::kRight});
  }
  columns.insert(columns.end(), {{"mass kg", Align::kRight},
                                 {"part"},
                                 {"peak MPa", Align::kRight},
                                 {"band MPa"},
                                 {"safety", Align::kRight},
                                 {"defl. mm", Align::kRight},
                                 {"verdict"}});
  return TextTable(columns);
}

std::vector<TextTable::Cell> row_of(const Collection& collection,
                                    const Variant& variant) {
  std::vector<TextTable::Cell> row{{variant.name}};
  for (const std::string& path : collection.paths()) {
    row.push_back({setting_of(variant, path)});
  }
  if (variant.parts.empty()) {
    row.insert(row.end(), 6, {"-"});
    if (variant.is_known()) {  // bearings alone
      row.push_back(
          {std::string(text(variant.verdict)), tone_of(variant.verdict)});
    } else {
      row.push_back({"no result", Tone::kDoubtful});
    }
    return row;
  }
  const VariantPart& part = variant.governing();
  row.insert(
      row.end(),
      {{fmt::format("{:#.4g}", variant.mass())},
       {part.name},
       {fmt::format("{:#.4g}", part.peak.value / kMegapascal)},
       {fmt::format("[{:#.4g}, {:#.4g}]", part.peak.low / kMegapascal,
                    part.peak.high / kMegapascal)},
       {fmt::format("{:#.4g}", part.safety_factor)},
       {fmt::format("{:#.4g}", variant.largest_deflection() / kMillimetre)},
       {std::string(text(variant.verdict)), tone_of(variant.verdict)}});
  return row;
}

std::string counts(const Collection& collection) {
  const auto count = [&](bool known, Verdict verdict) {
    return std::ranges::count_if(collection.variants, [&](const Variant& v) {
      return v.is_known() == known && (!known || v.verdict == verdict);
    });
  };
  return fmt::format(
      "{} variants: {} pass, {} fail, {} not judged, {} without a result",
      collection.variants.size(), count(true, Verdict::kPass),
      count(true, Verdict::kFail), count(true, Verdict::kNotJudged),
      count(false, Verdict::kPass));
}

std::string lightest_text(const Collection& collection) {
  const Variant* lightest = collection.lightest();
  if (lightest == nullptr) return "no variant passes\n";
  std::string text = fmt::format("lightest that passes: {}, {:#.4g} kg\n",
                                 lightest->name, lightest->mass());
  for (const auto& [path, value] : lightest->settings) {
    text += fmt::format("  {} = {}\n", printable(path), printable(value));
  }
  return text;
}

}  // namespace

std::string collection_table(const Collection& collection, Colour colour) {
  TextTable table = empty_table(collection);
  for (const Variant& variant : collection.variants) {
    table.add_row(row_of(collection, variant));
    if (!variant.is_known()) table.add_note(variant.missing);
  }
  return fmt::format("{}, variants\n\n{}\n{}\n{}", printable(collection.scene),
                     table.text(colour), counts(collection),
                     lightest_text(collection));
}

}  // namespace clevis::report
