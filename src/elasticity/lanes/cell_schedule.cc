#include "elasticity/lanes/cell_schedule.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace clevis::elasticity {
namespace {

constexpr int kLevels = 4;  // 16 parts: even loads for a few threads

using Order = std::vector<int>;

void bisect(const Eigen::Matrix3Xd& centres, Order::iterator begin,
            Order::iterator end) {
  const auto count = end - begin;
  if (count < 2) return;
  Eigen::Vector3d low = centres.col(*begin);
  Eigen::Vector3d high = low;
  for (auto at = begin; at != end; ++at) {
    low = low.cwiseMin(centres.col(*at));
    high = high.cwiseMax(centres.col(*at));
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const auto middle = begin + count / 2;
  std::nth_element(begin, middle, end, [&](int a, int b) {
    const double xa = centres(axis, a);
    const double xb = centres(axis, b);
    return xa != xb ? xa < xb : a < b;
  });
  bisect(centres, begin, middle);
  bisect(centres, middle, end);
}

/// Numbers nodes by first touch and finds the ghosts.
/// @param keys      cells × nodes per cell, any numbers below `key_count`.
/// @param number    per key, its node; -1 if unused.
NodeTable build_table(const CellSchedule& schedule, int degree,
                      const std::vector<int>& keys, int key_count,
                      std::vector<int>& number) {
  NodeTable table;
  table.degree = degree;
  const auto per_cell = static_cast<std::size_t>(table.nodes_per_cell());
  number.assign(static_cast<std::size_t>(key_count), -1);
  table.gather.resize(keys.size());
  table.scatter.resize(keys.size());
  table.part_start.push_back(0);
  std::vector<int> touched(static_cast<std::size_t>(key_count), -1);
  std::vector<int> place(static_cast<std::size_t>(key_count));
  std::vector<std::pair<int, int>> ghosts;  // in the order of the parts
  for (int part = 0; part < schedule.parts(); ++part) {
    const auto p = static_cast<std::size_t>(part);
    const auto begin =
        per_cell * static_cast<std::size_t>(schedule.part_start[p]);
    const auto end =
        per_cell * static_cast<std::size_t>(schedule.part_start[p + 1]);
    for (std::size_t i = begin; i < end; ++i) {
      const auto key = static_cast<std::size_t>(keys[i]);
      const bool first = touched[key] != part;
      if (first && number[key] < 0) {
        place[key] = number[key] = table.nodes++;
      } else if (first) {
        place[key] = -1 - static_cast<int>(ghosts.size());
        ghosts.emplace_back(number[key], static_cast<int>(ghosts.size()));
      }
      touched[key] = part;
      table.gather[i] = number[key];
      // Ghost places follow the nodes, whose number is not known yet: marked
      // by 2 g + 1, nodes by 2 n; the sign says "first".
      const int code =
          place[key] >= 0 ? 2 * place[key] : 2 * (-1 - place[key]) + 1;
      table.scatter[i] = first ? ~code : code;
    }
    table.part_start.push_back(table.nodes);
  }
  for (int& code : table.scatter) {
    const bool first = code < 0;
    const int twice = first ? ~code : code;
    const int at = twice / 2 + (twice % 2 == 1 ? table.nodes : 0);
    code = first ? ~at : at;
  }
  // By owner's part; within it still in the order of the parts that add.
  const auto owner = [&](const std::pair<int, int>& ghost) {
    return std::ranges::upper_bound(table.part_start, ghost.first) -
           table.part_start.begin() - 1;
  };
  std::ranges::stable_sort(ghosts, {}, owner);
  table.ghost_start.assign(static_cast<std::size_t>(schedule.parts()) + 1, 0);
  for (const auto& ghost : ghosts) {
    ++table.ghost_start[static_cast<std::size_t>(owner(ghost)) + 1];
  }
  std::partial_sum(table.ghost_start.begin(), table.ghost_start.end(),
                   table.ghost_start.begin());
  table.ghosts = std::move(ghosts);
  return table;
}

}  // namespace

CellSchedule schedule_cells(const Discretization<3>& discretization) {
  CellSchedule schedule;
  const int cells = discretization.cells();
  Eigen::Matrix3Xd centres(3, cells);
  for (int c = 0; c < cells; ++c) {
    centres.col(c) = discretization.cell_points[static_cast<std::size_t>(c)]
                         .rowwise()
                         .mean();
  }
  schedule.cell.resize(static_cast<std::size_t>(cells));
  std::iota(schedule.cell.begin(), schedule.cell.end(), 0);
  bisect(centres, schedule.cell.begin(), schedule.cell.end());
  // The halves of the bisection are the parts; cut the same way.
  schedule.part_start = {0, cells};
  for (int level = 0; level < kLevels; ++level) {
    std::vector<int> finer;
    for (std::size_t p = 0; p + 1 < schedule.part_start.size(); ++p) {
      const int begin = schedule.part_start[p];
      finer.push_back(begin);
      finer.push_back(begin + (schedule.part_start[p + 1] - begin) / 2);
    }
    finer.push_back(cells);
    schedule.part_start = std::move(finer);
  }
  return schedule;
}

std::vector<int> lexicographic_order(int degree) {
  const auto points = displacement_support_points<3>(mesh::CellShape::kTensor,
                                                     {degree, degree});
  std::vector<int> order(static_cast<std::size_t>(points.cols()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, [&](int a, int b) {
    for (int d = 2; d >= 0; --d) {
      const double difference = points(d, a) - points(d, b);
      if (std::abs(difference) > 1e-6) return difference < 0.0;
    }
    return false;
  });
  return order;
}

FineNodes number_nodes(const Discretization<3>& discretization,
                       const CellSchedule& schedule) {
  const auto order = lexicographic_order(discretization.degree);
  std::vector<int> keys;
  keys.reserve(schedule.cell.size() * order.size());
  for (int cell : schedule.cell) {
    const auto& nodes =
        discretization.cell_nodes[static_cast<std::size_t>(cell)];
    for (int local : order) {
      keys.push_back(nodes[static_cast<std::size_t>(local)]);
    }
  }
  FineNodes fine;
  fine.table = build_table(schedule, discretization.degree, keys,
                           discretization.nodes, fine.number);
  return fine;
}

NodeTable coarsen(const NodeTable& fine, const CellSchedule& schedule,
                  int degree) {
  // A corner, edge, face or cell of degree 2 has one node; its key is the
  // least of the fine nodes inside.
  const int p = fine.degree;
  const int n = degree + 1;
  const auto box = [&](int place) {
    if (place == 0) return std::pair{0, 0};
    return place == degree ? std::pair{p, p} : std::pair{1, p - 1};
  };
  std::vector<int> keys;
  for (int cell = 0; cell < schedule.cells(); ++cell) {
    const int* nodes = fine.gather.data() + static_cast<std::ptrdiff_t>(cell) *
                                                fine.nodes_per_cell();
    for (int place = 0; place < n * n * n; ++place) {
      const auto [x0, x1] = box(place % n);
      const auto [y0, y1] = box(place / n % n);
      const auto [z0, z1] = box(place / (n * n));
      int key = fine.nodes;
      for (int z = z0; z <= z1; ++z) {
        for (int y = y0; y <= y1; ++y) {
          for (int x = x0; x <= x1; ++x) {
            key = std::min(key, nodes[(z * (p + 1) + y) * (p + 1) + x]);
          }
        }
      }
      keys.push_back(key);
    }
  }
  std::vector<int> number;
  return build_table(schedule, degree, keys, fine.nodes, number);
}

}  // namespace clevis::elasticity
