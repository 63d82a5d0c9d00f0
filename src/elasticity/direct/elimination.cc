#include "elasticity/direct/elimination.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <span>
#include <utility>

#include "elasticity/algebra/blas_space.h"
#include "elasticity/algebra/dense_blocks.h"
#include "elasticity/algebra/large_buffer.h"
#include "elasticity/lanes/thread_team.h"

namespace clevis::elasticity {
namespace {

/// The matrix of a front's border, later × later, by columns: it waits for the
/// front above.
template <typename Real>
struct BorderMatrix {
  const Front* front;
  Real* matrix;
};

/// Where unknowns stand in the front at work.
class FrontRows {
 public:
  explicit FrontRows(std::size_t unknowns) : local_(unknowns) {}

  void open(const Front& front) {
    front_ = &front;
    for (int k = 0; k < front.later(); ++k) {
      const int unknown = front.border[static_cast<std::size_t>(k)];
      local_[static_cast<std::size_t>(unknown)] = front.own() + k;
    }
  }
  int of(int unknown) const {
    return unknown < front_->end ? unknown - front_->begin
                                 : local_[static_cast<std::size_t>(unknown)];
  }
  std::vector<int> of_border(const Front& child) const {
    std::vector<int> rows;
    rows.reserve(child.border.size());
    for (const int unknown : child.border) rows.push_back(of(unknown));
    return rows;
  }

 private:
  const Front* front_ = nullptr;
  std::vector<int> local_;
};

template <typename Real>
class Elimination {
 public:
  Elimination(const MatrixRows& ordered, const FrontTree& tree,
              const std::vector<std::size_t>& start, Real* factor)
      : ordered_(ordered), tree_(tree), start_(start), factor_(factor) {}

  bool run(int threads) {
    if (threads > 1 && is_large() && take_blas_space(threads)) {
      return eliminate_by_threads(threads);
    }
    return eliminate_subtree(0, tree_.fronts.size(), nullptr);
  }

 private:
  using Waiting = std::vector<BorderMatrix<Real>>;

  /// A subtree, or a front above all of them.
  struct Item {
    std::size_t begin{}, end{};  ///< of the fronts
    bool is_subtree{};
    bool is_done = false;
    bool is_positive = true;
    std::exception_ptr failure = {};
    LargeBuffer<Real> border = {};  ///< matrix of the last front's
  };

  /// Fills the front's panel and its border's matrix, and eliminates.
  /// @param waiting  the last of them are the front's children.
  /// @param border   later × later, anything.
  bool eliminate_front(std::size_t f, const Waiting& waiting, FrontRows& rows,
                       Real* border, const ForTasks& run) const {
    const Front& front = tree_.fronts[f];
    Real* panel = factor_ + start_[f];
    set_zero(panel, front.panel_entries(), run);
    set_zero(border, front.border_entries(), run);
    rows.open(front);
    assemble(front, rows, panel);
    for (int child = 0; child < front.children; ++child) {
      add(waiting[waiting.size() - 1 - static_cast<std::size_t>(child)], front,
          rows, panel, border, run);
    }
    return eliminate<Real>({panel, front.own(), front.later()}, border, run);
  }

  /// Enough for threads to gain by it.
  bool is_large() const {
    constexpr double kLarge = 1e7;  // flops
    double flops = 0.0;
    for (const Front& front : tree_.fronts) flops += front.flops();
    return flops > kLarge;
  }

  static void set_zero(Real* numbers, std::size_t count, const ForTasks& run) {
    constexpr std::size_t kBlock = std::size_t{1} << 20;
    run(static_cast<int>((count + kBlock - 1) / kBlock), [&](int i) {
      const std::size_t at = kBlock * static_cast<std::size_t>(i);
      std::fill_n(numbers + at, std::min(kBlock, count - at), Real{0});
    });
  }

  void assemble(const Front& front, const FrontRows& rows, Real* panel) const {
    MatrixRows::Room room;
    for (int i = front.begin; i < front.end; ++i) {
      Real* column =
          panel + static_cast<std::ptrdiff_t>(i - front.begin) * front.size();
      const auto [columns, values] = ordered_.row(i, room);
      for (std::size_t k = 0; k < columns.size(); ++k) {
        column[rows.of(columns[k])] += static_cast<Real>(values[k]);
      }
    }
  }

  static void add(const BorderMatrix<Real>& child, const Front& front,
                  const FrontRows& in_front, Real* panel, Real* border,
                  const ForTasks& run) {
    constexpr int kColumns = 128;
    const int n = child.front->later();
    const std::vector<int> rows = in_front.of_border(*child.front);
    run((n + kColumns - 1) / kColumns, [&](int i) {
      for (int c = kColumns * i; c < std::min(n, kColumns * (i + 1)); ++c) {
        const int column = rows[static_cast<std::size_t>(c)];
        const Real* from = child.matrix + static_cast<std::ptrdiff_t>(c) * n;
        Real* to =
            column < front.own()
                ? panel + static_cast<std::ptrdiff_t>(column) * front.size()
                : border +
                      static_cast<std::ptrdiff_t>(column - front.own()) *
                          front.later() -
                      front.own();
        for (int r = c; r < n; ++r) {
          to[rows[static_cast<std::size_t>(r)]] += from[r];
        }
      }
    });
  }

