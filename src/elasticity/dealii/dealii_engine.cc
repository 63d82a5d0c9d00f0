#include "elasticity/dealii/dealii_engine.h"

#include <chrono>
#include <optional>
#include <thread>

#include <deal.II/base/multithread_info.h>

#include "base/messages/errors.h"
#include "elasticity/dealii/dealii_service.h"
#include "elasticity/dealii/shared_solver.h"
#include "elasticity/engine_library/engine_library.h"
#include "elasticity/engine_library/petsc_session.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// What the first rank tells the others to do with it.
struct Order {
  enum Kind { kMake2, kMake3, kSolve, kDiagonal, kDrop, kEnd };
  int kind{};
  int columns{};  ///< to be solved
};

MPI_Comm start(bool is_shared) {
  start_petsc();
  dealii::MultithreadInfo::set_thread_limit(1);  // sums keep their order
  return is_shared ? MPI_COMM_WORLD : MPI_COMM_SELF;
}

/// As take_order() takes it: a blocking broadcast would not meet one that is
/// not.
void give(const Order& order, MPI_Comm ranks) {
  Order sent = order;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibcast(&sent, 2, MPI_INT, 0, ranks, &request);
  MPI_Wait(&request, MPI_STATUS_IGNORE);
}

/// The next order. A rank that waits leaves its processor to others: the first
/// one works alone between solves.
Order take_order() {
  constexpr auto kPause = std::chrono::microseconds(200);
  Order order;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibcast(&order, 2, MPI_INT, 0, MPI_COMM_WORLD, &request);
  for (int is_here = 0; is_here == 0;) {
    MPI_Test(&request, &is_here, MPI_STATUS_IGNORE);
    if (is_here == 0) std::this_thread::sleep_for(kPause);
  }
  return order;
}

/// On the first rank, whose orders the others follow; or alone.
template <int dim>
class FirstRank final : public DealiiEngine {
 public:
  explicit FirstRank(const DealiiTask<dim>& task)
      : ranks_(start(task.is_shared)) {
    order(dim == 2 ? Order::kMake2 : Order::kMake3);
    solver_.emplace(&task, ranks_);
  }
  ~FirstRank() override { order(Order::kDrop); }
  FirstRank(const FirstRank&) = delete;
  FirstRank& operator=(const FirstRank&) = delete;

  MatrixXd solve(const MatrixXd& loads) override {
    order(Order::kSolve, static_cast<int>(loads.cols()));
    MatrixXd result = MatrixXd::Zero(loads.rows(), loads.cols());
    solver_->solve(loads.cols(), loads, result);
    return result;
  }

  MatrixXd multiply_absolute_diagonal(const MatrixXd& columns) const override {
    order(Order::kDiagonal);
    return solver_->diagonal().cwiseAbs().asDiagonal() * columns.cwiseAbs();
  }

  const DealiiReport& report() const override { return solver_->report(); }

 private:
  void order(int kind, int columns = 0) const {
    if (dealii::Utilities::MPI::n_mpi_processes(ranks_) > 1) {
      give({kind, columns}, ranks_);
    }
  }

  MPI_Comm ranks_;
  std::optional<SharedSolver<dim>> solver_;
};

/// A solver of either dimension on one of the other ranks.
class OtherRank {
 public:
  void follow(const Order& order) {
    switch (order.kind) {
      case Order::kMake2:
        plate_.emplace(nullptr, MPI_COMM_WORLD);
        break;
      case Order::kMake3:
        solid_.emplace(nullptr, MPI_COMM_WORLD);
        break;
      case Order::kSolve:
        with_solver([&](auto& solver) {
          MatrixXd none;
          solver.solve(order.columns, none, none);
        });
        break;
      case Order::kDiagonal:
        with_solver([](auto& solver) {
          solver.diagonal();
        });
        break;
      default:
        drop();
    }
  }

  void drop() {
    plate_.reset();
    solid_.reset();
  }

 private:
  template <class Action>
  void with_solver(Action action) {
    if (plate_) action(*plate_);
    if (solid_) action(*solid_);
  }

  std::optional<SharedSolver<2>> plate_;
  std::optional<SharedSolver<3>> solid_;
};

}  // namespace

CLEVIS_ENGINE_ENTRY std::unique_ptr<DealiiEngine> clevis_dealii_2(
    const DealiiTask<2>& task) {
  return std::make_unique<FirstRank<2>>(task);
}

CLEVIS_ENGINE_ENTRY std::unique_ptr<DealiiEngine> clevis_dealii_3(
    const DealiiTask<3>& task) {
  return std::make_unique<FirstRank<3>>(task);
}

CLEVIS_ENGINE_ENTRY void clevis_dealii_serve() {
  start(true);
  OtherRank rank;
  for (Order order = take_order(); order.kind != Order::kEnd;
       order = take_order()) {
    try {
      rank.follow(order);
    } catch (const Error&) {  // on all ranks; the first one tells
      rank.drop();
    }
  }
}

CLEVIS_ENGINE_ENTRY void clevis_dealii_dismiss() {
  give({Order::kEnd, 0}, MPI_COMM_WORLD);
}

}  // namespace clevis::elasticity
