#include "elasticity/direct/frontal_cholesky.h"

#include <algorithm>
#include <utility>

#include "base/errors.h"
#include "elasticity/algebra/dense_blocks.h"

namespace clevis::elasticity {
namespace {

using Eigen::MatrixXd;

/// Row i holds the entries of the i-th eliminated unknown with itself and with
/// later ones; columns in no order.
UpperTriangle ordered(const UpperTriangle& matrix,
                      const std::vector<int>& place) {
  const auto n = static_cast<std::size_t>(matrix.rows());
  std::vector<int> next(n + 1, 0);
  const auto each = [&](const auto& visit) {
    for (std::size_t i = 0; i < n; ++i) {
      for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const int j = place[static_cast<std::size_t>(matrix.column[at])];
        const auto [first, later] = std::minmax(place[i], j);
        visit(static_cast<std::size_t>(first), later, at);
      }
    }
  };
  each([&](std::size_t first, int, std::size_t) {
    ++next[first + 1];
  });
  for (std::size_t i = 0; i < n; ++i) next[i + 1] += next[i];
  UpperTriangle result;
  result.row_start = next;
  result.column.resize(matrix.column.size());
  result.value.resize(matrix.value.size());
  each([&](std::size_t first, int later, std::size_t at) {
    const auto to = static_cast<std::size_t>(next[first]++);
    result.column[to] = later;
    result.value[to] = matrix.value[at];
  });
  return result;
}

bool is_in_order(const std::vector<int>& place) {
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] != static_cast<int>(i)) return false;
  }
  return true;
}

/// The dense matrices of the front at work and of those that wait for their
/// parent.
class Workspace {
 public:
  explicit Workspace(const FrontTree& tree)
      : local_(tree.place.size()), stack_(large_buffer(tree.stack_entries())) {}

  /// Matrix of the border, zero at first, above its children's.
  double* open(const Front& front) {
    const auto n = static_cast<std::size_t>(front.later());
    open_ = stack_.get() + top_;
    std::fill_n(open_, n * n, 0.0);
    for (int k = 0; k < front.later(); ++k) {
      local(front.border[static_cast<std::size_t>(k)]) = front.own() + k;
    }
    return open_;
  }

  void add_children(const Front& front, double* panel) {
    for (int child = 0; child < front.children; ++child) {
      const Waiting& waiting =
          waiting_[waiting_.size() - 1 - static_cast<std::size_t>(child)];
      add(*waiting.front, waiting.matrix, front, panel);
    }
  }

  /// Lays the border's matrix where the children's were.
  void close(const Front& front) {
    for (int child = 0; child < front.children; ++child) {
      top_ = static_cast<std::size_t>(waiting_.back().matrix - stack_.get());
      waiting_.pop_back();
    }
    const auto n = static_cast<std::size_t>(front.later());
    double* to = stack_.get() + top_;
    if (to != open_) std::copy_n(open_, n * n, to);
    waiting_.push_back({&front, to});
    top_ += n * n;
  }

  /// Place in the open front.
  int row(const Front& front, int unknown) {
    return unknown < front.end ? unknown - front.begin : local(unknown);
  }

 private:
  struct Waiting {
    const Front* front;
    double* matrix;
  };

  int& local(int unknown) { return local_[static_cast<std::size_t>(unknown)]; }

  void add(const Front& child, const double* matrix, const Front& front,
           double* panel) {
    const int n = child.later();
    rows_.resize(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) {
      const auto at = static_cast<std::size_t>(k);
      rows_[at] = row(front, child.border[at]);
    }
    for (int c = 0; c < n; ++c) {
      const int column = rows_[static_cast<std::size_t>(c)];
      const double* from = matrix + static_cast<std::ptrdiff_t>(c) * n;
      double* to =
          column < front.own()
              ? panel + static_cast<std::ptrdiff_t>(column) * front.size()
              : open_ +
                    static_cast<std::ptrdiff_t>(column - front.own()) *
                        front.later() -
                    front.own();
      for (int r = c; r < n; ++r) {
        to[rows_[static_cast<std::size_t>(r)]] += from[r];
      }
    }
  }