  /// One front after the other, the borders' matrices on a stack.
  /// @param result  takes the matrix of the last front's border, if wanted.
  bool eliminate_subtree(std::size_t begin, std::size_t end,
                         LargeBuffer<Real>* result) const {
    const std::span<const Front> fronts =
        std::span(tree_.fronts).subspan(begin, end - begin);
    const auto stack = large_buffer<Real>(stack_entries(fronts));
    FrontRows rows(tree_.place.size());
    Waiting waiting;
    Real* top = stack.get();
    for (std::size_t f = begin; f < end; ++f) {
      const Front& front = tree_.fronts[f];
      if (!eliminate_front(f, waiting, rows, top, one_by_one)) return false;
      const std::size_t n = front.border_entries();
      Real* const matrix = top;
      for (int child = 0; child < front.children; ++child) {
        top = waiting.back().matrix;
        waiting.pop_back();
      }
      if (top != matrix) std::copy_n(matrix, n, top);
      waiting.push_back({&front, top});
      top += n;
    }
    if (result != nullptr) {
      const std::size_t n = waiting.back().front->border_entries();
      *result = large_buffer<Real>(n);
      std::copy_n(waiting.back().matrix, n, result->get());
    }
    return true;
  }

  /// The tree as subtrees, each a small share of the work, and the fronts above
  /// them, in the order of the fronts.
  std::vector<Item> items(int threads) const {
    constexpr double kShare = 1.0 / 64.0;  // small ones stand in less memory
    const auto first = first_below(tree_.fronts);
    std::vector<double> until{0.0};  // flops of all fronts before
    for (const Front& front : tree_.fronts) {
      until.push_back(until.back() + front.flops());
    }
    std::vector<Item> result;
    for (std::size_t end = tree_.fronts.size(); end > 0;) {
      const std::size_t begin = first[end - 1];
      const bool is_small =
          until[end] - until[begin] <= kShare / threads * until.back();
      Item item;
      item.is_subtree = is_small;
      item.begin = is_small ? begin : end - 1;
      item.end = end;
      end = item.begin;
      result.push_back(std::move(item));
    }
    std::ranges::reverse(result);
    return result;
  }

  void eliminate_item(Item& item) const {
    try {
      item.is_positive = eliminate_subtree(item.begin, item.end, &item.border);
    } catch (...) {
      item.failure = std::current_exception();
    }
    item.is_done = true;
  }

  /// The next subtrees that are not done, a few per thread: more would stand
  /// in memory at once.
  bool eliminate_next(std::vector<Item>& all, std::size_t from,
                      ThreadTeam& team) const {
    constexpr int kPerThread = 4;
    std::vector<Item*> next;
    for (std::size_t i = from; i < all.size(); ++i) {
      if (!all[i].is_subtree || all[i].is_done) continue;
      next.push_back(&all[i]);
      if (static_cast<int>(next.size()) == kPerThread * team.threads()) break;
    }
    team.run(static_cast<int>(next.size()), [&](int i) {
      eliminate_item(*next[static_cast<std::size_t>(i)]);
    });
    for (const Item* item : next) {
      if (item->failure) std::rethrow_exception(item->failure);
    }
    return std::ranges::all_of(next, &Item::is_positive);
  }

  bool eliminate_by_threads(int threads) const {
    ThreadTeam team(threads);
    const ForTasks run = [&](int tasks, const std::function<void(int)>& task) {
      if (tasks < 2) return one_by_one(tasks, task);
      team.run(tasks, task);
    };
    auto all = items(threads);
    FrontRows rows(tree_.place.size());
    Waiting waiting;
    std::vector<LargeBuffer<Real>> standing;
    for (std::size_t i = 0; i < all.size(); ++i) {
      Item& item = all[i];
      const Front& front = tree_.fronts[item.end - 1];
      if (item.is_subtree) {
        if (!item.is_done && !eliminate_next(all, i, team)) return false;
      } else {
        item.border = large_buffer<Real>(front.border_entries());
        if (!eliminate_front(item.begin, waiting, rows, item.border.get(),
                             run)) {
          return false;
        }
        const auto left =
            waiting.size() - static_cast<std::size_t>(front.children);
        waiting.resize(left);
        standing.resize(left);
      }
      waiting.push_back({&front, item.border.get()});
      standing.push_back(std::move(item.border));
    }
    return true;
  }

  const MatrixRows& ordered_;
  const FrontTree& tree_;
  const std::vector<std::size_t>& start_;
  Real* factor_;
};

}  // namespace

template <typename Real>
bool eliminate_fronts(const MatrixRows& ordered, const FrontTree& tree,
                      const std::vector<std::size_t>& start, int threads,
                      Real* factor) {
  return Elimination<Real>(ordered, tree, start, factor).run(threads);
}

template bool eliminate_fronts<double>(const MatrixRows&, const FrontTree&,
                                       const std::vector<std::size_t>&, int,
                                       double*);
template bool eliminate_fronts<float>(const MatrixRows&, const FrontTree&,
                                      const std::vector<std::size_t>&, int,
                                      float*);

}  // namespace clevis::elasticity
