#include "scene/variants/design.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "base/values/index.h"

namespace clevis::scene {
namespace {

constexpr std::size_t kMostVariants = 100'000;

/// So many that values of the range stay apart.
int digits_of(const VariedRange& range) {
  constexpr int kUsual = 6, kOfDoubles = 17;
  constexpr double kApart = 1e-4;  // of the range
  const double largest = std::max(std::abs(range.from), std::abs(range.to));
  const double step = kApart * std::abs(range.to - range.from);
  if (!(step > 0.0) || !(largest > 0.0)) return kUsual;
  return std::clamp(1 + static_cast<int>(std::ceil(std::log10(largest / step))),
                    kUsual, kOfDoubles);
}

/// The value at a share of the quantity's range, 0 to 1.
std::string value_at(const VariedQuantity& quantity, double share) {
  if (!quantity.range) {
    const auto n = static_cast<double>(quantity.values.size());
    const auto i = static_cast<std::size_t>(share * n);
    return quantity.values[std::min(i, quantity.values.size() - 1)];
  }
  const VariedRange& range = *quantity.range;
  const double number = range.from + share * (range.to - range.from);
  return fmt::format("{:.{}g}{}{}", number, digits_of(range),
                     range.unit.empty() ? "" : " ", range.unit);
}

std::size_t grid_count(const VariedQuantity& quantity) {
  return quantity.range ? index(quantity.range->count) : quantity.values.size();
}

std::size_t grid_size(const VaryTable& vary) {
  std::size_t size = 1;
  for (const VariedQuantity& quantity : vary.quantities) {
    size *= grid_count(quantity);
    if (size > kMostVariants) {
      throw Error(
          "S006", vary.place,
          fmt::format("[vary] has more than {} variants", kMostVariants),
          "Take fewer values, or design = \"latin_hypercube\".");
    }
  }
  return size;
}

/// Shares of the ranges, one row per variant.
using Shares = std::vector<std::vector<double>>;

Shares grid_shares(const VaryTable& vary) {
  Shares shares(grid_size(vary));
  for (std::size_t v = 0; v < shares.size(); ++v) {
    std::size_t rest = v;
    std::vector<double> row(vary.quantities.size());
    for (std::size_t q = row.size(); q-- > 0;) {
      const VariedQuantity& quantity = vary.quantities[q];
      const std::size_t count = grid_count(quantity);
      const auto i = static_cast<double>(rest % count);
      rest /= count;
      const auto n = static_cast<double>(count);
      row[q] = quantity.range ? i / (n - 1.0) : (i + 0.5) / n;
    }
    shares[v] = std::move(row);
  }
  return shares;
}

/// Distributions of the standard library differ from one to the next, this
/// generator does not.
class Random {
 public:
  explicit Random(int seed) : engine_(static_cast<std::uint64_t>(seed)) {}
  /// In [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  std::vector<std::size_t> permutation(std::size_t n) {
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = n; i > 1; --i) {
      const auto other =
          static_cast<std::size_t>(uniform() * static_cast<double>(i));
      std::swap(order[i - 1], order[other]);
    }
    return order;
  }

 private:
  std::mt19937_64 engine_;
};

Shares hypercube_shares(const VaryTable& vary) {
  Random random(vary.seed);
  const std::size_t n = index(vary.samples);
  Shares shares(n, std::vector<double>(vary.quantities.size()));
  for (std::size_t q = 0; q < vary.quantities.size(); ++q) {
    const auto order = random.permutation(n);
    for (std::size_t v = 0; v < n; ++v) {
      shares[v][q] = (static_cast<double>(order[v]) + random.uniform()) /
                     static_cast<double>(n);
    }
  }
  return shares;
}

}  // namespace

std::string numbered_name(std::size_t n, std::size_t count) {
  const std::size_t digits =
      std::max<std::size_t>(3, std::to_string(count).size());
  return fmt::format("v{:0{}}", n, digits);
}

std::vector<Variant> variants_of(const VaryTable& vary) {
  const Shares shares = vary.design == VaryTable::Design::kGrid
                            ? grid_shares(vary)
                            : hypercube_shares(vary);
  std::vector<Variant> variants;
  for (const auto& row : shares) {
    Variant variant{numbered_name(variants.size() + 1, shares.size()), {}};
    for (std::size_t q = 0; q < row.size(); ++q) {
      const VariedQuantity& quantity = vary.quantities[q];
      variant.settings.push_back(
          {quantity.path, value_at(quantity, row[q]), quantity.place});
    }
    variants.push_back(std::move(variant));
  }
  return variants;
}

}  // namespace clevis::scene