  std::vector<int> local_, rows_;
  LargeBuffer stack_;
  std::size_t top_ = 0;
  double* open_ = nullptr;
  std::vector<Waiting> waiting_;
};

void assemble(const UpperTriangle& matrix, const Front& front,
              Workspace& workspace, double* panel) {
  for (int i = front.begin; i < front.end; ++i) {
    double* column =
        panel + static_cast<std::ptrdiff_t>(i - front.begin) * front.size();
    const auto row = static_cast<std::size_t>(i);
    for (int k = matrix.row_start[row]; k < matrix.row_start[row + 1]; ++k) {
      const auto at = static_cast<std::size_t>(k);
      column[workspace.row(front, matrix.column[at])] += matrix.value[at];
    }
  }
}

}  // namespace

FrontalCholesky::FrontalCholesky(const UpperTriangle& matrix, FrontTree tree,
                                 const std::string& name)
    : tree_(std::move(tree)), factor_(large_buffer(tree_.factor_entries())) {
  std::size_t next = 0;
  for (const Front& front : tree_.fronts) {
    start_.push_back(next);
    next += static_cast<std::size_t>(front.own()) *
            static_cast<std::size_t>(front.size());
  }
  if (is_in_order(tree_.place)) {
    factor(matrix, name);
  } else {
    factor(ordered(matrix, tree_.place), name);
  }
}

void FrontalCholesky::factor(const UpperTriangle& ordered,
                             const std::string& name) {
  Workspace workspace(tree_);
  for (std::size_t f = 0; f < tree_.fronts.size(); ++f) {
    const Front& front = tree_.fronts[f];
    double* panel = factor_.get() + start_[f];
    std::fill_n(panel,
                static_cast<std::size_t>(front.own()) *
                    static_cast<std::size_t>(front.size()),
                0.0);
    double* border = workspace.open(front);
    assemble(ordered, front, workspace, panel);
    workspace.add_children(front, panel);
    if (!eliminate({panel, front.own(), front.later()}, border)) {
      throw Error("F002", name, "the stiffness matrix is not positive definite",
                  "Check the mesh quality and the material.");
    }
    workspace.close(front);
  }
}

MatrixXd FrontalCholesky::solve(const MatrixXd& right_hand_sides) const {
  return solve_upper(solve_lower(right_hand_sides));
}

MatrixXd FrontalCholesky::solve_lower(const MatrixXd& right_hand_sides) const {
  MatrixXd x(right_hand_sides.rows(), right_hand_sides.cols());
  for (Eigen::Index e = 0; e < x.rows(); ++e) {
    x.row(tree_.place[static_cast<std::size_t>(e)]) = right_hand_sides.row(e);
  }
  MatrixXd border;
  for (std::size_t f = 0; f < tree_.fronts.size(); ++f) {
    const Front& front = tree_.fronts[f];
    auto own = x.middleRows(front.begin, front.own());
    forward({panel(f), front.own(), front.later()}, own, border);
    for (int k = 0; k < front.later(); ++k) {
      x.row(front.border[static_cast<std::size_t>(k)]) -= border.row(k);
    }
  }
  return x;
}

MatrixXd FrontalCholesky::solve_upper(const MatrixXd& ordered) const {
  MatrixXd x = ordered;
  MatrixXd border;
  for (std::size_t f = tree_.fronts.size(); f-- > 0;) {
    const Front& front = tree_.fronts[f];
    border.resize(front.later(), x.cols());
    for (int k = 0; k < front.later(); ++k) {
      border.row(k) = x.row(front.border[static_cast<std::size_t>(k)]);
    }
    auto own = x.middleRows(front.begin, front.own());
    backward({panel(f), front.own(), front.later()}, border, own);
  }
  MatrixXd result(x.rows(), x.cols());
  for (Eigen::Index e = 0; e < x.rows(); ++e) {
    result.row(e) = x.row(tree_.place[static_cast<std::size_t>(e)]);
  }
  return result;
}

}  // namespace clevis::elasticity
